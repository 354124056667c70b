#include "app/subjects/tree/draw.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/figures.hpp"

namespace snug::app {
namespace {

using lesson::Box2;
using lesson::Branch;
using lesson::Forest;
using lesson::Point2;

constexpr float kCopyWords = 13;  // the names of a copy's boxes
constexpr float kRimStep = 4;     // how much farther out the outline of a node is than those of its children, pixels

Point3 in_plane(const Point2& p) { return {p[0], p[1], 0}; }

struct ScreenBox {
  ImVec2 low, high;
};

ScreenBox on_screen(const Brush& brush, const Box2& box, float out) {
  const ImVec2 a = brush.at(in_plane(box.min)), b = brush.at(in_plane(box.max));
  return {{a.x - out, b.y - out}, {b.x + out, a.y + out}};
}

void draw_rim(Brush& brush, const ScreenBox& box, Stroke stroke, Color color, float width) {
  const std::array<ImVec2, 4> corners{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  path(brush.list, corners, true, stroke, color, width);
  for (std::size_t i = 0; i < 4; ++i) {
    const ImVec2 a = corners[i], b = corners[(i + 1) % 4];
    brush.canvas.obstacles.segments.push_back({a.x, a.y, b.x, b.y});
  }
}

void hatch_box(Brush& brush, const ScreenBox& box, Color color) {
  brush.list->PushClipRect(box.low, box.high, true);
  const ImVec2 middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  hatching(brush.list, middle, std::hypot(box.high.x - box.low.x, box.high.y - box.low.y) / 2,
           with_alpha(color, 0.35f));
  brush.list->PopClipRect();
}

int rank_of(const Forest& forest, Index i) {
  const Branch& branch = forest.at(i);
  if (!branch.divides()) return branch.boxes.size() > 1 ? 1 : 0;
  return 1 + std::max(rank_of(forest, branch.children[0]), rank_of(forest, branch.children[1]));
}

/// Draws the nodes that have more than one box, the current one over the others; those of a copy dotted.
void draw_nodes(Brush& brush, const TreeShown& shown, TreeSide side) {
  const Forest& forest = forest_on(shown, side);
  const Index current = branch_on(shown, side);
  const auto node = [&](Index i, bool now) {
    if (forest.at(i).boxes.size() < 2) return;
    const ScreenBox box = on_screen(brush, forest.at(i).box, kRimStep * static_cast<float>(rank_of(forest, i)));
    const TreeInk ink = ink_of(brush.p, shown, i, side);
    const bool dotted = ink.pale || side == TreeSide::kCopy;
    if (shown.run->nodes() != lesson::NodeKind::kAabb)
      return draw_volume(brush.canvas, lesson::volume_in_space(forest.at(i).volume),
                         {ink.pale ? Stroke::kDotted : Stroke::kSolid, now ? ink.line : with_alpha(ink.line, 0.8f),
                          brush.stroke(now ? 1.4f : 0.6f), now ? brush.p.fill : 0});
    if (now || ink.crossed) brush.list->AddRectFilled(box.low, box.high, with_alpha(ink.line, brush.p.fill), 3);
    if (ink.crossed) hatch_box(brush, box, ink.line);
    draw_rim(brush, box, dotted ? Stroke::kDotted : Stroke::kSolid, now ? ink.line : with_alpha(ink.line, 0.8f),
             brush.stroke(now        ? 1.4f
                          : ink.pale ? 0.4f
                                     : 0.6f));
  };
  std::vector<Index> there = forest.there();
  for (const Index i : there)
    if (i != current) node(i, false);
  if (std::find(there.begin(), there.end(), current) != there.end()) node(current, true);
}

/// Draws the volumes that nodes have got by merging: the last one with its children's, and with the one around the
/// vertices; and the boxes that nodes had when the tree was built.
void draw_merged(Brush& brush, const TreeShown& shown) {
  const lesson::TreeRun& run = *shown.run;
  const Palette& p = brush.p;
  const auto& [merged, tight] = run.volumes();
  const auto draw = [&](const fit::Volume3& volume, const VolumeStyle& style) {
    draw_volume(brush.canvas, volume, style);
  };
  for (const Index i : shown.forest().there()) {
    const std::size_t at = i;
    if (shown.forest().at(i).boxes.size() < 2 || i == shown.branch) continue;
    if (run.has_volume(i, shown.step))
      draw(merged[at], {Stroke::kSolid, with_alpha(p.current, 0.55f), brush.stroke(0.6f), 0});
    else draw_rim(brush, on_screen(brush, run.before().at(i).box, 0), Stroke::kDotted, p.previous, brush.stroke(0.7f));
  }
  if (shown.branch == kNoIndex || !run.has_volume(shown.branch, shown.step)) return;
  const std::size_t at = shown.branch;
  if (shown.forest().at(shown.branch).divides())
    for (const Index child : shown.forest().at(shown.branch).children)
      draw(merged[child], {Stroke::kSolid, p.current, brush.stroke(0.8f), 0});
  draw(merged[at], {Stroke::kSolid, p.current, brush.stroke(1.4f), p.fill});
  draw(tight[at], {Stroke::kDashed, p.optimum, brush.stroke(), 0});
}

/// Draws where the boxes were when the tree was built.
void draw_built(Brush& brush, const lesson::TreeStage& stage) {
  const std::vector<Box2> now = stage.aabbs(), built = stage.aabbs_built();
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i].min == built[i].min && now[i].max == built[i].max) continue;
    draw_rim(brush, on_screen(brush, built[i], 0), Stroke::kDotted, brush.p.previous, brush.stroke(0.8f));
    const ImVec2 from = brush.at(in_plane((built[i].min + built[i].max) / 2)),
                 to = brush.at(in_plane((now[i].min + now[i].max) / 2));
    arrow(brush.list, from, to, with_alpha(brush.p.previous, 0.7f), brush.stroke(0.7f));
  }
}

