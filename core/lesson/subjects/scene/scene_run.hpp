// A scene's runs: what a lesson lets the student choose of it, and every frame of it, recorded.
#pragma once

#include <span>
#include <vector>

#include "lesson/subject.hpp"
#include "lesson/subjects/scene/frame_steps.hpp"
#include "lesson/subjects/scene/scene_set.hpp"
#include "scene/scene.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

/// The searches for pairs, which broad_phase then makes, and the updates of volumes, which refit then makes.
[[nodiscard]] std::span<const Method> scene_methods();

/// What of a frame is drawn.
struct SceneFrame {
  std::vector<scene::Motion> bodies;
  std::vector<Aabb<double, 3>> volumes;
  std::vector<scene::Contact> contacts;
  std::vector<scene::Pair> pairs, near;
  std::vector<std::vector<scene::V3>> shadows, trails;
  std::vector<scene::Ray> rays;
  std::vector<scene::Tally> tallies;
  int swept_along = -1;  // the axis that boxes were sorted along; -1: none
};

struct SceneRecording {
  std::vector<Recorder<FrameStep>::Entry> steps;  // one a frame
  std::vector<SceneFrame> frames;                 // the beginning first
  std::vector<scene::Member> members;
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

/// Whether the scene can be run by each of the methods. Errors: as of run_scene; too many frames of too many bodies.
[[nodiscard]] tl::expected<void, InputError> check_scene_opens(const SceneSet& set,
                                                               std::span<const std::string> methods,
                                                               const AnyPointSet& points, std::uint64_t seed);

/// Whether all pairs of all frames can be kept. Frames are taken one by one, where they could be too many, and none is
/// kept. Errors: too many pairs, with the line of what looks for them.
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
