#include "app/commands.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "app/app_state.hpp"
#include "app/timeline.hpp"
#include "io/text.hpp"
#include "lesson/demo.hpp"
#include "lesson/demo_reveal.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

using Where = Command::Where;

constexpr double kOrbitStep = 0.2, kZoomStep = 1.25;

lesson::Conversation& conversation(AppState& s) { return s.session->conversation(); }

/// What is played goes on only if it is the way to an outcome. Returns true, as a command that did something.
bool stop(AppState& s) {
  s.playing = conversation(s).deciding() != nullptr;
  return true;
}

/// Ends the playing and goes there. Returns whether anything has changed.
bool go(AppState& s, auto there) {
  const auto state = [&] {
    return std::tuple(s.session->player().step(), s.session->player().previewing(), conversation(s).asked() != nullptr);
  };
  const auto before = state();
  there();
  s.playing = false;
  return state() != before;
}

/// Whether an exercise is over and shows the student's own run, which is stepped through in its own way.
bool shows_own_run(AppState& s) {
  return s.sitting && s.sitting->looks_at(*s.session) == lesson::Sitting::Looked::kOwn;
}

/// What comes first where somebody wants to go on: a step of one's own run, the end of an outcome, and the gate of a
/// question, which is skipped at the second press, because a clicker has no other key.
bool goes_on(AppState& s, bool to_mark) {
  if (shows_own_run(s) && s.sitting->step_own(*s.session, 1)) return true;
  if (conversation(s).acknowledge()) return true;
  const lesson::Asked* const asked = conversation(s).asked();
  const bool is_gate = asked != nullptr && (to_mark || asked->step != lesson::Asked::kAnytime);
  return is_gate && conversation(s).pass_by();
}

bool step(AppState& s, std::string_view) {
  if (goes_on(s, false)) return stop(s);
  return go(s, [&] { s.session->forward(); });
}

bool next_mark(AppState& s, std::string_view) {
  if (goes_on(s, true)) return stop(s);
  return go(s, [&] {
    if (s.session->player().previewing()) s.session->forward();
    else s.session->go(s.session->player().next_mark());
  });
}

/// Goes back, or in one's own run by a step.
bool go_back(AppState& s, int step) {
  if (shows_own_run(s)) return s.sitting->step_own(*s.session, -1), stop(s);
  return go(s, [&] { s.session->go(step); });
}

bool back(AppState& s, std::string_view) { return go_back(s, s.session->player().step() - 1); }
bool previous_mark(AppState& s, std::string_view) { return go_back(s, s.session->player().previous_mark()); }

bool first(AppState& s, std::string_view) {
  return go(s, [&] { s.session->go(0); });
}

bool last(AppState& s, std::string_view) {
  return go(s, [&] { s.session->last(); });
}

bool play(AppState& s, std::string_view) {
  if (shows_own_run(s)) s.sitting->change_run(*s.session);  // it is the right run that plays
  if (conversation(s).acknowledge()) return stop(s);
  s.playing = !s.playing && conversation(s).asked() == nullptr;
  if (!s.playing) return true;
  const lesson::Player& player = s.session->player();
  if (player.step() == player.steps() && !player.previewing()) s.session->go(0);
  s.next_step_at = s.now + (player.previewing() ? 0 : s.pause());
  return true;
}

template <int By>
bool change_speed(AppState& s, std::string_view) {
  const auto at = std::find(kSpeeds.begin(), kSpeeds.end(), s.speed) - kSpeeds.begin();
  s.speed = kSpeeds[std::clamp<std::ptrdiff_t>(at + By, 0, std::ssize(kSpeeds) - 1)];
  return true;
}

bool close_summary(AppState& s, std::string_view) {
  if (!conversation(s).at_summary()) return false;
  conversation(s).close_summary();
  return stop(s);
}

/// Closes what is told: an outcome, or the summary at the end.
bool go_on(AppState& s, std::string_view) { return conversation(s).acknowledge() ? stop(s) : close_summary(s, {}); }

bool commit_answer(AppState& s, std::string_view) {
  if (!go_on(s, {}) && !conversation(s).commit()) return false;
  s.decide_by_measuring();
  return true;
}

bool skip_question(AppState& s, std::string_view) { return conversation(s).give(lesson::Skipped{}, false); }
bool take_back(AppState& s, std::string_view) { return conversation(s).take_back() && stop(s); }
bool practise(AppState& s, std::string_view) { return conversation(s).practise() && stop(s); }
bool show_answer(AppState& s, std::string_view) { return conversation(s).show_answer() && stop(s); }
bool review(AppState& s, std::string_view question) { return conversation(s).review(question) && stop(s); }

