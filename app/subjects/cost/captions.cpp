#include "app/subjects/cost/captions.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "app/chart.hpp"
#include "app/subjects/cost/charts.hpp"
#include "measure/cost_run.hpp"
#include "measure/growth.hpp"
#include "measure/turn_run.hpp"

namespace snug::app {
namespace {

template <class... Values>
std::string phrase(const char* format, Values... values) {
  std::array<char, 256> text{};
  std::snprintf(text.data(), text.size(), format, values...);
  return text.data();
}

std::string figure(ChartUnit unit, double value) { return chart_figure(unit, value); }
std::string time(double ns) { return figure(ChartUnit::kTime, ns); }

double most_slack(std::span<const cost::TurnRow> line) {
  return cost::slack_range(line).value_or(cost::SlackRange{}).most;
}

/// The row of a point on a chart's line. The line has only rows with known looseness.
const cost::TurnRow& row_at(std::span<const cost::TurnRow> line, std::size_t point) {
  for (const cost::TurnRow& row : line)
    if (row.slack && point-- == 0) return row;
  return line.back();
}

/// The sentence about the updates that are always tight.
std::string tight_caption(const std::vector<std::span<const cost::TurnRow>>& lines, int tight) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const auto& line : lines) {
    const double own = line[0].updated.median;
    if (always_tight(line) && own > 0) least = std::min(least, own), most = std::max(most, own);
  }
  if (most == 0) return phrase("%d updates are as tight as can be at every angle.", tight);
  return phrase("%d updates are as tight as can be at every angle; one takes %s to %s.", tight, time(least).c_str(),
                time(most).c_str());
}

int count_tight(const std::vector<std::span<const cost::TurnRow>>& lines) {
  return static_cast<int>(std::count_if(lines.begin(), lines.end(), always_tight));
}

}  // namespace

std::string measuring_caption(int done, int all) {
  if (all > 0 && done == all)
    return "All are measured once. Each is measured again in turn, so that a slow moment falls on all alike.";
  return all > 0 ? phrase("Measuring: %d of %d algorithms are done.", done, all)
                 : phrase("Measuring: %d updates are done.", done);
}

std::string accuracy_caption(const cost::Table<cost::CostRow>& table, const cost::CostRow& row) {
  const AccuracyWords words = accuracy_words(table.rows, row);
  std::string size, part;
  if (words.size) size = ", " + figure(ChartUnit::kRatio, *words.size) + " times " + std::string(words.against);
  if (row.points < row.of)
    part = phrase(", on %d of %d points", static_cast<int>(row.points), static_cast<int>(row.of));
  return phrase("%s: %s%s%s; %son the front%s.", words.title.c_str(), time(row.time.median).c_str(), size.c_str(),
                part.c_str(), row.on_front ? "" : "not ", cost::is_tied(table.rows, row) ? ", tied with another" : "");
}

std::string accuracy_caption(const cost::Table<cost::CostRow>& table) {
  const auto front =
      std::count_if(table.rows.begin(), table.rows.end(), [](const cost::CostRow& row) { return row.on_front; });
  const auto slow =
      std::find_if(table.rows.begin(), table.rows.end(), [](const cost::CostRow& row) { return row.points < row.of; });
  const std::string left_out =
      slow == table.rows.end()
          ? ""
          : phrase(slow->whole_ns ? " %s was too slow here to measure on all points, and is left out of the front."
                                  : " %s is stopped by its own limit on so many points, and is left out of the front.",
                   algorithm_title(slow->volume, slow->algorithm).c_str());
  const bool doubtful = std::any_of(table.rows.begin(), table.rows.end(),
                                    [](const cost::CostRow& row) { return row.points == row.of && !row.time.trusted; });
  return phrase("%d of %d %s on the front%s.%s Choose a mark to load its volume.", static_cast<int>(front),
                static_cast<int>(table.rows.size()), front == 1 ? "lies" : "lie",
                doubtful ? ", as far as the times can be trusted" : "", left_out.c_str());
}

