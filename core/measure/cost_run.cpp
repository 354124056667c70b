#include "measure/cost_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "fit/hull/quickhull.hpp"
#include "fit/lift.hpp"
#include "fit/update/updates.hpp"
#include "geometry/tolerance.hpp"
#include "geometry/turn.hpp"
#include "measure/pareto.hpp"
#include "measure/sample.hpp"

namespace snug::cost {
namespace {

/// The number of poses in a full turn: each update follows one a few degrees before it, as from frame to frame.
constexpr int kPoses = 64;

}  // namespace

const fit::UpdateStrategy* update_of(const fit::Algorithm& algorithm) {
  if (algorithm.volume == "aabb") return fit::find_update("aabb", "hill_climb");
  if (algorithm.volume == "kdop") return fit::find_update("kdop", std::string(algorithm.name) + "_hill_climb");
  return fit::find_update(algorithm.volume, "transform");
}

CostRun::CostRun(const AnyPointSet& points, std::vector<const fit::Algorithm*> algorithms, const CostOptions& options,
                 Clock clock)
    : points_(points), algorithms_(std::move(algorithms)), options_(options), clock_(std::move(clock)),
      dim_(fit::dim_of(points)), single_(points.index() >= 2), rounds_(options.timing, clock_) {}

double CostRun::progress() const {
  if (done()) return 1;
  constexpr double kPieces = 8, kFirst = 0.5;  // the share of the first times
  const double rows =
      (static_cast<double>(at_) + static_cast<double>(piece_) / kPieces) / static_cast<double>(algorithms_.size());
  return kFirst * rows + (at_ < algorithms_.size() ? 0 : (1 - kFirst) * rounds_.progress());
}

void CostRun::step() {
  static constexpr std::array kPieces{&CostRun::climb,
                                      &CostRun::time_fit,
                                      &CostRun::count,
                                      &CostRun::compare_with_hull,
                                      &CostRun::compare_with_smallest,
                                      &CostRun::time_near,
                                      &CostRun::time_in_scene,
                                      &CostRun::time_update};
  if (done()) return;
  if (at_ == algorithms_.size()) return next_batch();
  if (!(this->*kPieces[piece_])()) return;
  started_ = false;
  if (++piece_ < kPieces.size()) return;
  rows_.push_back(std::exchange(row_, {}));
  piece_ = 0;
  ++at_;
}

const AnyPointSet& CostRun::points_of(Index n) {
  if (n == fit::count_of(points_)) return points_;
  auto& kept = samples_[n];
  if (!kept) kept = std::make_unique<AnyPointSet>(sample(points_, n, options_.fit.seed));
  return *kept;
}

Ladder& CostRun::ladder_of(const fit::Algorithm& algorithm) {
  return ladders_.try_emplace(&algorithm, algorithm, fit::count_of(points_)).first->second;
}

bool CostRun::step_up(Ladder& ladder) {
  if (!ladder.done())
    ladder.step(
        clock_, [this](Index n) -> const AnyPointSet& { return points_of(n); }, options_.fit, options_.limits);
  return ladder.done();
}

const fit::Volume3& CostRun::fitted(const fit::Algorithm& algorithm) {
  const auto [place, is_new] = fitted_.try_emplace({&algorithm, row_.points});
  if (is_new) place->second = algorithm.fit(points_of(row_.points), options_.fit).volume;
  return place->second;
}

/// On a busy machine, or after a single run, times seem to grow far too steeply, so the extrapolation is limited to the
/// theory's bound.
double CostRun::whole_time(const Ladder& ladder) const {
  const double foreseen = ladder.foreseen_at(row_.of);
  const auto work = fit::work_of(algorithm().theory, fit::dim_of(points_));
  if (work == nullptr) return foreseen;
  return std::min(foreseen, ladder.time() * work(row_.of) / work(row_.points));
}

bool CostRun::climb() {
  Ladder& ladder = ladder_of(algorithm());
  if (!step_up(ladder)) return false;
  row_.volume = algorithm().volume;
  row_.algorithm = algorithm().name;
  row_.points = ladder.reached();
  row_.of = fit::count_of(points_);
  const bool stopped = algorithm().most_finished < algorithm().max_points && row_.points == algorithm().most_finished;
  if (row_.points < row_.of && !stopped) row_.whole_ns = whole_time(ladder);
  return true;
}

void CostRun::start(Timing CostRow::*timing, std::function<void()> run, int parts) {
  rounds_.add(std::move(run));
  timed_.push_back({timing, parts, {at_}});
  started_ = true;
}

bool CostRun::go_on() {
  if (!rounds_.start_last()) return false;
  row_.*timed_.back().timing = rounds_.timing(timed_.size() - 1, timed_.back().parts);
  return true;
}

/// The rows follow the rounds: within one they stay as they are.
void CostRun::next_batch() {
  const int before = rounds_.round();
  rounds_.step();
  if (rounds_.round() == before && !rounds_.done()) return;
  for (std::size_t i = 0; i < timed_.size(); ++i)
    for (const std::size_t row : timed_[i].rows) rows_[row].*timed_[i].timing = rounds_.timing(i, timed_[i].parts);
}

bool CostRun::time_fit() {
  const fit::Algorithm* const own = &algorithm();
  const AnyPointSet* const set = &points_of(row_.points);
  if (!started_)
    start(
        &CostRow::time, [this, own, set] { (void)own->fit(*set, options_.fit); }, 1);
  return go_on();
}

bool CostRun::count() {
  const fit::Watched watched = algorithm().watch(points_of(row_.points), options_.fit, {});
  volume_ = watched.result.volume;
  row_.operations = watched.counts;
  row_.steps = watched.steps;
  row_.contains = watched.certificate.contains;
  row_.on_boundary = watched.certificate.on_boundary;
  row_.optimal = watched.certificate.optimal;
  row_.size = fit::size_of(volume_, dim_);
  row_.measure = fit::measure_of(volume_, dim_);
  row_.bytes = bytes_of(volume_, dim_, single_);
  rounding_ = rounding_of(points_of(row_.points));
  row_.noise = rounding_.noise(dim_);
  return true;
}

bool CostRun::compare_with_hull() {
  Ladder& ladder = ladder_of(*fit::find_algorithm("hull", "quickhull"));
  if (!step_up(ladder)) return false;
  if (ladder.reached() >= row_.points)
    row_.over_hull =
        rounding_.ratio(row_.measure, fit::measure_of(fitted(*fit::find_algorithm("hull", "quickhull")), dim_), dim_);
  return true;
}

bool CostRun::compare_with_smallest() {
  const int lengths = lengths_of_size(row_.volume, dim_);
  if (algorithm().exact) {
    row_.tightness = rounding_.ratio(row_.size, row_.size, lengths);
    return true;
  }
  const fit::Algorithm* const exact = fit::exact_algorithm(algorithm().volume);
  if (exact == nullptr) return true;
  Ladder& ladder = ladder_of(*exact);
  if (!step_up(ladder)) return false;
  if (ladder.reached() >= row_.points)
    row_.tightness = rounding_.ratio(row_.size, fit::size_of(fitted(*exact), dim_), lengths);
  return true;
}

bool CostRun::time_near() { return time_copies(Copies::kNear, &CostRow::overlap); }
bool CostRun::time_in_scene() { return time_copies(Copies::kScene, &CostRow::scene_overlap); }

bool CostRun::time_copies(Copies where, Timing CostRow::*timing) {
  if (started_) return go_on();
  const OverlapWork work = overlap_work(volume_, dim_, single_, where, options_.fit.seed);
  if (work.pairs == 0) return true;
  if (where == Copies::kNear) {
    row_.overlap_pairs = work.pairs;
    row_.overlapping = work.run();
  }
  start(
      timing, [run = work.run] { (void)run(); }, work.pairs);
  return false;
}

bool CostRun::time_update() {
  if (started_) return go_on();
  const fit::UpdateStrategy* const strategy = update_of(algorithm());
  // At the start, every update computes its body's hull and an oriented box.
  if (strategy == nullptr || ladder_of(*fit::find_algorithm("hull", "quickhull")).reached() < row_.points) return true;
  row_.update = strategy->name;
  const auto [place, is_new] = updates_.try_emplace({strategy, row_.points}, timed_.size());
  if (!is_new) {
    timed_[place->second].rows.push_back(at_);
    row_.updated = rounds_.timing(place->second, kPoses);
    return true;
  }
  const auto turn = fit::start_bare_updates(*strategy, points_of(row_.points), full_turn(dim_, kPoses));
  start(
      &CostRow::updated, [turn] { (void)turn(); }, kPoses);
  return false;
}

namespace {

Offer offer_of(const CostRow& row) {
  return {row.points == row.of ? row.time.median : std::numeric_limits<double>::infinity(),
          row.is_flat() ? 0 : row.measure, row.noise / tolerance::kKnownSize, row.time.doubt(kDoubtInRun)};
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const CostRow> rows) {
  std::vector<Offer> offers;
  for (const CostRow& row : rows) offers.push_back(offer_of(row));
  return pareto_front(offers);
}

void mark_front(std::span<CostRow> rows) {
  for (CostRow& row : rows) row.on_front = false;
  for (const std::size_t i : pareto_front(std::span<const CostRow>(rows))) rows[i].on_front = true;
}

bool is_tied(std::span<const CostRow> rows, const CostRow& row) {
  return row.on_front && std::any_of(rows.begin(), rows.end(), [&](const CostRow& other) {
           return &other != &row && other.on_front && are_equal(offer_of(row), offer_of(other));
         });
}

std::vector<Pose<double, 3>> full_turn(int dim, int poses) {
  std::vector<Pose<double, 3>> turned(poses);
  for (int i = 0; i < poses; ++i) {
    const double radians = 2 * std::numbers::pi * i / poses;
    Pose<double, 3>& pose = turned[i];
    if (dim == 2) pose.rotation.topLeftCorner<2, 2>() = turn(radians);
    else pose.rotation = turn(Vector<double, 3>(1, 2, 3), radians);
  }
  return turned;
}

}  // namespace snug::cost
