// A table that is measured piece by piece, shown as a chart and saved as a file, with an earlier one over it.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "app/chart.hpp"
#include "measure/cost_run.hpp"
#include "measure/report.hpp"

namespace snug::app {

/// Which chart it is.
enum class CostView : std::uint8_t { kAccuracy, kGrowth, kTurn };
inline constexpr int kCostViews = 3;
/// Their names in commands ("show_growth") and as people say them.
inline constexpr std::array<std::string_view, kCostViews> kCostViewNames{"accuracy", "growth", "turn"};
inline constexpr std::array<std::string_view, kCostViews> kCostViewTitles{"Accuracy", "Growth", "Looseness in a turn"};

class CostSheet {
 public:
  virtual ~CostSheet() = default;
  /// Works for budget nanoseconds, or by one indivisible piece. Returns whether there are new rows.
  virtual bool work(const cost::Clock& clock, double budget) = 0;
  /// Progress from 0 to 1; 1 if nothing runs.
  [[nodiscard]] virtual double progress() const = 0;
  [[nodiscard]] virtual bool done() const = 0;
  /// Ends the run; the finished rows stay.
  virtual void stop() = 0;
  /// Discards the measurement and the earlier result.
  virtual void clear() = 0;
  [[nodiscard]] virtual std::size_t rows() const = 0;
  [[nodiscard]] virtual Chart chart() const = 0;
  /// The format of `snug cost`.
  [[nodiscard]] virtual std::string csv() const = 0;
  [[nodiscard]] virtual std::string json() const = 0;
  /// The provenance of the measurement.
  [[nodiscard]] virtual const cost::Provenance& about() const = 0;
  /// The provenance of the earlier result; null if there is none.
  [[nodiscard]] virtual const cost::Provenance* then() const = 0;
};

template <class Run, class Row>
class CostSheetOf final : public CostSheet {
 public:
  using Table = cost::Table<Row>;
  explicit CostSheetOf(Chart (*draw)(const Table&, const Table*)) : draw_(draw) {}

  void start(std::unique_ptr<Run> run, cost::Provenance about) {
    run_ = std::move(run);
    revision_ = 0;
    table = {std::move(about), {}};
  }
  void lay_over(Table earlier) { then_ = std::move(earlier); }

  bool work(const cost::Clock& clock, double budget) override {
    cost::advance(*run_, clock, budget);
    const int before = std::exchange(revision_, cost::revision_of(*run_));
    return revision_ != before && (take(), true);
  }
  [[nodiscard]] double progress() const override { return run_ != nullptr ? run_->progress() : 1; }
  [[nodiscard]] bool done() const override { return run_ == nullptr || run_->done(); }
  void stop() override {
    if (run_ == nullptr) return;
    run_->stop();
    take();
    run_.reset();
  }
  void clear() override { run_.reset(), table = {}, then_.reset(); }
  [[nodiscard]] std::size_t rows() const override { return table.rows.size(); }
  [[nodiscard]] Chart chart() const override { return draw_(table, then_ ? &*then_ : nullptr); }
  [[nodiscard]] std::string csv() const override {
    return cost::csv_of(table.provenance, std::span<const Row>(table.rows));
  }
  [[nodiscard]] std::string json() const override {
    return cost::json_of(table.provenance, std::span<const Row>(table.rows));
  }
  [[nodiscard]] const cost::Provenance& about() const override { return table.provenance; }
  [[nodiscard]] const cost::Provenance* then() const override { return then_ ? &then_->provenance : nullptr; }

  Table table;  // the finished rows

 private:
  void take() {
    table.rows = run_->rows();
    if constexpr (std::is_same_v<Row, cost::CostRow>) cost::mark_front(table.rows);
  }

  Chart (*draw_)(const Table&, const Table*);
  std::unique_ptr<Run> run_;
  int revision_ = 0;  // of the run's rows
  std::optional<Table> then_;
};

}  // namespace snug::app
