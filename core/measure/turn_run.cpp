#include "measure/turn_run.hpp"

#include <algorithm>
#include <utility>

namespace snug::cost {

std::optional<SlackRange> slack_range(std::span<const TurnRow> rows) {
  std::optional<SlackRange> range;
  int known = 0;
  for (const TurnRow& row : rows) {
    if (!row.slack) continue;
    if (!range) range = {*row.slack, 0, *row.slack};
    range->least = std::min(range->least, *row.slack);
    range->most = std::max(range->most, *row.slack);
    range->mean += (*row.slack - range->mean) / ++known;
  }
  return range;
}

TurnRun::TurnRun(const AnyPointSet& points, std::vector<const fit::UpdateStrategy*> strategies, int frames,
                 const TimingOptions& timing, Clock clock)
    : points_(points), strategies_(std::move(strategies)), poses_(full_turn(fit::dim_of(points), frames)),
      rounds_(timing, std::move(clock)), noise_(rounding_of(points).noise(fit::dim_of(points))) {}

double TurnRun::progress() const {
  if (done()) return 1;
  const double part = static_cast<double>(frame_) / static_cast<double>(poses_.size());
  const double frames = (static_cast<double>(at_) + part) / static_cast<double>(strategies_.size());
  return (frames + (at_ < strategies_.size() ? 0 : rounds_.progress())) / 2;
}

void TurnRun::step() {
  if (done()) return;
  if (at_ == strategies_.size()) take_times();
  else if (!body_) body_ = fit::start_unwatched_updates(*strategies_[at_], points_);
  else if (frame_ < poses_.size()) add_frame();
  else finish_turn();
}

void TurnRun::add_frame() {
  const fit::UpdateStrategy& strategy = *strategies_[at_];
  const fit::UpdatedFrame frame = body_(poses_[frame_]);
  rows_.push_back(
      {.volume = std::string(strategy.volume),
       .strategy = std::string(strategy.name),
       .points = fit::count_of(points_),
       .degrees = 360.0 * static_cast<double>(frame_) / static_cast<double>(poses_.size()),
       .slack = frame.tightest > noise_ ? std::optional(fit::slack(frame.measure, frame.tightest)) : std::nullopt,
       .measure = frame.measure,
       .contains = frame.contains});
  ++frame_;
}

void TurnRun::finish_turn() {
  rounds_.add([turn = fit::start_bare_updates(*strategies_[at_], points_, poses_)] { (void)turn(); });
  body_ = nullptr;
  frame_ = 0;
  ++at_;
}

void TurnRun::take_times() {
  rounds_.step();
  if (!rounds_.done()) return;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i].updated = rounds_.timing(i / poses_.size(), static_cast<int>(poses_.size()));
}

}  // namespace snug::cost
