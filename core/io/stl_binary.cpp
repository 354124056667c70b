#include <algorithm>

#include "io/corner_merger.hpp"
#include "io/formats.hpp"
#include "number/bits.hpp"

namespace snug::io {
namespace {

constexpr std::size_t kHeader = 80;    // may contain anything
constexpr std::size_t kStart = 84;     // after the count
constexpr std::size_t kTriangle = 50;  // normal, three corners, two bytes of attributes

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << 8 * i;
  return word;
}

std::uint64_t size_claimed(std::string_view bytes) {
  return kStart + std::uint64_t{word_at(bytes, kHeader)} * kTriangle;
}

}  // namespace

namespace {

/// Whether the bytes after the claimed triangles could be more triangles, which would be lost. Padding could not.
bool has_more_triangles(std::string_view bytes, std::uint64_t claimed) {
  if (bytes.size() < claimed + kTriangle) return false;
  const std::string_view rest = bytes.substr(static_cast<std::size_t>(claimed));
  return rest.find_first_not_of(std::string_view("\0 \t\r\n", 5)) != std::string_view::npos;
}

}  // namespace

bool has_size_of_stl(std::string_view bytes) { return bytes.size() >= kStart && bytes.size() == size_claimed(bytes); }

Read<PointFile> read_stl_binary(std::string_view bytes, const Wanted& wanted) {
  const auto size = static_cast<std::int64_t>(bytes.size());
  if (bytes.size() < kStart) return at_byte(size, "the file is cut short: a binary STL has at least 84 bytes");
  const std::uint64_t claimed = size_claimed(bytes);
  // Four letters as a count would be more triangles than any file holds.
  const std::string_view count = bytes.substr(kHeader, 4);
  if (bytes.size() < claimed && std::all_of(count.begin(), count.end(),
                                            [](char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); }))
    return at_byte(static_cast<std::int64_t>(bytes.find('\0')), "there is a zero byte in the text");
  if (bytes.size() < claimed || (claimed == kStart && bytes.size() > kStart) || has_more_triangles(bytes, claimed))
    return at_byte(kHeader, "the header claims " + counted(word_at(bytes, kHeader), "triangle") + ", which is " +
                                std::to_string(size_claimed(bytes)) + " bytes, and the file has " +
                                std::to_string(size));
  CornerMerger merger;
  for (std::size_t triangle = kStart; triangle < claimed; triangle += kTriangle) {
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      Vector<double, 3> point;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = triangle + 12 * corner + 4 * axis;
        const double value = static_cast<double>(float_of(word_at(bytes, at)));
        const std::string_view fault = fault_of_coordinate(value, wanted.skip_nan);
        if (!fault.empty()) return at_byte(static_cast<std::int64_t>(at), std::string("the coordinate ").append(fault));
        point[static_cast<int>(axis)] = value;
      }
      if (merger.full()) return at_byte(static_cast<std::int64_t>(triangle), std::string(kTooManyPoints));
      merger.add(point);
    }
  }
  PointFile file = merger.take();
  pass_over(file, Passed::kBytes, size - static_cast<std::int64_t>(claimed));
  return file;
}

}  // namespace snug::io
