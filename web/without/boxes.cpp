// A program without lessons of two boxes, or of a box and a frustum: see snug_program() in CMakeLists.txt.
#include "web/boxes.hpp"
#include "app/axis_table.hpp"
#include "app/stage_brush.hpp"
#include "lesson/box_figures.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/frustum_figures.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/grade.hpp"

namespace snug::lesson {

std::span<const fit::Algorithm> box_tests() { return {}; }
std::span<const fit::Algorithm> frustum_tests() { return {}; }
fit::Recording record(const fit::Algorithm&, const BoxPair&) { return {}; }
fit::Recording record_frustum(const fit::Algorithm&, const BoxPair&) { return {}; }
bool says_overlap(const fit::Algorithm&, const BoxPair&) { return false; }
query::Culling says_of_box(const fit::Algorithm&, const BoxPair&) { return {}; }
std::optional<bool> share_a_point(const BoxPair&) { return {}; }
std::span<const AxisName> axis_names(int) { return {}; }
int axis_index(int, const query::SatAxis<double, 3>&) { return -1; }
std::vector<query::AxisTested<double, 3>> axes_seen(std::span<const Recorder<fit::Step3>::Entry>) { return {}; }
std::vector<Figure> box_figures(const RunView&) { return {}; }
std::vector<Proof> box_proofs(const RunView&) { return {}; }
std::vector<Figure> frustum_figures(const RunView&) { return {}; }
std::vector<Proof> frustum_proofs(const RunView&) { return {}; }
bool reaches(std::string_view, const BoxPair&) { return false; }
Grade grade_boxes(const Task&, const BoxPair&, std::vector<bool>&) { return {}; }

}  // namespace snug::lesson

namespace snug::app {

void Stage::draw_boxes(Brush&) const {}
void Stage::draw_frustum(Brush&, const lesson::BoxPair&) const {}
Rect Stage::draw_inset(Brush&, float) const { return {}; }
float draw_axis_table(const Look&, lesson::Session&, ImVec2, float) { return 0; }

}  // namespace snug::app

namespace snug::web {

emscripten::val boxes_object(const lesson::Session&) { return emscripten::val::null(); }
emscripten::val box_rows(const lesson::Session&) { return emscripten::val::null(); }
std::string set_box_rows(lesson::Session&, const emscripten::val&) { return {}; }
std::string set_box(lesson::Session&, int, const std::string&, const emscripten::val&) { return {}; }
std::string turn_box(lesson::Session&, int, int, double, bool) { return {}; }

}  // namespace snug::web