bool watch_outcome(AppState& s, std::string_view) {
  if (!conversation(s).watch_outcome()) return false;
  s.watch();
  return stop(s);
}

/// Forgets the lesson's answers and starts it over.
bool predict_again(AppState& s, std::string_view) {
  if (s.sitting) return false;
  s.forget();
  if (s.session->lesson().subject->experiment == nullptr) s.session->go(0);
  return stop(s);
}

bool pass_questions(AppState& s, std::string_view) {
  if (s.sitting) return false;
  lesson::pass_questions(*s.session);
  s.playing = false;
  return true;
}

bool reveal_answer(AppState& s, std::string_view) {
  if (s.sitting) return false;
  lesson::reveal_answer(*s.session);
  s.playing = false;
  return true;
}

bool hint(AppState& s, std::string_view) { return s.sitting && s.sitting->take_hint(*s.session) && stop(s); }
bool other_run(AppState& s, std::string_view) { return s.sitting && s.sitting->change_run(*s.session) && stop(s); }
bool back_to_best(AppState& s, std::string_view) { return s.sitting && s.sitting->back_to_best(*s.session) && stop(s); }
bool finish(AppState& s, std::string_view) { return s.sitting && s.sitting->finish() && stop(s); }
bool show_model(AppState& s, std::string_view) { return s.sitting && s.sitting->show_model(*s.session) && stop(s); }

bool undo(AppState& s, std::string_view) {
  if (!s.session->stage().can_undo()) return false;
  s.session->stage().undo();
  return true;
}

bool redo(AppState& s, std::string_view) {
  if (!s.session->stage().can_redo()) return false;
  s.session->stage().redo();
  return true;
}

bool add_point(AppState& s, std::string_view) { return s.stage.add_point(*s.session); }
bool delete_point(AppState& s, std::string_view) { return s.stage.delete_point(*s.session); }

/// Lets the selected body of a scene hop.
bool push(AppState& s, std::string_view) {
  return conversation(s).asked() == nullptr && s.session->player().push(s.stage.selected());
}

bool scatter(AppState& s, std::string_view) {
  return s.session->stage().scatter(s.session->stage().subject().origin().seed + 1).has_value();
}

bool reset_points(AppState& s, std::string_view) { return s.session->stage().reset().has_value(); }

/// Does with an effect of the scene what Player::toggle does.
bool turn(AppState& s, std::string_view effect) {
  for (const lesson::Switch& one : s.session->player().switches())
    if (one.name == effect) return s.session->player().toggle(one);
  return false;
}

/// Chooses the next or previous possible answer among the handles. Returns false if the question is not answered on the
/// stage; of several handles, each is tapped or named.
bool choose_target(AppState& s, int by) {
  const std::vector<Index> targets = conversation(s).targets();
  if (targets.empty() || conversation(s).asked()->many) return false;
  const lesson::Answer* picked = conversation(s).picked();
  if (picked == nullptr) picked = conversation(s).tried();
  const auto* const one = picked != nullptr ? std::get_if<lesson::OneHandle>(picked) : nullptr;
  const auto found = one != nullptr ? std::find(targets.begin(), targets.end(), one->handle) : targets.end();
  const std::ptrdiff_t n = std::ssize(targets);
  const std::ptrdiff_t at = found != targets.end() ? found - targets.begin() : -1;
  const std::ptrdiff_t next = at < 0 ? (by > 0 ? 0 : n - 1) : (at + by + n) % n;
  if (next != at) static_cast<void>(conversation(s).pick(lesson::OneHandle{targets[next]}, false));
  return true;
}

template <int By>
bool select(AppState& s, std::string_view) {
  if (choose_target(s, By)) return true;
  const Index n = s.session->stage().subject().size(), at = s.stage.selected();
  if (n == 0) return false;
  const Index begin = By > 0 ? n - 1 : 0;  // before the first, or behind the last
  Index to = ((at == kNoIndex ? begin : at) + n + By) % n;
  while (!s.stage.shows(*s.session, to)) to = (to + n + By) % n;
  s.stage.select(to);
  return true;
}

bool select_none(AppState& s, std::string_view) {
  if (conversation(s).picked() != nullptr) return conversation(s).unpick(), true;
  if (s.stage.selected() == kNoIndex) return false;
  s.stage.select(kNoIndex);
  return true;
}

/// Moves the selected point, by a tenth if fine.
template <int X, int Y, int Z, bool Fine>
bool move(AppState& s, std::string_view) {
  return s.stage.nudge(*s.session, X, Y, Z, Fine);
}

