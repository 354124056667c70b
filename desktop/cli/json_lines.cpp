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

/// text: the lines. name: for errors.
CommandResult answer_text(const std::string& text, const std::string& name,
                          const std::function<tl::expected<Json, std::string>(const Json&)>& answer) {
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
  }
  return printed;
}

}  // namespace

CommandResult answer_lines(const std::string& file,
                           const std::function<tl::expected<Json, std::string>(const Json&)>& answer) {
  const auto bytes = read_file(file);
  return bytes ? answer_text(*bytes, file, answer) : bad_input(bytes.error());
}

CommandResult answer_given(const std::string& file, const std::string& name,
                           tl::expected<std::string, InputError> (*line_of_case)(const std::string&),
                           const std::function<tl::expected<Json, std::string>(const Json&)>& answer) {
  if (name.empty()) return answer_lines(file, answer);
  const auto line = line_of_case(name);
  return line ? answer_text(*line, name, answer) : bad_input(line.error());
}

}  // namespace snug::desktop
