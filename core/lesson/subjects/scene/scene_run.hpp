// A scene's runs: what a lesson lets the student choose of it, and every frame of it, recorded.
#pragma once

#include <span>
#include <vector>

#include "lesson/subject.hpp"
#include "lesson/subjects/scene/frame_steps.hpp"
#include "lesson/subjects/scene/scene_frames.hpp"
#include "lesson/subjects/scene/scene_set.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The searches for pairs, which broad_phase then makes, and the updates of volumes, which refit then makes.
[[nodiscard]] std::span<const Method> scene_methods();

/// What an effect did by a frame.
struct EffectCount {
  std::int64_t run = 0, skipped = 0;
};

struct SceneRecording {
  std::vector<Recorder<FrameStep>::Entry> steps;  // one a frame
  SceneFrames frames;
  std::vector<scene::Member> members;
  std::vector<scene::Tally> tallies;  // at the end
  std::vector<EffectCount> counts;    // of the effects in the order of tallies, frame by frame, the beginning first
  Aabb<double, 3> bodies, volumes;    // around all bodies of all frames, however they turn, and around all volumes
};

/// An effect that the student switched off: it runs up to this frame, and no more.
struct SwitchedOff {
  std::string effect;  // as its tally has it
  int after = 0;
};

/// method: of scene_methods(). Errors: of scene::Scene::open, with lines of the lesson's file; an effect that the
/// method is about and the scene does not call for.
[[nodiscard]] tl::expected<SceneRecording, InputError> run_scene(const SceneSet& set, std::string_view method,
                                                                 const AnyPointSet& points, std::uint64_t seed,
                                                                 scene::Clock clock = nullptr,
                                                                 std::span<const SwitchedOff> off = {});

/// The figures of the last frame alone. Errors: as of run_scene.
[[nodiscard]] tl::expected<FrameTaken, InputError> last_frame(const SceneSet& set, std::string_view method,
                                                              const AnyPointSet& points, std::uint64_t seed);

/// Whether the scene can be run by each of the methods. Errors: as of run_scene; too many frames of too many bodies.
[[nodiscard]] tl::expected<void, InputError> check_scene_opens(const SceneSet& set,
                                                               std::span<const std::string> methods,
                                                               const AnyPointSet& points, std::uint64_t seed);

/// Whether the pairs of all frames are not too many. Frames are taken one by one, where they could be. Errors: too many
/// pairs, with the line of what looks for them.
[[nodiscard]] tl::expected<void, InputError> check_pairs(const SceneSet& set, std::string_view method,
                                                         const AnyPointSet& points, std::uint64_t seed);

/// The scene as the method has it: what run_scene opens.
[[nodiscard]] tl::expected<scene::Declaration, InputError>
declaration_with(const SceneSet& set, std::string_view method, const AnyPointSet& points, std::uint64_t seed);

/// The figures of a scene as it stands: what a frame's step says.
[[nodiscard]] FrameTaken frame_of(const scene::Scene& scene);

/// figure: of scene_figure_names(); 0 of any other.
[[nodiscard]] double figure_of(const FrameTaken& frame, std::string_view figure);

}  // namespace snug::lesson
