#include "app/timeline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/marks.hpp"
#include "app/timeline_buttons.hpp"
#include "app/timeline_map.hpp"
#include "app/widgets.hpp"
#include "lesson/exercise/sitting.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

/// On the button for one step.
std::string_view step_word(const lesson::Session& session) {
  return session.stage().subject().frames() != nullptr ? "Next" : "Step";
}

using Kind = lesson::Mark::Kind;
using lesson::AnswerState;

constexpr float kMarksApart = 13, kFlagWidth = 15;

/// What a gate's flag says: where it stands, whether its question is open, what became of the answer, and whether it is
/// the first of an exercise that differs from what is right.
struct Flag {
  float x = 0;
  bool open = false;
  AnswerState standing = AnswerState::kOpen;
  bool first = false;
};

void draw_flag(ImDrawList* list, const Look& look, const Flag& flag, float y) {
  const Palette& p = *look.palette;
  constexpr float kHeight = 17;
  const ImVec2 low{flag.x - kFlagWidth / 2, y - kHeight - 7}, high{low.x + kFlagWidth, low.y + kHeight};
  list->AddRectFilled(low, high, flag.first ? p.wrong : flag.open ? p.current : p.panel, 4);
  list->AddRect(low, high, flag.first ? p.wrong : p.current, 4, 0, 1.5f);
  const ImVec2 middle{flag.x, low.y + kHeight / 2};
  if (flag.standing == AnswerState::kRight) tick(list, middle, 4, p.optimum, 2);
  else if (flag.standing == AnswerState::kWrong) cross(list, middle, 3.5f, flag.first ? p.panel : p.wrong, 2);
  else {
    Look mark = look;  // it does not grow with the text, nor in a lecture: its flag does not
    mark.text_scale = 1, mark.least = 0, mark.drawn = nullptr;
    text_middle(list, mark, Face::kSemiBold, 12, {flag.x, middle.y - 6}, flag.open ? p.on_current : p.current_text,
                "?");
  }
}

void draw_mark(ImDrawList* list, const Look& look, Kind kind, ImVec2 at, const Flag& flag = {}) {
  const Palette& p = *look.palette;
  switch (kind) {
    case Kind::kGrew:
      disc(list, at, 5.5f * p.mark, p.support);
      disc(list, at, 3.5f * p.mark, p.panel);
      break;
    case Kind::kReplaced: diamond(list, at, 6 * p.mark, p.support, p.panel); break;
    case Kind::kBest:
      disc(list, at, 6.5f * p.mark, p.panel);
      tick(list, at, 5 * p.mark, p.optimum, 2.25f);
      break;
    case Kind::kWrong:
      disc(list, at, 6.5f * p.mark, p.panel);
      cross(list, at, 4.5f * p.mark, p.wrong, 2.25f);
      break;
    case Kind::kQuestion:
      // A gate: a flag above the track, filled until the question is answered.
      list->AddLine({flag.x, at.y - 8}, {at.x, at.y + 5}, p.current, 2);
      draw_flag(list, look, flag, at.y);
      break;
  }
}

bool is_over(const lesson::Session& session) { return session.stage().conduct().decides && all_decided(session); }

/// In an exercise a flag says whether the decision was right, once that is told: so the student's run and the right one
/// stand on one timeline.
AnswerState marked_as(const lesson::Session& session, const lesson::Asked& asked, bool over) {
  if (!session.stage().conduct().decides || !(session.stage().conduct().told || over)) return AnswerState::kOpen;
  return answer_state_of(session.conversation().outcome_of(asked));
}

/// Where both runs of an exercise first differ, once it is over; null for nowhere.
const lesson::Asked* first_difference(const lesson::Session& session) {
  return session.stage().conduct().decides ? first_wrong(session) : nullptr;
}

