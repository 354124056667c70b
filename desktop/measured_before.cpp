#include "desktop/measured_before.hpp"

#include <optional>
#include <utility>
#include <vector>

#include "desktop/cli/cost_text.hpp"
#include "lesson/figures.hpp"
#include "lesson/say.hpp"

namespace snug::desktop {
namespace {

constexpr const char* kUnknown = "–";

/// The value of a key; null where there is none.
Json at(const Json& json, const char* key) {
  const auto found = json.is_object() ? json.find(key) : json.end();
  return json.is_object() && found != json.end() ? *found : Json();
}

std::string words_at(const Json& json, const char* key) {
  const Json value = at(json, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

std::string number_at(const Json& json, const char* key, double times, const char* unit) {
  const Json value = at(json, key);
  return value.is_number() ? lesson::number_text(times * value.get<double>(), 3) + unit : kUnknown;
}

std::string time_at(const Json& row, const char* key) {
  const Json time = at(row, key), median = at(time, "median");
  if (!median.is_number()) return kUnknown;
  return time_text(median.get<double>()) + (at(time, "trusted") == false ? ", not measured reliably" : "");
}

std::string spread_at(const Json& row, const char* key) { return number_at(at(row, key), "spread", 100, " %"); }

std::string bytes_of(const Json& row) {
  const Json bytes = at(row, "bytes");
  return bytes.is_number_integer() ? lesson::count_text(bytes.get<std::int64_t>()) : kUnknown;
}

}  // namespace

std::string measured_says(const MeasuredTable& measured) {
  const Json about = at(measured.table, "provenance");
  std::string says = "Measured on " + measured.date + ", on " + words_at(about, "points") + ", by ";
  const std::string processor = words_at(about, "processor");
  says += processor.empty() ? "an unknown processor" : processor;
  for (const char* key : {"platform", "build"})
    if (const std::string words = words_at(about, key); !words.empty()) says += ", " + words;
  return says + ". Measure again to replace it.";
}

app::WordTable measured_words(const MeasuredTable& measured) {
  const bool which = words_at(measured.table, "table") == "which";
  app::WordTable words;
  words.head = which ? std::vector<std::string>{"Volume", "Test",   "Spread", "Looseness",
                                                "Build",  "Spread", "Bytes",  "False pos."}
                     : std::vector<std::string>{"Algorithm", "Time", "Spread", "Bytes", "Times the hull"};
  for (const Json& row : at(measured.table, "rows")) {
    std::vector<std::string>& cells = words.rows.emplace_back();
    cells.push_back(lesson::title_among_volumes(words_at(row, "volume"), words_at(row, "algorithm")));
    if (which)
      for (std::string& cell : std::vector<std::string>{time_at(row, "test_ns"), spread_at(row, "test_ns"),
                                                        number_at(row, "over_hull", 1, ""), time_at(row, "build_ns"),
                                                        spread_at(row, "build_ns"), bytes_of(row),
                                                        number_at(row, "false_positives", 100, " %")})
        cells.push_back(std::move(cell));
    else
      for (std::string& cell : std::vector<std::string>{time_at(row, "time_ns"), spread_at(row, "time_ns"),
                                                        bytes_of(row), number_at(row, "over_hull", 1, "")})
        cells.push_back(std::move(cell));
  }
  return words;
}

}  // namespace snug::desktop
