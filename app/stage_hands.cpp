// The pointer on the stage: selects, drags and taps handles, and pans, orbits and zooms the view.
#include <cmath>

#include "app/numbers.hpp"
#include "app/picking.hpp"
#include "app/stage.hpp"
#include "app/widgets.hpp"
#include "lesson/point_subject.hpp"

namespace snug::app {
namespace {

constexpr float kTravel = 3;         // pixels that a pointer may move before it counts as a drag
constexpr double kNudgePixels = 12;  // an arrow key's step is the next round number above this

}  // namespace

void Stage::take(lesson::Session& session, const Look& look, const Rect& rect) {
  ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextItemAllowOverlap();
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::InvisibleButton("stage", {std::max(1.0f, rect.width), std::max(1.0f, rect.height)},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  const bool over = ImGui::IsItemHovered();
  const float reach = look.fingers ? kFingerReach : kMouseReach;
  hands_.hovered = over || hands_.dragging ? meant_at(session, io.MousePos.x, io.MousePos.y, reach) : kNoIndex;
  hands_.grabs = pressed_ != kNoIndex || (over && grabbed(session, look, io.MousePos.x, io.MousePos.y) != kNoIndex);
  if (pressed_ != kNoIndex) hands_.hovered = pressed_;
  if (ImGui::IsItemActivated()) press(session, look);
  // A key may have deleted the handle meanwhile; and any edit by one ends a drag.
  if (pressed_ >= session.stage().subject().size() || (hands_.dragging && !session.stage().dragging())) let_go();
  // Also in the frame in which it ends, because a whole drag can happen between two slow frames.
  if (pressing_ && ImGui::IsMousePosValid()) drag(session);
  if (pressing_ && !ImGui::IsItemActive()) release(session);
  if (over) steer_camera();
  if (over && view_->can_move(session) && !answered_on_stage(session) && hands_.hovered == kNoIndex && !travelled_ &&
      ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
    const Point3 at = camera_.unproject(io.MousePos.x, io.MousePos.y, camera_.view().target);
    if (session.stage().add(at))
      hands_.selected = lesson::count_of(session.stage().subject()) - 1, hands_.arrows = false;
  }
}

/// The handle that a tap at a place means; while a question is answered on the stage, only possible answers.
Index Stage::meant_at(const lesson::Session& session, float x, float y, float reach) const {
  if (!answered_on_stage(session) || session.conversation().asked()->stage_points.empty())
    return pick(screen_, x, y, reach);
  const std::vector<Index> targets = session.conversation().targets();
  std::vector<ScreenPoint> places;
  for (const Index i : targets) places.push_back(screen_[i]);
  const Index found = pick(places, x, y, reach);
  return found == kNoIndex ? kNoIndex : targets[found];
}

/// The handle that a press at a place would drag.
Index Stage::grabbed(const lesson::Session& session, const Look& look, float x, float y) const {
  if (!view_->can_move(session)) return kNoIndex;
  const Index found = grab(screen_, session.stage().subject().dim() == 3, hands_.selected, x, y, look.fingers);
  return found != kNoIndex && session.stage().may_move(found) ? found : kNoIndex;
}

void Stage::press(lesson::Session& session, const Look& look) {
  const ImGuiIO& io = ImGui::GetIO();
  pressing_ = true;
  travelled_ = false;
  press_x_ = io.MousePos.x, press_y_ = io.MousePos.y;
  const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
  const bool means_points = left && !io.KeyShift;
  const float reach = look.fingers ? kFingerReach : kMouseReach;
  tapped_ = means_points ? meant_at(session, press_x_, press_y_, reach) : kNoIndex;
  if (means_points && tapped_ == kNoIndex) tapped_ = pick(screen_, press_x_, press_y_, reach);
  pressed_ = means_points ? grabbed(session, look, press_x_, press_y_) : kNoIndex;
  panning_ = !left || io.KeyShift || session.stage().subject().dim() == 2;
  if (pressed_ == kNoIndex) return;
  const ScreenPoint& point = screen_[pressed_];
  grab_x_ = point.x - press_x_, grab_y_ = point.y - press_y_;
}

void Stage::drag(lesson::Session& session) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!travelled_ && std::hypot(io.MousePos.x - press_x_, io.MousePos.y - press_y_) < kTravel) return;
  const bool begins = !travelled_;
  travelled_ = true;
  if (pressed_ == kNoIndex) {
    // The first few pixels, which distinguish a drag from a click, are part of the motion.
    const float dx = begins ? io.MousePos.x - press_x_ : io.MouseDelta.x,
                dy = begins ? io.MousePos.y - press_y_ : io.MouseDelta.y;
    if (panning_) camera_.pan(dx, dy);
    else camera_.orbit(dx, dy);
    return;
  }
  if (begins) {
    session.stage().begin_drag();
    hands_.dragging = true;
    hands_.selected = pressed_;  // shows its numbers; the arrow keys still step the player
    hands_.arrows = false;
  }
  if (io.MouseDelta.x == 0 && io.MouseDelta.y == 0 && !begins) return;
  const Point3 at = shown_at(session, session.stage().subject().at(pressed_));
  const Point3 to = camera_.unproject(io.MousePos.x + grab_x_, io.MousePos.y + grab_y_, at);
  // If refused, beyond the largest coordinate, the point stays.
  static_cast<void>(session.stage().move(pressed_, meant_by(session, to)));
}

