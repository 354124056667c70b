// broad_phase: finds the pairs whose AABBs overlap.
#include <utility>

#include "hierarchy/broad_phase/broad_phase.hpp"
#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class BroadPhase final : public Effect {
 public:
  explicit BroadPhase(hierarchy::PairSearch search) : search_(search) {}

  void run(World& world) override {
    std::vector<Aabb<double, 3>> boxes = world.state.volumes;
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes[i] = with_room(boxes[i], world.margin(i));
    hierarchy::PairsFound found = hierarchy::broad_phase(boxes, search_, &world.state.sweep);
    Funnel& funnel = world.state.funnel;
    funnel.compared = found.compared;
    funnel.axis = found.axis;
    funnel.swaps = found.swaps;
    funnel.after_broad = static_cast<std::int64_t>(found.pairs.size());
    world.state.pairs = std::move(found.pairs);
    world.state.changed(Slot::kPairs);
  }

 private:
  hierarchy::PairSearch search_;
};

}  // namespace

MadeEffect make_broad_phase(const EffectCall& call, World& world) {
  Settings settings(call, world);
  const std::size_t search = settings.word("search", hierarchy::kPairSearchNames);
  return settings.make<BroadPhase>(static_cast<hierarchy::PairSearch>(search));
}

}  // namespace snug::scene
