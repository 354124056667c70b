#include "desktop/course_screen.hpp"

#include <imgui.h>
#include <snug_gl.h>

#include <algorithm>
#include <cmath>

#include "app/look.hpp"
#include "app/widgets.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/picture.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kGap = 20, kLeastCard = 220, kPicture = 300.0f / 480;  // of a card's width
constexpr std::string_view kTitle = "Bounding volumes, by hand and eye";
constexpr std::string_view kSays =
    "Drag points, turn boxes, and watch each algorithm answer at once: how a volume is fitted, how tight it is, what "
    "it costs, and where the arithmetic breaks.";

/// How far one is, in words, and in a colour.
struct Progress {
  std::string words;
  app::Color color;
};

Progress progress_of(const app::Look& look, const LessonFile& file, const KeptLesson* kept) {
  if (kept == nullptr) return {"Not begun", look->muted};
  if (kept->done) return {kept->task ? "✓ Done, task too" : "✓ Done", look->optimum_text};
  if (kept->answered > 0)
    return {std::to_string(kept->answered) + " of " + std::to_string(file.lesson.questions.size()) + " predictions",
            look->support_text};
  return {"At step " + std::to_string(kept->step) + " of " + std::to_string(kept->steps), look->support_text};
}

void outline(ImDrawList* list, const app::Rect& r, app::Color color, float width) {
  list->AddRect({r.x, r.y}, {r.x + r.width, r.y + r.height}, color, 8, 0, width);
}

}  // namespace

std::uint32_t CourseScreen::picture(const std::string& id, bool dark) {
  const std::string name = id + (dark ? "-dark.png" : ".png");
  if (const auto found = pictures_.find(name); found != pictures_.end()) return found->second;
  const auto bytes = read_file((program_folder() / "assets" / "course" / name).string());
  const std::uint32_t texture = bytes ? texture_of_png(*bytes) : 0;
  return pictures_[name] = texture;
}

void CourseScreen::draw_hero(Shell& shell, const app::Rect& place, float& y) {
  const app::Look& look = shell.app().look();
  ImDrawList* list = ImGui::GetWindowDrawList();
  app::text(list, look, Face::kSemiBold, 30, {place.x, y}, look->ink, kTitle);
  y += look.px(44);
  y += app::paragraph(list, look, Face::kRegular, 15, 24, {place.x, y}, std::min(place.width, look.px(560)), look->ink,
                      kSays);
  y += 16;
  const auto [lead, words] = shell.lead();
  const float height = look.px(42), width = app::measure(look, Face::kSemiBold, 15, words).x + 36;
  const app::Rect start{place.x, y, width, height};
  if (app::button(list, look,
                  {.id = "start", .rect = start, .words = words, .kind = app::ButtonKind::kPrimary, .size = 15}))
    shell.open_at_place(lead);
  if (chosen_ < 0) outline(list, {start.x - 3, start.y - 3, width + 6, height + 6}, look->current, 2);
  const std::string to = std::to_string(lead + 1) + " · " + shell.lessons()[lead].lesson.title;
  app::text(list, look, Face::kSemiBold, 15, {place.x + width + 16, app::middle_of(y + height / 2, look.px(15))},
            look->ink, to);
  y += height;
}

