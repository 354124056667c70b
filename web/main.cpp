// The browser's door: gives the front end a canvas, input and files, and gives the page the data for its HTML. The
// page's side is page/door.js, which calls every function here.
#include <emscripten.h>
#include <emscripten/bind.h>
#include <emscripten/val.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "app/app.hpp"
#include "app/subjects/cost/costs.hpp"
#include "io/point_file.hpp"
#include "lesson/kept_answers.hpp"
#include "snug_gl.h"
#include "web/boxes.hpp"
#include "web/canvas.hpp"
#include "web/costs.hpp"
#include "web/shared_points.hpp"
#include "web/view.hpp"

namespace {

using emscripten::val;
using namespace snug;

struct Door {
  std::map<std::string, std::string, std::less<>> fonts;
  std::unique_ptr<app::App> app;
  bool graphics = false;
  app::Layout layout;
  float width = 1, height = 1, scale = 1;
  double last_frame = 0;
  std::array<float, 3> ground{};
  web::SharedPoints shared;
};

Door& door() {
  static Door only;
  return only;
}

/// Null before the first lesson is open.
lesson::Session* session() { return door().app ? door().app->session() : nullptr; }

/// An error's sentence; "" for none, which tells the page that there was no error.
template <class Value>
std::string sentence(const tl::expected<Value, InputError>& result) {
  return result ? std::string() : result.error().message();
}

// ---- starting -------------------------------------------------------------------------------------------------

void give_font(const std::string& name, const std::string& bytes) { door().fonts[name] = bytes; }

/// Returns "" or why nothing can be drawn; the lesson works in either case.
std::string start_graphics() {
  web::start_renderer();
  door().graphics = door().app->create_graphics();
  return door().graphics ? "" : door().app->graphics_error();
}

void stop_graphics() {
  if (!door().graphics) return;
  door().graphics = false;
  door().app->abandon_graphics();
  web::abandon_renderer();
}

/// processor: as far as the browser tells. smooth: several samples a pixel; lines and points are antialiased in any
/// case.
std::string start(const std::string& selector, bool smooth, const std::string& processor) {
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  const auto font = [](std::string_view name) {
    const auto found = door().fonts.find(name);
    return found == door().fonts.end() ? std::string() : found->second;
  };
  const auto clock = [] { return emscripten_get_now() * 1e6; };
  door().app = std::make_unique<app::App>(app::Platform{
      .font = font, .glsl_version = web::kGlslVersion, .clock = clock, .here = web::web_provenance(processor)});
  if (!web::make_graphics_context(selector.c_str(), smooth)) return "no WebGL 2";
  return start_graphics();
}

// ---- frames ---------------------------------------------------------------------------------------------------

app::Rect rectangle(const val& from) {
  return {from["x"].as<float>(), from["y"].as<float>(), from["width"].as<float>(), from["height"].as<float>()};
}

/// {width, height, scale, fingers, tools, foot, stage, timeline, inspector: {x, y, width, height}}
void set_layout(val from) {
  door().layout = {rectangle(from["stage"]),   rectangle(from["timeline"]), rectangle(from["inspector"]),
                   from["fingers"].as<bool>(), from["tools"].as<float>(),   from["foot"].as<float>()};
  door().width = from["width"].as<float>();
  door().height = from["height"].as<float>();
  door().scale = from["scale"].as<float>();
}

/// {theme, textScale, reducedMotion, ground: [r, g, b] between the parts}
void set_settings(val from) {
  const std::string theme = from["theme"].as<std::string>();
  app::Settings& settings = door().app->settings();
  settings.theme = theme == "dark"        ? app::Theme::kDark
                   : theme == "contrast"  ? app::Theme::kHighContrast
                   : theme == "projector" ? app::Theme::kProjector
                                          : app::Theme::kLight;
  settings.text_scale = from["textScale"].as<float>();
  settings.reduced_motion = from["reducedMotion"].as<bool>();
  for (int channel = 0; channel < 3; ++channel) door().ground[channel] = from["ground"][channel].as<float>();
}

/// Draws one frame, or only plays on if nothing can be drawn. now: in seconds.
void frame(double now) {
  Door& d = door();
  if (!d.graphics) return d.app->advance(now);
  web::begin_frame(d.width, d.height, d.scale, static_cast<float>(now - d.last_frame));
  d.last_frame = now;
  d.app->frame(d.layout, now);
  ImGui::Render();
  const int across = static_cast<int>(std::lround(d.width * d.scale));
  const int down = static_cast<int>(std::lround(d.height * d.scale));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, across, down);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(d.ground[0], d.ground[1], d.ground[2], 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  d.app->draw_3d_behind(across, down, d.scale);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

/// The seconds until a frame is due; infinity for none.
double seconds_until_due(double now) {
  if (!door().graphics) return door().app->seconds_until_step(now);
  return web::input_pending() ? 0 : door().app->seconds_until_due(now);
}

/// Whether a menu on the canvas is open, which the page's layers must not cover.
bool menu_open() {
  return ImGui::GetCurrentContext() != nullptr && ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

// ---- lessons --------------------------------------------------------------------------------------------------

/// {error} or {mesh}: the mesh that the page must load for open_lesson, "" for none.
val check_lesson(const std::string& toml, const std::string& name) {
  val answer = val::object();
  const auto lesson = lesson::read_lesson(toml, name);
  if (lesson) answer.set("mesh", lesson->points.mesh);
  else answer.set("error", lesson.error().message());
  return answer;
}

/// mesh: a PLY file's bytes, "" for none.
std::string open_lesson(const std::string& toml, const std::string& name, const std::string& mesh) {
  auto lesson = lesson::read_lesson(toml, name);
  if (!lesson) return lesson.error().message();
  std::optional<io::PointFile> file;
  if (!mesh.empty()) {
    auto read = io::read_points(mesh, lesson->points.mesh + ".ply");
    if (!read) return read.error().message();
    file = std::move(*read);
  }
  if (const auto opened = door().app->open(std::move(*lesson), std::move(file)); !opened)
    return opened.error().message();
  door().shared.forget();
  door().shared.remember(*session());
  return "";
}

val opened_lesson() { return session() ? web::lesson_object(*session()) : val::null(); }
val view_now() { return session() ? web::view_object(*door().app, *session()) : val::null(); }

val handles() {
  val array = val::array();
  if (!door().app) return array;
  for (const app::Handle& handle : door().app->handles()) {
    val object = val::object();
    object.set("id", handle.id);
    object.set("x", handle.x);
    object.set("y", handle.y);
    array.call<void>("push", object);
  }
  return array;
}

// ---- what the user does ---------------------------------------------------------------------------------------

/// Remembers how an address can describe the current points.
void remember_points() { door().shared.remember(*session()); }

bool command(const std::string& name) {
  if (!session() || !door().app->command(name)) return false;
  if (name == "scatter" || name == "reset_points") remember_points();
  return true;
}

std::string command_of_key(const std::string& key, bool shift, bool control) {
  return door().app ? std::string(door().app->command_of_key(key, shift, control)) : std::string();
}

/// Chooses an answer by its number; choosing it again gives it.
void pick_choice(int choice) {
  if (session()) session()->pick({lesson::Answer::Kind::kChoice, choice});
}
/// Chooses a handle by its typed name. Returns false if it cannot be the answer.
bool pick_name(const std::string& name) { return session() && session()->pick(std::string_view(name)); }
/// The names of the handles that can be the answer. A mesh has thousands, so they are not part of view().
val targets() { return session() ? web::target_names(*session()) : val::array(); }

bool figures_fill() { return door().app && door().app->figures_fill(); }
double figures_height() { return door().app ? static_cast<double>(door().app->figures_height()) : 0; }

/// A pinch: factor > 1 as the fingers part, around (x, y), which moved by (dx, dy).
void pinch(float factor, float x, float y, float dx, float dy) { door().app->pinch(factor, x, y, dx, dy); }

void go(int step) {
  if (session()) session()->go(step);
}

void jump(int step) {
  if (session()) session()->jump(step);
}

void forget_answers() {
  if (!session()) return;
  session()->forget_answers();
  if (app::Cover* const cover = door().app->cover()) cover->show(false);  // the chart would give the answers away
}

/// The given answers, for the device to keep; and those of an earlier visit, passed in before the lesson is opened.
std::string kept_answers() { return session() ? lesson::kept_text(session()->outcomes()) : ""; }
void keep_answers(const std::string& lesson, const std::string& kept) {
  door().app->keep_answers(lesson, lesson::outcomes_of(kept));
}
/// Erases the answers to all lessons.
void erase_answers() {
  if (!door().app) return;
  door().app->forget_answers();
  if (app::Cover* const cover = door().app->cover()) cover->show(false);
}

/// name: "" clears the comparison.
std::string choose(int slot, const std::string& name) {
  return session() ? sentence(session()->choose(slot, name)) : "";
}

void select_point(int point) {
  if (session()) door().app->select(point >= 0 && point < session()->size() ? point : kNoIndex);
}

std::string move_point(int point, double x, double y, double z) {
  if (!session() || point < 0 || point >= session()->size()) return "there is no such point";
  return sentence(session()->move(point, {x, y, session()->dim() == 2 ? 0 : z}));
}

/// Makes many moves as one entry of undo: [[point, x, y(, z)] …].
std::string move_points(val rows) {
  if (!session()) return "";
  std::string error;
  session()->begin_drag();
  for (int i = 0; i < rows["length"].as<int>() && error.empty(); ++i) {
    const val row = rows[i];
    error = move_point(row[0].as<int>(), row[1].as<double>(), row[2].as<double>(),
                       session()->dim() == 3 ? row[3].as<double>() : 0);
  }
  session()->end_drag();
  return error;
}

std::uint64_t whole(double seed) { return static_cast<std::uint64_t>(std::clamp(seed, 0.0, 0x1p53)); }

/// Scatters points of the same kind again, from a seed.
void scatter(double seed) {
  if (!session()) return;
  session()->scatter(whole(seed));
  remember_points();
}

/// Scatters points of another kind.
std::string set_generator(const std::string& kind, int count, double seed) {
  if (!session()) return "";
  const auto set = session()->set_generator(kind, count, session()->dim(), whole(seed));
  if (set) remember_points();
  return sentence(set);
}

/// Loads a point file in any of the formats.
std::string load_file(const std::string& bytes, const std::string& name) {
  if (!session()) return "";
  const auto file = io::read_points(bytes, name);
  if (!file) return file.error().message();
  const auto loaded = door().app->load(*file, name);
  if (loaded) remember_points();
  return sentence(loaded);
}

/// Does a slice of the running measurement. milliseconds: the budget.
void measure_slice(double milliseconds) { door().app->measure(milliseconds * 1e6); }
bool measuring() { return door().app->cover() != nullptr && door().app->cover()->running(); }
/// The progress of the measurement, from 0 to 1.
double measured() { return door().app->cover() != nullptr ? door().app->cover()->progress() : 1; }
std::string costs_file(const std::string& format) { return web::costs_file(*door().app, format); }
std::string lay_over(const std::string& csv, const std::string& name) {
  return session() ? web::lay_over(*door().app, csv, name) : "";
}

/// Lights a mark that the prose links to, until another, or "" for none.
void light(const std::string& mark) {
  if (door().app) door().app->light(mark);
}

void start_task() {
  if (!session()) return;
  session()->start_task();
  remember_points();
}

std::string set_box_rows(val rows) { return session() ? web::set_box_rows(*session(), rows) : ""; }
std::string set_box(int box, const std::string& what, val values) {
  return session() ? web::set_box(*session(), box, what, values) : "";
}
std::string turn_box(int box, int axis, double degrees, bool to) {
  return session() ? web::turn_box(*session(), box, axis, degrees, to) : "";
}

val shared_points() { return session() ? door().shared.describe(*session()) : val::object(); }

}  // namespace

EMSCRIPTEN_BINDINGS(snug) {
  using emscripten::function;
  function("give_font", &give_font);
  function("start", &start);
  function("start_graphics", &start_graphics);
  function("stop_graphics", &stop_graphics);
  function("set_layout", &set_layout);
  function("set_settings", &set_settings);
  function("frame", &frame);
  function("seconds_until_due", &seconds_until_due);
  function("menu_open", &menu_open);
  function("figures_height", &figures_height);
  function("figures_fill", &figures_fill);
  function("pointer_moved", &web::pointer_moved);
  function("pointer_left", &web::pointer_left);
  function("pointer_button", &web::pointer_button);
  function("wheel_turned", &web::wheel_turned);
  function("pinch", &pinch);
  function("modifiers_held", &web::modifiers_held);
  function("cursor", &web::cursor);
  function("check_lesson", &check_lesson);
  function("open_lesson", &open_lesson);
  function("lesson", &opened_lesson);
  function("view", &view_now);
  function("handles", &handles);
  function("command", &command);
  function("command_of_key", &command_of_key);
  function("pick_choice", &pick_choice);
  function("pick_name", &pick_name);
  function("targets", &targets);
  function("words", &web::words_object);
  function("go", &go);
  function("jump", &jump);
  function("forget_answers", &forget_answers);
  function("kept_answers", &kept_answers);
  function("keep_answers", &keep_answers);
  function("erase_answers", &erase_answers);
  function("choose", &choose);
  function("select_point", &select_point);
  function("move_point", &move_point);
  function("move_points", &move_points);
  function("set_box_rows", &set_box_rows);
  function("set_box", &set_box);
  function("turn_box", &turn_box);
  function("scatter", &scatter);
  function("set_generator", &set_generator);
  function("light", &light);
  function("start_task", &start_task);
  function("load_file", &load_file);
  function("measure", &measure_slice);
  function("measuring", &measuring);
  function("measured", &measured);
  function("costs_file", &costs_file);
  function("lay_over", &lay_over);
  function("shared_points", &shared_points);
}