void draw_track(ImDrawList* list, const Look& look, lesson::Session& session, const TimelineMap& map, float y) {
  const Palette& p = *look.palette;
  const float half = 3;
  const float reach = look.fingers ? 22.0f : 14.0f;
  const Touch touch = pointer_area("track", {map.left - 12, y - reach, map.width + 24, 2 * reach});
  if (touch.held) {
    const int step = map.step_at(ImGui::GetIO().MousePos.x);
    if (step != session.player().step()) session.go(step);
  }
  const float thumb = map.x_of(session.player().step());
  list->AddRectFilled({map.left, y - half}, {map.left + map.width, y + half}, p.track, half);
  list->AddRectFilled({map.left, y - half}, {thumb, y + half}, p.current, half);
  std::vector<lesson::Mark> marks = marks_with_room(marks_to_show(session), map, kMarksApart);
  std::erase_if(marks, [&](const lesson::Mark& mark) { return mark.step > map.steps; });
  const std::vector<float> flags = flag_places(marks, map, kFlagWidth + 2);
  auto asked = std::find_if(session.conversation().questions().begin(), session.conversation().questions().end(),
                            [](const lesson::Asked& one) { return one.step != lesson::Asked::kAnytime; });
  const lesson::Asked* const first = first_difference(session);
  const bool over = is_over(session);
  std::size_t gate = 0;
  for (const lesson::Mark& mark : marks) {
    Flag flag;
    if (mark.kind == Kind::kQuestion) {  // in the order of the questions
      flag = {flags[gate++], is_open(session, *asked), marked_as(session, *asked, over), &*asked == first};
      ++asked;
    }
    draw_mark(list, look, mark.kind, {map.x_of(mark.step), y}, flag);
  }
  const float radius = (touch.held || touch.hovered ? 10.0f : 8.0f) + (look.fingers ? 2.0f : 0.0f);
  disc(list, {thumb, y}, radius + 3, p.panel);
  disc(list, {thumb, y}, radius, p.current);
}

/// Draws the legend of the marks that occur, from the right.
void draw_legend(ImDrawList* list, const Look& look, const lesson::Session& session, const MarkWords& meanings,
                 float right, float y, float room) {
  constexpr float kSize = 13;
  if (first_difference(session) != nullptr) {
    constexpr std::string_view kFirst = "your first difference";
    const float width = measure(look, Face::kRegular, kSize, kFirst).x + 22;
    if ((room -= width + 16) < 0) return;
    text_right(list, look, Face::kRegular, kSize, {right, middle_of(y, look.px(kSize))}, look->muted, kFirst);
    draw_flag(list, look, {right - width + 8, false, AnswerState::kWrong, true}, y + 15);
    right -= width + 16;
  }
  const std::array<std::pair<Kind, std::string_view>, 4> kinds{{{Kind::kGrew, meanings.grew},
                                                                {Kind::kReplaced, meanings.replaced},
                                                                {Kind::kBest, meanings.best},
                                                                {Kind::kWrong, meanings.wrong}}};
  for (const auto& [kind, words] : kinds) {
    const std::vector<lesson::Mark> marks = marks_to_show(session);
    if (std::none_of(marks.begin(), marks.end(), [kind = kind](const lesson::Mark& m) { return m.kind == kind; }))
      continue;
    const float width = measure(look, Face::kRegular, kSize, words).x + 18;
    if ((room -= width + 16) < 0) return;
    text_right(list, look, Face::kRegular, kSize, {right, middle_of(y, look.px(kSize))}, look->muted, words);
    draw_mark(list, look, kind, {right - width + 6, y});
    right -= width + 16;
  }
}

std::string speed_text(float speed) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%g×", static_cast<double>(speed));
  return text.data();
}

/// Draws the menu of speeds above its button.
float speed_menu(const Look& look, const Rect& anchor, float current) {
  float chosen = 0;
  const float row = look.fingers ? 44.0f : look.px(30), width = look.px(80);
  const float height = row * static_cast<float>(kSpeeds.size()) + 8;
  const Popup popup("speeds", {anchor.x + anchor.width - width, anchor.y - height - 4, width, height});
  if (!popup) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetWindowPos();
  for (std::size_t i = 0; i < kSpeeds.size(); ++i) {
    const float speed = kSpeeds[kSpeeds.size() - 1 - i];
    const std::string words = speed_text(speed);
    const Rect rect{corner.x + 4, corner.y + 4 + row * static_cast<float>(i), width - 8, row};
    if (button(list, look,
               {.id = words.c_str(),
                .rect = rect,
                .words = words,
                .kind = speed == current ? ButtonKind::kPlain : ButtonKind::kQuiet})) {
      chosen = speed;
      ImGui::CloseCurrentPopup();
    }
  }
  return chosen;
}

