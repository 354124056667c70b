#include "web/cover.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <snug_gl.h>

#include <cmath>

#include "app/cover_picture.hpp"
#include "app/picture_svg.hpp"
#include "app/told/door.hpp"
#include "web/canvas.hpp"
#include "web/door.hpp"
#include "web/values.hpp"

namespace snug::web {

cost::Provenance web_provenance(const std::string& processor) {
  return {.version = SNUG_VERSION, .build = SNUG_BUILD, .platform = "WebAssembly", .processor = processor};
}

emscripten::val cover_file(const std::string& format, const std::string& address) {
  app::App& app = *door().app;
  return value_of(app::told::CoverFile{.name = app.cover()->file_name() + "." + format,
                                       .text = format == "svg"   ? app::cover_svg(app, address)
                                               : format == "png" ? std::string()
                                                                 : app.cover()->file(format)});
}

namespace {

/// Draws the current frame onto the canvas, at a size of its own.
void show_frame(float width, float height, float scale) {
  Door& d = door();
  ImGui::Render();
  const int across = static_cast<int>(std::lround(width * scale)), down = static_cast<int>(std::lround(height * scale));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, across, down);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(d.ground[0], d.ground[1], d.ground[2], 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  d.app->draw_3d_behind(across, down, scale);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

constexpr int kFramesForPicture = 6;  // until the stage has settled

/// Draws a picture's frames, each by draw(last). Returns false if nothing can be drawn.
template <class Draw>
bool draw_frames(float width, float height, float scale, Draw&& draw) {
  Door& d = door();
  if (!d.graphics || session() == nullptr) return false;
  app::Settings& settings = d.app->settings();
  const app::Settings before = settings;
  settings.tools = false, settings.reduced_motion = true;
  for (int left = kFramesForPicture; left > 0; --left) {
    begin_frame(width, height, scale, 0);
    draw(left == 1);
  }
  settings = before;
  return true;
}

}  // namespace

bool draw_picture(float width, float height, float scale) {
  return draw_frames(width, height, scale, [&](bool) {
    door().app->frame({.stage = {0, 0, width, height}}, door().last_frame);
    show_frame(width, height, scale);
  });
}

std::string picture_svg(float width, float height, const std::string& address) {
  std::string svg;
  draw_frames(width, height, 1, [&](bool last) {
    Door& d = door();
    if (last) {
      svg = app::stage_svg(*d.app, {.width = width, .height = height, .address = address}, d.last_frame);
    } else {
      d.app->frame({.stage = {0, 0, width, height}}, d.last_frame);
      ImGui::Render();
    }
  });
  return svg;
}

bool draw_cover(float width, float height, float scale) {
  Door& d = door();
  if (!d.graphics || d.app->cover() == nullptr || d.app->cover()->picture() == nullptr) return false;
  begin_frame(width, height, scale, 0);
  d.app->frame({}, d.last_frame);  // sets the fonts and palette
  app::draw_cover_picture(*d.app, {0, 0, width, height});
  show_frame(width, height, scale);
  return true;
}

}  // namespace snug::web
