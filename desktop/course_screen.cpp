#include "desktop/course_screen.hpp"

#include <imgui.h>
#include <snug_gl.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "app/look.hpp"
#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/picture.hpp"
#include "desktop/shell.hpp"
#include "lesson/door_words.hpp"
#include "lesson/say.hpp"
#include "lesson/search.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kGap = 20, kLeastCard = 220, kWideHero = 780;
constexpr float kPicture = 300.0f / 480;  // a picture's height, of its width

/// How far one is, in a mark and a word.
struct Progress {
  enum class Kind { kOpen, kBegun, kDone } kind;
  std::string words;
  app::Color color;
};

Progress progress_of(const app::Look& look, const LessonFile& file, const KeptLesson* kept) {
  using Kind = Progress::Kind;
  if (kept == nullptr) return {Kind::kOpen, std::string(lesson::kNotBegunWord), look->muted};
  if (kept->done) return {Kind::kDone, kept->task ? "Done, task too" : "Done", look->optimum_text};
  if (kept->answered > 0)
    return {Kind::kBegun,
            std::to_string(kept->answered) + " of " + std::to_string(file.lesson.questions.size()) + " predictions",
            look->support_text};
  return {Kind::kBegun, "At step " + std::to_string(kept->step) + " of " + std::to_string(kept->steps),
          look->support_text};
}

/// right: the end of its words' line.
void draw_progress(ImDrawList* list, const app::Look& look, ImVec2 right, const Progress& progress) {
  using Kind = Progress::Kind;
  const Face face = progress.kind == Kind::kDone ? Face::kSemiBold : Face::kRegular;
  app::text_right(list, look, face, 13, right, progress.color, progress.words);
  const float radius = look.px(5), x = right.x - app::measure(look, face, 13, progress.words).x - radius - 7;
  const ImVec2 at{x, right.y + look.px(13) / 2};
  if (progress.kind == Kind::kDone) return app::tick(list, at, radius, progress.color, 2);
  app::ring(list, at, radius, progress.color, 1.5f);
  if (progress.kind == Kind::kOpen) return;
  list->PathArcTo(at, radius, 1.5708f, 4.7124f, 12);
  list->PathFillConvex(progress.color);
}

void outline(ImDrawList* list, const app::Rect& r, app::Color color, float width) {
  list->AddRect({r.x, r.y}, {r.x + r.width, r.y + r.height}, color, 8, 0, width);
}

/// In the place of a picture that there is not: an empty stage.
void draw_blank(const app::Look& look, const app::Rect& place, bool all_round) {
  constexpr float kGrid = 24;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled({place.x, place.y}, {place.x + place.width, place.y + place.height}, look->ground, 8,
                      all_round ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersTop);
  const app::Color line = app::with_alpha(look->line, 0.6f);
  for (float x = kGrid; x < place.width; x += kGrid)
    list->AddRectFilled({place.x + x, place.y + 1}, {place.x + x + 1, place.y + place.height - 1}, line);
  for (float y = kGrid; y < place.height; y += kGrid) app::rule(list, place.x + 1, place.y + y, place.width - 2, line);
}

/// What the gallery is, above its first chapter. Returns how high that is.
float draw_gallery_words(const app::Look& look, float x, float y, float width) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float room = std::min(width, look.px(640));
  const float said =
      app::paragraph(list, look, Face::kSemiBold, 20, 28, {x, y}, room, look->ink, lesson::kGalleryTitle);
  return said + 4 +
         app::paragraph(list, look, Face::kRegular, 15, 24, {x, y + said + 4}, room, look->ink, lesson::kGallerySays);
}

/// How high a case's card is so that none of these is cut.
float case_height(const app::Look& look, const std::vector<LessonFile>& files, float width) {
  float most = 0;
  for (const LessonFile& file : files) {
    if (file.of_course()) continue;
    const auto title = app::lines_of(look, Face::kSemiBold, 15, file.lesson.title, width - 24).size();
    const auto says = app::lines_of(look, Face::kRegular, 13, file.lesson.summary, width - 24).size();
    most = std::max(most, look.px(21) * static_cast<float>(title) + look.px(19) * static_cast<float>(says));
  }
  return std::ceil(most) + 28;
}

}  // namespace

