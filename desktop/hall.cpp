#include "desktop/hall.hpp"

#include <algorithm>
#include <cmath>

#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "lesson/qr.hpp"

namespace snug::desktop {
namespace {

constexpr double kStays = 3, kFades = 1.5;  // seconds
constexpr float kLight = 0.13f;             // the spotlight's radius, of the window's height
constexpr app::Color kBlack = 0xff000000, kWhite = 0xffffffff, kPen = 0xff1a1ae0;

ImVec2 corner_of(const app::Rect& rect) { return {rect.x + rect.width, rect.y + rect.height}; }

/// Dims everything except what is near the pointer.
void draw_spotlight(ImDrawList* list, const app::Rect& window) {
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (at.x < window.x - window.width) return;  // the pointer is elsewhere
  const float radius = kLight * window.height, far = window.width + window.height;
  // A ring whose inside is the light reaches beyond every corner.
  list->AddCircle(at, (radius + far) / 2, app::with_alpha(kBlack, 0.62f), 96, far - radius);
}

/// Type of this height, a fortieth of the window's, is what the last row still reads.
void draw_ruler(ImDrawList* list, const app::Look& look, const app::Rect& window) {
  constexpr int kParts = 40;
  const float part = window.height / kParts, x = window.x + window.width - 2.5f * part;
  const app::Color ink = look->ink;
  list->AddRectFilled({x - part, window.y}, corner_of(window), app::with_alpha(look->panel, 0.9f));
  for (int i = 0; i <= kParts; ++i) {
    const float y = window.y + part * static_cast<float>(i), length = i % 5 == 0 ? 1.5f : 0.8f;
    list->AddLine({x + 2.5f * part - length * part, y}, {x + 2.5f * part, y}, ink, i % 5 == 0 ? 2.0f : 1.0f);
  }
  const float size = part / look.text_scale;
  const std::string words = "1/40: the least that the last row reads";
  const float width = app::measure(look, app::Face::kSemiBold, size, words).x;
  const float y = window.y + window.height / 2, left = x - 2 * part - width;
  list->AddRectFilled({left - part / 2, y - part / 4}, {left + width + part / 2, y + 1.25f * part}, look->panel,
                      part / 4);
  app::text(list, look, app::Face::kSemiBold, size, {left, y}, ink, words);
}

/// Draws the code, its letters and its address on a sheet of paper over the whole window.
void draw_taken(ImDrawList* list, const app::Look& look, const app::Rect& window, const CodeWords& taken) {
  list->AddRectFilled({window.x, window.y}, corner_of(window), kWhite);
  const float letters = 0.09f * window.height / look.text_scale,
              words = std::max(15.0f, 0.025f * window.height / look.text_scale);
  const auto line = [&](float size, app::Face face, float y, std::string_view text) {
    app::text_middle(list, look, face, size, {window.x + window.width / 2, y}, kBlack, text);
  };
  const auto code = taken.address.empty() ? std::nullopt : lesson::qr_code(taken.address);
  if (code) {
    const auto across = static_cast<float>(code->size + 2 * lesson::kQuietZone);
    const float module = std::floor(0.76f * std::min(window.width, window.height) / across);
    const float left = std::floor(window.x + (window.width - module * across) / 2);
    for (int y = 0; y < code->size; ++y)
      for (int x = 0; x < code->size; ++x) {
        const auto at = [&](int i) { return module * static_cast<float>(i + lesson::kQuietZone); };
        if (code->at(x, y))
          list->AddRectFilled({left + at(x), window.y + at(y)}, {left + at(x + 1), window.y + at(y + 1)}, kBlack);
      }
  }
  line(letters, app::Face::kMonoBold, window.y + 0.77f * window.height, taken.letters);
  float y = window.y + 0.88f * window.height;
  for (const std::string_view part : app::lines_of(look, app::Face::kRegular, words, taken.says, 0.9f * window.width)) {
    line(words, app::Face::kRegular, y, part);
    y += 1.4f * look.px(words);
  }
}

}  // namespace

bool Hall::answer_key(const std::string& key) {
  const auto is = [&](auto... names) { return ((key == names) || ...); };
  if (is("l", "L")) return spotlight_ = !spotlight_, true;
  if (is("w", "W")) return pen_ = !pen_, true;
  if (is("r", "R")) return ruler_ = !ruler_, true;
  return curtain_key(key);
}

bool Hall::curtain_key(const std::string& key) {
  const auto is = [&](auto... names) { return ((key == names) || ...); };
  if (is("b", "B", ".")) return black = !black, true;
  if (is("f", "F")) return frozen = !frozen, true;
  return false;
}

bool Hall::put_away() {
  const bool any = spotlight_ || pen_ || ruler_ || !taken.letters.empty();
  spotlight_ = pen_ = ruler_ = false, taken = {};
  return any;
}

void Hall::write(const app::Look& look, const app::Rect& window, double now) {
  const app::Pane pane("##pen", window, app::Pane::Kind::kOver);
  const app::Touch touch = app::pointer_area("pen", window);
  if (touch.held) {
    if (!down_) strokes_.emplace_back();
    strokes_.back().points.push_back(ImGui::GetIO().MousePos);
    strokes_.back().ended = now;
  }
  down_ = touch.held;
  ImGui::SetMouseCursor(ImGuiMouseCursor_None);
  ImGui::GetForegroundDrawList()->AddCircleFilled(ImGui::GetIO().MousePos, std::max(4.0f, 2 * look->stroke), kPen);
}

void Hall::draw(const app::Look& look, const app::Rect& window, double now) {
  ImDrawList* const list = ImGui::GetForegroundDrawList();
  if (spotlight_) draw_spotlight(list, window);
  if (pen_) write(look, window, now);
  else down_ = false;
  std::erase_if(strokes_, [&](const Stroke& stroke) { return now - stroke.ended > kStays + kFades; });
  for (const Stroke& stroke : strokes_) {
    const double late = std::max(0.0, now - stroke.ended - kStays);
    const auto alpha = static_cast<float>(1 - late / kFades);
    app::path(list, stroke.points, false, app::Stroke::kSolid, app::with_alpha(kPen, std::clamp(alpha, 0.0f, 1.0f)),
              std::max(4.0f, window.height / 200));
  }
  if (ruler_) draw_ruler(list, look, window);
  if (!taken.letters.empty()) draw_taken(list, look, window, taken);
}

}  // namespace snug::desktop