bool reset_view(AppState& s, std::string_view) {
  s.stage.reset_view(*s.session);
  return true;
}

template <bool In>
bool zoom(AppState& s, std::string_view) {
  s.stage.zoom_by(In ? kZoomStep : 1 / kZoomStep);
  return true;
}

template <int Right, int Up>
bool orbit(AppState& s, std::string_view) {
  return s.stage.orbit_by(Right * kOrbitStep, Up * kOrbitStep);
}

bool toggle_optimum(AppState& s, std::string_view) {
  s.settings.show_optimum = !s.settings.show_optimum;
  return true;
}

constexpr auto kSelected = Where::kSelected, kNothing = Where::kNothingSelected, kExercise = Where::kInExercise;

constexpr Command kCommands[] = {
    // The player.
    {"step", step, "ArrowRight ArrowDown", kNothing, "", "next, previous"},
    {"back", back, "ArrowLeft ArrowUp", kNothing, "", kAbove},
    {"play", play, "Space", {}, "Play or pause", "play or pause"},
    {"first", first, "Home", {}, "First step", "the first step, the last step"},
    {"last", last, "End", {}, "Last step", kAbove},
    {"next_mark",
     next_mark,
     "PageDown",
     {},
     "Next mark",
     "the next mark, the previous one; at a question, PgDn twice skips it"},
    {"previous_mark", previous_mark, "PageUp", {}, "Previous mark", kAbove},
    {"slower", change_speed<-1>, "<", {}, "", "slower, faster"},
    {"faster", change_speed<1>, ">", {}, "", kAbove},
    // The questions.
    {"commit_answer", commit_answer, "Enter", {}, "", "give the chosen answer; continue"},
    {"skip_question", skip_question, "s", {}, "", "skip the question"},
    {"continue", go_on},
    {"show_answer", show_answer},
    {"watch_outcome", watch_outcome},
    {"close_summary", close_summary, "Escape", Where::kAtSummary},
    {"review:", review},
    {"practise", practise},
    {"predict_again", predict_again},
    {"pass_questions", pass_questions},
    {"reveal_answer", reveal_answer},
    // An exercise.
    {"hint", hint, "h", kExercise, "", "in an exercise: a hint; at its end, from the right run to yours, and back"},
    {"other_run", other_run, "r", kExercise, "", kAbove},
    {"take_back", take_back, "Backspace", kExercise, "", "in an exercise: take back the last decision"},
    {"back_to_best", back_to_best},
    {"finish", finish},
    {"show_model", show_model},
    // The stage.
    {"select_previous",
     select<-1>,
     "[",
     {},
     "",
     "select the previous or the next point; in a question, those that can be the answer"},
    {"select_next", select<1>, "]", {}, "", kAbove},
    {"select_none", select_none, "Escape", {}, "", "select nothing"},
    {"move_up", move<0, 1, 0, false>, "ArrowUp", kSelected, "", "move the selected point; with Shift by a tenth"},
    {"move_down", move<0, -1, 0, false>, "ArrowDown", kSelected, "", kAbove},
    {"move_left", move<-1, 0, 0, false>, "ArrowLeft", kSelected, "", kAbove},
    {"move_right", move<1, 0, 0, false>, "ArrowRight", kSelected, "", kAbove},
    {"move_farther", move<0, 0, 1, false>, ",", kSelected, "", "move it farther away or nearer (3-D)"},
    {"move_nearer", move<0, 0, -1, false>, ".", kSelected, "", kAbove},
    {"move_up_fine", move<0, 1, 0, true>, "Shift+ArrowUp", kSelected},
    {"move_down_fine", move<0, -1, 0, true>, "Shift+ArrowDown", kSelected},
    {"move_left_fine", move<-1, 0, 0, true>, "Shift+ArrowLeft", kSelected},
    {"move_right_fine", move<1, 0, 0, true>, "Shift+ArrowRight", kSelected},
    {"move_farther_fine", move<0, 0, 1, true>, "Shift+<", kSelected},
    {"move_nearer_fine", move<0, 0, -1, true>, "Shift+>", kSelected},
    {"add_point", add_point, "a", {}, "", "add a point"},
    {"delete_point", delete_point, "Delete Backspace", {}, "", "delete the selected point"},
    {"undo", undo, "Ctrl+z", {}, "Undo", "undo, redo"},
    {"redo", redo, "Ctrl+y Ctrl+Shift+z", {}, "Redo", kAbove},
    {"scatter", scatter},
    {"reset_points", reset_points, "", {}, "Start over"},
    {"push", push, "p", {}, "", "push a body of the scene"},
    {"turn:", turn},
    // The view.
    {"zoom_in", zoom<true>, "+ =", {}, "Zoom in", "zoom in, zoom out, show everything"},
    {"zoom_out", zoom<false>, "-", {}, "Zoom out", kAbove},
    {"reset_view", reset_view, "0", {}, "Show everything", kAbove},
    {"orbit_left", orbit<-1, 0>, "Ctrl+ArrowLeft", {}, "", "orbit (3-D); so with the other arrows"},
    {"orbit_right", orbit<1, 0>, "Ctrl+ArrowRight"},
    {"orbit_up", orbit<0, 1>, "Ctrl+ArrowUp"},
    {"orbit_down", orbit<0, -1>, "Ctrl+ArrowDown"},
    {"toggle_optimum", toggle_optimum, "o", {}, "", "show the smallest volume"},
};

