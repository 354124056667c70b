// Draws the stage once more, magnified, in the close-up.
#include "app/close_up.hpp"
#include "app/point_marks.hpp"
#include "app/stage.hpp"

namespace snug::app {
namespace {

bool inside(const Rect& rect, ImVec2 at) {
  return at.x > rect.x && at.y > rect.y && at.x < rect.x + rect.width && at.y < rect.y + rect.height;
}

}  // namespace

void Stage::draw_close_up(const Brush& brush, float top) {
  close_up_ = close_up_of(brush, top, close_up_ ? close_up_->panel : Rect{});
  if (!close_up_) return;
  draw_close_up_panel(brush, *close_up_);
  const Rect picture = picture_of(*close_up_, brush.look);
  Camera camera = camera_;
  camera.magnify(close_up_->times, {close_up_->x, close_up_->y},
                 {picture.x + picture.width / 2, picture.y + picture.height / 2});
  std::vector<ScreenPoint> handles;
  for (Index i = 0; i < brush.session.size(); ++i) handles.push_back(camera.project(brush.point(i)));
  GlScene behind;  // what OpenGL would draw is behind the panel, and left out
  behind.three_d = scene_.three_d, behind.eye = scene_.eye, behind.light = scene_.light;
  Obstacles obstacles;
  Brush close{.list = brush.list,
              .look = brush.look,
              .p = brush.p,
              .session = brush.session,
              .view = brush.view,
              .rect = {picture.x, picture.y, picture.width, picture.height - kScaleHeight},
              .canvas = {brush.list, brush.look, camera, frame_, behind, obstacles},
              .hands = hands_,
              .handles = handles,
              .point_radius = brush.point_radius,
              .volume = brush.volume,
              .labels = {}};
  brush.list->PushClipRect({picture.x, picture.y}, {picture.x + picture.width, picture.y + picture.height}, true);
  draw_in_close_up(close);
  brush.list->PopClipRect();
  draw_close_up_scale(brush, *close_up_);
}

/// Everything but OpenGL's part. Of the labels only those of what is in the picture, where there is room.
void Stage::draw_in_close_up(Brush& close) const {
  draw_outline(close);
  view_->draw(close);
  const ImVec2 low = close.list->GetClipRectMin(), high = close.list->GetClipRectMax();
  const Rect seen{low.x - 9, low.y - 9, high.x - low.x + 18, high.y - low.y + 18};  // with the halves of points
  for (Index i = 0; i < close.session.size(); ++i) {
    const ScreenPoint& handle = close.handles[i];
    if (handle.visible && view_->shows_points(close.session) && view_->is_point(close.session, i) &&
        inside(seen, {handle.x, handle.y}))
      disc(close.list, {handle.x, handle.y}, close.point_radius, close.p.point);
  }
  draw_handles(close);
  std::erase_if(close.labels, [&](const Label& label) {
    return !inside(close.rect, {label.request.x, label.request.y});
  });
  for (Label& label : close.labels) label.request.optional = true;
  draw_labels(close);
}

}  // namespace snug::app