std::uint32_t CourseScreen::picture(const std::string& id, bool dark) {
  const std::string name = id + (dark ? "-dark.png" : ".png");
  if (const auto found = pictures_.find(name); found != pictures_.end()) return found->second;
  const auto bytes = read_file((data_folder() / "assets" / "course" / name).string());
  const std::uint32_t texture = bytes ? texture_of_png(*bytes) : 0;
  return pictures_[name] = texture;
}

/// Cut at its top and foot, or its sides, to what the place has room for.
void CourseScreen::draw_picture(Shell& shell, const std::string& id, const app::Rect& place, bool all_round) {
  const app::Theme theme = shell.app().settings().theme;
  const bool dark = theme == app::Theme::kDark || theme == app::Theme::kHighContrast;
  const std::uint32_t texture = shell.writing() ? 0 : picture(id, dark);
  if (texture == 0) return draw_blank(shell.app().look(), place, all_round);
  const float share = place.height / (place.width * kPicture);  // of the picture's height
  const float u = share > 1 ? (1 - 1 / share) / 2 : 0, v = share < 1 ? (1 - share) / 2 : 0;
  ImGui::GetWindowDrawList()->AddImageRounded(
      static_cast<ImTextureID>(texture), {place.x, place.y}, {place.x + place.width, place.y + place.height}, {u, v},
      {1 - u, 1 - v}, IM_COL32_WHITE, 8, all_round ? ImDrawFlags_RoundCornersAll : ImDrawFlags_RoundCornersTop);
}

/// One way in for who is new; who was in a lesson goes on there.
void CourseScreen::draw_start(Shell& shell, const app::Rect& place, float& y) {
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto [lead, words] = shell.lead();
  const lesson::Lesson& lesson = shell.lessons()[lead].lesson;
  const float height = look.px(44), width = app::measure(look, Face::kSemiBold, 15, words).x + 36;
  if (app::button(list, look,
                  {.id = "start",
                   .rect = {place.x, y, width, height},
                   .words = words,
                   .kind = app::ButtonKind::kPrimary,
                   .size = 15}))
    shell.open_at_place(lead);
  start_ = ImGui::GetItemID();
  std::string to = std::to_string(lead + 1) + " · " + lesson.title;
  const float x = place.x + width + 16, room = place.x + place.width - x;
  const auto lines = app::lines_of(look, Face::kSemiBold, 15, to, room);
  const KeptLesson* const kept = shell.kept_lesson(lesson.id);
  const bool begun = kept != nullptr && !kept->done;
  const float all = look.px(21) * static_cast<float>(lines.size() + (begun ? 1 : 0));
  const float top = y + std::max(0.0f, (height - all) / 2);
  const float said = app::paragraph(list, look, Face::kSemiBold, 15, 21, {x, top}, room, look->ink, to);
  if (begun)
    app::text(list, look, Face::kRegular, 14, {x, top + said + look.px(3)}, look->muted,
              "at step " + std::to_string(kept->step) + " of " + std::to_string(kept->steps));
  y += std::max(height, all);
}

void CourseScreen::draw_hero(Shell& shell, const app::Rect& place, float& y) {
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float image = place.width >= look.px(kWideHero) ? std::min(look.px(420), place.width * 0.42f) : 0;
  const app::Rect words{place.x, y, place.width - image - (image > 0 ? look.px(48) : 0), 0};
  const float top = y, picture_height = std::floor(image * 23 / 42);
  const float says_width = std::min(words.width, look.px(540));
  const auto says = app::lines_of(look, Face::kRegular, 15, lesson::kCourseSays, says_width).size();
  const auto title = app::lines_of(look, Face::kSemiBold, 34, lesson::kCourseTitle, words.width).size();
  const float all = look.px(42) * static_cast<float>(title) + look.px(24) * static_cast<float>(says) + look.px(44) + 32;
  y += std::max(0.0f, (picture_height - all) / 2);
  y += app::paragraph(list, look, Face::kSemiBold, 34, 42, {place.x, y}, words.width, look->ink, lesson::kCourseTitle) +
       12;
  y +=
      app::paragraph(list, look, Face::kRegular, 15, 24, {place.x, y}, says_width, look->ink, lesson::kCourseSays) + 20;
  draw_start(shell, words, y);
  if (image == 0) return;
  const app::Rect shown{place.x + place.width - image, top, image, picture_height};
  draw_picture(shell, shell.lessons().front().lesson.id, shown, true);
  outline(list, shown, look->line, 1);
  y = std::max(y, top + picture_height);
}

