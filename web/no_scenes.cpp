// The page has no scenes yet: simulating them would add a half to what a visitor waits for, and the lists of lessons here
// leave theirs out (CMakeLists.txt). The linker takes these in the place of core/lesson/scene_runs.cpp.
#include "lesson/scene_runs.hpp"

namespace snug::lesson {
namespace {

tl::unexpected<InputError> no_scenes() {
  return tl::unexpected(InputError{.what = "the page does not run scenes: the desktop program does"});
}

}  // namespace

std::span<const fit::Algorithm> scene_methods() { return {}; }
std::span<const std::string_view> scene_figure_names() { return {}; }
tl::expected<SceneRun, InputError> run_scene(const SceneSet&, std::string_view, const AnyPointSet&, std::uint64_t, scene::Clock) {
  return no_scenes();
}
tl::expected<scene::Declaration, InputError> declaration_with(const SceneSet&, std::string_view, const AnyPointSet&, std::uint64_t) {
  return no_scenes();
}
fit::FrameTaken frame_of(const scene::Scene&) { return {}; }
double figure_of(const fit::FrameTaken&, std::string_view) { return 0; }

}  // namespace snug::lesson