/// Writes a copy's name into its box, where other names keep clear of it; none where it would stand over another copy's
/// (named: where those are).
void name_copy(Brush& brush, const ScreenBox& box, Index i, Color color, std::vector<Rect>& named) {
  const float high = brush.look.px(kCopyWords);
  const ImVec2 middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
  const Rect room{middle.x - high / 2, middle.y - high / 2, high, high};
  if (std::any_of(named.begin(), named.end(), [&](const Rect& other) { return overlap(room, other); })) return;
  text_middle(brush.list, brush.look, Face::kSemiBold, kCopyWords, {middle.x, middle_of(middle.y, high)}, color,
              lesson::small(lesson::box_name(i)));
  brush.canvas.obstacles.taken.push_back(room);
  named.push_back(room);
}

void draw_boxes(Brush& brush, const TreeShown& shown, TreeSide side) {
  const std::vector<Box2>& boxes = side == TreeSide::kOwn ? shown.run->boxes() : shown.run->pairing()->moved;
  std::vector<Rect> named;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const ScreenBox box = on_screen(brush, boxes[i], 0);
    const TreeInk ink = ink_of_box(brush.p, shown, static_cast<Index>(i), side);
    brush.list->AddRectFilled(box.low, box.high, with_alpha(ink.line, ink.fill > 0 ? 3 * ink.fill : 0.1f), 2);
    if (ink.crossed) hatch_box(brush, box, ink.line);
    const bool waits = static_cast<Index>(i) == shown.incoming;
    const bool dotted = ink.pale || side == TreeSide::kCopy;
    draw_rim(brush, box, dotted ? Stroke::kDotted : Stroke::kSolid, ink.line, brush.stroke(waits ? 1.4f : 0.8f));
    if (side == TreeSide::kCopy) name_copy(brush, box, static_cast<Index>(i), ink.words, named);
  }
}