void CourseScreen::draw_card(Shell& shell, std::size_t lesson, const app::Rect& card) {
  const app::Look& look = shell.app().look();
  const LessonFile& file = shell.lessons()[lesson];
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto touch = app::touch_area(file.lesson.id.c_str(), card, file.lesson.title);
  cards_.push_back({lesson, ImGui::GetItemID(), card});
  const float picture_height = std::floor(card.width * kPicture);
  list->AddRectFilled({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->panel, 8);
  draw_picture(shell, file.lesson.id, {card.x, card.y, card.width, picture_height}, false);
  app::rule(list, card.x, card.y + picture_height, card.width, look->line);
  const float x = card.x + 12, foot = card.y + card.height - 12 - look.px(13);
  const std::string number = std::to_string(lesson + 1);
  const float indent = app::measure(look, Face::kRegular, 15, number).x + 8;
  app::text(list, look, Face::kRegular, 15, {x, card.y + picture_height + 12}, look->muted, number);
  app::paragraph(list, look, Face::kSemiBold, 15, 21, {x + indent, card.y + picture_height + 9},
                 card.width - 24 - indent, touch.hovered ? look->current_text : look->ink, file.lesson.title);
  app::text(list, look, Face::kRegular, 13, {x, foot}, look->muted,
            file.lesson.minutes > 0 ? std::to_string(file.lesson.minutes) + " min" : "Draft");
  draw_progress(list, look, {card.x + card.width - 12, foot},
                progress_of(look, file, shell.kept_lesson(file.lesson.id)));
  outline(list, card, touch.hovered ? look->current : look->line, 1);
  if (touch.clicked) shell.open_at_place(lesson);
}

/// A case has no picture and no progress: its title, and what is hard about it.
void CourseScreen::draw_case(Shell& shell, std::size_t lesson, const app::Rect& card) {
  const app::Look& look = shell.app().look();
  const lesson::Lesson& own = shell.lessons()[lesson].lesson;
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto touch = app::touch_area(own.id.c_str(), card, own.title);
  cards_.push_back({lesson, ImGui::GetItemID(), card});
  list->AddRectFilled({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->panel, 8);
  const float x = card.x + 12, room = card.width - 24;
  const float said = app::paragraph(list, look, Face::kSemiBold, 15, 21, {x, card.y + 9}, room,
                                    touch.hovered ? look->current_text : look->ink, own.title);
  const ImVec2 corner{card.x + card.width, card.y + card.height - 8};
  list->PushClipRect({card.x, card.y}, corner, true);
  app::paragraph(list, look, Face::kRegular, 13, 19, {x, card.y + 9 + said + 4}, room, look->muted, own.summary);
  list->PopClipRect();
  outline(list, card, touch.hovered ? look->current : look->line, 1);
  if (touch.clicked) shell.open_at_place(lesson);
}

/// Those of its lessons that are found, under its title and how many of them are done.
void CourseScreen::draw_chapter(Shell& shell, const Grid& grid, std::size_t from, std::size_t to, float& y) {
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const auto& lessons = shell.lessons();
  std::vector<std::size_t> shown;
  int done = 0;
  for (std::size_t i = from; i < to; ++i) {
    const KeptLesson* const kept = shell.kept_lesson(lessons[i].lesson.id);
    done += kept != nullptr && kept->done ? 1 : 0;
    if (lesson::is_found(text_of(shell, i), asked())) shown.push_back(i);
  }
  if (shown.empty()) return;
  y += look.px(36);
  app::text(list, look, Face::kSemiBold, 16, {grid.left, y}, look->ink, lessons[from].chapter);
  app::text_right(list, look, Face::kRegular, 13, {grid.left + grid.width, y + look.px(2)}, look->muted,
                  lessons[from].is_case ? std::string(lesson::kCasesWord)
                  : lessons[from].sheet != nullptr
                      ? "Measured, built and written, for one file to hand in"
                      : std::to_string(done) + " of " + std::to_string(to - from) + " done");
  y += look.px(26);
  app::rule(list, grid.left, y, grid.width, look->line);
  y += 16;
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const auto column = static_cast<int>(k) % grid.across;
    if (column == 0 && k > 0) y += grid.height + kGap;
    const app::Rect card{grid.left + static_cast<float>(column) * (grid.card + kGap), y, grid.card, grid.height};
    if (!lessons[from].of_course()) draw_case(shell, shown[k], card);
    else draw_card(shell, shown[k], card);
  }
  y += grid.height;
}

void CourseScreen::draw_found(Shell& shell, const app::Rect& place, float& y) {
  const app::Look& look = shell.app().look();
  lesson::Found found;
  for (std::size_t i = 0; i < shell.lessons().size(); ++i)
    if (lesson::is_found(text_of(shell, i), asked()))
      ++(shell.lessons()[i].sheet != nullptr ? found.sheets : found.lessons);
  std::set<std::string> exercises;  // some stand in several sets
  for (const lesson::ExerciseSet& set : shell.sets())
    for (const lesson::Exercise* exercise : found_in(shell, set)) exercises.insert(exercise->id);
  found.exercises = static_cast<int>(exercises.size());
  const float height = look.px(34),
              width = app::measure(look, Face::kSemiBold, 14, lesson::kShowAllWord).x + look.px(28);
  app::text(ImGui::GetWindowDrawList(), look, Face::kSemiBold, 15,
            {place.x, app::middle_of(y + height / 2, look.px(15))}, look->ink, lesson::found_text(found, asked()));
  if (app::button(ImGui::GetWindowDrawList(), look,
                  {.id = "all lessons",
                   .rect = {place.x + place.width - width, y, width, height},
                   .words = lesson::kShowAllWord,
                   .kind = app::ButtonKind::kOutlined}))
    asked_ = {};
  y += height;
}

void CourseScreen::draw(Shell& shell, const app::Rect& rect) {
  const app::Look& look = shell.app().look();
  const app::Pane pane("##course", rect, app::Pane::Kind::kScrolls);
  pane.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->ground);
  const float width = std::min(rect.width - 2 * look.px(48), look.px(1120));
  Grid grid{.left = std::floor(rect.x + (rect.width - width) / 2), .width = width, .card = 0, .height = 0, .across = 1};
  grid.across = std::max(1, static_cast<int>((width + kGap) / (look.px(kLeastCard) + kGap)));
  grid.card = std::floor((width - kGap * static_cast<float>(grid.across - 1)) / static_cast<float>(grid.across));
  grid.height = std::floor(grid.card * kPicture) + look.px(42 + 13) + 42;
  float y = rect.y + look.px(36) - ImGui::GetScrollY();
  cards_.clear();
  const app::Rect place{grid.left, y, width, 0};
  if (lesson::is_search(asked())) draw_found(shell, place, y);
  else draw_hero(shell, place, y);
  const auto& lessons = shell.lessons();
  for (std::size_t i = 0, end = 0; i < lessons.size(); i = end) {
    while (end < lessons.size() && lessons[end].chapter == lessons[i].chapter) ++end;
    if (i == shell.course_size()) {
      draw_sets(shell, grid, y);
      grid.height = case_height(look, lessons, grid.card);
    }
    if (lessons[i].is_case && (i == 0 || !lessons[i - 1].is_case) && !lesson::is_search(asked())) {
      y += look.px(52);
      y += draw_gallery_words(look, grid.left, y, width);
    }
    draw_chapter(shell, grid, i, end, y);
  }
  y += look.px(40);
  app::rule(pane.list(), grid.left, y, width, look->line);
  const std::string foot =
      std::string(lesson::kKeptFoot) + (shell.kept().works() ? std::string() : " " + std::string(lesson::kNotKept)) +
      (shell.kept().set_aside().empty()
           ? std::string()
           : " What was kept before is damaged, and was set aside as " + shell.kept().set_aside() + ".");
  y += 12;
  y += app::paragraph(pane.list(), look, Face::kRegular, 13, 20, {grid.left, y}, width, look->muted, foot);
  ImGui::SetCursorScreenPos({grid.left, y + look.px(32)});
  ImGui::Dummy({1, 1});
}

