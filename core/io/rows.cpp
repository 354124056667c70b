// xyz, csv and txt: two or three numbers a line.
#include <algorithm>
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
  bool open = false;  // whether the line ends with a separator

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

Fields fields_of(std::string_view line, char separator) {
  Fields fields;
  if (separator == '\0') {
    for (auto word = take_word(line); !word.empty() && !fields.full(); word = take_word(line)) fields.add(word);
    return fields;
  }
  for (bool more = true; more && !fields.full();) {
    const std::size_t end = line.find(separator);
    more = end != std::string_view::npos;
    const std::string_view field = trim(line.substr(0, end));
    if (!more && field.empty() && fields.count > 0) {
      fields.open = true;
      break;
    }
    fields.add(field);
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

/// What is wrong with a header; empty if the first columns are x, y and z. Other columns would be taken for
/// coordinates, silently. Two columns may have other names, such as u and v, if neither is called x, y or z.
std::string wrong_columns(const Fields& fields) {
  const std::string_view names = "xyz";
  const auto columns = std::span(fields.at).first(std::min<std::size_t>(fields.count, 3));
  const auto is_axis = [&](std::string_view field) {
    return field.size() == 1 && names.find(lower_case(field)) != std::string_view::npos;
  };
  if (columns.size() < 3 && std::none_of(columns.begin(), columns.end(), is_axis)) return {};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (lower_case(columns[i]).find(names[i]) == std::string::npos)
      return "column " + std::to_string(i + 1) + " is " + quoted(fields.at[i]) +
             ": the first columns must be x, y and z";
  }
  return {};
}

/// A line without its comment.
std::string_view content_of(std::string_view line) {
  line = trim(without_comment(line));
  return line.substr(0, 2) == "//" ? std::string_view() : line;
}

tl::expected<Vector<double, 3>, std::string> point_of(const Fields& fields, const Wanted& wanted) {
  Vector<double, 3> point = Vector<double, 3>::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(fields.count, 3); ++i) {
    if (fields.at[i].empty()) return tl::unexpected("field " + std::to_string(i + 1) + " is empty");
    const auto value = parse_coordinate(fields.at[i], wanted.skip_nan);
    if (!value) return tl::unexpected(value.error());
    point[static_cast<int>(i)] = *value;
  }
  if (fields.count < 2) return tl::unexpected(std::string("there is one number on the line: a point has two or three"));
  return point;
}

/// What is wrong with a line that is no point. fields: its own. Where commas leave a tab within a field, numbers have
/// decimal commas and tabs separate them: "1,5" is wrong then, and not "5 2".
std::string fault_of(std::string_view line, const Fields& fields, const Wanted& wanted, std::string fault) {
  const auto has_tab = [](std::string_view field) { return field.find('\t') != std::string_view::npos; };
  if (std::none_of(fields.at.begin(), fields.at.end(), has_tab)) return fault;
  const auto by_tabs = point_of(fields_of(line, '\t'), wanted);
  return by_tabs ? fault : by_tabs.error();
}

/// Whether a line has as many columns as the first. Beyond the third one, an empty field may be missing.
bool are_alike(const Fields& fields, const Fields& first) {
  const auto may_be_more = [](const Fields& some) { return some.full() || (some.count == 3 && some.open); };
  return fields.count == first.count || (may_be_more(fields) && may_be_more(first));
}

std::string columns_text(std::size_t n) { return n > 3 ? "more than 3" : std::to_string(n); }

}  // namespace

Read<PointFile> read_rows(std::string_view text, bool csv, const Wanted& wanted) {
  PointFile file;
  Fields first;                 // of the first point, which sets the dimension
  std::int64_t first_line = 0;  // the line of the first point
  bool header_may_come = true;
  std::optional<InputError> header;
  for (Lines lines(text); lines.next();) {
    const std::string_view line = content_of(lines.line());
    if (line.empty() || (header_may_come && line.substr(0, 4) == "sep=")) continue;
    const Fields fields = fields_of(line, separator_of(line, csv));
    if (std::exchange(header_may_come, false) && is_header(fields)) {
      if (const std::string wrong = wrong_columns(fields); !wrong.empty()) return at_line(lines.number(), wrong);
      if (csv) continue;
      header = at_line(lines.number(), quoted(fields.at[0]) + " is not a number").value();
      pass_over(file, Passed::kHeader);
      continue;
    }
    const auto point = point_of(fields, wanted);
    if (!point) return at_line(lines.number(), fault_of(line, fields, wanted, point.error()));
    if (first_line == 0) {
      first_line = lines.number();
      first = fields;
      file.dim = first.count == 2 ? 2 : 3;
    }
    if (!are_alike(fields, first))
      return at_line(lines.number(), "there are " + columns_text(fields.count) + " numbers on the line, and on line " +
                                         std::to_string(first_line) + " there were " + columns_text(first.count));
    if (fields.full()) pass_over(file, Passed::kColumns);
    if (file.points.size() == kMostPoints) return at_line(lines.number(), std::string(kTooManyPoints));
    file.points.push_back(*point);
  }
  if (file.points.empty() && header) return tl::unexpected(*header);
  return file;
}

}  // namespace snug::io
