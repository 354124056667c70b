// xyz, csv and txt: two or three numbers a line.
#include <array>
#include <span>
#include <utility>

#include "io/formats.hpp"

namespace snug::io {
namespace {

/// The fields of a line, and their number; fields beyond the capacity are only counted.
struct Fields {
  std::array<std::string_view, 4> at;
  std::size_t count = 0;

  void add(std::string_view field) {
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    at[count++] = trim(field);
  }
  [[nodiscard]] bool full() const { return count == at.size(); }
};

/// The separator of a line's fields. A semicolon takes precedence over a comma, which is then a decimal comma and is
/// refused. '\0' stands for any run of blanks.
char separator_of(std::string_view line, bool csv) {
  for (const char c : {';', ','})
    if (line.find(c) != std::string_view::npos) return c;
  return csv && line.find('\t') != std::string_view::npos ? '\t' : '\0';
}

Fields fields_of(std::string_view line, bool csv) {
  Fields fields;
  const char separator = separator_of(line, csv);
  if (separator == '\0') {
    for (auto word = take_word(line); !word.empty() && !fields.full(); word = take_word(line)) fields.add(word);
    return fields;
  }
  for (bool more = true; more && !fields.full();) {
    const std::size_t end = line.find(separator);
    more = end != std::string_view::npos;
    fields.add(trim(line.substr(0, end)));
    if (more) line.remove_prefix(end + 1);
  }
  return fields;
}

/// Whether every field is a name. "1,5" is not a name, but a number with a decimal comma.
bool is_header(const Fields& fields) {
  constexpr std::string_view kNumberStarts = "0123456789+-.";
  for (const std::string_view field : std::span(fields.at).first(fields.count))
    if (field.empty() || kNumberStarts.find(field.front()) != std::string_view::npos || parse_number(field))
      return false;
  return true;
}

tl::expected<Vector<double, 3>, std::string> point_of(const Fields& fields) {
  Vector<double, 3> point = Vector<double, 3>::Zero();
  for (std::size_t i = 0; i < fields.count; ++i) {
    if (fields.at[i].empty()) return tl::unexpected("field " + std::to_string(i + 1) + " is empty");
    if (i == 3) return tl::unexpected(std::string("there are more than three numbers on the line"));
    const auto value = parse_coordinate(fields.at[i]);
    if (!value) return tl::unexpected(value.error());
    point[static_cast<int>(i)] = *value;
  }
  if (fields.count < 2) return tl::unexpected(std::string("there is one number on the line: a point has two or three"));
  return point;
}

}  // namespace

Read<PointFile> read_rows(std::string_view text, bool csv) {
  PointFile file;
  std::int64_t first_line = 0;  // the line of the first point, which sets the dimension
  bool header_may_come = csv;
  for (Lines lines(text); lines.next();) {
    const std::string_view line = trim(lines.line().substr(0, lines.line().find('#')));
    if (line.empty()) continue;
    const Fields fields = fields_of(line, csv);
    if (std::exchange(header_may_come, false) && is_header(fields)) continue;
    const auto point = point_of(fields);
    if (!point) return at_line(lines.number(), point.error());
    const int dim = static_cast<int>(fields.count);
    if (first_line == 0) {
      first_line = lines.number();
      file.dim = dim;
    }
    if (dim != file.dim)
      return at_line(lines.number(), "there are " + std::to_string(dim) + " numbers on the line, and on line " +
                                         std::to_string(first_line) + " there were " + std::to_string(file.dim));
    if (file.points.size() == kMostPoints) return at_line(lines.number(), std::string(kTooManyPoints));
    file.points.push_back(*point);
  }
  return file;
}

}  // namespace snug::io
