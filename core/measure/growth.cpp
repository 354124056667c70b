#include "measure/growth.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "measure/ladder.hpp"

namespace snug::cost {
namespace {

constexpr Index kFewest = 10;
/// Below this ratio (little more than one decade), five sizes in equal steps say more than half decades.
constexpr double kFewDecades = 32;
constexpr int kFewSteps = 4;

/// The power is fitted only if the sizes span at least this ratio.
constexpr double kLeastRange = 4;
/// Every algorithm reads every point. If the time seems to grow by less than this power, most of it is still constant.
constexpr double kLeastTold = 0.5;

constexpr std::string_view kOwnLimit = " points is stopped by its own limit";

/// time: in ns.
std::string why_stopped(Index points, double time) {
  const bool in_seconds = time >= 999.5e6;
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "one run of %d points would take about %.*g %s", static_cast<int>(points),
                in_seconds ? 2 : 3, in_seconds ? time / 1e9 : std::round(time / 1e6), in_seconds ? "s" : "ms");
  return text.data();
}

/// The times that the power is fitted through: those of the last decade and a half of sizes, or of the last three sizes
/// if those are fewer. For each size it is the least time, which was disturbed the least: on a busy machine, medians
/// bend the line.
std::vector<SizedTime> tail_of(std::span<GrowthRow> rows) {
  std::vector<SizedTime> tail;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].in_fit = rows[i].points * kTail >= rows.back().points || i + 3 >= rows.size();
    if (rows[i].in_fit) tail.push_back({static_cast<double>(rows[i].points), rows[i].time.min});
  }
  return tail;
}

/// The fitted power; none if the sizes are too few, too close together or too small to tell how the time grows.
std::optional<double> told_power(std::span<const SizedTime> tail) {
  const auto power = power_of(tail);
  const bool told = power && *power >= kLeastTold && tail.back().points >= kLeastRange * tail.front().points;
  return told ? power : std::nullopt;
}

}  // namespace

bool ends_at_own_limit(const GrowthRow& row) { return row.stopped.ends_with(kOwnLimit); }

Workload workload_of(const fit::Algorithm& algorithm, int dim, Index most, std::shared_ptr<PointStock> points,
                     const fit::Options& options) {
  Workload load{.volume = std::string(algorithm.volume),
                .algorithm = std::string(algorithm.name),
                .most = std::min(most, algorithm.most_finished)};
  if (load.most < std::min(most, algorithm.max_points))
    load.ends = "a run on more than " + std::to_string(load.most) + std::string(kOwnLimit);
  load.theory = fit::bound_of(algorithm.theory, dim);
  load.work = fit::work_of(algorithm.theory, dim);
  load.tight = algorithm.theory.tight;
  load.make_ready = [points](Index n) { return points->make(n); };
  load.prepare = [&algorithm, points, options](Index n) -> std::function<void()> {
    const AnyPointSet* const set = &points->of(n);
    return [&algorithm, set, options] { (void)algorithm.fit(*set, options); };
  };
  return load;
}

std::vector<Index> growth_sizes(Index most) {
  std::vector<Index> sizes;
  if (most <= kFewest) return {most};
  const double decades = static_cast<double>(most) / kFewest;
  const int steps = decades < kFewDecades ? kFewSteps : static_cast<int>(2 * std::log10(decades) + 1e-9);
  const double factor = decades < kFewDecades ? std::pow(decades, 1.0 / kFewSteps) : std::sqrt(10.0);
  for (int i = 0; i <= steps; ++i) {
    const auto n = std::min(most, static_cast<Index>(std::lround(kFewest * std::pow(factor, i))));
    if (sizes.empty() || n > sizes.back()) sizes.push_back(n);
  }
  if (sizes.back() < most) sizes.push_back(most);
  return sizes;
}

std::optional<double> power_of(std::span<const SizedTime> times) {
  if (times.size() < 3) return std::nullopt;
  double x = 0, y = 0;
  for (const SizedTime& at : times) {
    if (!(at.time > 0)) return std::nullopt;
    x += std::log(at.points);
    y += std::log(at.time);
  }
  x /= static_cast<double>(times.size());
  y /= static_cast<double>(times.size());
  double xx = 0, xy = 0;
  for (const SizedTime& at : times) {
    const double dx = std::log(at.points) - x;
    xx += dx * dx;
    xy += dx * (std::log(at.time) - y);
  }
  if (!(xx > 0)) return std::nullopt;
  return xy / xx;
}

double GrowthRun::progress() const {
  if (done()) return 1;
  const double half = sizes_.empty() ? 0 : static_cast<double>(size_) / static_cast<double>(2 * sizes_.size());
  return (static_cast<double>(at_) + (stopped_ ? 1 - half : half)) / static_cast<double>(workloads_.size());
}

void GrowthRun::step() {
  if (done()) return;
  if (stopped_) step_back();
  else step_up();
}

void GrowthRun::step_up() {
  const Workload& load = workloads_[at_];
  if (sizes_.empty()) sizes_ = growth_sizes(load.most);
  const Index n = sizes_[size_];
  if (watches_.size() == size_) {
    const auto own = own_rows();
    if (own.size() >= 2) {
      const GrowthRow &a = own[own.size() - 2], &b = own.back();
      const double time = foreseen(a.points, a.time.min, b.points, b.time.min, n);
      if (time > longest_) return turn(why_stopped(n, time));
    }
    if (load.make_ready && !load.make_ready(n)) return;
    watches_.emplace_back(load.prepare(n), timing_);
    watches_.back().pause_after((timing_.repeats + 1) / 2);
    return;
  }
  watches_.back().step(clock_);
  if (!watches_.back().done()) return;
  rows_.push_back({.volume = load.volume, .algorithm = load.algorithm, .points = n, .time = watches_.back().timing()});
  if (++size_ == sizes_.size()) turn(load.ends);
}

void GrowthRun::turn(std::string stopped) {
  stopped_ = std::move(stopped);
  for (Stopwatch& watch : watches_) watch.pause_after(timing_.repeats);
}

void GrowthRun::step_back() {
  if (size_ == 0) return finish();
  Stopwatch& watch = watches_[size_ - 1];
  if (!watch.done()) return watch.step(clock_);
  own_rows()[--size_].time = watch.timing();
}

void GrowthRun::finish() {
  const Workload& load = workloads_[at_];
  std::vector<SizedTime> tail = tail_of(own_rows());
  const auto power = told_power(tail);
  std::optional<double> theory;
  if (power && load.work != nullptr) {
    for (SizedTime& at : tail) at.time = load.work(at.points);
    theory = power_of(tail);
  }
  for (GrowthRow& row : own_rows()) {
    row.exponent = power;
    row.theory = load.theory;
    row.theory_exponent = theory;
    row.tight = load.tight;
    row.stopped = *stopped_;
  }
  first_ = rows_.size();
  size_ = 0;
  sizes_.clear();
  watches_.clear();
  stopped_.reset();
  ++at_;
}

void GrowthRun::stop() {
  if (done()) return;
  if (!stopped_) turn("stopped");
  if (first_ < rows_.size()) finish();
  at_ = workloads_.size();
}

}  // namespace snug::cost
