// A stage without the panels around it, and how large what stands on it is drawn.
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "app/stage.hpp"
#include "app/subjects.hpp"
#include "bench.hpp"
#include "course_lessons.hpp"

namespace snug::app {

/// The smaller side of what a stage leaves free beside its buttons, its sentence or a question's card, and a second
/// picture. scale: of words.
inline float free_side(ImVec2 stage, float card = 0, float second = 0, float scale = 1) {
  constexpr float kAround = 28;
  const float tools = 20 + 32 * scale;                             // a button
  const float below = stage.x >= 560 ? 48 + 44 * scale : kAround;  // two lines; a narrow page has them elsewhere
  return std::min(stage.x - 2 * kAround, stage.y - tools - std::max(below, card) - second);
}

/// The box around places on the screen.
struct Around {
  ImVec2 low{1e9f, 1e9f}, high{-1e9f, -1e9f};
  void take(ImVec2 at) {
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  void clip(const Rect& to) {
    low = {std::max(low.x, to.x), std::max(low.y, to.y)};
    high = {std::min(high.x, to.x + to.width), std::min(high.y, to.y + to.height)};
  }
  [[nodiscard]] float longer() const { return std::max({high.x - low.x, high.y - low.y, 0.0f}); }
};

class LoneStage {
 public:
  /// bench: has ImGui's context and the look.
  LoneStage(Bench& bench, lesson::Lesson lesson, ImVec2 size, float card)
      : bench_(bench), look_(bench.app.look()), rect_{0, 0, size.x, size.y}, view_(subject_of(lesson).view()) {
    look_.foot = card, look_.still = true, look_.drawn = nullptr;
    auto mesh = mesh_of(lesson.points.mesh);
    auto opened = lesson::Session::open(std::move(lesson), std::move(mesh));
    REQUIRE(opened.has_value());
    session_.emplace(*std::move(opened));
    stage_.open(*session_, *view_);
  }

  [[nodiscard]] lesson::Session& session() { return *session_; }
  [[nodiscard]] float second_picture() const { return view_->room_of_inset(look_, *session_, rect_); }
  [[nodiscard]] const Camera& camera() const { return stage_.camera(); }

  /// What is drawn of the step, without marks, words and second pictures, as far as it is in view above a card.
  [[nodiscard]] Around drawn() {
    const lesson::WithDecimals wished(session_->lesson().view.decimals);
    constexpr int kSettled = 3;  // frames
    for (int i = 0; i < kSettled; ++i) {
      ImGui::NewFrame();
      stage_.draw(look_, bench_.app.settings(), *session_, rect_, now_ += 0.02);
      if (i + 1 < kSettled) ImGui::EndFrame();
    }
    const Around around = picture();
    ImGui::EndFrame();
    return around;
  }

 private:
  /// Draws the picture once more, on a list of its own.
  Around picture() {
    const Camera& camera = stage_.camera();
    const Frame frame{camera.view().target, camera.view().height};
    GlScene scene;
    scene.three_d = camera.dim() == 3;
    Obstacles obstacles;
    std::vector<ScreenPoint> places;
    for (Index i = 0; i < session_->stage().subject().size(); ++i)
      places.push_back(camera.project(view_->place_of(*session_, i)));
    ImDrawList* const list = ImGui::GetForegroundDrawList();
    const int before = list->VtxBuffer.Size;
    Brush brush{.list = list,
                .look = look_,
                .p = *look_.palette,
                .session = *session_,
                .view = *view_,
                .rect = rect_,
                .canvas = {list, look_, camera, frame, scene, obstacles},
                .hands = {},
                .handles = places,
                .volume = view_->shown().volume,
                .labels = {}};
    view_->draw(brush);
    Around around;
    for (int i = before; i < list->VtxBuffer.Size; ++i) around.take(list->VtxBuffer[i].pos);
    for (Index i = 0; view_->shows_points(*session_) && i < session_->stage().subject().size(); ++i)
      if (view_->is_point(*session_, i) && places[i].visible) around.take({places[i].x, places[i].y});
    if (scene.marks != nullptr)
      for (const GlMark& mark : scene.marks->marks)
        around.take(brush.at(frame.origin + frame.unit * mark.at.cast<double>()));
    around.clip({rect_.x, rect_.y, rect_.width, rect_.height - look_.foot});
    return around;
  }

  Bench& bench_;
  Look look_;
  Rect rect_;
  std::optional<lesson::Session> session_;
  std::unique_ptr<SubjectView> view_;
  Stage stage_;
  double now_ = 0;
};

}  // namespace snug::app
