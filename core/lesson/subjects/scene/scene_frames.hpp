// The frames of a scene's run, within bounds of memory however many there are.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "geometry/aabb.hpp"
#include "scene/scene.hpp"

namespace snug::lesson {

/// What of a frame is drawn. Hundreds of frames are kept: nothing stands here that nobody looks at.
struct SceneFrame {
  struct Placed {
    scene::V3 position;
    Quaternion orientation;
    [[nodiscard]] Matrix<double, 3> rotation() const { return matrix_of(orientation); }
  };
  std::vector<Placed> bodies;
  std::vector<Aabb<double, 3>> volumes;
  std::vector<scene::Pair> pairs, near, touching;
  std::vector<std::vector<scene::V3>> shadows, trails;
  std::vector<scene::Ray> rays;
  int swept_along = -1;  // the axis that boxes were sorted along; -1: none
};

// 2,000 bodies in 125 frames, each of which overlaps six others.
inline constexpr std::size_t kMostFrameBytes = 56 << 20;

/// The frames of a scene, taken one by one up to the last, and looked at in any order then. All of them are kept where
/// they take no more than so many bytes; of a longer run those next to the one that was looked at last, and any other
/// is taken anew from the scene's nearest snapshot, to the same bits.
class SceneFrames {
 public:
  SceneFrames() = default;  // none
  explicit SceneFrames(scene::Scene scene, std::size_t most = kMostFrameBytes);

  /// Takes the next frame.
  void step();
  /// No more frames are taken.
  void finish();
  /// As it stands at the last frame that was taken. Before finish.
  [[nodiscard]] scene::Scene& scene() { return *scene_; }

  /// With the beginning, which is frame 0.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// frame < size(). It stays until another is asked for.
  [[nodiscard]] const SceneFrame& operator[](std::size_t frame) const;
  [[nodiscard]] std::size_t kept() const { return kept_.size(); }

 private:
  [[nodiscard]] std::size_t end() const { return first_ + kept_.size(); }
  void take_anew(std::size_t frame) const;
  void drop(bool front) const;

  // What is kept changes with what is looked at, and nothing else does.
  mutable std::optional<scene::Scene> scene_;  // none where all frames are kept
  mutable std::deque<SceneFrame> kept_;        // frames in a row
  mutable std::size_t first_ = 0;              // the frame of the first of them
  mutable std::size_t bytes_ = 0;
  std::size_t size_ = 0, most_ = 0;
};

}  // namespace snug::lesson
