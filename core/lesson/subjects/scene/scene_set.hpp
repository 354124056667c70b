// A lesson's scene: its bodies, made of the lesson's points, and the effects that it calls for.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point_set.hpp"
#include "lesson/lesson.hpp"
#include "scene/declaration.hpp"
#include "scene/limits.hpp"

namespace snug::lesson {

/// The volume of a lesson about a scene.
inline constexpr std::string_view kScene = "scene";

struct SceneBody {
  scene::Body body;
  bool of_points = false;  // whether its shape is all of the lesson's points, which may be a mesh's
  bool at_points = false;  // whether there is one such body at each of the points
  int color = -1;          // of kBodyColors; -1: that of every body
};

/// What bodies can be painted, so that they can be told apart. Each has its number of bars as well
/// (app/subjects/scene).
inline constexpr std::array<std::string_view, 4> kBodyColors{"blue", "green", "plum", "grey"};

struct SceneSet : Tables {
  std::vector<SceneBody> bodies;
  std::vector<scene::EffectCall> effects;
  std::vector<scene::EffectCall> spare;  // that it does not call for, but the student may add
  bool graph = false;      // whether its effects are what the lesson is about: their graph is on the stage, the student
                           // adds and takes them out, and pushes bodies
  double step = 1.0 / 60;  // seconds a frame
  int frames = 120;        // how many are shown
  int line = 0, frames_line = 0;  // in the file, for errors: those of [scene] and of its key
  std::string text;               // as write_scene says it, or as it was typed
  bool typed = false;             // whether the student typed it: then a method may have no effect to choose for

  /// Whether there are too many frames of too many bodies (kMostBodyFrames).
  [[nodiscard]] bool is_too_long(std::int64_t points) const;
  /// The most points that it is not too long for.
  [[nodiscard]] std::int64_t most_points() const;
  /// The body at the first of the points.
  [[nodiscard]] std::size_t first_at_points() const {
    const auto found = std::find_if(bodies.begin(), bodies.end(), [](const SceneBody& body) { return body.at_points; });
    return found - bodies.begin();
  }
  /// Whether a body stands at each of the points.
  [[nodiscard]] bool at_points() const {
    return std::any_of(bodies.begin(), bodies.end(), [](const SceneBody& body) { return body.at_points; });
  }
};

/// The greatest number of bodies times frames in a lesson's scene. All frames are computed before the first is shown; a
/// body takes a microsecond in each, or about 25 us in a crowd of 2,000, so a scene is ready within 6 s. SceneFrames
/// bounds the memory. Tested by "a scene with too many frames of too many bodies is refused before it is run".
inline constexpr std::int64_t kMostBodyFrames = 250'000;

/// Bodies in a pile push each other. Where there are more than this many, the time for each is taken to grow with their
/// number: 200 bodies took 13 s for 600 frames.
inline constexpr std::int64_t kFreeImpulses = 10;

/// How many places of a trail count as one body.
inline constexpr std::int64_t kPlacesOfBody = 10;

/// The greatest number of pairs in all frames together: 50 for each body in each frame.
inline constexpr std::int64_t kMostPairs = 50 * kMostBodyFrames;

/// How many places a trail keeps in a frame. Its effect refuses invalid lengths.
inline std::int64_t places_of(const scene::EffectCall& trail, int frames) {
  double length = scene::limits::kTrailPlaces;
  for (const scene::Setting& setting : trail.settings)
    if (setting.key == "length" && !setting.numbers.empty()) length = setting.numbers.front();
  return length < frames ? static_cast<std::int64_t>(std::max(0.0, length)) : frames;  // for a NaN: frames
}

inline bool SceneSet::is_too_long(std::int64_t points) const {
  std::int64_t count = 0, places = 0;
  for (const SceneBody& body : bodies) count += body.at_points ? points : 1;
  for (const scene::EffectCall& effect : effects)
    if (effect.name == "trail") places += (effect.body.empty() ? count : 1) * places_of(effect, frames);
  const bool impulses =
      std::any_of(effects.begin(), effects.end(), [](const auto& one) { return one.name == "bounce"; });
  if (impulses) count *= std::max<std::int64_t>(1, count / kFreeImpulses);
  return (count + places / kPlacesOfBody) * frames > kMostBodyFrames;
}

inline std::int64_t SceneSet::most_points() const {
  std::int64_t least = 0, beyond = kMostBodyFrames + 1;
  while (beyond - least > 1) (is_too_long((least + beyond) / 2) ? beyond : least) = (least + beyond) / 2;
  return least;
}

[[nodiscard]] inline std::string too_long_text() {
  return "too many frames of too many bodies: one times the other may be at most " + std::to_string(kMostBodyFrames) +
         ", and " + std::to_string(kPlacesOfBody) + " places of a trail count as a body";
}

/// The scene's declaration with the current points.
[[nodiscard]] scene::Declaration declaration_of(const SceneSet& set, const AnyPointSet& points, std::uint64_t seed);

/// "all_pairs", "compared", "after_broad", "after_loose", "touching", "swaps", "slack" (in per cent), "cost", "energy".
[[nodiscard]] std::span<const std::string_view> scene_figure_names();

}  // namespace snug::lesson
