// What accuracy costs on the session's points: measured in slices between frames, and shown as one of three charts on
// the stage: accuracy against time, time against the number of points, looseness over a full turn.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cover.hpp"
#include "app/subjects/cost/sheet.hpp"

namespace snug::app {

using CostTable = cost::Table<cost::CostRow>;
using GrowthTable = cost::Table<cost::GrowthRow>;
using TurnTable = cost::Table<cost::TurnRow>;

/// Why the last two charts are not available before the predictions.
inline constexpr std::string_view kPredictFirst =
    "Answer the questions first: the other charts would give the answers away.";

/// The costs of one session, from when it is opened. At first an empty chart is shown, for the predictions.
class Costs final : public Cover {
 public:
  explicit Costs(const Platform& platform);
  ~Costs() override;

  /// If there are more points than the stage can show, it shows some, but all are measured. Errors: also more points
  /// than kMostMeasured.
  tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file,
                                      std::string_view name) override;
  /// Shows an earlier result over the current one, and that chart. Row: CostRow, GrowthRow or TurnRow. Returns false if
  /// that chart is not available before the predictions.
  template <class Row>
  bool lay_over(const lesson::Session& session, cost::Table<Row> then);

  /// Names: measure stop_measuring toggle_chart chart_next chart_previous chart_up chart_down chart_load show_accuracy
  /// show_growth show_turn show_other. Returns false if the command is impossible now.
  bool command(lesson::Session& session, std::string_view name) override;
  [[nodiscard]] std::string_view command_of_key(std::string_view key) const override;
  void work(lesson::Session& session, double budget) override;

  [[nodiscard]] bool running() const override { return at_work_.has_value(); }
  [[nodiscard]] double progress() const override { return at_work_ ? of(*at_work_).progress() : 1; }
  /// The chart that is selected, and its table.
  [[nodiscard]] CostView view() const { return view_; }
  [[nodiscard]] const CostSheet& sheet() const { return of(view_); }
  /// Whether this chart may be chosen: before the predictions, only the first.
  [[nodiscard]] bool may_see(const lesson::Session& session, CostView view) const;
  [[nodiscard]] const CostTable& accuracy() const;
  [[nodiscard]] const GrowthTable& growth() const;
  [[nodiscard]] const TurnTable& turn() const;
  /// How many points are measured, except for growth, which has its own points.
  [[nodiscard]] Index size(const lesson::Session& session) const;
  [[nodiscard]] int version() const override { return version_; }

  [[nodiscard]] bool shown() const override { return shown_; }
  void show(bool on) override { shown_ = on, ++version_; }
  [[nodiscard]] CoverButton button() const override { return {"toggle_chart", shown_ ? "Shape" : "Chart"}; }
  void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) override;
  [[nodiscard]] std::string caption(const lesson::Session& session) const override;
  [[nodiscard]] std::vector<CoverButton> choices(const lesson::Session& session) const override;
  [[nodiscard]] std::array<CoverButton, 2> work_buttons(const lesson::Session& session) const override;
  [[nodiscard]] std::string status(const lesson::Session& session) const override;
  [[nodiscard]] WordTable table(const lesson::Session&) const override;
  [[nodiscard]] bool decided(const lesson::Session& session) const override;
  /// The formats of `snug cost`.
  [[nodiscard]] std::span<const std::string_view> formats() const override;
  [[nodiscard]] std::string file_name() const override;
  [[nodiscard]] std::string file(std::string_view format) const override;
  [[nodiscard]] const Chart* picture() const override { return &chart_; }
  std::optional<tl::expected<void, InputError>> lay_over(lesson::Session& session, std::string_view text,
                                                         std::string_view name) override;
  /// The marks, named by algorithm; for lines, the last mark of each.
  [[nodiscard]] std::vector<Handle> handles() const override;

 private:
  [[nodiscard]] CostSheet& of(CostView view) const { return *sheets_[static_cast<std::size_t>(view)]; }
  /// Why these points cannot be measured by every algorithm of the chart that is seen; empty if they can.
  [[nodiscard]] std::string not_for_these(const lesson::Session& session) const;
  void start(const lesson::Session& session);
  void start_accuracy(const lesson::Session& session, cost::Provenance about);
  void start_growth(const lesson::Session& session, cost::Provenance about);
  void start_turn(cost::Provenance about);
  void finish(lesson::Session& session);
  void take_rows();
  bool look_at(const lesson::Session& session, CostView view);
  [[nodiscard]] bool load_algorithm(lesson::Session& session);
  [[nodiscard]] bool started_on_these(const lesson::Session& session, CostView view) const;
  /// How many algorithms or updates the selected table has.
  [[nodiscard]] int count() const;
  [[nodiscard]] std::vector<ChartHit> stops(bool to_line) const;
  void move_focus(int by, bool to_line);
  [[nodiscard]] std::optional<ChartHit> focused() const;

  cost::Clock clock_;
  cost::Provenance here_;
  cost::CostOptions options_;
  double longest_growing_ = 0;
  std::optional<AnyPointSet> whole_, some_;  // a large file's points, and the part of them in the session
  std::optional<AnyPointSet> subject_;       // the points of the run
  std::array<std::optional<AnyPointSet>, kCostViews> at_start_;  // the session's points when each chart's run started
  std::array<std::unique_ptr<CostSheet>, kCostViews> sheets_;
  std::optional<CostView> at_work_;
  CostView view_ = CostView::kAccuracy;
  Chart chart_;
  std::vector<ChartPlace> places_;  // where the chart's series were drawn
  int focus_row_ = -1;              // a row of the table, or a line of the chart,
  std::size_t focus_point_ = 0;     // and a point of that
  std::string refused_;             // why it could not be loaded
  bool shown_ = true;
  int version_ = 0;
};

/// More points are refused, because measuring them needs memory that not every machine has.
inline constexpr Index kMostMeasured = 2'000'000;

[[nodiscard]] std::unique_ptr<Cover> cost_cover(const Platform& platform);

}  // namespace snug::app
