#include "lesson/subjects/scene/scene_run.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "fit/update/updates.hpp"
#include "hierarchy/bounds.hpp"
#include "hierarchy/broad_phase/broad_phase.hpp"
#include "hierarchy/broad_phase/grid.hpp"

namespace snug::lesson {
namespace {

constexpr Index kMostBodies = 4000;
constexpr std::string_view kSceneSource = "C. Ericson, Real-Time Collision Detection, 2005";

Method scene_method(std::string_view name, std::string_view title, std::span<const std::string_view> pseudocode) {
  return {.volume = kScene,
          .name = name,
          .title = title,
          .source = kSceneSource,
          .pseudocode = pseudocode,
          .max_points = kMostBodies};
}

constexpr std::array<std::string_view, 9> kFigures{"all_pairs", "compared", "after_broad", "after_loose", "touching",
                                                   "swaps",     "slack",    "cost",        "energy"};

/// The name of an update in lessons: with the volume, if that is not an AABB. A k-DOP climbs where nothing is said.
std::string name_of(const fit::UpdateStrategy& strategy) {
  const bool climbs = strategy.k > 0 && strategy.name.ends_with("_hill_climb");
  if (strategy.volume == "aabb" || (strategy.k > 0 && !climbs)) return std::string(strategy.name);
  return strategy.k > 0 ? "k" + std::to_string(strategy.k) : std::string(strategy.volume);
}

std::vector<Method> methods_of_scenes() {
  std::vector<Method> all{scene_method("sweep_and_prune", "Sort and sweep", hierarchy::kSweepAndPrunePseudocode),
                          scene_method("tree", "Tree (BVH)", hierarchy::kTreePairsPseudocode),
                          scene_method("all_pairs", "All pairs", hierarchy::kAllPairsPseudocode),
                          scene_method("grid", "Uniform grid", hierarchy::kGridPairsPseudocode)};
  static std::vector<std::string> names;  // the rows only refer to them
  for (const fit::UpdateStrategy& strategy : fit::update_strategies()) names.push_back(name_of(strategy));
  for (std::size_t i = 0; i < names.size(); ++i) {
    const fit::UpdateStrategy& strategy = fit::update_strategies()[i];
    if (strategy.space) all.push_back(scene_method(names[i], strategy.title, strategy.pseudocode));
  }
  return all;
}

/// Sets a word in the call of an effect.
void set(scene::EffectCall& call, std::string_view key, std::string_view word) {
  std::erase_if(call.settings, [&](const scene::Setting& setting) { return setting.key == key; });
  call.settings.push_back({std::string(key), {}, std::string(word)});
}

void switch_off(scene::Scene& scene, std::span<const SwitchedOff> off, int after) {
  for (const SwitchedOff& one : off)
    for (std::size_t i = 0; i < scene.tallies().size(); ++i)
      if (one.after == after && scene.tallies()[i].effect == one.effect) scene.turn(i, false);
}

void hold(Aabb<double, 3>& box, const scene::V3& least, const scene::V3& greatest) {
  box = {box.min.cwiseMin(least), box.max.cwiseMax(greatest)};
}

/// Adds the current frame to the recording.
void add_frame(SceneRecording& run, const scene::Scene& scene) {
  const scene::World& world = scene.world();
  for (std::size_t i = 0; i < world.size(); ++i) {
    const scene::V3 reach = scene::V3::Constant(world.members[i].shape.reach);
    hold(run.bodies, world.bodies[i].position - reach, world.bodies[i].position + reach);
  }
  for (const Aabb<double, 3>& box : world.state.volumes) hold(run.volumes, box.min, box.max);
  run.tallies.assign(scene.tallies().begin(), scene.tallies().end());
  for (const scene::EffectTally& tally : run.tallies) run.counts.push_back({tally.run, tally.skipped});
  int awake = 0;
  for (std::size_t i = 0; i < world.size(); ++i) awake += world.awake(i) ? 1 : 0;
  run.awake.push_back(awake);
}

/// Begins the recording of a scene at its start.
SceneRecording begun_with(scene::Scene opened) {
  const scene::V3 far = scene::V3::Constant(1e300);
  SceneRecording run{.frames = SceneFrames(std::move(opened)), .bodies = {far, -far}, .volumes = {far, -far}};
  const scene::Scene& scene = run.frames.scene();
  run.members = scene.world().members;
  run.kinds = scene.kinds();
  run.camera = scene.world().camera;
  add_frame(run, scene);
  return run;
}

/// Only a body of points has its volume measured.
FrameStep step_of(const scene::Scene& scene, int line) {
  const bool measured = scene.world().members.front().shape.cloud != nullptr;
  return {line, measured, scene.world().state.refitted.first, frame_of(scene)};
}

}  // namespace

std::span<const std::string_view> scene_figure_names() { return kFigures; }

std::span<const Method> scene_methods() {
  static const std::vector<Method> all = methods_of_scenes();
  return all;
}

scene::Declaration declaration_of(const SceneSet& set, const AnyPointSet& points, std::uint64_t seed) {
  scene::Declaration declaration{.effects = set.effects, .seed = seed, .step = set.step};
  const Index count = fit::count_of(points);
  for (const SceneBody& one : set.bodies) {
    scene::Body body = one.body;
    if (one.of_points) {
      scene::Cloud cloud;
      for (Index i = 0; i < count; ++i) cloud.push_back(fit::point_of(points, i));
      body.shape = std::move(cloud);
    }
    const scene::V3 position = body.position;
    for (Index i = 0; i < (one.at_points ? count : 1); ++i) {
      if (one.at_points) body.position = position + fit::point_of(points, i);
      declaration.bodies.push_back(body);
    }
  }
  return declaration;
}

tl::expected<scene::Declaration, InputError> declaration_with(const SceneSet& scene_set, std::string_view method,
                                                              const AnyPointSet& points, std::uint64_t seed) {
  scene::Declaration declaration = declaration_of(scene_set, points, seed);
  const bool search = std::find(hierarchy::kPairSearchNames.begin(), hierarchy::kPairSearchNames.end(), method) !=
                      hierarchy::kPairSearchNames.end();
  const std::string_view effect = search ? "broad_phase" : "refit";
  const auto call = std::find_if(declaration.effects.begin(), declaration.effects.end(),
                                 [&](const scene::EffectCall& one) { return one.name == effect; });
  const auto is_spare = [&](const scene::EffectCall& one) { return one.name == effect; };
  const bool left_out = scene_set.typed || std::any_of(scene_set.spare.begin(), scene_set.spare.end(), is_spare);
  if (call == declaration.effects.end() && left_out)
    return declaration;  // by the student, and the method has nothing to choose
  if (call == declaration.effects.end())
    return tl::unexpected(InputError{.what = "the scene does not call for " + std::string(effect) + ", which " +
                                             std::string(method) + " is about"});
  if (search) set(*call, "search", method);
  for (const fit::UpdateStrategy& strategy : fit::update_strategies())
    if (!search && name_of(strategy) == method)
      set(*call, "volume", strategy.volume), set(*call, "strategy", strategy.name);
  return declaration;
}

tl::expected<void, InputError> check_scene_opens(const SceneSet& set, std::span<const std::string> methods,
                                                 const AnyPointSet& points, std::uint64_t seed) {
  if (set.is_too_long(fit::count_of(points))) return tl::unexpected(InputError{.what = too_long_text()});
  for (const std::string& method : methods) {
    const auto scene = declaration_with(set, method, points, seed).and_then([](const scene::Declaration& declaration) {
      return scene::Scene::open(declaration);
    });
    if (!scene) return tl::unexpected(scene.error());
  }
  return {};
}

std::vector<InputError> scene_faults(const SceneSet& set, std::span<const std::string> methods,
                                     const AnyPointSet& points, std::uint64_t seed) {
  if (set.is_too_long(fit::count_of(points))) return {scene::error_at(set.frames_line, too_long_text())};
  std::vector<InputError> all;
  // A table that makes many bodies is told of a mistake once, at the first of them.
  const auto without_name = [](std::string_view what) { return what.substr(std::min(what.size(), what.find(": "))); };
  const auto add = [&](const InputError& fault) {
    const auto is_told = [&](const InputError& one) {
      return one.message() == fault.message() ||
             (one.position == fault.position && without_name(one.what) == without_name(fault.what));
    };
    if (std::none_of(all.begin(), all.end(), is_told)) all.push_back(fault);
  };
  for (const std::string& method : methods) {
    const auto declaration = declaration_with(set, method, points, seed);
    if (!declaration) add(declaration.error());
    else
      for (const InputError& fault : scene::faults_in(*declaration)) add(fault);
  }
  return all;
}

tl::expected<void, InputError> check_pairs(const SceneSet& set, std::string_view method, const AnyPointSet& points,
                                           std::uint64_t seed) {
  const auto declaration = declaration_with(set, method, points, seed);
  if (!declaration) return {};
  const auto bodies = static_cast<std::int64_t>(declaration->bodies.size());
  const auto looks = [](const scene::EffectCall& call) { return call.name == "broad_phase"; };
  const auto search = std::find_if(declaration->effects.begin(), declaration->effects.end(), looks);
  if (search == declaration->effects.end() || bodies * (bodies - 1) / 2 * set.frames <= kMostPairs) return {};
  auto scene = scene::Scene::open(*declaration);
  std::size_t kept = 0;
  for (int frame = 1; scene && frame <= set.frames; ++frame) {
    scene->step();
    kept += scene->world().state.pairs.size();
    if (kept > static_cast<std::size_t>(kMostPairs))
      return tl::unexpected(scene::error_at(
          search->line, "too many pairs: those of all frames together may be at most " + std::to_string(kMostPairs) +
                            ", which are reached at frame " + std::to_string(frame)));
  }
  return {};
}

FrameTaken frame_of(const scene::Scene& scene) {
  const scene::State& state = scene.world().state;
  const std::uint64_t hash = scene.world().hash();
  const bool pairs = std::any_of(scene.tallies().begin(), scene.tallies().end(),
                                 [](const scene::EffectTally& tally) { return tally.effect == "broad_phase"; });
  return {.frame = state.frame,
          .all_pairs = pairs ? static_cast<double>(state.funnel.all) : 0,
          .compared = static_cast<double>(state.funnel.compared),
          .after_broad = static_cast<double>(state.funnel.after_broad),
          .after_loose = static_cast<double>(state.funnel.after_loose),
          .touching = static_cast<double>(state.funnel.touching),
          .swaps = static_cast<double>(state.funnel.swaps),
          .slack = state.refitted.slack,
          .cost = state.refitted.cost,
          .energy = scene.world().energy(),
          .resting = scene.resting(),
          .hash_high = static_cast<int>(hash >> 32),
          .hash_low = static_cast<int>(hash & 0xffffffffu)};
}

double figure_of(const FrameTaken& frame, std::string_view figure) {
  const double values[] = {frame.all_pairs, frame.compared,    frame.after_broad, frame.after_loose, frame.touching,
                           frame.swaps,     100 * frame.slack, frame.cost,        frame.energy};
  const auto found = std::find(kFigures.begin(), kFigures.end(), figure);
  return found == kFigures.end() ? 0 : values[found - kFigures.begin()];
}

SceneRecorder::SceneRecorder(scene::Scene opened, int line, int frames, std::vector<SwitchedOff> off,
                             std::vector<Pushed> pushed)
    : recording_(begun_with(std::move(opened))), line_(line), frames_(frames), off_(std::move(off)),
      pushed_(std::move(pushed)) {
  if (frames_ == 0) recording_.frames.finish();
}

const SceneRecording& SceneRecorder::up_to(int frame) {
  while (recorded() < std::min(frame, frames_)) record_next();
  return recording_;
}

void SceneRecorder::record_next() {
  SceneRecording& run = recording_;
  scene::Scene& scene = run.frames.scene();
  const int before = recorded();
  switch_off(scene, off_, before);
  for (const Pushed& one : pushed_)
    if (one.after == before) scene.push(one.body);
  run.frames.step();
  counts_[static_cast<std::size_t>(Operation::kPointsTouched)] +=
      static_cast<std::int64_t>(scene.world().state.refitted.cost);
  run.steps.push_back({step_of(scene, line_), counts_});
  run.deeds.insert(run.deeds.end(), scene.deeds().begin(), scene.deeds().end());
  run.changes.push_back(scene.changes());
  add_frame(run, scene);
  if (recorded() == frames_) run.frames.finish();
}

tl::expected<SceneRecorder, InputError> run_scene(const SceneSet& set, std::string_view method,
                                                  const AnyPointSet& points, std::uint64_t seed, scene::Clock clock,
                                                  std::span<const SwitchedOff> off, std::span<const Pushed> pushed) {
  auto declaration = declaration_with(set, method, points, seed);
  if (!declaration) return tl::unexpected(std::move(declaration.error()));
  auto opened = scene::Scene::open(*declaration, clock);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  const auto known = std::find_if(scene_methods().begin(), scene_methods().end(),
                                  [&](const Method& one) { return one.name == method; });
  const int line = static_cast<int>(known->pseudocode.size()) - 1;
  return SceneRecorder(*std::move(opened), line, frames_of(set, fit::count_of(points), pushed),
                       {off.begin(), off.end()}, {pushed.begin(), pushed.end()});
}

int frames_of(const SceneSet& set, std::int64_t points, std::span<const Pushed> pushed) {
  constexpr int kToRest = 150;
  SceneSet longer;
  longer.bodies = set.bodies, longer.effects = set.effects, longer.frames = set.frames;
  for (const Pushed& one : pushed) longer.frames = std::max(longer.frames, one.after + kToRest);
  return longer.is_too_long(points) ? set.frames : longer.frames;
}

tl::expected<SceneRecorder, InputError> start_of(const SceneSet& set, const AnyPointSet& points, std::uint64_t seed) {
  scene::Declaration still = declaration_of(set, points, seed);
  still.effects.clear();
  return scene::Scene::open(still).map([](scene::Scene scene) { return SceneRecorder(std::move(scene), 0, 0); });
}

tl::expected<LastFrame, InputError> last_frame(const SceneSet& set, std::string_view method, const AnyPointSet& points,
                                               std::uint64_t seed) {
  return declaration_with(set, method, points, seed)
      .and_then([](const scene::Declaration& declaration) { return scene::Scene::open(declaration); })
      .map([&](scene::Scene scene) {
        for (int frame = 0; frame < set.frames; ++frame) scene.step();
        return LastFrame{step_of(scene, 0), pictured_in(scene)};
      });
}

}  // namespace snug::lesson
