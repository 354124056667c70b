#include "app/subjects/field/draw.hpp"

#include <algorithm>
#include <cmath>

#include "app/polytope.hpp"
#include "query/cull/classify.hpp"

namespace snug::app {
namespace {

using lesson::FieldRun;
using query::Culling;

constexpr float kHandle = 7;             // pixels
constexpr std::size_t kMostNodes = 130;  // drawn of a level of the tree

const FieldRun& run_on(const lesson::Session& session) { return lesson::field_run(session.player().run(0)); }
const lesson::FieldStage& stage_on(const lesson::Session& session) {
  return lesson::as<lesson::FieldSubject>(session.stage().subject())->stage();
}

/// The marks of boxes, by their answers; the last is that of a box without one.
struct FieldInk {
  GlMark::Shape shape;
  Color color;
  float size;
};
FieldInk ink_of(const Palette& p, const FieldRun& run, std::size_t box, int step) {
  if (!run.knows(box, step)) return {GlMark::kDot, with_alpha(p.muted, 0.6f), 1};
  switch (run.verdicts()[box]) {
    case Culling::kInside: return {GlMark::kSquare, p.current, 1};
    case Culling::kIntersecting: return {GlMark::kDiamond, p.examined, 1.5f};
    case Culling::kOutside: break;
  }
  return {GlMark::kCross, with_alpha(p.wrong, run.objects() > 20'000 ? 0.22f : 0.4f), 0.8f};
}

bool same_pose(const lesson::CameraPose& a, const lesson::CameraPose& b) {
  return a.position == b.position && a.aim == b.aim;
}

/// Draws the side of the frustum that is tested. Opposite planes belong to the positive or negative side of an axis of
/// the solid: left is -x, right x, bottom -y, top y, near z, far -z.
void draw_side(Brush& brush, const Polytope& solid, int plane) {
  const int axis = plane / 2;
  const bool positive = axis == 2 ? plane == 4 : plane % 2 == 1;
  std::vector<ImVec2> outline;
  for (const int corner : solid.faces[2 * axis + (positive ? 0 : 1)])
    outline.push_back(brush.at(solid.corners[corner]));
  brush.list->AddConvexPolyFilled(outline.data(), static_cast<int>(outline.size()), with_alpha(brush.p.examined, 0.2f));
  path(brush.list, outline, true, Stroke::kSolid, brush.p.examined, brush.stroke(1.4f));
}

struct NodeTested {
  Index node;
  Culling verdict;
};

/// The nodes of a level that the frustum is tested against: those whose parent intersects it.
std::vector<NodeTested> nodes_on(const hierarchy::Field& field, const Frustum<double, 3>& frustum, int level) {
  std::vector<NodeTested> now{{0, query::classify(frustum, field.tree.nodes[0].volume).verdict}};
  for (int at = 0; at < level; ++at) {
    std::vector<NodeTested> next;
    for (const auto& [node, verdict] : now) {
      const auto& parent = field.tree.nodes[node];
      if (verdict != Culling::kIntersecting || parent.is_leaf()) continue;
      for (const Index child : {parent.first, parent.first + 1})
        next.push_back({child, query::classify(frustum, field.tree.nodes[child].volume).verdict});
    }
    now = std::move(next);
    if (now.size() > kMostNodes) return {};
  }
  return now;
}

/// Draws the nodes of the level that a step is about.
void draw_level(Brush& brush, int level, bool tested) {
  const auto& stage = stage_on(brush.session);
  const hierarchy::Field& field = run_on(brush.session).field();
  const Palette& p = brush.p;
  for (const auto& [node, verdict] : nodes_on(field, *lesson::frustum_of(stage.recipe, stage.now), level)) {
    const auto& box = field.tree.nodes[node].volume;
    const Color color = !tested                        ? p.muted
                        : verdict == Culling::kOutside ? p.wrong
                        : verdict == Culling::kInside  ? p.current
                                                       : p.examined;
    const Stroke stroke = !tested || verdict != Culling::kOutside ? Stroke::kSolid : Stroke::kDotted;
    draw_volume(brush.canvas, polytope_of(box, 3), {stroke, color, brush.stroke(0.6f)});
  }
}

void draw_fact(Brush& brush, const Polytope& solid) {
  const int step = brush.session.player().step();
  if (step == 0) return;
  const auto& fact = run_on(brush.session).trace()[step - 1].step.fact;
  if (const auto* sweep = std::get_if<lesson::PlaneSwept>(&fact)) draw_side(brush, solid, sweep->plane);
  if (const auto* level = std::get_if<lesson::LevelTested>(&fact)) draw_level(brush, level->level, true);
  if (const auto* level = std::get_if<lesson::PlanesSkipped>(&fact)) draw_level(brush, level->level, false);
}

/// Draws the camera and its aim, which are the handles.
void draw_camera_line(Brush& brush, const lesson::CameraPose& pose) {
  const Palette& p = brush.p;
  draw_line(brush.canvas, pose.position, pose.aim, {Stroke::kDashed, p.ink, brush.stroke(0.6f)});
  for (const Point3& place : {pose.position, pose.aim}) {
    const ImVec2 at = brush.at(place);
    disc(brush.list, at, (kHandle + 2) * p.mark, p.ground);
    ring(brush.list, at, kHandle * p.mark, p.ink, brush.stroke(0.8f));
    disc(brush.list, at, 3.5f * p.mark, p.ink);
  }
}

}  // namespace

void FieldMarks::show(Brush& brush) {
  const Frame& frame = brush.canvas.frame;
  const bool same = marks_ != nullptr && revision_ == brush.session.revision() && palette_ == &brush.p &&
                    frame_.origin == frame.origin && frame_.unit == frame.unit;
  if (!same) fill(brush);
  brush.canvas.gl.marks = marks_;
}

/// The ones that matter more come last: they are on top.
void FieldMarks::fill(const Brush& brush) {
  if (marks_ == nullptr) marks_ = std::make_shared<GlMarks>();
  revision_ = brush.session.revision(), palette_ = &brush.p, frame_ = brush.canvas.frame;
  const FieldRun& run = run_on(brush.session);
  const int step = brush.session.player().step();
  constexpr std::array<GlMark::Shape, 4> kOrder{GlMark::kCross, GlMark::kDot, GlMark::kSquare, GlMark::kDiamond};
  std::array<std::vector<GlMark>, kOrder.size()> layers;
  const auto& boxes = run.field().boxes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const FieldInk ink = ink_of(brush.p, run, i, step);
    const Point3 half = (boxes[i].max - boxes[i].min) / 2;
    const auto radius = static_cast<float>(half.maxCoeff() / frame_.unit) * ink.size;
    layers[static_cast<std::size_t>(ink.shape)].push_back(
        {frame_.to_stage(boxes[i].min + half), radius, static_cast<float>(ink.shape), ink.color});
  }
  marks_->marks.clear();
  for (const GlMark::Shape shape : kOrder) {
    const auto& layer = layers[static_cast<std::size_t>(shape)];
    marks_->marks.insert(marks_->marks.end(), layer.begin(), layer.end());
  }
  marks_->least_radius = 2.2f * brush.p.mark;
  ++marks_->version;
}

std::optional<Polytope> frustum_solid(const lesson::FieldRecipe& recipe, const lesson::CameraPose& pose) {
  const auto frustum = lesson::frustum_of(recipe, pose);
  if (!frustum) return std::nullopt;
  const auto corners = corners_of(*frustum);
  if (!corners) return std::nullopt;
  Polytope solid = polytope_of(Obb<double, 3>{}, 3);
  for (std::size_t bits = 0; bits < solid.corners.size(); ++bits)
    solid.corners[bits] = (*corners)[bits ^ 4];  // its third axis is back, and that of the vertices is far
  return solid;
}

void draw_field(Brush& brush) {
  const auto& stage = stage_on(brush.session);
  const Palette& p = brush.p;
  const bool remembers = run_on(brush.session).way() == hierarchy::FieldWay::kLastPlane;
  if (remembers && !same_pose(stage.now, stage.before))
    if (const auto before = frustum_solid(stage.recipe, stage.before))
      draw_volume(brush.canvas, *before, {Stroke::kDotted, p.previous, brush.stroke(0.7f)});
  if (const auto solid = frustum_solid(stage.recipe, stage.now)) {
    draw_volume(brush.canvas, *solid, {Stroke::kSolid, p.ink, brush.stroke(0.8f)});
    draw_fact(brush, *solid);
  }
  draw_camera_line(brush, stage.now);
}

}  // namespace snug::app
