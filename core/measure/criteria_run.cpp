#include "measure/criteria_run.hpp"

#include <functional>
#include <memory>
#include <numeric>
#include <utility>

#include "fit/update/updates.hpp"
#include "geometry/about_origin.hpp"
#include "geometry/convert.hpp"
#include "measure/sample.hpp"

namespace snug::cost {
namespace {

constexpr int kTurnPoses = 64;  // of a full turn

template <int Dim>
Pose<double, Dim> pose_in(const Pose<double, 3>& pose) {
  return {pose.rotation.topLeftCorner<Dim, Dim>(), pose.translation.head<Dim>()};
}

/// Poses a volume through a full turn, or is empty for one that does not rotate with its body. What it makes is kept,
/// so that no compiler leaves the work out.
template <int Dim>
std::function<void()> turn_of(const fit::Volume3& lifted) {
  return std::visit(
      [](const auto& kind) -> std::function<void()> {
        const auto volume = converted<double, Dim>(kind);
        using Kind = std::remove_const_t<decltype(volume)>;
        if constexpr (kRotatesWithBody<Kind>) {
          std::vector<Pose<double, Dim>> poses;
          for (const Pose<double, 3>& pose : full_turn(Dim, kTurnPoses)) poses.push_back(pose_in<Dim>(pose));
          auto made = std::make_shared<std::vector<Kind>>(poses.size());
          return [volume, poses, made] {
            for (std::size_t i = 0; i < poses.size(); ++i) (*made)[i] = posed(volume, poses[i]);
          };
        } else {
          return {};
        }
      },
      lifted);
}

double total(const OperationCounts& counts) {
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::int64_t{1}));
}

/// The operations of an update, on average over a full turn.
double counted_update(const fit::UpdateStrategy& strategy, const AnyPointSet& points) {
  const fit::UpdateBody body = fit::start_updates(strategy, points);
  double sum = 0;
  for (const Pose<double, 3>& pose : full_turn(fit::dim_of(points), kTurnPoses)) sum += total(body(pose, {}).counts);
  return sum / kTurnPoses;
}

}  // namespace

CriteriaRun::CriteriaRun(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, bool still,
                         const CostOptions& options, Clock clock)
    : points_(points), algorithms_(std::move(algorithms)), still_(still), options_(options), clock_(std::move(clock)),
      costs_(points, algorithms_, options, clock_) {}

double CriteriaRun::progress() const {
  constexpr double kCosts = 0.8, kPasses = 0.1;  // the shares of the time, about
  if (done()) return 1;
  if (piece_ == 0) return kCosts * costs_.progress();
  return piece_ + 1 < kPieces ? kCosts : 1 - kPasses * (1 - (passes_ ? passes_->progress() : 0));
}

void CriteriaRun::step() {
  static constexpr std::array kAll{&CriteriaRun::measure_costs, &CriteriaRun::fit_volume, &CriteriaRun::take_update,
                                   &CriteriaRun::test_pair};
  static_assert(kAll.size() == kPieces);
  if (!done() && (this->*kAll[piece_])()) ++piece_;
}

bool CriteriaRun::measure_costs() {
  costs_.step();
  return costs_.done();
}

/// Fits the next volume to as many points as its costs were measured on.
bool CriteriaRun::fit_volume() {
  const std::size_t i = volumes_.size();
  const Index n = costs_.rows()[i].points;
  const AnyPointSet some = n < fit::count_of(points_) ? sample(points_, n, options_.fit.seed) : points_;
  volumes_.push_back(algorithms_[i]->fit(some, options_.fit).volume);
  return volumes_.size() == algorithms_.size();
}

bool CriteriaRun::take_update() {
  const std::size_t i = updates_.size();
  const CostRow& row = costs_.rows()[i];
  if (!watch_) {
    auto turn = fit::dim_of(points_) == 2 ? turn_of<2>(volumes_[i]) : turn_of<3>(volumes_[i]);
    if (!row.update && turn) {
      watch_.emplace(std::move(turn), options_.timing);
      return false;
    }
    updates_.push_back(row.updated);
    return updates_.size() == algorithms_.size();
  }
  watch_->step(clock_);
  if (!watch_->done()) return false;
  Timing timing = watch_->timing();
  timing.median /= kTurnPoses;
  timing.min /= kTurnPoses;
  updates_.push_back(timing);
  watch_.reset();
  return updates_.size() == algorithms_.size();
}

bool CriteriaRun::test_pair() {
  if (!passes_) passes_.emplace(points_, algorithms_, volumes_, still_, options_.fit.seed);
  passes_->step();
  if (!passes_->done()) return false;
  for (std::size_t i = 0; i < algorithms_.size(); ++i)
    rows_.push_back({costs_.rows()[i], updates_[i], passes_->rows()[i]});
  return true;
}

std::vector<CriteriaRow> counted_criteria(const AnyPointSet& points,
                                          const std::vector<const fit::Algorithm*>& algorithms, bool still,
                                          const fit::Options& options) {
  const int dim = fit::dim_of(points);
  const Rounding rounding = rounding_of(points);
  const double hull = fit::measure_of(fit::find_algorithm("hull", "quickhull")->fit(points, options).volume, dim);
  std::vector<CriteriaRow> rows;
  std::vector<fit::Volume3> volumes;
  for (const fit::Algorithm* algorithm : algorithms) {
    const fit::Watched watched = algorithm->watch(points, options, {});
    const fit::Volume3& volume = volumes.emplace_back(watched.result.volume);
    CostRow& row = rows.emplace_back().costs;
    row.volume = algorithm->volume;
    row.algorithm = algorithm->name;
    row.points = row.of = fit::count_of(points);
    row.time.median = total(watched.counts);
    row.size = fit::size_of(volume, dim);
    row.measure = fit::measure_of(volume, dim);
    row.noise = rounding.noise(dim);
    row.over_hull = rounding.ratio(row.measure, hull, dim);
    row.bytes = bytes_of(volume, dim, false);
    const fit::UpdateStrategy* const update = update_of(*algorithm);
    rows.back().update.median =
        update != nullptr ? counted_update(*update, points) : static_cast<double>(row.bytes) / sizeof(double);
  }
  FalsePositiveRun passes(points, algorithms, volumes, still, options.seed);
  while (!passes.done()) passes.step();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].passes = passes.rows()[i];
    const double tests = static_cast<double>(rows[i].passes.tests) / FalsePositiveRun::kPairs;
    rows[i].costs.overlap.median = tests * 2 * static_cast<double>(rows[i].costs.bytes) / sizeof(double);
  }
  return rows;
}

}  // namespace snug::cost
