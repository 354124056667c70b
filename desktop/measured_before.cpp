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

std::string scaled_at(const Json& json, const char* key, double times, const char* unit) {
  const auto value = number_at(json, key);
  return value ? lesson::number_text(times * *value, 3) + unit : kUnknown;
}

std::string time_at(const Json& row, const char* key) {
  const Json* const time = value_at(row, key);
  const auto median = time != nullptr ? number_at(*time, "median") : std::nullopt;
  if (!median) return kUnknown;
  const Json* const trusted = value_at(*time, "trusted");
  return time_text(*median) + (trusted != nullptr && *trusted == false ? ", not measured reliably" : "");
}

std::string spread_at(const Json& row, const char* key) {
  const Json* const time = value_at(row, key);
  return time != nullptr ? scaled_at(*time, "spread", 100, " %") : kUnknown;
}

std::string bytes_of(const Json& row) {
  const Json* const bytes = value_at(row, "bytes");
  return bytes != nullptr && bytes->is_number_integer() ? lesson::count_text(bytes->get<std::int64_t>()) : kUnknown;
}

}  // namespace

std::string measured_says(const MeasuredTable& measured) {
  const Json& about = measured.table["provenance"];
  std::string says = "Measured on " + measured.date + ", on " + text_at(about, "points") + ", by ";
  const std::string processor = text_at(about, "processor");
  says += processor.empty() ? "an unknown processor" : processor;
  for (const char* key : {"platform", "build"})
    if (const std::string words = text_at(about, key); !words.empty()) says += ", " + words;
  return says + ". Measure again to replace it.";
}

app::WordTable measured_words(const MeasuredTable& measured) {
  const bool which = text_at(measured.table, "table") == "which";
  app::WordTable words;
  words.head = which ? std::vector<std::string>{"Volume", "Test",   "Spread", "Looseness",
                                                "Build",  "Spread", "Bytes",  "False pos."}
                     : std::vector<std::string>{"Algorithm", "Time", "Spread", "Bytes", "Times the hull"};
  for (const Json& row : measured.table["rows"]) {
    std::vector<std::string>& cells = words.rows.emplace_back();
    cells.push_back(lesson::title_among_volumes(text_at(row, "volume"), text_at(row, "algorithm")));
    if (which)
      for (std::string& cell : std::vector<std::string>{time_at(row, "test_ns"), spread_at(row, "test_ns"),
                                                        scaled_at(row, "over_hull", 1, ""), time_at(row, "build_ns"),
                                                        spread_at(row, "build_ns"), bytes_of(row),
                                                        scaled_at(row, "false_positives", 100, " %")})
        cells.push_back(std::move(cell));
    else
      for (std::string& cell : std::vector<std::string>{time_at(row, "time_ns"), spread_at(row, "time_ns"),
                                                        bytes_of(row), scaled_at(row, "over_hull", 1, "")})
        cells.push_back(std::move(cell));
  }
  return words;
}

}  // namespace snug::desktop
