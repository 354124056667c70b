#include "lesson/subjects/field/field_measuring.hpp"

#include <algorithm>
#include <utility>

namespace snug::lesson {
namespace {

using hierarchy::FieldCost;
using hierarchy::FieldWay;

constexpr double kEnoughTime = 2e6;  // ns: a few runs of a fast way, one of a slow one
constexpr std::size_t kMostRuns = 7, kBoxesOfPart = 4000;

}  // namespace

FieldMeasuring::FieldMeasuring(std::shared_ptr<const hierarchy::Field> field, const FieldStage& stage, FieldWay way,
                               Clock clock)
    : field_(std::move(field)), way_(way), clock_(clock), now_(*frustum_of(stage.recipe, stage.now)),
      before_(*frustum_of(stage.recipe, stage.before)), verdicts_(field_->boxes.size()),
      remembered_(way == FieldWay::kLastPlane ? verdicts_.size() : 0, -1), last_(remembered_),
      prepared_(way != FieldWay::kLastPlane) {}

bool FieldMeasuring::done() const {
  return !times_.empty() && (spent_ >= kEnoughTime || times_.size() >= kMostRuns || clock_ == nullptr);
}

void FieldMeasuring::work(double budget) {
  double spent = 0;
  do spent += part();
  while (!done() && spent < budget);
}

/// Takes the next boxes. Returns how long that took, ns.
double FieldMeasuring::part() {
  const std::size_t to = hierarchy::one_by_one(way_) ? std::min(boxes(), at_ + kBoxesOfPart) : boxes();
  const double begin = clock_ != nullptr ? clock_() : 0;
  const FieldCost cost = hierarchy::one_by_one(way_)
                             ? hierarchy::cull_boxes(*field_, prepared_ ? now_ : before_, way_, at_, to,
                                                     prepared_ ? last_ : remembered_, verdicts_)
                             : hierarchy::cull_field(*field_, now_, way_, {}, verdicts_);
  const double took = clock_ != nullptr ? clock_() - begin : kEnoughTime;
  at_ = to;
  if (prepared_) run_ += took, cost_.planes += cost.planes, cost_.products += cost.products;
  if (at_ == boxes()) end_run();
  return took;
}

void FieldMeasuring::end_run() {
  at_ = 0;
  last_ = remembered_;
  if (!std::exchange(prepared_, true)) return;
  times_.push_back(run_);
  spent_ += std::exchange(run_, 0);
  last_cost_ = std::exchange(cost_, {});
}

FieldMeasured FieldMeasuring::result() const {
  std::vector<double> times = times_;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return {last_cost_, clock_ != nullptr ? std::optional(*middle) : std::nullopt};
}

}  // namespace snug::lesson
