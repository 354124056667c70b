#include "app/subjects/scene/search.hpp"

#include <algorithm>
#include <string>

#include "app/subjects/scene/owner.hpp"
#include "app/subjects/scene/pairs.hpp"
#include "hierarchy/broad_phase/grid.hpp"
#include "hierarchy/build.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

using lesson::SceneFrame;
using BroadBox = Aabb<double, 3>;

constexpr int kLevelsDrawn = 3;  // of a tree's nodes below the root, besides those around the body
constexpr std::int64_t kMostCellsDrawn = 64;

const BroadBox& aabb_of_body(const SceneFrame& frame, Index body) { return frame.volumes[body]; }

bool has_body(const hierarchy::Tree<BroadBox>& tree, Index node, Index body) {
  const auto below = tree.bodies_below(node);
  return std::find(below.begin(), below.end(), body) != below.end();
}

/// The nodes of the first levels, and those around the body down to its leaf.
void draw_nodes_around(Brush& brush, const SceneFrame& frame, Index body) {
  const hierarchy::Tree<BroadBox> tree = hierarchy::build_median<BroadBox>(frame.volumes);
  std::vector<int> levels(tree.nodes.size(), 0);
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const auto& node = tree.nodes[i];
    const bool around = has_body(tree, static_cast<Index>(i), body);
    if (levels[i] < kLevelsDrawn || around)
      draw_box(brush.canvas, node.volume.min, node.volume.max,
               {around ? Stroke::kSolid : Stroke::kDashed,
                around ? brush.p.support : with_alpha(brush.p.previous, 0.7f), brush.stroke(around ? 0.7f : 0.5f)});
    if (node.is_leaf()) continue;
    const std::size_t left = node.first;
    levels[left] = levels[left + 1] = levels[i] + 1;
  }
}

/// The cells that the body's AABB reaches into.
void draw_cells(Brush& brush, const SceneFrame& frame, Index body) {
  const hierarchy::Grid grid = hierarchy::grid_of(frame.volumes);
  const hierarchy::Grid::Cell from = grid.cell_of(aabb_of_body(frame, body).min),
                              to = grid.cell_of(aabb_of_body(frame, body).max);
  if ((to[0] - from[0] + 1) * (to[1] - from[1] + 1) * (to[2] - from[2] + 1) > kMostCellsDrawn) return;
  for (std::int64_t x = from[0]; x <= to[0]; ++x)
    for (std::int64_t y = from[1]; y <= to[1]; ++y)
      for (std::int64_t z = from[2]; z <= to[2]; ++z) {
        const Point3 at = Point3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
        const Point3 least = grid.origin + at.cwiseProduct(grid.cell);
        draw_box(brush.canvas, least, least + grid.cell, {Stroke::kDashed, brush.p.support, brush.stroke(0.5f)});
      }
}

}  // namespace

std::optional<SearchShown> search_at(const Brush& brush, const SceneFrame& frame) {
  const lesson::Session& session = brush.session;
  const auto& subject = static_cast<const lesson::SceneSubject&>(session.stage().subject());
  if (subject.off_since("broad_phase", session.player().step()) >= 0)
    return std::nullopt;                                   // the pairs are of another frame
  if (lesson::set_of(session).graph) return std::nullopt;  // the stage is about the effects
  if (session.player().step() == 0 || session.conversation().asked() != nullptr || frame.volumes.size() > kCrowd)
    return std::nullopt;
  const auto search = lesson::search_shown(lesson::set_of(session), session.player().method(0)->name);
  if (!search) return std::nullopt;
  const std::vector<BodyPair> compared = lesson::pairs_compared(frame, *search);
  SearchShown shown{.search = *search};
  const Index chosen = brush.hands.hovered != kNoIndex ? brush.hands.hovered : brush.hands.selected;
  const std::vector<Index> most = lesson::most_compared(compared, frame.bodies.size());
  if (chosen != kNoIndex && owner_of(lesson::set_of(session)).at_points)
    shown.body = static_cast<Index>(owner_of(lesson::set_of(session)).body) + chosen;
  else if (!most.empty()) shown.body = most.front();
  else return std::nullopt;
  shown.others = lesson::compared_with(compared, shown.body);
  if (*search == hierarchy::PairSearch::kSweepAndPrune) shown.active = lesson::active_list(frame, shown.body);
  return shown;
}

void draw_search(Brush& brush, const SceneFrame& frame, const SearchShown& shown) {
  const Palette& p = brush.p;
  const auto center = [&](Index body) { return frame.bodies[body].position; };
  if (shown.search == hierarchy::PairSearch::kTree) draw_nodes_around(brush, frame, shown.body);
  if (shown.search == hierarchy::PairSearch::kGrid) draw_cells(brush, frame, shown.body);
  for (const Index other : shown.others) {
    line(brush.list, brush.at(center(shown.body)), brush.at(center(other)), Stroke::kSolid,
         with_alpha(p.examined, 0.75f), brush.stroke(0.7f));
    draw_box(brush.canvas, aabb_of_body(frame, other).min, aabb_of_body(frame, other).max,
             {Stroke::kSolid, with_alpha(p.examined, 0.8f), brush.stroke(0.5f)});
  }
  const BroadBox& own = aabb_of_body(frame, shown.body);
  draw_box(brush.canvas, own.min, own.max, {Stroke::kSolid, p.support, brush.stroke(1.0f)});
  brush.canvas.obstacles.segments.clear();  // names may cover so many edges
}

}  // namespace snug::app
