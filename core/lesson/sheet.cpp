#include "lesson/sheet.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "io/text.hpp"
#include "lesson/names.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/session.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {
namespace {

constexpr std::array<std::string_view, 2> kMeasuredTables{"costs", "which"};

Measured read_measured(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[measured]]", complaints);
  Measured measured{table.text("id"), table.text("prompt"), table.text("table"), table.text_or("points", "")};
  check_name(table, "table", measured.table, kMeasuredTables);
  table.refuse_others();
  return measured;
}

Written read_written(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[written]]", complaints);
  Written written{table.text("id"), table.text("prompt")};
  table.refuse_others();
  return written;
}

void read_sheet(toml::table& toml, std::string_view name, Sheet& sheet, Complaints& complaints) {
  std::set<std::string> ids;
  TomlTable root(toml, "the sheet", complaints);
  const auto take = [&](const char* key, auto& parts, auto read) {
    for (const toml::table* one : root.tables(key)) {
      parts.push_back(read(*one, complaints));
      if (!ids.insert(parts.back().id).second)
        complaints.add(file_place(*one), "the sheet has two parts with the id \"" + parts.back().id + '"');
    }
    toml.erase(key);
  };
  take("measured", sheet.measured, read_measured);
  take("written", sheet.written, read_written);
  if (!toml.contains("covers")) toml.insert("covers", toml::array());
  if (const toml::array* const tasks = toml["task"].as_array(); tasks != nullptr && !sheet.measured.empty())
    complaints.add(file_place(*tasks),
                   "a sheet with [[measured]] has no [[task]]: what depends on times cannot be judged later");
  else if (tasks == nullptr && sheet.measured.empty() && sheet.written.empty())
    complaints.add({}, "the sheet has nothing to hand in: no [[task]], [[measured]] or [[written]]");
  if (auto lesson = read_as_written(toml, name, complaints)) sheet.lesson = *std::move(lesson);
}

}  // namespace

bool is_sheet(std::string_view toml) {
  return toml.find("\n[[measured]]") != std::string_view::npos || toml.find("\n[[written]]") != std::string_view::npos;
}

SheetDraft read_sheet(std::string_view text, std::string_view name) {
  Complaints complaints(name);
  SheetDraft draft;
  draft.sheet.hash = hash_of_text(text);
  if (auto toml = parse_file(text, "a sheet", complaints)) read_sheet(*toml, name, draft.sheet, complaints);
  draft.mistakes = complaints.mistakes();
  return draft;
}

const Measured* measurement_of(const Sheet& sheet, std::string_view table, std::string_view points) {
  const Measured* any = nullptr;
  for (const Measured& one : sheet.measured) {
    if (one.table != table) continue;
    if (one.points == points) return &one;
    if (one.points.empty()) any = &one;
  }
  return any;
}

std::size_t letters_of(const Rows& rows) {
  std::size_t letters = 0;
  for (const std::vector<double>& row : rows)
    for (const double number : row) letters += io::shortest_text(number).size();
  return letters;
}

bool is_smaller(const Rows& a, const Rows& b) {
  return a.size() != b.size() ? a.size() < b.size() : letters_of(a) < letters_of(b);
}

tl::expected<BuiltJudged, InputError> judge_built(const Sheet& sheet, std::size_t task, const Rows& rows) {
  if (task >= sheet.lesson.tasks.size()) return tl::unexpected(InputError{.what = "the sheet has no such task"});
  auto session = Session::open(sheet.lesson);
  if (!session) return tl::unexpected(session.error());
  session->stage().start_task(task);
  if (const auto put = session->stage().set_rows(rows); !put) return tl::unexpected(put.error());
  const Grade grade = session->grade(task);
  return BuiltJudged{grade.done, grade.says};
}

}  // namespace snug::lesson
