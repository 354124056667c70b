#include "web/deeds.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/cover.hpp"
#include "app/told/door.hpp"
#include "app/told/exercise.hpp"
#include "app/told/player.hpp"
#include "io/point_file.hpp"
#include "lesson/demo.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/patience.hpp"
#include "lesson/playground.hpp"
#include "number/fnv.hpp"
#include "web/door.hpp"
#include "web/values.hpp"

namespace snug::web {
namespace {

/// An error's sentence; "" for none, which tells the page that there was no error.
template <class Value>
std::string sentence(const tl::expected<Value, InputError>& result) {
  return result ? std::string() : result.error().message();
}

}  // namespace

/// Remembers how an address can describe the current state, once it is there.
static void remember() {
  door().remembers_later = session()->stage().preparing() != nullptr;
  if (!door().remembers_later) door().stages.remember(*session());
}

val preparing() { return session() ? value_of(app::told::preparing_of(*session())) : val::null(); }
std::string go_on(double milliseconds) {
  if (!session()) return "";
  const auto gone_on = session()->stage().go_on(milliseconds * 1e6);
  if (session()->stage().preparing() != nullptr) return "";
  if (std::exchange(door().remembers_later, false) && gone_on) remember();
  return sentence(gone_on);
}
void give_up() {
  door().remembers_later = false;
  if (session()) session()->stage().give_up();
}

bool command(const std::string& name) {
  if (!session() || !door().app->command(name)) return false;
  if (name == "scatter" || name == "practise" || name == "reset_points") remember();
  return true;
}

std::string command_of_key(const std::string& key, bool shift, bool control) {
  return door().app ? std::string(door().app->command_of_key(key, shift, control)) : std::string();
}

val key_rows() {
  std::vector<std::array<std::string_view, 2>> rows;
  for (const app::KeyRow& row : app::key_rows()) rows.push_back({row.keys, row.words});
  return value_of(rows);
}

void pick_choice(int choice) {
  if (door().app) door().app->pick_choice(choice);
}
bool pick_name(const std::string& name) { return session() && session()->conversation().pick(std::string_view(name)); }
val targets() { return session() ? value_of(session()->conversation().target_names()) : val::array(); }
val trace() { return session() ? val(hex_of(session()->player().trace_hash())) : val::null(); }

bool figures_fill() { return door().app && door().app->figures_fill(); }
double figures_height() { return door().app ? static_cast<double>(door().app->figures_height()) : 0; }

void pinch(float factor, float x, float y, float dx, float dy) { door().app->pinch(factor, x, y, dx, dy); }

void go(int step) {
  if (session()) session()->go(step);
}

void jump(int step) {
  if (session()) session()->jump(step);
}

std::string kept_answers() { return session() ? lesson::kept_text(lesson::answers_of(*session())) : ""; }
void keep_answers(const std::string& lesson, const std::string& kept) {
  door().app->keep_answers(lesson, lesson::kept_answers_of(kept));
}
void erase_answers() {
  if (door().app) door().app->forget_answers();
}

std::string choose(int slot, const std::string& name) {
  return session() ? sentence(session()->player().choose(slot, name)) : "";
}

void select_point(int point) {
  if (door().app) door().app->select(point);
}

std::string move_point(int point, double x, double y, double z) {
  if (!session() || point < 0 || point >= session()->stage().subject().size()) return "there is no such point";
  return sentence(session()->stage().move(point, {x, y, session()->stage().subject().dim() == 2 ? 0 : z}));
}

std::string show_situation(const std::string& name) {
  if (!session()) return "";
  const auto shown = session()->stage().show_situation(name);
  if (shown && session()->stage().is_own()) remember();
  return sentence(shown);
}

std::string hold_slider(bool held) {
  if (!session()) return "";
  if (!held) return sentence(session()->stage().end_drag());
  session()->stage().begin_drag();
  return "";
}
std::string slide(int slider, int place) {
  return session() ? sentence(session()->stage().slide_to_place(slider, place)) : "";
}
static std::uint64_t whole(double seed) { return static_cast<std::uint64_t>(std::clamp(seed, 0.0, 0x1p53)); }

void scatter(double seed) {
  if (!session()) return;
  session()->stage().scatter(whole(seed));
  remember();
}

std::string set_generator(const std::string& kind, int count, double seed) {
  if (!session()) return "";
  const auto set = session()->stage().set_generator(kind, count, session()->stage().subject().dim(), whole(seed));
  if (set) remember();
  return sentence(set);
}

std::string set_float(bool in_float) { return session() ? sentence(session()->stage().set_float(in_float)) : ""; }

std::string load_file(const std::string& bytes, const std::string& name) {
  if (!session()) return "";
  if (app::Cover* const cover = door().app->cover())
    if (const auto laid = cover->lay_over(*session(), bytes, name)) return sentence(*laid);
  const auto file = io::read_points(bytes, name);
  if (!file) return file.error().message();
  const auto loaded = door().app->load(*file, name);
  if (loaded) remember();
  return sentence(loaded);
}

void measure_slice(double milliseconds) { door().app->measure(milliseconds * 1e6); }
bool measuring() { return door().app->cover() != nullptr && door().app->cover()->running(); }
double measured() { return door().app->cover() != nullptr ? door().app->cover()->progress() : 1; }
std::string playground_says() { return session() ? std::string(lesson::playground_text(*session())) : ""; }
void carry_points() { door().carried = session() ? lesson::points_to_try(*session()) : std::nullopt; }
std::string put_down_points(const std::string& name) {
  if (!session() || !door().carried) return "";
  const auto loaded = door().app->load(*std::exchange(door().carried, std::nullopt), name);
  if (loaded) remember();
  return sentence(loaded);
}

std::string read_exercise(const std::string& toml, const std::string& name) {
  lesson::ExerciseDraft draft = lesson::read_exercise(toml, name);
  if (!draft.mistakes.empty()) return draft.mistakes.front().error().message();
  door().exercise = std::make_shared<const lesson::Exercise>(std::move(draft.exercise));
  return "";
}

std::string open_exercise(double seed, int level, bool practises) {
  if (!door().exercise) return "no exercise was read";
  const auto own = std::make_shared<const lesson::Exercise>(at_level(*door().exercise, level));
  const auto opened = door().app->open_exercise(own, whole(seed), practises);
  if (!opened) return opened.error().message();
  door().stages.forget();
  return "";
}

std::string take_up_attempt(const val& decisions) {
  lesson::Sitting* const sitting = door().app->sitting();
  if (sitting == nullptr) return "no exercise is open";
  lesson::Attempt attempt;
  for (const std::string& text : emscripten::vecFromJSArray<std::string>(decisions)) {
    const auto made = lesson::made_of(text);
    if (!made) return made.error().message();
    attempt.made.push_back(*made);
  }
  return sentence(sitting->take_up(*session(), attempt));
}

val attempt() { return parsed(app::told::attempt_text(*door().app)); }
double seed_of_name(const std::string& name) { return static_cast<double>(lesson::seed_of(name)); }

void light(const std::string& mark) {
  if (door().app) door().app->light(mark);
}

void invite(int followed) {
  if (door().app) door().app->invite(followed);
}

void start_task(int task) {
  if (!session() || task < 0) return;
  session()->stage().start_task(task);
  remember();
}

std::string solve_again(int task) {
  if (!session() || task < 0 || task >= static_cast<int>(session()->lesson().tasks.size())) return "";
  const auto solved = session()->solve_again(task);
  remember();
  return sentence(solved);
}

std::string set_numbers(int group, int row, const val& values) {
  if (!session()) return "";
  return sentence(session()->stage().set_numbers(group, row, emscripten::vecFromJSArray<double>(values)));
}

std::string set_file(const std::string& text) { return session() ? sentence(session()->stage().set_file(text)) : ""; }
void end_typing() {
  if (session()) session()->stage().end_typing();
}

static lesson::Place place_now() {
  lesson::Place place = door().stages.place_of(*session());
  place.camera = door().app->hand_view();
  return place;
}

val place(bool bare) {
  if (!session()) return val::null();
  lesson::Place now = place_now();
  if (bare) now.rows.clear(), now.moved.clear(), now.file.clear(), now.draft.clear();
  return value_of(app::told::PlaceNow{lesson::address_of(now), lesson::fits_address(now)});
}

std::string demo_state() {
  if (!session()) return "";
  return lesson::state_text(place_now(), session()->lesson().title, session()->player().trace_hash());
}

val read_place(const std::string& address) {
  lesson::PlaceRead read = lesson::read_place(address);
  const auto lent = [](const std::string&) -> tl::expected<io::PointFile, InputError> {
    if (door().lent) return *door().lent;
    return tl::unexpected(InputError{.what = "its mesh could not be loaded"});
  };
  door().lent.reset();
  app::told::PlaceRead told{std::move(read.problems), read.place.is_bare(), read.place.step, {}};
  door().way.emplace(std::move(read.place), lent);
  if (session()) told.mesh = door().way->mesh_needed(session()->lesson());
  return value_of(told);
}

std::string lend_mesh(const std::string& bytes) {
  auto file = io::read_points(bytes, "mesh.ply");
  if (!file) return file.error().message();
  door().lent = *std::move(file);
  return "";
}

val go_along() {
  app::told::WayGone told{.done = !session() || !door().way || door().way->done(), .refused = {}};
  if (!told.done) {
    const auto gone = door().way->go_on(*session());
    if (gone && (*gone == "situation" || *gone == "seed" || *gone == "from")) remember();
    if (!gone) told.refused = gone.error().error.message();
  } else if (session() && door().way && !door().way->place().camera.empty()) {
    door().app->look_from(door().way->place().camera);
  }
  return value_of(told);
}

}  // namespace snug::web
