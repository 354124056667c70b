// What a student has done of a sheet, as JSON.
#include <algorithm>
#include <array>
#include <charconv>
#include <ctime>

#include "desktop/cli/sheet_files.hpp"
#include "lesson/exercise/attempt.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

constexpr std::size_t kMostWritten = 4000;  // bytes of an answer
constexpr std::size_t kMostRows = 200;      // of a table

/// The beginning of an answer, which does not end within a letter.
std::string shortened(std::string text) {
  if (text.size() <= kMostWritten) return text;
  std::size_t end = kMostWritten;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end);
}

/// A key's object; an empty one where it is missing or something else.
Json object_at(const Json& json, const char* key) {
  const Json* const found = value_at(json, key);
  return found != nullptr && found->is_object() ? *found : Json::object();
}

/// Whether it is a table as the program writes it, as far as people and charts need it.
bool is_table(const Json& json) {
  if (!json.is_object() || !json.contains("table") || !json["table"].is_string()) return false;
  const Json* const rows = value_at(json, "rows");
  const Json* const provenance = value_at(json, "provenance");
  if (provenance == nullptr || !provenance->is_object() || rows == nullptr || !rows->is_array()) return false;
  for (const char* key : {"version", "build", "platform", "processor", "points"})
    if (!provenance->contains(key) || !(*provenance)[key].is_string()) return false;
  return rows->size() <= kMostRows && std::all_of(rows->begin(), rows->end(), [](const Json& row) {
           return row.is_object() && row.contains("volume") && row["volume"].is_string() && row.contains("algorithm") &&
                  row["algorithm"].is_string();
         });
}

}  // namespace

std::string missing_of(const lesson::Sheet& sheet, const SheetWork& work) {
  std::size_t missing = 0;
  for (const lesson::Measured& one : sheet.measured) missing += work.measured.count(one.id) == 0;
  for (std::size_t task = 0; task < sheet.lesson.tasks.size(); ++task) missing += work.built.count(task) == 0;
  for (const lesson::Written& one : sheet.written) {
    const auto answer = work.written.find(one.id);
    missing += answer == work.written.end() || answer->second.empty();
  }
  const std::size_t all = sheet.measured.size() + sheet.lesson.tasks.size() + sheet.written.size();
  if (missing == 0) return {};
  return std::to_string(missing) + " of " + std::to_string(all) +
         (missing == 1 ? " parts is missing." : " parts are missing.");
}

Json json_of(const std::string& id, std::uint64_t hash, const SheetWork& work) {
  Json json{{"sheet", id},
            {"hash", hex_of(hash)},
            {"written", Json::object()},
            {"measured", Json::object()},
            {"built", Json::object()}};
  for (const auto& [part, text] : work.written) json["written"][part] = text;
  for (const auto& [part, one] : work.measured) json["measured"][part] = {{"date", one.date}, {"table", one.table}};
  for (const auto& [task, rows] : work.built)
    json["built"][std::to_string(task + 1)] = text_of(lesson::Made{.hints = 0, .tries = {}, .built = rows});
  return json;
}

tl::expected<ClaimedSheet, std::string> sheet_of(const Json& json) {
  const auto wrong = [](const std::string& what) { return tl::unexpected<std::string>(what); };
  if (!json.is_object()) return wrong("a sheet is no object");
  const Json *const id = value_at(json, "sheet"), *const hash = value_at(json, "hash");
  if (id == nullptr || !id->is_string()) return wrong("\"sheet\" is no text");
  if (hash == nullptr || !hash->is_string()) return wrong("\"hash\" is no text");
  ClaimedSheet claimed{id->get<std::string>(), hash->get<std::string>(), {}};
  const Json writings = object_at(json, "written"), tables = object_at(json, "measured"),
             examples = object_at(json, "built");
  for (const auto& [part, text] : writings.items()) {
    if (!text.is_string()) return wrong("the answer \"" + part + "\" is no text");
    claimed.work.written[part] = shortened(text.get<std::string>());
  }
  for (const auto& [part, one] : tables.items()) {
    const Json *const date = value_at(one, "date"), *const table = value_at(one, "table");
    if (date == nullptr || !date->is_string() || table == nullptr || !is_table(*table))
      return wrong("what was measured as \"" + part + "\" is no table with its date");
    claimed.work.measured[part] = {date->get<std::string>(), *table};
  }
  for (const auto& [task, text] : examples.items()) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(task.data(), task.data() + task.size(), number);
    const auto made =
        text.is_string() ? lesson::made_of(text.get<std::string>()) : tl::unexpected(InputError{.what = "is no text"});
    if (error != std::errc() || end != task.data() + task.size() || number == 0 || !made || made->built.empty())
      return wrong("what was built as \"" + task + "\" is no example");
    claimed.work.built[number - 1] = made->built;
  }
  return claimed;
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &local);
  return text.data();
}

}  // namespace snug::desktop