void CourseScreen::draw_search(Shell& shell, const app::Rect& bar) {
  const app::Look& look = shell.app().look();
  const float width = std::min(bar.width, look.px(256));
  ImGui::PushFont(look.font(Face::kRegular), app::font_size(look, Face::kRegular, 14));
  const float height = ImGui::GetFrameHeight();
  ImGui::SetCursorScreenPos({bar.x + bar.width - width, std::floor(bar.y + (bar.height - height) / 2)});
  ImGui::SetNextItemWidth(width);
  ImGui::PushStyleColor(ImGuiCol_Border, look->muted);
  const bool entered =
      ImGui::InputTextWithHint("##search", "Search: k-DOP, PCA …", asked_.data(), asked_.size(),
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_EscapeClearsAll);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  search_ = ImGui::GetItemID();
  app::offer_field(lesson::kSearchWord);
  if (entered && !cards_.empty()) shell.focus.go_to(cards_.front().id);
}

const std::string& CourseScreen::text_of(const Shell& shell, std::size_t lesson) {
  const auto& lessons = shell.lessons();
  for (std::size_t i = texts_.size(); i < lessons.size(); ++i)
    texts_.push_back(
        lesson::search_text(lessons[i].lesson, static_cast<int>(i) + 1, lessons[i].chapter, lessons[i].slides));
  return texts_[lesson];
}

