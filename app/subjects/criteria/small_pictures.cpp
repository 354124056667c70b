#include "app/subjects/criteria/small_pictures.hpp"

#include <algorithm>
#include <cmath>

#include "app/polytope.hpp"
#include "app/volumes.hpp"
#include "app/widgets.hpp"
#include "fit/catalogue.hpp"

namespace snug::app {
namespace {

constexpr double kTurnPerPixel = 0.008, kSteepestGaze = 1.48;  // radians
constexpr float kTravelled = 3;                                // pixels, from where a press is a drag
constexpr Index kMostDots = 400;
constexpr float kPictureName = 13, kPictureFigure = 12;

/// The widths of the words under a picture.
struct PictureWords {
  float mark, name, gap, figure;
  PictureWords(const Look& look, const SmallPicture& picture)
      : mark(picture.chosen || picture.best ? look.px(16) : 0),
        name(measure(look, Face::kSemiBold, kPictureName, picture.name).x), gap(look.px(6)),
        figure(measure(look, Face::kMono, kPictureFigure, picture.figure).x) {}
  [[nodiscard]] float in_one_line() const { return mark + name + gap + figure; }
};

/// How the pictures stand: in as many columns as make them largest, if their words have room in a cell.
struct Grid {
  int columns = 1;
  float width = 0, height = 0;  // of a cell
  float words = 0;              // the height of the words in it
  bool folded = false;          // whether the figure stands below the name, because a cell is too narrow for both
};

Grid grid_of(const Look& look, const Rect& room, const std::vector<SmallPicture>& pictures) {
  const int count = static_cast<int>(pictures.size());
  float widest = 0, widest_name = 0;
  for (const SmallPicture& picture : pictures) {
    const PictureWords words(look, picture);
    widest = std::max(widest, words.in_one_line()), widest_name = std::max(widest_name, words.mark + words.name);
  }
  Grid best;
  float largest = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    Grid grid{columns, room.width / static_cast<float>(columns), room.height / static_cast<float>(rows)};
    if (columns > 1 && widest_name > grid.width - 4) break;
    grid.folded = widest > grid.width - 8;
    grid.words = look.px(kPictureName + 8) + (grid.folded ? look.px(kPictureFigure + 4) : 0);
    const float picture = std::min(grid.width, grid.height - grid.words);
    if (picture > largest) largest = picture, best = grid;
  }
  return best;
}

/// The ball that contains all of them, so that all have one scale.
fit::Sphere3 ball_around_all(const std::vector<SmallPicture>& pictures, int dim) {
  fit::Sphere3 ball = ball_around(*pictures.front().volume, dim);
  for (const SmallPicture& picture : pictures) ball = ball_around(ball, ball_around(*picture.volume, dim));
  return ball;
}

void draw_dots(const Canvas& canvas, const AnyPointSet& points) {
  const Index n = fit::count_of(points), every = std::max<Index>(1, n / kMostDots);
  const float radius = n > 60 ? 1.0f : 1.75f;
  for (Index i = 0; i < n; i += every)
    canvas.list->AddCircleFilled(canvas.at(fit::point_of(points, i)), radius, canvas.look->point);
}

/// OpenGL fills the stage's spheres; here the list does.
void fill_sphere(const Canvas& canvas, const fit::Sphere3& sphere, const VolumeStyle& style) {
  if (canvas.camera.dim() == 2) return;
  const double apart = (canvas.camera.eye() - sphere.center).norm(), share = sphere.radius / apart;
  const auto radius = static_cast<float>(sphere.radius * canvas.camera.scale_at(sphere.center) /
                                         std::sqrt(std::max(1 - share * share, 1e-6)));
  canvas.list->AddCircleFilled(canvas.at(sphere.center), radius, with_alpha(style.color, style.fill));
}

void draw_words(ImDrawList* list, const Look& look, const Rect& cell, const Grid& grid, const SmallPicture& picture) {
  const PictureWords words(look, picture);
  const float y = cell.y + cell.height - grid.words + 2;
  const auto centered = [&](float width) { return cell.x + std::max(2.0f, (cell.width - width) / 2); };
  float x = centered(grid.folded ? words.mark + words.name : words.in_one_line());
  const ImVec2 middle{x + look.px(5), y + look.px(kPictureName) / 2 + 1};
  if (picture.best) tick(list, middle, look.px(5), look->optimum, 2);
  else if (picture.chosen) diamond(list, middle, look.px(5), look->support, look->ground);
  x += words.mark;
  text(list, look, Face::kSemiBold, kPictureName, {x, y}, picture.chosen ? look->support_text : look->ink,
       picture.name);
  const ImVec2 beside{x + words.name + words.gap, y + look.px(kPictureName - kPictureFigure)};
  const ImVec2 below{centered(words.figure), y + look.px(kPictureName + 4)};
  text(list, look, Face::kMono, kPictureFigure, grid.folded ? below : beside, look->muted, picture.figure);
}

void draw_picture(ImDrawList* list, const Look& look, const Rect& cell, float words, const AnyPointSet& points,
                  const fit::Sphere3& ball, const SmallPicture& picture, const Gaze& gaze) {
  Camera camera(fit::dim_of(points), gaze.yaw, gaze.pitch);
  camera.set_stage(cell, 4, 4, words + 2);
  camera.frame(ball, true);
  const Frame frame;
  GlScene unseen;
  Obstacles obstacles;
  const Canvas canvas{list, look, camera, frame, unseen, obstacles};
  const VolumeStyle style{.color = look->current, .width = picture.chosen ? 2.0f : 1.5f, .fill = look->fill};
  list->PushClipRect({cell.x, cell.y}, {cell.x + cell.width, cell.y + cell.height}, true);
  draw_dots(canvas, points);
  if (const auto* sphere = std::get_if<fit::Sphere3>(picture.volume)) fill_sphere(canvas, *sphere, style);
  draw_volume(canvas, *picture.volume, style);
  list->PopClipRect();
}

}  // namespace