constexpr std::pair<std::string_view, std::string_view> kOtherKeys[] = {
    {"1  2  3", "choose an answer to the question; press again to give it"},
    {"M  C  V", "cost chart: measure, show the chart or the shape, the next chart"},
    {"Ctrl S", "cost chart: save the result as CSV"},
};

bool is_at(Where where, const KeyPlace& place) {
  switch (where) {
    case Where::kAnywhere: return true;
    case Where::kNothingSelected: return !place.selected;
    case Where::kSelected: return place.selected;
    case Where::kInExercise: return place.exercise;
    case Where::kAtSummary: return place.summary;
  }
  return false;
}

/// A key as the table has it: "Ctrl+Shift+z". Caps Lock changes nothing.
std::string chord_of(std::string_view key, bool shift, bool control) {
  std::string chord = std::string(control ? "Ctrl+" : "") + (shift ? "Shift+" : "");
  if (key == " ") return chord + "Space";
  return key.size() == 1 ? chord + io::lower_case(key) : chord.append(key);
}

bool is_among_words(std::string_view words, std::string_view wanted) {
  for (std::string_view word; !(word = io::take_word(words)).empty();)
    if (word == wanted) return true;
  return false;
}

}  // namespace

std::span<const Command> commands() { return kCommands; }

const Command* find_command(std::string_view name) {
  const std::string_view until_colon = name.substr(0, name.find(':') + 1);  // all of it without one
  const auto found = std::find_if(std::begin(kCommands), std::end(kCommands), [&](const Command& row) {
    return row.name == (until_colon.empty() ? name : until_colon);
  });
  return found == std::end(kCommands) ? nullptr : found;
}

bool has_key(std::string_view keys, std::string_view key, bool shift, bool control) {
  return is_among_words(keys, chord_of(key, shift, control));
}

std::string_view command_for(std::string_view key, bool shift, bool control, const KeyPlace& place) {
  for (const bool with_shift : {true, false}) {
    if (with_shift && !shift) continue;
    for (const bool anywhere : {false, true})  // what a place of its own says comes first
      for (const Command& row : kCommands)
        if ((row.where == Where::kAnywhere) == anywhere && is_at(row.where, place) &&
            has_key(row.keys, key, with_shift, control))
          return row.name;
  }
  return {};
}

std::string shown_key(std::string_view keys) {
  constexpr std::pair<std::string_view, std::string_view> kNames[] = {
      {"ArrowLeft", "←"},   {"ArrowRight", "→"}, {"ArrowUp", "↑"},  {"ArrowDown", "↓"},
      {"PageDown", "PgDn"}, {"PageUp", "PgUp"},  {"Escape", "Esc"}, {"-", "−"}};
  std::string_view key = io::take_word(keys);
  std::string shown;
  for (const std::string_view held : {"Ctrl", "Shift"}) {
    if (!key.starts_with(held) || key.size() <= held.size() || key[held.size()] != '+') continue;
    shown.append(held) += ' ';
    key.remove_prefix(held.size() + 1);
  }
  for (const auto& [named, as] : kNames)
    if (key == named) return shown.append(as);
  if (key.size() == 1 && key[0] >= 'a' && key[0] <= 'z') return shown += static_cast<char>(key[0] - 'a' + 'A');
  return shown.append(key);
}

std::vector<KeyRow> key_rows() {
  std::vector<KeyRow> rows;
  for (const Command& row : kCommands)
    if (row.card == kAbove) rows.back().keys += "  " + shown_key(row.keys);
    else if (!row.card.empty()) rows.push_back({shown_key(row.keys), std::string(row.card)});
  for (const auto& [keys, words] : kOtherKeys) rows.push_back({std::string(keys), std::string(words)});
  return rows;
}

}  // namespace snug::app