/// Draws the line along which a node is or would be divided.
void draw_border(Brush& brush, const TreeShown& shown) {
  const Index node = shown.split != nullptr    ? shown.split->node
                     : shown.priced != nullptr ? shown.priced->node
                                               : kNoIndex;
  const int axis = shown.split != nullptr ? shown.split->axis : shown.priced != nullptr ? shown.priced->axis : kNoIndex;
  if (node == kNoIndex || axis == kNoIndex) return;
  const double at = shown.split != nullptr ? shown.split->position : shown.priced->position(axis, shown.priced->border);
  const Box2& box = shown.forest().at(node).box;
  Point2 from = box.min, to = box.max;
  from[axis] = to[axis] = at;
  const ImVec2 a = brush.at(in_plane(from)), b = brush.at(in_plane(to));
  const float out = 14;
  const ImVec2 low{a.x - (axis == 1 ? out : 0), a.y + (axis == 0 ? out : 0)},
      high{b.x + (axis == 1 ? out : 0), b.y - (axis == 0 ? out : 0)};
  line(brush.list, low, high, Stroke::kDashed, brush.p.support, brush.stroke(1.1f));
  brush.canvas.obstacles.segments.push_back({low.x, low.y, high.x, high.y});
  brush.label(high, 6, {axis == 0 ? 0.0f : 1.0f, axis == 0 ? -1.0f : 0.0f},
              std::string(1, "xy"[axis]) + " = " + lesson::number_text(at), brush.p.support_text, Face::kSemiBold, 13);
}

/// Where a line from a place on the screen leaves the stage.
ImVec2 beyond_stage(const Rect& rect, ImVec2 from, ImVec2 through) {
  const float dx = through.x - from.x, dy = through.y - from.y, length = std::hypot(dx, dy);
  const float reach = rect.width + rect.height + std::hypot(from.x - rect.x, from.y - rect.y);
  return length > 0 ? ImVec2{from.x + dx / length * reach, from.y + dy / length * reach} : from;
}

void draw_frustum_query(Brush& brush, const lesson::QueryPlaces& query, Color color) {
  std::vector<ImVec2> corners;
  for (const Point2& corner : lesson::corners_of_query(query)) corners.push_back(brush.at(in_plane(corner)));
  brush.list->AddConvexPolyFilled(corners.data(), static_cast<int>(corners.size()), with_alpha(color, 0.07f));
  path(brush.list, corners, true, Stroke::kLongDashed, color, brush.stroke(1.1f));
}

/// Draws what the method asks for, between Q and R.
void draw_query(Brush& brush, const lesson::QueryPlaces& query, std::string_view method) {
  const Color color = brush.p.support;
  const ImVec2 from = brush.at(in_plane(query.at[0])), to = brush.at(in_plane(query.at[1]));
  switch (lesson::shape_of_query(method)) {
    case lesson::QueryShape::kPoint: plus(brush.list, from, 9 * brush.p.mark, color, brush.stroke(1.2f)); break;
    case lesson::QueryShape::kBox: {
      const ScreenBox box = on_screen(brush, lesson::box_of(query), 0);
      brush.list->AddRectFilled(box.low, box.high, with_alpha(color, 0.07f));
      draw_rim(brush, box, Stroke::kLongDashed, color, brush.stroke(1.1f));
      break;
    }
    case lesson::QueryShape::kRay: {
      const ImVec2 end = beyond_stage(brush.rect, from, to);
      line(brush.list, from, end, Stroke::kLongDashed, color, brush.stroke(1.1f));
      arrow(brush.list, from, to, color, brush.stroke(1.1f));
      brush.canvas.obstacles.segments.push_back({from.x, from.y, end.x, end.y});
      break;
    }
    case lesson::QueryShape::kFrustum: draw_frustum_query(brush, query, color); break;
    case lesson::QueryShape::kMove: {
      line(brush.list, from, to, Stroke::kLongDashed, color, brush.stroke(0.9f));
      arrow(brush.list, from, to, color, brush.stroke(0.9f));
      brush.canvas.obstacles.segments.push_back({from.x, from.y, to.x, to.y});
      break;
    }
  }
}

