// What accuracy costs on the session's points: measured in slices between the frames, shown as a chart on the stage.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"
#include "app/chart.hpp"
#include "measure/cost_run.hpp"
#include "measure/report.hpp"

namespace snug::app {

using CostTable = cost::Table<cost::CostRow>;

class Costs {
 public:
  explicit Costs(const Platform& platform);
  Costs(const Costs&) = delete;  // the run points into it
  Costs& operator=(const Costs&) = delete;

  /// Of a session that was just opened.
  void open();
  /// A file's points. Of more than the stage can hold it shows some, and all of them are measured. Errors: as of
  /// Session::load; more than kMostMeasured.
  tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file, std::string_view name);
  /// An earlier result, to lie over the present one.
  void lay_over(CostTable then);

  /// Names: measure stop_measuring toggle_chart chart_next chart_previous chart_load. false: it cannot be done now.
  bool command(lesson::Session& session, std::string_view name);
  /// Goes on for so many nanoseconds, or one piece that cannot be cut.
  void work(lesson::Session& session, double budget);

  [[nodiscard]] bool running() const { return run_ != nullptr; }
  /// From 0 to 1.
  [[nodiscard]] double progress() const { return run_ != nullptr ? run_->progress() : 1; }
  [[nodiscard]] const CostTable& table() const { return table_; }
  [[nodiscard]] const CostTable* then() const { return then_ ? &*then_ : nullptr; }
  /// How many points are measured.
  [[nodiscard]] Index size(const lesson::Session& session) const;
  /// Changes with whatever the chart shows, and with each per cent of progress.
  [[nodiscard]] int version() const { return version_; }

  /// Whether the chart stands on the stage, in the place of the points.
  [[nodiscard]] bool shown() const { return shown_; }
  void show(bool on) { shown_ = on, ++version_; }
  /// In the current pane.
  void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence);
  [[nodiscard]] std::string caption(const lesson::Session& session) const;
  /// The marks, by their algorithms' names.
  [[nodiscard]] std::vector<Handle> handles() const;

 private:
  void start(const lesson::Session& session);
  void finish(lesson::Session& session);
  void take_rows();
  [[nodiscard]] bool load_algorithm(lesson::Session& session);
  void move_focus(int by);

  cost::Clock clock_;
  cost::CostOptions options_;
  std::optional<AnyPointSet> whole_, some_;  // a large file's points, and those of them that the session has
  std::optional<AnyPointSet> subject_, at_start_;  // of the run: its points, and the session's
  std::unique_ptr<cost::CostRun> run_;
  CostTable table_;
  std::optional<CostTable> then_;
  Chart chart_;
  std::vector<std::optional<ChartPlace>> places_;  // of the rows, as drawn
  int focus_ = -1;                                // a row
  std::string refused_;                           // why it could not be loaded
  bool shown_ = false;
  int version_ = 0, percent_ = 0;
};

/// More points are refused: measuring would need memory that not every machine has.
inline constexpr Index kMostMeasured = 2'000'000;

}  // namespace snug::app