std::string growth_caption(const cost::Table<cost::GrowthRow>& table, int line, std::size_t point) {
  const auto own = lines_of(table.rows)[line];
  const cost::GrowthRow& row = own[std::min(point, own.size() - 1)];
  const bool last = point + 1 >= own.size() && !row.stopped.empty();
  const bool too_few = !row.exponent && is_fitted(own);
  const std::string theory = too_few ? std::string(cost::kTooFewToTell) : theory_words(row);
  return phrase("%s: %s points, %s.%s%s%s%s%s%s", growth_title(table.rows, row).c_str(),
                figure(ChartUnit::kCount, static_cast<double>(row.points)).c_str(), time(row.time.median).c_str(),
                theory.empty() ? "" : " ", theory.empty() ? "" : row.theory.c_str(), theory.empty() ? "" : ", ",
                theory.c_str(), theory.empty() ? "" : ".",
                last ? phrase(" The line ends there: %s.", row.stopped.c_str()).c_str() : "");
}

std::string growth_caption(const cost::Table<cost::GrowthRow>& table, double longest) {
  const auto lines = lines_of(table.rows);
  const auto ended = [&](std::string_view why) {
    return static_cast<int>(
        std::count_if(lines.begin(), lines.end(), [&](auto line) { return line[0].stopped == why; }));
  };
  const std::string limits = own_limits(table.rows);
  const auto limited = static_cast<int>(
      std::count_if(lines.begin(), lines.end(), [](auto line) { return ends_at_own_limit(line.back()); }));
  const int all = static_cast<int>(lines.size()), whole = ended("");
  const char* const why = ended("stopped") > 0 ? ", or where you stopped it."
                          : longest < 1e9      ? ": a longer run would hold up the page."
                                               : ".";
  if (limited > 0 && whole + limited == all)
    return phrase("%d of %d %s measured to the end.", whole, all, whole == 1 ? "is" : "are") + limits;
  if (whole + limited == 0)
    return phrase("All lines end where one run would take over %s%s", time(longest).c_str(), why);
  if (whole == all) return "All are measured to the end. The steeper the line, the faster the time grows.";
  return phrase("%d of %d %s measured to the end; the others end where one run would take over %s%s", whole, all,
                whole == 1 ? "is" : "are", time(longest).c_str(), why) +
         (limited > 0 ? " But" + limits : "");
}

std::string turn_caption(const cost::Table<cost::TurnRow>& table, int line, std::size_t point) {
  const auto lines = lines_of(table.rows);
  const auto own = lines[line];
  const cost::TurnRow& row = row_at(own, point);
  if (const int tight = count_tight(lines); tight > 1 && always_tight(own)) return tight_caption(lines, tight);
  return phrase(
      "%s, at %s: %s larger than the tightest.%s", update_title(row.volume, row.strategy).c_str(),
      figure(ChartUnit::kDegrees, row.degrees).c_str(), figure(ChartUnit::kPercent, row.slack.value_or(0)).c_str(),
      row.updated.median > 0 ? phrase(" One update takes %s.", time(row.updated.median).c_str()).c_str() : "");
}

std::string turn_caption(const cost::Table<cost::TurnRow>& table) {
  const auto lines = lines_of(table.rows);
  const auto loosest =
      *std::max_element(lines.begin(), lines.end(), [](auto a, auto b) { return most_slack(a) < most_slack(b); });
  const int tight = count_tight(lines);
  return phrase("%d of %d updates %s. The loosest is up to %s larger: %s.", tight, static_cast<int>(lines.size()),
                tight == 1 ? "is always the tightest of its kind" : "are always the tightest of their kind",
                figure(ChartUnit::kPercent, most_slack(loosest)).c_str(),
                update_title(loosest[0].volume, loosest[0].strategy).c_str());
}

}  // namespace snug::app