PictureHands draw_small_pictures(ImDrawList* list, const Look& look, const Rect& room, const AnyPointSet& points,
                                 const std::vector<SmallPicture>& pictures, const Gaze& gaze,
                                 std::vector<ImVec2>& places) {
  PictureHands hands;
  places.clear();
  if (pictures.empty() || room.width < 40 || room.height < 40) return hands;
  const int count = static_cast<int>(pictures.size());
  const Grid grid = grid_of(look, room, pictures);
  const fit::Sphere3 ball = ball_around_all(pictures, fit::dim_of(points));
  for (int i = 0; i < count; ++i) {
    const int row = i / grid.columns, in_row = std::min(grid.columns, count - row * grid.columns);
    const float inset = (room.width - grid.width * static_cast<float>(in_row)) / 2;  // a short row stands in the middle
    const Rect cell{room.x + inset + grid.width * static_cast<float>(i % grid.columns),
                    room.y + grid.height * static_cast<float>(row), grid.width, grid.height};
    const SmallPicture& picture = pictures[i];
    const Touch touch = touch_area(picture.id.c_str(), cell, picture.name + ", " + picture.figure);
    const bool dragged = ImGui::IsMouseDragging(ImGuiMouseButton_Left, kTravelled);
    if (touch.held && dragged)
      hands.turned_x = ImGui::GetIO().MouseDelta.x, hands.turned_y = ImGui::GetIO().MouseDelta.y;
    const ImVec2 gone = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0);
    if (touch.clicked && std::hypot(gone.x, gone.y) < kTravelled) hands.clicked = i;
    draw_picture(list, look, cell, grid.words, points, ball, picture, gaze);
    draw_words(list, look, cell, grid, picture);
    const ImVec2 low{cell.x + 2, cell.y + 2}, high{cell.x + cell.width - 2, cell.y + cell.height - 1};
    if (picture.chosen) list->AddRect(low, high, look->support, 8, 0, 1.5f);
    else if (touch.hovered) list->AddRect(low, high, look->line, 8, 0, 1.5f);
    places.push_back({cell.x + cell.width / 2, cell.y + cell.height / 2});
  }
  return hands;
}

Gaze turned(const Gaze& gaze, float dx, float dy) {
  return {gaze.yaw - dx * kTurnPerPixel, std::clamp(gaze.pitch + dy * kTurnPerPixel, -kSteepestGaze, kSteepestGaze)};
}

}  // namespace snug::app
