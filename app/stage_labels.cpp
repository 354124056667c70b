// Draws the requested labels where there is room.
#include <algorithm>
#include <cmath>

#include "app/stage.hpp"

namespace snug::app {
namespace {

constexpr float kTied = 14;  // a label this much farther out than preferred gets a leader line, pixels

using LabelPlaces = std::vector<std::optional<Rect>>;

/// Draws a line from a label far out to what it names, unless it would strike through another label.
void draw_leader(const Brush& brush, const Label& label, const Rect& place, const LabelPlaces& all) {
  const ImVec2 anchor{label.request.x, label.request.y};
  const ImVec2 from{std::clamp(anchor.x, place.x, place.x + place.width),
                    std::clamp(anchor.y, place.y, place.y + place.height)};
  const float dx = anchor.x - from.x, dy = anchor.y - from.y, away = std::hypot(dx, dy);
  if (away < label.request.gap + kTied) return;
  const float share = 1 - label.request.gap / away;
  const ImVec2 to{from.x + dx * share, from.y + dy * share};
  const Obstacles::Segment leader{from.x, from.y, to.x, to.y};
  const auto struck = [&](const std::optional<Rect>& other) {
    return other && &*other != &place && crosses(*other, leader);
  };
  if (std::none_of(all.begin(), all.end(), struck))
    brush.list->AddLine(from, to, with_alpha(label.color, 0.6f), brush.p.mark);
}

void draw_plate(Brush& brush, const Rect& place) {
  brush.list->AddRectFilled({place.x, place.y}, {place.x + place.width, place.y + place.height},
                            with_alpha(brush.p.ground, 0.92f), 4);
}

}  // namespace

void Stage::draw_labels(Brush& brush) {
  std::vector<LabelRequest> requests;
  for (const Label& label : brush.labels) requests.push_back(label.request);
  const Rect& r = brush.rect;
  const auto places = place_labels(requests, brush.canvas.obstacles, {r.x + 4, r.y + 4, r.width - 8, r.height - 8});
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const Label& label = brush.labels[i];
    const ImVec2 at{places[i]->x + 3, places[i]->y + 1};
    draw_leader(brush, label, *places[i], places);
    if (label.plate) draw_plate(brush, *places[i]);
    // A name that is shown only if it is clear of everything needs no halo.
    if (is_of_signs(label.words) || (label.request.optional && brush.dim() == 2))
      text(brush.list, brush.look, label.face, label.size, at, label.color, label.words);
    else halo_text(brush.list, brush.look, label.face, label.size, at, label.color, brush.p.ground, label.words);
  }
}

}  // namespace snug::app
