// A lesson's scene: its bodies, made of the lesson's points, and the effects that it calls for.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point_set.hpp"
#include "scene/declaration.hpp"

namespace snug::lesson {

/// A lesson's volume where a scene moves.
inline constexpr std::string_view kScene = "scene";

struct SceneBody {
  scene::Body body;
  bool of_points = false;   // its shape is all of the lesson's points, which may be a mesh's
  bool at_points = false;   // there is one such body at each of the points
};

struct SceneSet {
  std::vector<SceneBody> bodies;
  std::vector<scene::EffectCall> effects;
  double step = 1.0 / 60;   // seconds a frame
  int frames = 120;         // how many are shown

  /// Whether a body stands at each of the points.
  [[nodiscard]] bool at_points() const {
    return std::any_of(bodies.begin(), bodies.end(), [](const SceneBody& body) { return body.at_points; });
  }
};

/// The scene with the points as they stand.
[[nodiscard]] scene::Declaration declaration_of(const SceneSet& set, const AnyPointSet& points, std::uint64_t seed);

/// "all_pairs", "after_broad", "after_loose", "touching", "slack" (in per cent), "cost", "energy".
[[nodiscard]] std::span<const std::string_view> scene_figure_names();

}  // namespace snug::lesson
