// A program without scenes: see snug_program() in CMakeLists.txt.
#include "app/scene_panel.hpp"
#include "app/stage_brush.hpp"
#include "lesson/grade.hpp"
#include "lesson/read_scene.hpp"
#include "lesson/scene_figures.hpp"
#include "lesson/scene_runs.hpp"

namespace snug::lesson {
namespace {

tl::unexpected<InputError> no_scenes() {
  return tl::unexpected(InputError{.what = "this program does not run scenes"});
}

}  // namespace

std::span<const fit::Algorithm> scene_methods() { return {}; }
std::span<const std::string_view> scene_figure_names() { return {}; }
tl::expected<SceneRun, InputError> run_scene(const SceneSet&, std::string_view, const AnyPointSet&, std::uint64_t,
                                             scene::Clock, std::span<const SwitchedOff>) {
  return no_scenes();
}
tl::expected<scene::Declaration, InputError> declaration_with(const SceneSet&, std::string_view, const AnyPointSet&,
                                                              std::uint64_t) {
  return no_scenes();
}
tl::expected<void, InputError> check_scene_opens(const SceneSet&, std::span<const std::string>, const AnyPointSet&,
                                                 std::uint64_t) {
  return no_scenes();
}
tl::expected<void, InputError> check_pairs(const SceneSet&, std::string_view, const AnyPointSet&, std::uint64_t) {
  return no_scenes();
}
fit::FrameTaken frame_of(const scene::Scene&) { return {}; }
double figure_of(const fit::FrameTaken&, std::string_view) { return 0; }
SceneSet read_scene_of(TomlTable&, int, Complaints&) { return {}; }  // to run it is the error
void read_ranges(TomlTable&, Question&) {}
Task read_scene_task(const toml::table&, const std::vector<std::string>&, Complaints&) { return {}; }
std::vector<Figure> scene_figures(const RunView&) { return {}; }
std::string scene_figure_text(std::string_view, double) { return {}; }
std::string effect_time_text(const scene::Tally&, double) { return {}; }
Grade grade_scene(const Task&, const SceneSet&, const AnyPointSet&, std::uint64_t) { return {}; }

}  // namespace snug::lesson

namespace snug::app {

Point3 place_of(const lesson::Session& session, Index i) { return session.point(i); }
bool can_move(const lesson::Session&) { return true; }
bool shows_points(const lesson::Session&) { return true; }
fit::Sphere3 extent_of_scene(const lesson::Session&) { return {}; }
void Stage::draw_scene(Brush&) const {}
std::string frame_caption(const fit::FrameTaken&, const lesson::Session*) { return {}; }
float draw_scene_panel(const Look&, lesson::Session&, ImVec2, float) { return 0; }

}  // namespace snug::app