int CourseScreen::chosen(const Shell& shell) const {
  for (const Card& card : cards_)
    if (card.id == shell.focus.at() && card.exercise.empty()) return static_cast<int>(card.lesson);
  return -1;
}

std::vector<std::size_t> CourseScreen::found(const Shell& shell) const {
  std::vector<std::size_t> lessons;
  for (const Card& card : cards_)
    if (card.exercise.empty() && card.lesson < shell.course_size()) lessons.push_back(card.lesson);
  return lessons;
}

std::vector<std::string> CourseScreen::found_beside(const Shell& shell) const {
  std::vector<std::string> ids;
  for (const Card& card : cards_)
    if (!card.exercise.empty()) ids.push_back(card.exercise);
    else if (shell.lessons()[card.lesson].sheet != nullptr) ids.push_back(shell.lessons()[card.lesson].lesson.id);
  return ids;
}

void CourseScreen::open(Shell& shell, const Card& card) {
  if (card.exercise.empty()) shell.open_at_place(card.lesson);
  else shell.go_on_with_exercise(std::string(card.exercise));  // the card goes with the screen
}

/// The card that an arrow key leads to, from one or from none; null before the first.
const CourseScreen::Card* CourseScreen::next_card(const Card* from, std::string_view key) const {
  const bool on = key == "ArrowRight" || key == "ArrowDown";
  if (from == nullptr) return on ? &cards_.front() : nullptr;
  if (key == "ArrowRight") return from + 1 < cards_.data() + cards_.size() ? from + 1 : from;
  if (key == "ArrowLeft") return from > cards_.data() ? from - 1 : nullptr;
  // In the next row, the one that stands nearest.
  const Card* best = nullptr;
  const auto away = [&](const Card& card) {
    return std::abs(card.rect.y - from->rect.y) * 10 + std::abs(card.rect.x - from->rect.x);
  };
  for (const Card& card : cards_)
    if ((on ? card.rect.y > from->rect.y + 1 : card.rect.y < from->rect.y - 1) &&
        (best == nullptr || away(card) < away(*best)))
      best = &card;
  return best != nullptr || !on ? best : from;
}

bool CourseScreen::answer_key(Shell& shell, std::string_view key) {
  if (key == "/") return shell.focus.go_to(search_), true;
  if (key == "Escape" && lesson::is_search(asked())) return asked_ = {}, true;
  if (key == "Enter" || key == " ") {
    if (cards_.empty()) return false;
    if (lesson::is_search(asked())) open(shell, cards_.front());
    else shell.open_at_place(shell.lead().first);
    return true;
  }
  if (cards_.empty()) return false;
  const auto at =
      std::find_if(cards_.begin(), cards_.end(), [&](const Card& one) { return one.id == shell.focus.at(); });
  const Card* const from = at != cards_.end() ? &*at : nullptr;
  const bool arrow = key.starts_with("Arrow");
  if (!arrow && key != "Home" && key != "End") return false;
  const Card* const to = arrow ? next_card(from, key) : key == "End" ? &cards_.back() : nullptr;
  shell.focus.go_to(to != nullptr ? to->id : start_);
  return true;
}

}  // namespace snug::desktop
