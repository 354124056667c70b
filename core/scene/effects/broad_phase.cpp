// broad_phase: finds the pairs whose AABBs overlap.
#include <utility>

#include "geometry/tolerance.hpp"
#include "scene/effect.hpp"
#include "scene/pairs.hpp"

namespace snug::scene {
namespace {

class BroadPhase final : public Effect {
 public:
  explicit BroadPhase(PairSearch search) : search_(search) {}

  void run(World& world) override {
    std::vector<Aabb<double, 3>> boxes = world.state.volumes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      // Room for points that rounding may have put outside the box, and for the body's motion until the next test.
      const double room = world.margin(i) + tolerance::kPlaced<double> * (boxes[i].min.cwiseAbs().maxCoeff() +
                                                                          boxes[i].max.cwiseAbs().maxCoeff());
      boxes[i].min -= V3::Constant(room), boxes[i].max += V3::Constant(room);
    }
    PairsFound found = overlapping_pairs(boxes, search_, &world.state.sweep);
    world.state.pairs = std::move(found.pairs);
    world.state.funnel.compared = found.compared, world.state.funnel.axis = found.axis;
    world.state.funnel.swaps = found.swaps;
    world.state.funnel.after_broad = static_cast<std::int64_t>(world.state.pairs.size());
    world.state.changed(Slot::kPairs);
  }

 private:
  PairSearch search_;
};

}  // namespace

MadeEffect make_broad_phase(const EffectCall& call, World& world) {
  Settings settings(call, world);
  const std::size_t search = settings.word("search", kPairSearchNames);
  return settings.make<BroadPhase>(static_cast<PairSearch>(search));
}

}  // namespace snug::scene
