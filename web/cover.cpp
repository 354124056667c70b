#include "web/cover.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <snug_gl.h>

#include <cmath>
#include <vector>

#include "app/cover_picture.hpp"
#include "web/canvas.hpp"
#include "web/door.hpp"
#include "web/values.hpp"

namespace snug::web {

using emscripten::val;

val button_object(const app::CoverButton& button) {
  val object = val::object();
  object.set("command", button.command);
  object.set("words", button.words);
  object.set("chosen", button.chosen);
  object.set("enabled", button.enabled);
  return object;
}

val table_object(const app::WordTable& table) {
  val object = val::object();
  object.set("head", array_of(table.head, text));
  object.set("rows", array_of(table.rows, [](const auto& row) { return array_of(row, text); }));
  object.set("title", table.title);
  object.set("sorts", array_of(table.sorts, text));
  object.set("sorted", table.sorted);
  object.set("picks", array_of(table.picks, text));
  object.set("picked", table.picked);
  object.set("best", array_of(table.best, [](const auto& row) {
               val flags = val::array();
               for (const bool best : row) flags.call<void>("push", best);
               return flags;
             }));
  return object;
}

cost::Provenance web_provenance(const std::string& processor) {
  return {.version = SNUG_VERSION, .build = SNUG_BUILD, .platform = "WebAssembly", .processor = processor};
}

val cover_object(app::App& app) {
  const app::Cover* const cover = app.cover();
  if (cover == nullptr) return val::null();
  const lesson::Session& session = *app.session();
  const app::WordTable table = cover->table(session);
  val object = val::object();
  object.set("choices", array_of(cover->choices(session), button_object));
  object.set("work", array_of(cover->work_buttons(session), button_object));
  object.set("button", button_object(cover->button()));
  object.set("shown", cover->shown());
  object.set("running", cover->running());
  object.set("progress", cover->progress());
  object.set("decided", cover->decided(session));
  object.set("says", cover->status(session));
  object.set("table", table_object(table));
  object.set("formats", array_of(app::formats_of(*cover), text));
  object.set("any", !table.rows.empty());
  return object;
}

val cover_file_object(app::App& app, const std::string& format) {
  val object = val::object();
  object.set("name", app.cover()->file_name() + "." + format);
  object.set("text", format == "svg"   ? app::cover_svg(app)
                     : format == "png" ? std::string()
                                       : app.cover()->file(format));
  return object;
}

bool draw_cover(float width, float height, float scale) {
  Door& d = door();
  if (!d.graphics || d.app->cover() == nullptr || d.app->cover()->picture() == nullptr) return false;
  begin_frame(width, height, scale, 0);
  d.app->frame({}, d.last_frame);  // sets the fonts and palette
  app::draw_cover_picture(*d.app, {0, 0, width, height});
  ImGui::Render();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, static_cast<int>(std::lround(width * scale)), static_cast<int>(std::lround(height * scale)));
  glDisable(GL_SCISSOR_TEST);
  glClearColor(d.ground[0], d.ground[1], d.ground[2], 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  return true;
}

}  // namespace snug::web
