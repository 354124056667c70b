#include "io/ply_body.hpp"

#include <cmath>

#include "io/formats.hpp"
#include "number/bits.hpp"

namespace snug::io {
namespace {

template <class Integer>
std::int64_t as_signed(std::uint64_t bits) {
  return static_cast<std::int64_t>(static_cast<Integer>(bits));
}

std::int64_t integer_of(PlyType type, std::uint64_t bits) {
  switch (type) {
    case PlyType::kInt8: return as_signed<std::int8_t>(bits);
    case PlyType::kInt16: return as_signed<std::int16_t>(bits);
    case PlyType::kInt32: return as_signed<std::int32_t>(bits);
    default: return static_cast<std::int64_t>(bits);  // an integer, from as many bytes as the type has
  }
}

double number_of(PlyType type, std::uint64_t bits) {
  if (type == PlyType::kFloat32) return static_cast<double>(float_of(static_cast<std::uint32_t>(bits)));
  if (type == PlyType::kFloat64) return double_of(bits);
  if (type == PlyType::kUint64) return static_cast<double>(bits);
  return static_cast<double>(integer_of(type, bits));
}

/// The number as an integer, if it is one.
std::optional<std::int64_t> whole_of(std::optional<double> number) {
  if (!number || !(std::abs(*number) < 1e15) || *number != std::floor(*number)) return std::nullopt;
  return static_cast<std::int64_t>(*number);
}

}  // namespace

// ---- text ------------------------------------------------------------------------------------------------------

PlyText::PlyText(const PlyHeader& header, std::string_view, const Wanted& wanted)
    : lines_(header.body, header.lines + 1), wanted_(wanted) {}

std::int64_t PlyText::smallest(const PlyElement& element) {
  return 2 * static_cast<std::int64_t>(element.properties.size());  // a digit and a separator
}

bool PlyText::begin(const PlyElement& element, std::int64_t instance) {
  if (!lines_.next_filled())
    return fail("the file ends after " + std::to_string(instance) + " of " + counted(element.count, "line") + " of " +
                quoted(element.name));
  rest_ = lines_.line();
  first_ = lines_.number();
  return true;
}

bool PlyText::word(std::string_view& word) {
  word = take_word(rest_);
  if (!word.empty()) return true;
  if (!lines_.next_filled()) return fail("the line has fewer values than the header says");
  rest_ = lines_.line();
  word = take_word(rest_);
  return true;
}

bool PlyText::number(PlyType, double& value) {
  std::string_view text;
  if (!word(text)) return false;
  const auto coordinate = parse_coordinate(text, wanted_.skip_nan);
  if (!coordinate) return fail(coordinate.error());
  value = *coordinate;
  return true;
}

std::string PlyText::not_integer() const { return quoted(word_) + " is not an integer"; }

bool PlyText::whole(PlyType, std::optional<std::int64_t>& value) {
  if (!word(word_)) return false;
  value = parse_integer(word_);
  if (!value) value = whole_of(parse_number(word_));  // some programs write 3.0
  return true;
}

bool PlyText::skip(PlyType, std::int64_t n) {
  std::string_view text;
  for (std::int64_t i = 0; i < n; ++i)
    if (!word(text)) return false;
  return true;
}

bool PlyText::end() {
  if (trim(rest_).empty()) return true;
  if (first_ == lines_.number()) return fail("the line has more values than the header says");
  error_ = at_line(first_, "the line has fewer values than the header says, and the next line has more").value();
  return false;
}

void PlyText::finish(PointFile& file) {
  while (lines_.next_filled()) pass_over(file, Passed::kLines);
}

bool PlyText::fail(std::string what) {
  error_ = at_line(lines_.number(), std::move(what)).value();
  return false;
}

// ---- bytes -----------------------------------------------------------------------------------------------------

PlyBytes::PlyBytes(const PlyHeader& header, std::string_view whole, const Wanted& wanted)
    : bytes_(whole), at_(whole.size() - header.body.size()), value_(at_),
      big_endian_(header.form == PlyForm::kBigEndian), wanted_(wanted) {}

std::int64_t PlyBytes::smallest(const PlyElement& element) {
  std::size_t size = 0;
  for (const PlyProperty& property : element.properties) size += bytes_of(property.count_type.value_or(property.type));
  return static_cast<std::int64_t>(size);
}

bool PlyBytes::begin(const PlyElement&, std::int64_t) {
  value_ = at_;
  return true;
}

bool PlyBytes::bits(PlyType type, std::uint64_t& value) {
  const std::size_t size = bytes_of(type);
  if (bytes_.size() - at_ < size) return cut_short();
  value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const auto byte = static_cast<unsigned char>(bytes_[at_ + i]);
    value |= std::uint64_t{byte} << 8 * (big_endian_ ? size - 1 - i : i);
  }
  value_ = at_;
  at_ += size;
  return true;
}

bool PlyBytes::number(PlyType type, double& value) {
  std::uint64_t raw = 0;
  if (!bits(type, raw)) return false;
  value = number_of(type, raw);
  const std::string_view fault = fault_of_coordinate(value, wanted_.skip_nan);
  return fault.empty() || fail(std::string("the coordinate ").append(fault));
}

std::string PlyBytes::not_integer() const { return "the number is not an integer"; }

bool PlyBytes::whole(PlyType type, std::optional<std::int64_t>& value) {
  std::uint64_t raw = 0;
  if (!bits(type, raw)) return false;
  value = is_integer(type) ? integer_of(type, raw) : whole_of(number_of(type, raw));
  return true;
}

bool PlyBytes::skip(PlyType type, std::int64_t n) {
  const auto size = static_cast<std::int64_t>(bytes_of(type));
  if (n > left() / size) return cut_short();
  at_ += static_cast<std::size_t>(n * size);
  return true;
}

void PlyBytes::finish(PointFile& file) { pass_over(file, Passed::kBytes, left()); }

bool PlyBytes::cut_short() {
  value_ = bytes_.size();
  return fail("the file is cut short: the header says that there is more");
}

bool PlyBytes::fail(std::string what) {
  error_ = at_byte(static_cast<std::int64_t>(value_), std::move(what)).value();
  return false;
}

}  // namespace snug::io