void CourseScreen::draw_card(Shell& shell, std::size_t lesson, const app::Rect& card) {
  const app::Look& look = shell.app().look();
  const LessonFile& file = shell.lessons()[lesson];
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto touch = app::touch_area(file.lesson.id.c_str(), card);
  const bool chosen = chosen_ == static_cast<int>(lesson);
  const float picture_height = std::floor(card.width * kPicture);
  list->AddRectFilled({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->panel, 8);
  const app::Theme theme = shell.app().settings().theme;
  const bool dark = theme == app::Theme::kDark || theme == app::Theme::kHighContrast;
  if (const std::uint32_t texture = picture(file.lesson.id, dark); texture != 0)
    list->AddImageRounded(static_cast<ImTextureID>(texture), {card.x, card.y},
                          {card.x + card.width, card.y + picture_height}, {0, 0}, {1, 1}, IM_COL32_WHITE, 8,
                          ImDrawFlags_RoundCornersTop);
  app::rule(list, card.x, card.y + picture_height, card.width, look->line);
  const float x = card.x + 12, foot = card.y + card.height - 12 - look.px(13);
  const std::string number = std::to_string(lesson + 1);
  app::text(list, look, Face::kRegular, 15, {x, card.y + picture_height + 12}, look->muted, number);
  const float indent = look.px(24);
  app::paragraph(list, look, Face::kSemiBold, 15, 21, {x + indent, card.y + picture_height + 9},
                 card.width - 24 - indent, touch.hovered ? look->current_text : look->ink, file.lesson.title);
  app::text(list, look, Face::kRegular, 13, {x, foot}, look->muted, std::to_string(file.lesson.minutes) + " min");
  const Progress progress = progress_of(look, file, shell.kept().lesson(file.lesson.id));
  app::text_right(list, look, Face::kRegular, 13, {card.x + card.width - 12, foot}, progress.color, progress.words);
  outline(list, card, chosen || touch.hovered ? look->current : look->line, chosen ? 2 : 1);
  if (chosen && show_) {
    const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
    if (card.y < top || card.y + card.height > bottom) ImGui::SetScrollFromPosY(card.y + card.height / 2 - top);
    show_ = false;
  }
  if (touch.clicked) shell.open_at_place(lesson);
}

void CourseScreen::draw(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const app::Pane pane("##course", rect, app::Pane::Kind::kScrolls);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->ground);
  const float width = std::min(rect.width - 2 * look.px(48), look.px(1120));
  const float left = rect.x + (rect.width - width) / 2;
  float y = rect.y + look.px(36) - ImGui::GetScrollY();
  if (chosen_ < 0 && show_) ImGui::SetScrollY(0), show_ = false;
  draw_hero(shell, {left, y, width, 0}, y);
  across_ = std::max(1, static_cast<int>((width + kGap) / (look.px(kLeastCard) + kGap)));
  const float card = std::floor((width - kGap * static_cast<float>(across_ - 1)) / static_cast<float>(across_));
  const float height = std::floor(card * kPicture) + look.px(42 + 13) + 42;
  const auto& lessons = shell.lessons();
  for (std::size_t i = 0; i < lessons.size();) {
    const std::string& chapter = lessons[i].chapter;
    y += look.px(36);
    app::text(pane.list(), look, Face::kSemiBold, 16, {left, y}, look->ink, chapter);
    y += look.px(26);
    app::rule(pane.list(), left, y, width, look->line);
    y += 16;
    int column = 0;
    for (; i < lessons.size() && lessons[i].chapter == chapter; ++i, column = (column + 1) % across_) {
      if (column == 0 && i > 0 && lessons[i - 1].chapter == chapter) y += height + kGap;
      draw_card(shell, i, {left + static_cast<float>(column) * (card + kGap), y, card, height});
    }
    y += height;
  }
  y += look.px(40);
  app::rule(pane.list(), left, y, width, look->line);
  y += 16;
  const float foot = look.px(32);
  app::text(pane.list(), look, Face::kRegular, 13, {left, app::middle_of(y + foot / 2, look.px(13))}, look->muted,
            "Your answers and your place are kept on this device and go nowhere else.");
  const std::string_view erase = shell.erase_asked ? "Press again to erase them" : "Erase my answers";
  const float erase_width = app::measure(look, Face::kSemiBold, 13, erase).x + 28;
  if (app::button(pane.list(), look,
                  {.id = "erase",
                   .rect = {left + width - erase_width, y, erase_width, foot},
                   .words = erase,
                   .kind = app::ButtonKind::kOutlined,
                   .size = 13})) {
    if (shell.erase_asked) shell.erase_answers();
    shell.erase_asked = !shell.erase_asked;
  }
  ImGui::SetCursorScreenPos({left, y + foot + look.px(32)});
  ImGui::Dummy({1, 1});
}

bool CourseScreen::answer_key(Shell& shell, std::string_view key) {
  const int last = static_cast<int>(shell.lessons().size()) - 1;
  if (key == "Enter" || key == " ") {
    shell.open_at_place(chosen_ >= 0 ? static_cast<std::size_t>(chosen_) : shell.lead().first);
    return true;
  }
  const int step = key == "ArrowRight"  ? 1
                   : key == "ArrowLeft" ? -1
                   : key == "ArrowDown" ? across_
                   : key == "ArrowUp"   ? -across_
                                        : 0;
  const int to = key == "Home"             ? -1
                 : key == "End"            ? last
                 : step == 0               ? chosen_
                 : chosen_ < 0 && step > 0 ? 0
                                           : chosen_ + step;
  if (to == chosen_ && step == 0) return false;
  chosen_ = std::clamp(to, -1, last);
  show_ = true;
  return true;
}

}  // namespace snug::desktop
