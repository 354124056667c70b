// The runs of a scene: the methods that a lesson offers for it, and the recording of every frame.
#pragma once

#include <span>
#include <vector>

#include "lesson/subject.hpp"
#include "lesson/subjects/scene/frame_steps.hpp"
#include "lesson/subjects/scene/pictured.hpp"
#include "lesson/subjects/scene/scene_frames.hpp"
#include "lesson/subjects/scene/scene_set.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The searches for pairs, for broad_phase, and the updates of volumes, for refit.
[[nodiscard]] std::span<const Method> scene_methods();

/// What an effect had done by a frame.
struct EffectCount {
  std::int64_t run = 0, skipped = 0;
};

/// A body that the student pushed, after this frame.
struct Pushed {
  std::size_t body = 0;
  int after = 0;
};

/// What is recorded of a scene, up to some frame.
struct SceneRecording {
  std::vector<Recorder<FrameStep>::Entry> steps;  // one for each frame
  SceneFrames frames;
  std::vector<scene::Member> members;
  std::vector<scene::EffectTally> tallies;  // those at its last frame
  std::vector<EffectCount> counts;          // for each frame, the start first: the effects in the order of tallies
  Aabb<double, 3> bodies, volumes;  // around all bodies in all its frames and orientations, and around all volumes
  std::vector<const scene::EffectKind*> kinds = {};  // of the effects, in the order of tallies
  std::vector<scene::Deed> deeds = {};               // for each frame from the first on: what each effect did
  std::vector<scene::SlotSet> changes = {};          // for each frame from the first on: what changed
  std::vector<int> awake = {};                       // for each frame, the start first: how many bodies are awake
  std::optional<Frustum<double, 3>> camera = {};     // that culling tests against
};

/// An effect that the student switched off: it runs only up to this frame.
struct SwitchedOff {
  std::string effect;  // as in its tally
  int after = 0;
};

/// Records a scene frame by frame, no farther than it is asked: while a body is dragged, only the frame that is shown
/// is needed, and a hundred more would be late for the next.
class SceneRecorder {
 public:
  SceneRecorder() = default;  // of nothing
  /// line: of the pseudocode, to which every frame belongs. frames: how many there are to record.
  SceneRecorder(scene::Scene opened, int line, int frames, std::vector<SwitchedOff> off = {},
                std::vector<Pushed> pushed = {});

  /// How many frames there are, recorded or not; the start is not counted.
  [[nodiscard]] int frames() const { return frames_; }
  [[nodiscard]] int recorded() const { return static_cast<int>(recording_.steps.size()); }
  /// The recording, which goes at least as far as this frame. Valid until more is asked for.
  const SceneRecording& up_to(int frame);

 private:
  void record_next();

  SceneRecording recording_;
  OperationCounts counts_{};
  int line_ = 0, frames_ = 0;
  std::vector<SwitchedOff> off_;
  std::vector<Pushed> pushed_;
};

/// method: one of scene_methods(). Errors: those of scene::Scene::open, with lines of the lesson's file; an effect that
/// the method is about but that the scene does not call for.
[[nodiscard]] tl::expected<SceneRecorder, InputError>
run_scene(const SceneSet& set, std::string_view method, const AnyPointSet& points, std::uint64_t seed,
          scene::Clock clock = nullptr, std::span<const SwitchedOff> off = {}, std::span<const Pushed> pushed = {});

/// How many frames are shown: after a push as many as bodies usually need to come to rest again, if a scene may have so
/// many.
[[nodiscard]] int frames_of(const SceneSet& set, std::int64_t points, std::span<const Pushed> pushed);

/// The start alone of a scene that is refused: its bodies stand where they are put, and nothing runs. Errors: those of
/// scene::check.
[[nodiscard]] tl::expected<SceneRecorder, InputError> start_of(const SceneSet& set, const AnyPointSet& points,
                                                               std::uint64_t seed);

/// The last frame only, with the first body's volume if that is measured. Errors: those of run_scene.
struct LastFrame {
  FrameStep step;
  Pictured pictured;
};
[[nodiscard]] tl::expected<LastFrame, InputError> last_frame(const SceneSet& set, std::string_view method,
                                                             const AnyPointSet& points, std::uint64_t seed);

/// Checks that each method can run the scene. Errors: those of run_scene; too many frames of too many bodies.
[[nodiscard]] tl::expected<void, InputError> check_scene_opens(const SceneSet& set,
                                                               std::span<const std::string> methods,
                                                               const AnyPointSet& points, std::uint64_t seed);

/// All that is wrong with a scene for these methods, each with its line. Empty: check_scene_opens finds nothing either.
[[nodiscard]] std::vector<InputError> scene_faults(const SceneSet& set, std::span<const std::string> methods,
                                                   const AnyPointSet& points, std::uint64_t seed);

/// Checks that all frames together do not have too many pairs, and computes frames only if they could. Errors: too many
/// pairs, with the line of the effect that searches for them.
[[nodiscard]] tl::expected<void, InputError> check_pairs(const SceneSet& set, std::string_view method,
                                                         const AnyPointSet& points, std::uint64_t seed);

/// The scene's declaration with the method applied: what run_scene opens.
[[nodiscard]] tl::expected<scene::Declaration, InputError>
declaration_with(const SceneSet& set, std::string_view method, const AnyPointSet& points, std::uint64_t seed);

/// The figures of a scene at its current frame: the fact of that frame.
[[nodiscard]] FrameTaken frame_of(const scene::Scene& scene);

/// A frame's figure by name. figure: one of scene_figure_names(); any other gives 0.
[[nodiscard]] double figure_of(const FrameTaken& frame, std::string_view figure);

}  // namespace snug::lesson