constexpr float kButtonSize = 14, kButtonEdges = 8;

void draw_buttons(ImDrawList* list, const Look& look, const lesson::Session& session, const std::array<Rect, 5>& rects,
                  const PlayerView& player, PlayerWish& wish) {
  const bool gate = session.conversation().asked() != nullptr;
  const bool chosen = session.conversation().picked() != nullptr &&
                      answers(*session.conversation().asked(), *session.conversation().picked());
  const bool told = session.conversation().outcome() != nullptr;
  const bool at_end = session.player().step() == session.player().steps() && !session.player().previewing();
  // The student's run, which goes from decision to decision.
  const bool own = told && is_over(session) &&
                   session.conversation().question_of(*session.conversation().outcome()) !=
                       &session.conversation().questions().back();
  const std::string_view step = own ? lesson::kNextDecisionWord : step_words(session);
  const bool short_of_room = measure(look, Face::kSemiBold, kButtonSize, step).x > rects[2].width - kButtonEdges;
  const bool at_start = session.player().step() == 0;
  const auto press = [&](const Button& b, std::string_view command) {
    if (button(list, look, b)) wish.command = command;
    return b.rect;
  };
  press({.id = "To the start", .rect = rects[0], .icon = Icon::kFirst, .enabled = !at_start}, "first");
  press({.id = "Back", .rect = rects[1], .icon = Icon::kBack, .enabled = !at_start || own}, "back");
  wish.step = press({.id = "step",
                     .rect = rects[2],
                     .words = gate            ? lesson::kAnswerWord
                              : own           ? (short_of_room ? "Next" : step)
                              : told          ? lesson::kContinueWord
                              : short_of_room ? step_word(session)
                                              : step,
                     .icon = chosen || told || session.player().previewing() ? Icon::kNone
                             : gate                                          ? Icon::kLock
                                                                             : Icon::kStep,
                     .kind = ButtonKind::kPrimary,
                     .enabled = chosen || told || (!gate && !at_end)},
                    gate           ? "commit_answer"
                    : told && !own ? "continue"
                                   : "step");
  wish.play = press({.id = "play",
                     .rect = rects[3],
                     .words = player.playing ? "Pause" : "Play",
                     .icon = player.playing ? Icon::kPause : Icon::kPlay,
                     .enabled = player.playing || !gate},
                    "play");
  press({.id = "To the end", .rect = rects[4], .icon = Icon::kLast, .enabled = !gate && !at_end}, "last");
}

}  // namespace

std::string_view step_words(const lesson::Session& session) {
  return session.player().previewing() ? "From the start" : step_word(session);
}

PlayerWish draw_timeline(const Look& look, lesson::Session& session, const SubjectView& view, const Rect& rect,
                         const PlayerView& player) {
  constexpr float kSize = 14;
  PlayerWish wish;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Palette& p = *look.palette;
  rule(list, rect.x, rect.y, rect.width, p.line);

  const TimelineButtons buttons = timeline_buttons(look, rect);
  const TimelineMap map{buttons.left, buttons.width, player.furthest.value_or(session.player().steps())};
  draw_track(list, look, session, map, buttons.track);
  const Rect& at = buttons.speed;
  if (!buttons.low) {
    const std::string step = std::string(session.lesson().subject->step_word) + " " +
                             std::to_string(session.player().step()) +
                             (player.furthest ? "" : " of " + std::to_string(session.player().steps()));
    text(list, look, Face::kRegular, kSize, {map.left + 2, middle_of(buttons.words, look.px(kSize))}, p.muted, step);
    const float said = measure(look, Face::kRegular, kSize, step).x;
    const float legend = buttons.speed_among_words ? at.x - 8 : map.left + map.width;
    draw_legend(list, look, session, view.mark_words(session), legend, buttons.words, legend - map.left - said - 12);
  }
  draw_buttons(list, look, session, buttons.player, player, wish);
  const std::string speed = speed_text(player.speed);
  if (button(list, look, {.id = "speed", .rect = at, .words = speed, .kind = ButtonKind::kQuiet}))
    ImGui::OpenPopup("speeds");
  wish.speed = speed_menu(look, at, player.speed);
  return wish;
}

}  // namespace snug::app
