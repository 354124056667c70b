// The controls beside the cost charts: buttons, the table in words, files, and earlier results.
#include <algorithm>
#include <cstdio>

#include "app/subjects/cost/charts.hpp"
#include "app/subjects/cost/costs.hpp"
#include "lesson/subjects/cost/cost.hpp"
#include "measure/growth.hpp"
#include "measure/turn_run.hpp"

namespace snug::app {
namespace {

constexpr std::array<std::string_view, 2> kFormats{"csv", "json"};
/// The beginning of a result file, before the name of its table.
constexpr std::string_view kTable = "# snug table: ";

std::string count(double number) { return chart_figure(ChartUnit::kCount, number); }

std::string two_digits(double number) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", number);
  return text.data();
}

std::string time_of(const cost::Timing& timing) {
  return chart_figure(ChartUnit::kTime, timing.median) + (timing.trusted ? "" : ", not measured reliably");
}

std::string percent_of(const std::optional<cost::SlackRange>& range, double cost::SlackRange::*end) {
  return range ? chart_figure(ChartUnit::kPercent, (*range).*end) : "not known";
}

/// A line in words: its least and greatest looseness.
std::vector<std::string> words_of(std::span<const cost::TurnRow> line) {
  const auto range = cost::slack_range(line);
  return {update_title(line[0].volume, line[0].strategy), percent_of(range, &cost::SlackRange::least),
          percent_of(range, &cost::SlackRange::most),
          line[0].updated.median > 0 ? time_of(line[0].updated) : "not measured"};
}

WordTable table_of(std::vector<std::string> head, const auto& rows) {
  WordTable table{std::move(head), {}};
  for (const auto& row : rows) table.rows.push_back(words_of(row));
  return table;
}

/// Each line in words: its last point and its power.
WordTable growth_table(const std::vector<cost::GrowthRow>& rows) {
  WordTable table{{"Algorithm", "Most points", "Time for these", "Power of n", "In theory"}, {}};
  for (const std::span<const cost::GrowthRow> line : lines_of(rows)) {
    const cost::GrowthRow& last = line.back();
    const std::string theory = theory_words(last);
    table.rows.push_back({growth_title(rows, last),
                          count(last.points) + (last.stopped.empty() ? "" : ": ") + last.stopped, time_of(last.time),
                          last.exponent ? two_digits(*last.exponent) : std::string(cost::kTooFewToTell),
                          last.theory + (theory.empty() ? "" : ", ") + theory});
  }
  return table;
}

WordTable accuracy_table(const std::vector<cost::CostRow>& rows) {
  WordTable table{
      {"Algorithm", "Time", "Spread", "Bytes", "Times " + std::string(accuracy_against(rows)), "On the front"}, {}};
  for (const cost::CostRow& row : rows) {
    const AccuracyWords words = accuracy_words(rows, row);
    const std::string on = row.points < row.of ? ", on " + count(row.points) + " of " + count(row.of) + " points" : "";
    table.rows.push_back({words.title, time_of(row.time) + on,
                          row.time.spread ? lesson::number_text(100 * *row.time.spread, 2) + " %" : "none",
                          lesson::count_text(row.bytes),
                          words.size ? chart_figure(ChartUnit::kRatio, *words.size) : "not known",
                          row.on_front ? "yes" : "no"});
  }
  return table;
}

template <class Row>
tl::expected<void, InputError> lay_over_as(Costs& costs, const lesson::Session& session, std::string_view text,
                                           std::string_view name) {
  auto table = cost::read_csv<Row>(text, name);
  if (!table) return tl::unexpected(std::move(table.error()));
  if (!costs.lay_over(session, *std::move(table)))
    return tl::unexpected(InputError{.what = std::string(kPredictFirst)});
  return {};
}

}  // namespace

std::vector<CoverButton> Costs::choices(const lesson::Session& session) const {
  std::vector<CoverButton> buttons;
  for (std::size_t i = 0; i < kCostViewNames.size(); ++i) {
    const auto view = static_cast<CostView>(i);
    buttons.push_back({"show_" + std::string(kCostViewNames[i]), std::string(kCostViewTitles[i]), view == view_,
                       may_see(session, view)});
  }
  return buttons;
}

std::array<CoverButton, 2> Costs::work_buttons(const lesson::Session& session) const {
  return {CoverButton{"measure", "Measure", false, !running() && session.conversation().asked() == nullptr},
          CoverButton{"stop_measuring", "Stop", false, running()}};
}

WordTable Costs::table(const lesson::Session&) const {
  if (view_ == CostView::kGrowth) return growth_table(growth().rows);
  if (view_ == CostView::kTurn)
    return table_of({"Update", "Least looseness", "Most looseness", "Time of one"}, lines_of(turn().rows));
  return accuracy_table(accuracy().rows);
}

bool Costs::decided(const lesson::Session& session) const { return lesson::costs_of(session) != nullptr; }

std::span<const std::string_view> Costs::formats() const { return kFormats; }

std::string Costs::file_name() const {
  const auto view = static_cast<std::size_t>(view_);
  return "snug-" + (view_ == CostView::kAccuracy ? "costs" : std::string(kCostViewNames[view]));
}

std::string Costs::file(std::string_view format) const {
  if (sheet().rows() == 0) return {};
  return format == "csv" ? sheet().csv() : sheet().json();
}

std::optional<tl::expected<void, InputError>> Costs::lay_over(lesson::Session& session, std::string_view text,
                                                              std::string_view name) {
  if (!text.starts_with(kTable)) return std::nullopt;
  const std::string_view table = text.substr(kTable.size(), text.find_first_of("\r\n") - kTable.size());
  if (table == cost::GrowthRow::kTable) return lay_over_as<cost::GrowthRow>(*this, session, text, name);
  if (table == cost::TurnRow::kTable) return lay_over_as<cost::TurnRow>(*this, session, text, name);
  return lay_over_as<cost::CostRow>(*this, session, text, name);
}

}  // namespace snug::app
