// What accuracy costs on the session's points: measured in slices between the frames, shown as one of three charts on
// the stage: accuracy against time, time against the number of points, looseness over a turn.
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

/// The charts' names in commands ("show_growth") and as people say them, in CostView's order.
inline constexpr std::array<std::string_view, kCostViews> kCostViewNames{"accuracy", "growth", "turn"};
inline constexpr std::array<std::string_view, kCostViews> kCostViewTitles{"Accuracy", "Growth", "Looseness in a turn"};
/// Why the last two are not to be had before the predictions.
inline constexpr std::string_view kPredictFirst =
    "Answer the questions first: the other charts would give the answers away.";

/// Of one session, from when it is opened; an empty chart is shown at first, which is what the predictions are of.
class Costs final : public Cover {
 public:
  explicit Costs(const Platform& platform);
  ~Costs() override;

  /// Of more points than the stage can hold it shows some, and all of them are measured. Errors: also more points than
  /// kMostMeasured.
  tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file,
                                      std::string_view name) override;
  /// An earlier result, to lie over the present one, whose chart is shown then. Row: CostRow, GrowthRow or TurnRow.
  /// false: that chart is not to be had before the predictions.
  template <class Row>
  bool lay_over(const lesson::Session& session, cost::Table<Row> then);

  /// Names: measure stop_measuring toggle_chart chart_next chart_previous chart_up chart_down chart_load show_accuracy
  /// show_growth show_turn show_other. false: it cannot be done now.
  bool command(lesson::Session& session, std::string_view name) override;
  [[nodiscard]] std::string_view command_of_key(std::string_view key) const override;
  void work(lesson::Session& session, double budget) override;

  [[nodiscard]] bool running() const override { return at_work_.has_value(); }
  [[nodiscard]] double progress() const override { return at_work_ ? of(*at_work_).progress() : 1; }
  /// Which chart is shown, or would be, and its table.
  [[nodiscard]] CostView view() const { return view_; }
  [[nodiscard]] const CostSheet& sheet() const { return of(view_); }
  /// Whether this chart may be chosen: not before the predictions, of what they are about.
  [[nodiscard]] bool may_see(const lesson::Session& session, CostView view) const;
  [[nodiscard]] const CostTable& table() const;
  [[nodiscard]] const GrowthTable& growth() const;
  [[nodiscard]] const TurnTable& turn() const;
  /// How many points are measured, but of the growth, which has its own.
  [[nodiscard]] Index size(const lesson::Session& session) const;
  [[nodiscard]] int version() const override { return version_; }

  [[nodiscard]] bool shown() const override { return shown_; }
  void show(bool on) override { shown_ = on, ++version_; }
  [[nodiscard]] std::string_view button_words() const override { return shown_ ? "Shape" : "Chart"; }
  void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) override;
  [[nodiscard]] std::string caption(const lesson::Session& session) const override;
  /// What to do next, or what was measured: a line beside the buttons.
  [[nodiscard]] std::string status(const lesson::Session& session) const;
  /// The marks by their algorithms' names; of lines the last of each.
  [[nodiscard]] std::vector<Handle> handles() const override;

 private:
  [[nodiscard]] CostSheet& of(CostView view) const { return *sheets_[static_cast<std::size_t>(view)]; }
  void start(const lesson::Session& session);
  void start_accuracy(const lesson::Session& session, cost::Provenance about);
  void start_growth(const lesson::Session& session, cost::Provenance about);
  void start_turn(cost::Provenance about);
  void finish(lesson::Session& session);
  void take_rows();
  bool look_at(const lesson::Session& session, CostView view);
  [[nodiscard]] bool load_algorithm(lesson::Session& session);
  /// How many algorithms or updates the table that is shown has.
  [[nodiscard]] int count() const;
  [[nodiscard]] std::vector<ChartHit> stops(bool to_line) const;
  void move_focus(int by, bool to_line);
  [[nodiscard]] std::optional<ChartHit> focused() const;

  cost::Clock clock_;
  cost::Provenance here_;
  cost::CostOptions options_;
  double longest_growing_ = 0;
  std::optional<AnyPointSet> whole_, some_;        // a large file's points, and those of them that the session has
  std::optional<AnyPointSet> subject_, at_start_;  // of the run: its points, and the session's
  std::array<std::unique_ptr<CostSheet>, kCostViews> sheets_;
  std::optional<CostView> at_work_;
  CostView view_ = CostView::kAccuracy;
  Chart chart_;
  std::vector<ChartPlace> places_;  // of the chart's series, as drawn
  int focus_row_ = -1;              // a row of the table, or a line of the chart,
  std::size_t focus_point_ = 0;     // and a point of that
  std::string refused_;             // why it could not be loaded
  bool shown_ = true;
  int version_ = 0;
};

/// More points are refused: measuring would need memory that not every machine has.
inline constexpr Index kMostMeasured = 2'000'000;

/// The subject's name: of the lessons with the charts.
inline constexpr std::string_view kCostSubject = "cost";
[[nodiscard]] std::unique_ptr<Cover> cost_cover(const Platform& platform);
/// What is measured in the lesson that is open; null where it has another subject, and before the first open.
[[nodiscard]] Costs* costs_of(App& app);

}  // namespace snug::app