void Stage::release(lesson::Session& session) {
  if (hands_.dragging) {
    session.stage().end_drag();
    seen_ = session.revision() - 1;  // the view may follow now
  } else if (!travelled_) {
    tap(session);
  }
  let_go();
}

/// The hand is off the stage.
void Stage::let_go() {
  pressing_ = hands_.dragging = panning_ = false;
  pressed_ = tapped_ = kNoIndex;
}

/// A press without a drag: it chooses an answer, if a question is answered on the stage, or selects a point. The arrow
/// keys then move the point only if no question is open; otherwise they still step.
void Stage::tap(lesson::Session& session) {
  if (answered_on_stage(session)) {
    if (tapped_ != kNoIndex) static_cast<void>(session.conversation().pick(lesson::OneHandle{tapped_}));
    hands_.selected = kNoIndex;
    return;
  }
  if (tapped_ != kNoIndex && session.conversation().asked() == nullptr &&
      session.player().push(tapped_)) {  // where it cannot be moved
    hands_.selected = kNoIndex;
    return;
  }
  hands_.selected = tapped_;
  hands_.arrows = tapped_ != kNoIndex && session.conversation().asked() == nullptr && view_->can_move(session) &&
                  session.stage().may_move(tapped_);
}

void Stage::steer_camera() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.MouseWheel == 0 || hands_.dragging) return;
  camera_.zoom(std::pow(1.12, io.MouseWheel), io.MousePos.x, io.MousePos.y);
}

void Stage::pinch(float factor, float x, float y, float dx, float dy) {
  camera_.pan(dx, dy);
  if (factor > 0) camera_.zoom(factor, x, y);
}

Point3 Stage::shown_at(const lesson::Session& session, const Point3& at) const {
  const LocalFrame* const frame = view_->local_frame(session);
  return frame != nullptr ? frame->place_shown(session, at) : at;
}

Point3 Stage::meant_by(const lesson::Session& session, const Point3& shown) const {
  const LocalFrame* const frame = view_->local_frame(session);
  return frame != nullptr ? frame->place_meant(session, shown) : shown;
}

bool Stage::nudge(lesson::Session& session, int right, int up, int away, bool fine) {
  if (hands_.selected == kNoIndex || !view_->can_move(session) || (away != 0 && session.stage().subject().dim() == 2))
    return false;
  const Point3 from = shown_at(session, session.stage().subject().at(hands_.selected));
  const double step = nice_at_least(kNudgePixels / camera_.scale_at(from)) * (fine ? 0.1 : 1);
  const Point3 by = camera_.right() * right + camera_.up() * up + camera_.forward() * away;
  return session.stage().move(hands_.selected, meant_by(session, from + by * step)).has_value();
}

bool Stage::add_point(lesson::Session& session) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Rect& stage = camera_.stage();
  const bool over = view_->can_move(session) && mouse.x >= stage.x && mouse.y >= stage.y &&
                    mouse.x < stage.x + stage.width && mouse.y < stage.y + stage.height;
  const Point3 at = over ? camera_.unproject(mouse.x, mouse.y, camera_.view().target) : Point3(camera_.view().target);
  if (!session.stage().add(at)) return false;
  hands_.selected = lesson::count_of(session.stage().subject()) - 1;
  hands_.arrows = false;
  return true;
}

bool Stage::delete_point(lesson::Session& session) {
  if (hands_.selected == kNoIndex || !session.stage().remove(hands_.selected)) return false;
  hands_.selected = kNoIndex;
  return true;
}

}  // namespace snug::app