/// The box along the axes around a merged volume: a circle, or an oriented box, reaches farther than the boxes in it.
Box2 bounds_of_merged(const fit::Volume3& volume) {
  const auto around = [](const Point3& center, const Point2& half) {
    return Box2{center.head<2>() - half, center.head<2>() + half};
  };
  if (const auto* ball = std::get_if<fit::Sphere3>(&volume))
    return around(ball->center, Point2::Constant(ball->radius));
  if (const auto* box = std::get_if<Obb<double, 3>>(&volume))
    return around(box->center, (box->axes.cwiseAbs() * box->half_extents).head<2>());
  const auto& box = std::get<Aabb<double, 3>>(volume);
  return {box.min.head<2>(), box.max.head<2>()};
}

}  // namespace

Box2 stage_room(const lesson::Session& session) {
  const auto& stage = lesson::as<lesson::TreeSubject>(session.stage().subject())->stage();
  Box2 all = stage.boxes.front().aabb();
  const auto take = [&](const Box2& box) { all = {all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)}; };
  for (const lesson::HeldBox& box : stage.boxes) take(box.aabb());
  if (!stage.built.empty())
    for (const Box2& box : stage.aabbs_built()) take(box);
  if (stage.query)
    for (const Point2& at : stage.query->at) take({at, at});
  if (stage.nodes != lesson::NodeKind::kAabb) {  // a circle reaches farther than the boxes in it
    const lesson::TreeRun& run = lesson::tree_run(session.player().run(0));
    for (const Index root : run.forest(run.steps()).roots)
      take(lesson::bounds_of(run.forest(run.steps()).at(root).volume));
  }
  if (const lesson::TreeRun& run = lesson::tree_run(session.player().run(0)); run.is_merging())
    for (const auto* volumes : {&run.volumes().merged, &run.volumes().tight})
      for (const fit::Volume3& volume : *volumes) take(bounds_of_merged(volume));
  if (!stage.query) return all;
  const lesson::QueryShape shape = lesson::shape_of_query(session.player().method(0)->name);
  if (shape == lesson::QueryShape::kFrustum)
    for (const Point2& at : lesson::corners_of_query(*stage.query)) take({at, at});
  if (shape == lesson::QueryShape::kMove)
    for (const Box2& box : lesson::moved_by(*stage.query, stage.aabbs())) take(box);
  return all;
}

Box2 tree_room(const lesson::Session& session, TreePlace place) {
  constexpr double kHeight = 0.4, kGap = 0.14, kOne = 0.7, kTwo = 1.35;  // of the larger side of the boxes
  constexpr double kAside = 0.2, kHigh = 0.84;  // beside them; how high it is there, of their height
  const Box2 boxes = stage_room(session);
  const Point2 size = boxes.max - boxes.min, middle = (boxes.min + boxes.max) / 2;
  const double larger = size.maxCoeff(),
               wide = lesson::tree_run(session.player().run(0)).pairing() != nullptr ? kTwo : kOne,
               narrowest = std::max(size[0], wide * larger);
  if (place == TreePlace::kBeside) {
    const double left = boxes.max[0] + kAside * larger, half = kHigh * size[1] / 2;
    return {{left, middle[1] - half}, {left + narrowest, middle[1] + half}};
  }
  const double top = boxes.min[1] - kGap * larger;
  return {{middle[0] - narrowest / 2, top - kHeight * larger}, {middle[0] + narrowest / 2, top}};
}

void draw_tree(Brush& brush, const TreeShown& shown, TreePlace place) {
  const auto& stage = lesson::as<lesson::TreeSubject>(brush.session.stage().subject())->stage();
  const bool paired = shown.run->pairing() != nullptr;
  if (paired) draw_boxes(brush, shown, TreeSide::kCopy);
  draw_boxes(brush, shown, TreeSide::kOwn);
  if (shown.run->is_update()) draw_built(brush, stage);
  if (paired) draw_nodes(brush, shown, TreeSide::kCopy);
  if (shown.run->is_merging()) draw_merged(brush, shown);
  else draw_nodes(brush, shown, TreeSide::kOwn);
  draw_border(brush, shown);
  draw_tree_picture(brush, shown, place);
  if ((shown.run->is_query() || paired) && stage.query)
    draw_query(brush, *stage.query, brush.session.player().method(0)->name);
}

}  // namespace snug::app
