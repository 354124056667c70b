#include "desktop/cli/json_lines.hpp"

#include <algorithm>
#include <set>

#include "desktop/cli/files.hpp"
#include "desktop/cli/progress.hpp"

namespace snug::desktop {
namespace {

/// Parses one line of JSON. Errors: invalid JSON, including a repeated key.
tl::expected<Json, std::string> json_line(const std::string& line) {
  if (line.find('\0') != std::string::npos)
    return tl::unexpected(std::string("not JSON: it has a NUL byte"));  // the library would end there
  std::vector<std::set<std::string>> open;
  std::string twice;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second)
      twice = parsed.dump();
    return true;
  };
  try {
    Json json = Json::parse(line, watch);
    if (!twice.empty()) return tl::unexpected("the key " + twice + " appears twice");
    return json;
  } catch (const Json::exception& error) {
    const std::string what = error.what();
    const std::size_t from = what.find("] ");  // after the library's error code
    return tl::unexpected("not JSON: " + (from == std::string::npos ? what : what.substr(from + 2)));
  }
}

/// The warning about them, at the line of the first.
InputError warning_of(const RoughAxes& rough, const std::string& name) {
  const std::string others = rough.count == 1 ? "" : " (and " + std::to_string(rough.count - 1) + " more)";
  return {rough.first + others + " are only unit and perpendicular to about four digits, and were made so exactly",
          name, InputError::Unit::kLine, rough.line};
}

/// text: the lines. name: for errors.
CommandResult answer_text(const std::string& text, const std::string& name,
                          const std::function<tl::expected<Json, std::string>(const Json&)>& answer, RoughAxes& rough) {
  Printed printed;
  std::int64_t number = 0;
  Progress progress("lines", static_cast<int>(std::count(text.begin(), text.end(), '\n')) + 1);
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string line = text.substr(from, end - from);
    from = end + 1;
    ++number;
    progress.advance();
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto answered = json_line(line).and_then(answer);
    if (!answered && printed.text.empty() && !Json::accept(line) && Json::accept(text))
      return bad_input(InputError{"this is one JSON value over several lines: write each object in a line of its own",
                                  name, InputError::Unit::kLine, number});
    if (!answered) return bad_input(InputError{answered.error(), name, InputError::Unit::kLine, number});
    printed.text += line_of(*answered);
    if (rough.count > 0 && rough.line == 0) rough.line = number;
  }
  if (rough.count > 0) printed.warnings.push_back(warning_of(rough, name));
  return printed;
}

}  // namespace

CommandResult answer_given(const std::string& file, const std::string& name,
                           tl::expected<std::string, InputError> (*line_of_case)(const std::string&),
                           const std::function<tl::expected<Json, std::string>(const Json&)>& answer,
                           RoughAxes& rough) {
  const auto text = name.empty() ? read_file(file) : line_of_case(name);
  return text ? answer_text(*text, name.empty() ? file : name, answer, rough) : bad_input(text.error());
}

}  // namespace snug::desktop
