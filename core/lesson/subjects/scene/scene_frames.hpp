// The frames of a scene's run, within bounds of memory however many there are.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "geometry/aabb.hpp"
#include "scene/scene.hpp"

namespace snug::lesson {

/// The part of a frame that is drawn. Hundreds of frames are kept, so it has nothing that nobody uses.
struct SceneFrame {
  struct Placed {
    scene::V3 position;
    Quaternion orientation;
    [[nodiscard]] Matrix<double, 3> rotation() const { return matrix_of(orientation); }
  };
  std::vector<Placed> bodies;
  std::vector<Aabb<double, 3>> volumes;
  std::vector<BodyPair> pairs, near, touching;
  std::vector<std::vector<scene::V3>> shadows, trails;
  std::vector<scene::Ray> rays;
  int swept_along = -1;                  // the axis that AABBs were sorted along; -1: none
  std::vector<std::uint8_t> asleep;      // by body
  std::vector<std::uint8_t> visibility;  // by body, query::Culling; empty if nothing culls
  std::vector<Index> swept;              // the bodies in the order along that axis
};

// Enough for 2,000 bodies in 125 frames, each body overlapping six others.
inline constexpr std::size_t kMostFrameBytes = 56 << 20;

/// The frames of a scene, which are computed one by one up to the last, and then accessed in any order. All are kept if
/// they fit into kMostFrameBytes. Of a longer run, those near the last accessed frame are kept, and any other is
/// computed again from the scene's nearest snapshot, with the same bits.
class SceneFrames {
 public:
  SceneFrames() = default;  // none
  explicit SceneFrames(scene::Scene scene, std::size_t most = kMostFrameBytes);

  /// Computes the next frame.
  void step();
  /// Says that no more frames are to come.
  void finish();
  /// The scene at the last computed frame. Only before finish.
  [[nodiscard]] scene::Scene& scene() { return *scene_; }

  /// The number of frames, including frame 0, the start.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// frame < size(). The reference is valid until another frame is requested.
  [[nodiscard]] const SceneFrame& operator[](std::size_t frame) const;
  [[nodiscard]] std::size_t kept() const { return kept_.size(); }

 private:
  [[nodiscard]] std::size_t end() const { return first_ + kept_.size(); }
  void take_anew(std::size_t frame) const;
  void drop(bool front) const;

  // Access changes only which frames are kept.
  mutable std::optional<scene::Scene> scene_;  // none if all frames are kept
  mutable std::deque<SceneFrame> kept_;        // consecutive frames
  mutable std::size_t first_ = 0;              // the number of the first of them
  mutable std::size_t bytes_ = 0;
  std::size_t size_ = 0, most_ = 0;
};

}  // namespace snug::lesson
