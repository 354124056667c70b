// libFuzzer: any bodies with any effects. They are refused with a sentence, or run: poses stay finite, volumes contain
// their bodies, every search finds the pairs that trying all finds, and going back and on again has the same bits.
#include <string>

#include "fuzz/bytes.hpp"
#include "geometry/tolerance.hpp"
#include "hierarchy/broad_phase/broad_phase.hpp"
#include "scene/scene.hpp"

namespace {

using namespace snug;
using fuzz::require;
using scene::V3;

constexpr unsigned kMostBodies = 6, kMostEffects = 8;
constexpr int kMostFrames = 40;

/// Numbers and words that an effect may be set to; of those that it does not know, it refuses the scene.
struct Known {
  std::string_view key;
  int numbers;  // 0: a word
  std::vector<std::string_view> words;
};
const std::vector<std::pair<std::string_view, std::vector<Known>>>& settings() {
  static const std::vector<std::pair<std::string_view, std::vector<Known>>> all{
      {"spin", {{"axis", 3, {}}, {"turns_per_second", 1, {}}, {"degrees", 1, {}}}},
      {"orbit", {{"center", 3, {}}, {"axis", 3, {}}, {"turns_per_second", 1, {}}, {"vary", 1, {}}}},
      {"path", {{"places", 9, {}}, {"speed", 1, {}}, {"then", 0, {"stop", "round"}}}},
      {"fall", {{"gravity", 3, {}}}},
      {"drag", {{"to", 3, {}}, {"stiffness", 1, {}}}},
      {"bounce", {{"restitution", 1, {}}, {"friction", 1, {}}, {"sleep", 0, {"yes", "no"}}}},
      {"refit", {{"strategy", 0, {"rotated_box", "loose", "rebuild", "hill_climb"}}}},
      {"broad_phase", {{"search", 0, {hierarchy::kPairSearchNames.begin(), hierarchy::kPairSearchNames.end()}}}},
      {"cull", {{"from", 3, {}}, {"at", 3, {}}, {"half_tangent", 1, {}}, {"near", 1, {}}, {"far", 1, {}}}},
      {"shadow", {{"light", 3, {}}, {"ground", 1, {}}}},
      {"trail", {{"length", 1, {}}}},
      {"projection_rays", {{"ground", 1, {}}}},
  };
  return all;
}

V3 any_place(fuzz::Bytes& bytes) { return bytes.point<double, 3>(); }

std::variant<scene::Volume3, scene::Cloud> any_shape(fuzz::Bytes& bytes) {
  switch (bytes.below(5)) {
    case 0: return scene::Volume3(Sphere<double, 3>{any_place(bytes), bytes.number<double>()});
    case 1: return scene::Volume3(Capsule<double, 3>{any_place(bytes), any_place(bytes), bytes.number<double>()});
    case 2: return bytes.cloud<double, 3>(8);
    case 3: return scene::Volume3(Obb<double, 3>{any_place(bytes), Matrix<double, 3>::Identity(), any_place(bytes)});
    default: {
      const V3 half = any_place(bytes).cwiseAbs();
      return scene::Volume3(Aabb<double, 3>{-half, half});
    }
  }
}

scene::Body any_body(fuzz::Bytes& bytes, unsigned i) {
  scene::Body body{.name = std::string(1, static_cast<char>('a' + i)), .shape = any_shape(bytes)};
  const unsigned given = bytes.byte();  // the rest as it comes
  if ((given & 1) != 0) {
    const V3 axis = any_place(bytes);
    body.orientation = {bytes.number<double>(), axis[0], axis[1], axis[2]};
  }
  if ((given & 2) != 0) body.mass = bytes.number<double>();
  if ((given & 4) != 0) body.velocity = any_place(bytes);
  if ((given & 8) != 0) body.angular_velocity = any_place(bytes);
  body.fixed = (given & 48) == 48;
  body.position = any_place(bytes);
  return body;
}

void set_any(fuzz::Bytes& bytes, scene::EffectCall& call) {
  for (const auto& [effect, keys] : settings())
    for (const Known& known : keys) {
      if (effect != call.name || bytes.below(2) == 0) continue;
      scene::Setting setting{std::string(known.key), {}, {}};
      for (int i = 0; i < known.numbers; ++i) setting.numbers.push_back(bytes.number<double>());
      if (known.numbers == 0) setting.text = known.words[bytes.below(static_cast<unsigned>(known.words.size()))];
      call.settings.push_back(setting);
    }
}

scene::Declaration any_declaration(fuzz::Bytes& bytes) {
  scene::Declaration declaration;
  for (unsigned count = 1 + bytes.below(kMostBodies), i = 0; i < count; ++i)
    declaration.bodies.push_back(any_body(bytes, i));
  if (bytes.below(2) == 0)  // what most effects stand on
    for (const char* name : {"refit", "broad_phase", "narrow_phase", "bounce", "fall"}) {
      scene::EffectCall call{.name = name, .body = {}, .settings = {}};
      set_any(bytes, call);
      declaration.effects.push_back(call);
    }
  for (unsigned count = bytes.below(kMostEffects), i = 0; i < count; ++i) {
    const auto kinds = scene::catalogue();
    scene::EffectCall call{
        .name = std::string(kinds[bytes.below(static_cast<unsigned>(kinds.size()))].name), .body = {}, .settings = {}};
    if (bytes.below(2) == 0) call.body = declaration.bodies[bytes.byte() % declaration.bodies.size()].name;
    set_any(bytes, call);
    declaration.effects.push_back(call);
  }
  if (bytes.below(8) == 0) declaration.step = bytes.number<double>();
  return declaration;
}

bool has(const scene::Scene& scene, std::string_view effect) {
  for (const scene::EffectTally& tally : scene.tallies())
    if (tally.effect == effect) return tally.on && tally.run > 0;
  return false;
}

/// Within the roundings of a placed corner and of the box's own bounds.
void check_volumes(const scene::World& world) {
  for (std::size_t i = 0; i < world.size(); ++i) {
    const physics::Shape& shape = world.members[i].shape;
    const Pose<double, 3> pose = pose_of(world.bodies[i]);
    const double off =
        32 * tolerance::kRoundoff<double> * (pose.translation.cwiseAbs().maxCoeff() + shape.reach + shape.radius);
    const Aabb<double, 3>& box = world.state.volumes[i];
    for (const V3& corner : shape.corners) {
      const V3 at = placed<double, 3>(pose, corner);
      require((at - box.min).minCoeff() >= shape.radius - off && (box.max - at).minCoeff() >= shape.radius - off);
    }
  }
}

void check_pairs(const scene::Scene& scene) {
  const scene::State& state = scene.world().state;
  const auto wanted = hierarchy::broad_phase(state.volumes, hierarchy::PairSearch::kAllPairs).pairs;
  for (const auto search :
       {hierarchy::PairSearch::kSweepAndPrune, hierarchy::PairSearch::kTree, hierarchy::PairSearch::kGrid})
    require(hierarchy::broad_phase(state.volumes, search).pairs == wanted);
  // The broad phase gives each box room for the motion until its next run.
  if (has(scene, "broad_phase"))
    require(std::includes(state.pairs.begin(), state.pairs.end(), wanted.begin(), wanted.end()));
}

void check_frame(const scene::Scene& scene) {
  for (const scene::Motion& motion : scene.world().bodies) {
    require(motion.position.allFinite() && motion.rotation.allFinite());
    require(motion.velocity.allFinite() && motion.angular_velocity.allFinite());
  }
  if (!has(scene, "refit")) return;
  check_volumes(scene.world());
  check_pairs(scene);
}

/// Something that the user does to a running scene.
void meddle(fuzz::Bytes& bytes, scene::Scene& scene) {
  switch (bytes.below(8)) {
    case 0: scene.push(bytes.byte() % scene.world().size()); break;
    case 1: scene.pull_to(any_place(bytes)); break;
    case 2:
      if (!scene.tallies().empty()) scene.turn(bytes.byte() % scene.tallies().size(), bytes.below(2) == 0);
      break;
    default: break;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  const scene::Declaration declaration = any_declaration(bytes);
  auto scene = scene::Scene::open(declaration);
  if (!scene) {
    require(!scene.error().message().empty());
    return 0;
  }
  const int meddled = static_cast<int>(bytes.below(kMostFrames / 2));
  scene->go(meddled);
  meddle(bytes, *scene);
  std::vector<std::uint64_t> hashes;  // from the frame on in which it was meddled with
  while (scene->frame() < kMostFrames) {
    scene->step();
    check_frame(*scene);
    hashes.push_back(scene->world().hash());
  }
  for (int turn = 0; turn < 3; ++turn) {
    const int frame = meddled + 1 + static_cast<int>(bytes.below(static_cast<unsigned>(kMostFrames - meddled)));
    scene->go(bytes.below(2) == 0 ? meddled : meddled + 1);
    scene->go(frame);
    require(scene->frame() == frame);
    require(scene->world().hash() == hashes[frame - meddled - 1]);
  }
  return 0;
}
