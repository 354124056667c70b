#include "lesson/subjects/field/field_run.hpp"

#include <algorithm>

namespace snug::lesson {
namespace {

using hierarchy::FieldAnswer;
using hierarchy::FieldCost;
using hierarchy::FieldRecord;
using hierarchy::FieldWay;
using query::Culling;

constexpr int kFieldPlanes = kFrustumPlanes<3>;

/// The lines of the methods' pseudocode (field_methods.cpp) that steps name.
int line_of_sweep(FieldWay way) {
  switch (way) {
    case FieldWay::kAllVertices: return 3;
    case FieldWay::kSpheresFirst: return 6;
    case FieldWay::kLastPlane: return 3;
    default: return 2;
  }
}
int line_of_end(FieldWay way) {
  switch (way) {
    case FieldWay::kAllVertices: return 5;
    case FieldWay::kSpheresFirst: return 7;
    case FieldWay::kLastPlane: return 5;
    case FieldWay::kTree: return 1;
    default: return 4;
  }
}

}  // namespace

FieldRun::FieldRun(std::shared_ptr<const hierarchy::Field> field, const FieldStage& stage, FieldWay way)
    : field_(std::move(field)), way_(way), verdicts_(field_->boxes.size()), decided_(field_->boxes.size(), kOpen),
      left_(static_cast<std::int64_t>(field_->boxes.size())), tallies_(1) {
  std::vector<std::int8_t> last;
  if (way == FieldWay::kLastPlane) {
    last.assign(field_->boxes.size(), -1);
    hierarchy::cull_field(*field_, *frustum_of(stage.recipe, stage.before), way, last, verdicts_);
  }
  FieldRecord record;
  const FieldCost cost =
      hierarchy::cull_field(*field_, *frustum_of(stage.recipe, stage.now), way, last, verdicts_, &record);
  tell(record, cost);
}

void FieldRun::tell(const FieldRecord& record, const FieldCost& cost) {
  if (way_ == FieldWay::kTree) tell_levels(record);
  else if (way_ == FieldWay::kAtOnce) tell_lanes(cost);
  else {
    if (way_ == FieldWay::kSpheresFirst) tell_spheres(record);
    if (way_ == FieldWay::kLastPlane) tell_last_planes(record);
    tell_sweeps(record);
  }
  for (std::size_t box = 0; box < decided_.size(); ++box)
    if (is_open(box)) decide(box);
  std::array<std::int64_t, 3> all{};
  for (const Culling verdict : verdicts_) ++all[static_cast<std::size_t>(verdict)];
  add(line_of_end(way_), FieldCulled{all[0], all[1], all[2], cost.planes}, 0, 0);
  for (std::size_t box = 0; box < decided_.size(); ++box)
    ++tallies_[decided_[box]].known[static_cast<std::size_t>(verdicts_[box])];
  for (std::size_t step = 1; step < tallies_.size(); ++step)
    for (const std::size_t verdict : {0, 1, 2}) tallies_[step].known[verdict] += tallies_[step - 1].known[verdict];
}

void FieldRun::tell_spheres(const FieldRecord& record) {
  SpheresTested fact{.planes = record.sphere_planes};
  for (std::size_t box = 0; box < decided_.size(); ++box) {
    if (record.answers[box].planes != 0) continue;
    ++(verdicts_[box] == Culling::kOutside ? fact.outside : fact.inside);
    decide(box);
  }
  fact.left = left_;
  add(3, fact, fact.planes, fact.planes);
}

void FieldRun::tell_last_planes(const FieldRecord& record) {
  LastPlanesTested fact;
  for (std::size_t box = 0; box < decided_.size(); ++box) {
    const FieldAnswer& answer = record.answers[box];
    if (answer.first < 0) continue;
    ++fact.tested;
    if (answer.rejected_by != answer.first) continue;
    ++fact.rejected;
    decide(box);
  }
  fact.left = left_;
  add(2, fact, fact.tested, 2 * fact.tested - fact.rejected);
}

/// Where every plane is tested, a box that was rejected is tested on. All boxes are looked at once, for all planes.
void FieldRun::tell_sweeps(const FieldRecord& record) {
  const bool all = way_ == FieldWay::kAllVertices;
  std::array<PlaneSwept, kFieldPlanes> facts;
  const int first_step = next_step();
  for (std::size_t box = 0; box < decided_.size(); ++box) {
    if (!is_open(box)) continue;
    const FieldAnswer& answer = record.answers[box];
    const int end = answer.rejected_by < 0 ? kFieldPlanes : answer.rejected_by + 1;
    for (int plane = 0; plane < end; ++plane)
      facts[plane].tested += (answer.planes >> plane & 1) != 0 && answer.first != plane ? 1 : 0;
    if (answer.rejected_by < 0) continue;
    ++facts[answer.rejected_by].rejected;
    decided_[box] = static_cast<std::uint8_t>(first_step + answer.rejected_by);
  }
  for (int plane = 0; plane < kFieldPlanes; ++plane) {
    PlaneSwept& fact = facts[plane];
    fact.plane = plane;
    if (all) fact.tested = objects();
    fact.left = left_ -= fact.rejected;
    add(line_of_sweep(way_), fact, fact.tested, all ? 8 * fact.tested : 2 * fact.tested - fact.rejected);
  }
}

void FieldRun::tell_levels(const FieldRecord& record) {
  std::vector<std::int64_t> boxes(record.levels.size());
  std::vector<std::uint8_t> steps(record.levels.size(), kOpen);  // that give their boxes the answer
  for (const FieldAnswer& answer : record.answers) ++boxes[answer.level];
  for (std::size_t level = 0; level < record.levels.size(); ++level) {
    const hierarchy::LevelTests& tests = record.levels[level];
    const int at = static_cast<int>(level);
    if (tests.volumes == 0) continue;
    if (tests.skipped > 0) add(2, PlanesSkipped{at, tests.skipped, tests.planes}, 0, 0, tests.skipped);
    steps[level] = next_step(), left_ -= boxes[level];
    const int line = tests.left_out > 0 ? 3 : tests.taken > 0 ? 4 : 5;
    add(line, LevelTested{at, tests.volumes, tests.planes, tests.left_out, tests.taken, left_}, tests.planes,
        2 * tests.planes - tests.rejected);
  }
  for (std::size_t box = 0; box < decided_.size(); ++box) decided_[box] = steps[record.answers[box].level];
}

void FieldRun::tell_lanes(const FieldCost& cost) {
  constexpr std::size_t kLanes = query::AabbArray<double>::kBlock;
  LanesTested fact{.products = cost.products};
  for (std::size_t begin = 0; begin < verdicts_.size(); begin += kLanes) {
    const auto group = std::span(verdicts_).subspan(begin, std::min(kLanes, verdicts_.size() - begin));
    ++fact.groups;
    fact.empty += std::all_of(group.begin(), group.end(), [](Culling c) { return c == Culling::kOutside; });
  }
  for (std::size_t box = 0; box < decided_.size(); ++box) decide(box);
  add(2, fact, cost.planes, cost.products);
}

void FieldRun::add(int line, FieldStep::Fact fact, std::int64_t planes, std::int64_t products, std::int64_t skipped) {
  FieldTally next = tallies_.back();
  next.planes += planes, next.products += products, next.skipped += skipped;
  OperationCounts counts{};
  counts[static_cast<std::size_t>(Operation::kOrientationTests)] = next.products;
  trace_.push_back({FieldStep{line, std::move(fact)}, counts});
  tallies_.push_back(next);
}

}  // namespace snug::lesson
