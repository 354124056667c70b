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
#include <utility>
#include <vector>

#include "app/app.hpp"
#include "app/told/door.hpp"
#include "app/told/lesson.hpp"
#include "app/told/shared_words.hpp"
#include "app/told/view.hpp"
#include "io/point_file.hpp"
#include "lesson/reopening.hpp"
#include "snug_gl.h"
#include "web/canvas.hpp"
#include "web/cover.hpp"
#include "web/deeds.hpp"
#include "web/door.hpp"
#include "web/values.hpp"

namespace {

using emscripten::val;
using namespace snug;
namespace told = app::told;
using web::door;
using web::Door;
using web::session;

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
  door().app = std::make_unique<app::App>(app::Platform{.font = font,
                                                        .glsl_version = web::kGlslVersion,
                                                        .clock = clock,
                                                        .gives_way = true,
                                                        .here = web::web_provenance(processor)});
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

/// {theme, textScale, leastWords, reducedMotion, labels, grounded, ground: [r, g, b] between the parts}: see
/// app::Settings
void set_settings(val from) {
  const std::string theme = from["theme"].as<std::string>();
  app::Settings& settings = door().app->settings();
  settings.theme = theme == "dark"        ? app::Theme::kDark
                   : theme == "contrast"  ? app::Theme::kHighContrast
                   : theme == "projector" ? app::Theme::kProjector
                                          : app::Theme::kLight;
  settings.text_scale = from["textScale"].as<float>();
  settings.least_words = from["leastWords"].as<float>();
  settings.reduced_motion = from["reducedMotion"].as<bool>();
  settings.labels = from["labels"].as<bool>(), settings.ground = from["grounded"].as<bool>();
  for (int channel = 0; channel < 3; ++channel) door().ground[channel] = from["ground"][channel].as<float>();
}

/// Draws one frame, or only plays on if nothing can be drawn. now: in seconds.
void frame(double now) {
  Door& d = door();
  if (!d.graphics) return d.app->advance_unseen(now);
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
  if (!door().graphics) return door().app->seconds_until_unseen(now);
  return web::input_pending() ? 0 : door().app->seconds_until_due(now);
}

/// Whether a menu on the canvas is open, which the page's layers must not cover.
bool menu_open() {
  return ImGui::GetCurrentContext() != nullptr && ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup);
}

// ---- lessons --------------------------------------------------------------------------------------------------

/// Reads a lesson's file for open_lesson. Its algorithms are not run: whoever serves a lesson has checked it.
val read_lesson(const std::string& toml, const std::string& name) {
  lesson::Draft& draft = door().draft;
  draft = lesson::read_draft(toml, name);
  return web::value_of(
      told::LessonRead{.draws = draft.lesson.has_value(),
                       .mesh = draft.lesson ? draft.lesson->points.mesh : std::string(),
                       .error = draft.mistakes.empty() ? std::string() : draft.mistakes.front().error().message()});
}

/// Opens the lesson that was read. mesh: a PLY file's bytes, "" for none. anew: at the place where it stands now.
std::string open_lesson(const std::string& mesh, bool anew) {
  std::optional<lesson::Lesson> lesson = std::exchange(door().draft.lesson, std::nullopt);
  if (!lesson) return "no lesson was read";
  std::optional<io::PointFile> file;
  if (!mesh.empty()) {
    auto read = io::read_points(mesh, lesson->points.mesh + ".ply");
    if (!read) return read.error().message();
    file = std::move(*read);
  }
  std::optional<lesson::Reopening> place;
  if (anew && session()) place.emplace(*session());
  if (const auto opened = door().app->open(std::move(*lesson), std::move(file), place.has_value()); !opened)
    return opened.error().message();
  door().stages.forget();
  door().stages.remember(*session());
  if (place) place->take(*session());
  return "";
}

val opened_lesson() { return session() ? web::parsed(told::lesson_text(*session())) : val::null(); }

/// What has changed is put into what was told before. The page must not change it.
val view_now() {
  if (!session()) return val::null();
  static told::Changes changes;
  static val view = val::object();
  const val changed = web::parsed(changes.tell(*door().app));
  view = val::global("Object").call<val>("assign", val::object(), view, changed);
  return view;
}

val handles() {
  std::vector<told::Handle> all;
  if (door().app)
    for (const app::Handle& handle : door().app->handles()) all.push_back({handle.id, handle.x, handle.y});
  return web::value_of(all);
}

/// Where a handle of that name is on the canvas; null if it is not in view.
val place_named(const std::string& name) {
  const auto at = door().app ? door().app->place_named(name) : std::nullopt;
  return at ? web::value_of(told::Point{at->x, at->y}) : val::null();
}

val shared_words() {
  told::ByName<std::string_view> words;
  for (const auto& [name, word] : told::kSharedWords) words.emplace_back(name, word);
  return web::value_of(words);
}

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
  function("figures_height", &web::figures_height);
  function("figures_fill", &web::figures_fill);
  function("pointer_moved", &web::pointer_moved);
  function("pointer_left", &web::pointer_left);
  function("forget_input", &web::forget_input);
  function("pointer_button", &web::pointer_button);
  function("wheel_turned", &web::wheel_turned);
  function("pinch", &web::pinch);
  function("modifiers_held", &web::modifiers_held);
  function("cursor", &web::cursor);
  function("read_lesson", &read_lesson);
  function("open_lesson", &open_lesson);
  function("lesson", &opened_lesson);
  function("view", &view_now);
  function("handles", &handles);
  function("place_named", &place_named);
  function("command", &web::command);
  function("command_of_key", &web::command_of_key);
  function("key_rows", &web::key_rows);
  function("pick_choice", &web::pick_choice);
  function("pick_name", &web::pick_name);
  function("targets", &web::targets);
  function("trace", &web::trace);
  function("words", &shared_words);
  function("go", &web::go);
  function("jump", &web::jump);
  function("kept_answers", &web::kept_answers);
  function("keep_answers", &web::keep_answers);
  function("erase_answers", &web::erase_answers);
  function("choose", &web::choose);
  function("select_point", &web::select_point);
  function("move_point", &web::move_point);
  function("set_numbers", &web::set_numbers);
  function("set_file", &web::set_file);
  function("end_typing", &web::end_typing);
  function("place", &web::place);
  function("demo_state", &web::demo_state);
  function("read_place", &web::read_place);
  function("lend_mesh", &web::lend_mesh);
  function("go_along", &web::go_along);
  function("show_situation", &web::show_situation);
  function("hold_slider", &web::hold_slider);
  function("slide", &web::slide);
  function("scatter", &web::scatter);
  function("preparing", &web::preparing);
  function("go_on", &web::go_on);
  function("give_up", &web::give_up);
  function("set_generator", &web::set_generator);
  function("set_float", &web::set_float);
  function("read_exercise", &web::read_exercise);
  function("open_exercise", &web::open_exercise);
  function("take_up_attempt", &web::take_up_attempt);
  function("attempt", &web::attempt);
  function("seed_of_name", &web::seed_of_name);
  function("light", &web::light);
  function("invite", &web::invite);
  function("start_task", &web::start_task);
  function("solve_again", &web::solve_again);
  function("load_file", &web::load_file);
  function("measure", &web::measure_slice);
  function("measuring", &web::measuring);
  function("measured", &web::measured);
  function("cover_file", &web::cover_file);
  function("draw_cover", &web::draw_cover);
  function("draw_picture", &web::draw_picture);
  function("picture_svg", &web::picture_svg);
  function("playground_says", &web::playground_says);
  function("carry_points", &web::carry_points);
  function("put_down_points", &web::put_down_points);
}
