#include "desktop/window.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <snug_gl.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/chart_pen.hpp"
#include "app/cover.hpp"
#include "app/cover_picture.hpp"
#include "app/look.hpp"
#include "app/picture_svg.hpp"
#include "app/timeline_buttons.hpp"
#include "app/widgets.hpp"
#include "desktop/animation.hpp"
#include "desktop/chart_file.hpp"
#include "desktop/chart_picture.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/defaults.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/page_address.hpp"
#include "desktop/cli/timing.hpp"
#include "desktop/controls.hpp"
#include "desktop/demo_draw.hpp"
#include "desktop/file_dialog.hpp"
#include "desktop/glfw_host.hpp"
#include "desktop/header.hpp"
#include "desktop/keys_card.hpp"
#include "desktop/menus.hpp"
#include "desktop/picture.hpp"
#include "desktop/picture_pdf.hpp"
#include "desktop/presentation.hpp"
#include "desktop/prose_panel.hpp"
#include "desktop/question_card.hpp"
#include "desktop/second_window.hpp"
#include "desktop/shell.hpp"
#include "desktop/state_file.hpp"
#include "desktop/stored_panel.hpp"
#include "desktop/strip.hpp"
#include "desktop/versions.hpp"
#include "desktop/working.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/patience.hpp"
#include "lesson/stored.hpp"

namespace snug::desktop {
namespace {

constexpr int kBadInput = 2;
constexpr double kTick = 0.008;           // seconds between looks at the clock while something plays
constexpr double kLook = 0.25;            // seconds between looks at the files of lessons that are being written
constexpr double kSlice = 8e6;            // nanoseconds of measuring between two frames
constexpr double kBetweenSeconds = 0.25;  // between looks at a file that is being read
constexpr double kSettled = 0.3;          // seconds after which a window's size is the one that it stays at
constexpr double kLongestRun = 1e9;   // nanoseconds of one run on the growth chart: a window may stand still that long
constexpr int kFramesForPicture = 6;  // until ImGui has measured everything once

int stop(const std::string& why) {
  std::fprintf(stderr, "snug: %s\n", why.c_str());
  return kBadInput;
}

std::string font_bytes(std::string_view name) {
  for (const char* extension : {".otf", ".ttf"})
    if (auto bytes = read_file((data_folder() / "assets" / "fonts" / (std::string(name) + extension)).string()))
      return *bytes;
  return {};
}

/// The rectangles of all parts; empty for those that are not shown.
struct Parts {
  app::Rect window, header, strip, column, cover, title, question, side_tabs, stored, code, controls;
  app::Layout app;
};

/// Whether the numbers want so much of the right column that the pseudocode is a tab beside them.
bool numbers_fill(const Shell& shell, const app::Look& look, float height) {
  constexpr float kLeastCode = 272;  // the choice of algorithms, and enough lines to follow
  return shell.app().figures_fill() && shell.figures_most > height - look.px(kLeastCode);
}

/// Tabs over the right column, and what is chosen there in place of the numbers.
void place_side(Parts& parts, const app::Look& look, Shell& shell, bool code_tab) {
  using Tab = Shell::SideTab;
  const bool stores =
      !shell.course_shown && shell.app().session() != nullptr && !lesson::stored_of(shell.session()).empty();
  shell.side_tabs.clear();
  if (stores) shell.side_tabs.push_back(Tab::kStored);
  if (stores || code_tab) shell.side_tabs.push_back(Tab::kNumbers);
  if (code_tab) shell.side_tabs.push_back(Tab::kCode);
  const bool there = std::find(shell.side_tabs.begin(), shell.side_tabs.end(), shell.side_tab) != shell.side_tabs.end();
  if (!there && !shell.side_tabs.empty()) shell.side_tab = Tab::kNumbers;
  if (!stores || shell.side_tab != Tab::kStored) shell.stored_lit.clear(), shell.stored_rows.clear();
  if (shell.side_tabs.empty()) return;
  app::Rect& numbers = parts.app.inspector;
  const float tabs = std::min(look.px(40), numbers.height);
  parts.side_tabs = {numbers.x, numbers.y, numbers.width, tabs};
  numbers.y += tabs, numbers.height -= tabs;
  if (shell.side_tab == Tab::kNumbers) return;
  (shell.side_tab == Tab::kStored ? parts.stored : parts.code) = numbers;
  numbers.height = 0;
}

/// How wide a column at the side is: a share of a usual window within limits, and of a large one a smaller share.
float side_width(float window, float share, float least, float usual, float share_of_large, float most, float scale) {
  return std::floor(std::max(std::clamp(window * share, least, usual), std::min(window * share_of_large, most)) *
                    scale);
}

/// What a state of a demo has in the right column; all of it where there is no demo.
struct Beside {
  bool numbers = true, code = true, question = true;
  [[nodiscard]] bool any() const { return numbers || code || question; }
};
Beside beside_of(Shell& shell) {
  if (!shell.demo || shell.app().session() == nullptr) return {};
  const lesson::Session& session = *shell.app().session();
  const bool asks = session.conversation().asked() != nullptr || session.conversation().deciding() != nullptr ||
                    session.conversation().outcome() != nullptr;
  return {shell.demo->shows("numbers"), shell.demo->shows("code"), asks};
}

/// A presentation has no bar, and the lesson's text only on demand. The controls of a cover stand in the right column
/// then.
Parts parts_of(const Extent& extent, const app::Look& look, Shell& shell) {
  const float scale = std::max(1.0f, std::sqrt(look.text_scale));
  const bool lecture = shell.presenting, cover = shell.app().cover() != nullptr;
  const float bar = lecture ? 0 : look.px(48), strip = shell.strip().empty() ? 0 : shell.strip_height;
  const float header = bar + strip;
  const float column = lecture && !shell.text_shown ? 0 : side_width(extent.width, 0.29f, 300, 380, 0.22f, 432, scale);
  const Beside beside = beside_of(shell);
  constexpr float kLectureSide = 0.28f;  // its words grow with the window, and so does the column that has them
  float inspector = lecture && !beside.any() ? 0
                    : lecture                ? std::max(side_width(extent.width, 0.3f, 280, 350, 0.2f, 400, scale),
                                                        std::floor(extent.width * kLectureSide))
                                             : side_width(extent.width, 0.22f, 280, 290, 0.175f, 336, scale);
  constexpr float kLowScreen = 690, kLeastSide = 400;  // kLowScreen: for words of the size that they are made for
  // Where two columns leave the stage next to nothing, the left one has what stands in both.
  constexpr float kLeastStage = 240, kLeastHigh = 480;  // kLeastHigh: of a stage that a question's card may cover
  shell.narrow = !lecture && extent.width - column - inspector < look.px(kLeastStage);
  const bool side_shown = shell.narrow && shell.tab == Shell::Tab::kSide;
  if (shell.narrow) inspector = 0;
  shell.low = lecture && extent.height < kLowScreen * look.text_scale;
  const bool no_timeline = cover && shell.app().cover()->shown();  // it is the stage's
  const float timeline = no_timeline ? 0 : shell.low ? app::low_timeline_height(look) : app::timeline_height(look);
  const float height = extent.height - header, right = extent.width - inspector;
  Parts parts;
  parts.window = {0, 0, extent.width, extent.height};
  parts.header = {0, 0, extent.width, bar};
  parts.strip = {0, bar, extent.width, strip};
  const float pinned = cover && !side_shown ? std::min(shell.pinned_height, height - look.px(164)) : 0;
  const float tabs = side_shown ? look.px(44) : 0;
  const float middle = right - column - 1;  // and a line
  const float controls = controls_height(shell, look, middle);
  parts.app.stage = {column, header, middle, height - timeline - controls};
  shell.asks_beside = shell.narrow || (!lecture && parts.app.stage.height < look.px(kLeastHigh));
  // What a question leaves of the left column, where it stands there, and below that at least a few lines.
  const float asked = shell.asks_beside ? std::min(shell.question_height, height - pinned) : 0;
  const float left = height - pinned - asked;
  parts.column = {0, header + asked, column, lecture ? height : side_shown ? tabs : left < look.px(72) ? 0 : left};
  if (cover && !lecture && !side_shown) parts.cover = {0, header + height - pinned, column, pinned};
  parts.controls = {column, header + height - timeline - controls, middle, controls};
  parts.app.timeline = {column, header + height - timeline, parts.app.stage.width, timeline};
  const float title = lecture && beside.any() ? title_height(shell, look, inspector) : 0;
  if (lecture) parts.title = {right, header, inspector, title};
  // The whole stage is the question's figure: the question stands beside it.
  const float question = lecture ? std::min(shell.question_height, height - title) : shell.narrow ? asked : 0;
  parts.question =
      lecture ? app::Rect{right, header + title, inspector, question} : app::Rect{0, header, column, asked};
  const float side = std::max(0.0f, height - title - question - tabs);  // what numbers and pseudocode have
  const bool code_tab = !lecture && !cover && numbers_fill(shell, look, height);
  // A presentation has no tabs: where the numbers may need the whole column, they have the most of it.
  const bool no_code = code_tab || !beside.code || (lecture && beside.numbers && side < look.px(kLeastSide));
  const float most_code = beside.numbers ? side * (shell.app().figures_fill() ? 0.38f : 0.52f) : side;
  const float code = no_code ? 0 : beside.numbers ? std::min(shell.code_height, most_code) : most_code;
  const float below = lecture && cover ? std::min(shell.pinned_height, side * 0.52f) : code;
  const float side_left = side_shown ? 0 : right, across = side_shown ? column : inspector;
  parts.code = {side_left, header + height - code, across, cover && lecture ? 0 : code};
  if (lecture && cover) parts.cover = {right, header + height - below, inspector, below};
  parts.app.inspector = {side_left, header + title + question + tabs, across, beside.numbers ? side - below : 0};
  place_side(parts, look, shell, code_tab);
  parts.app.tools = lecture && !shell.demo ? presentation_reach(look) : 0;
  parts.app.foot = covered_by_question(shell);
  return parts;
}

/// Renders the frame: the panels' colour, the stage's 3-D, and ImGui's drawing over both.
void finish(const Extent& extent, app::App& app, app::Color ground) {
  ImGui::Render();
  const ImVec4 color = ImGui::ColorConvertU32ToFloat4(ground);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, extent.device_width, extent.device_height);
  glClearColor(color.x, color.y, color.z, color.w);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  app.draw_3d_behind(extent.device_width, extent.device_height, extent.scale);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

/// Draws only the stage into the bound framebuffer.
void draw_stage(GlfwHost& host, app::App& app, double now) {
  host.begin_frame();
  const Extent extent = host.extent();
  app.frame({.stage = {0, 0, extent.width, extent.height}}, now);
  finish(extent, app, app.settings().ground ? app.look()->ground : 0);
}

void draw_stage_and_panels(Shell& shell, const Parts& parts, double now) {
  const auto shown = [](const app::Rect& rect) { return rect.width >= 1 && rect.height >= 1; };
  app::App& app = shell.app();
  app.advance(now);  // the panels show the step that the stage does
  // The panels first: what they change of the session, the stage shows in this same frame.
  if (shown(parts.header)) draw_header(shell, parts.header);
  if (shown(parts.strip)) draw_strip(shell, parts.strip);
  if (shown(parts.title)) draw_title(shell, parts.title);
  if (shown(parts.column)) draw_prose_panel(shell, parts.column);
  else shell.links.clear(), app.light(shell.stored_lit);
  if (shown(parts.cover)) draw_cover_panel(shell, parts.cover);
  if (shown(parts.side_tabs)) draw_side_tabs(shell, parts.side_tabs);
  if (shown(parts.stored)) draw_stored_panel(shell, parts.stored);
  if (shown(parts.code)) draw_code_panel(shell, parts.code);
  if (shown(parts.controls)) draw_controls(shell, parts.controls);
  app.frame(parts.app, now);
  if (const float wanted = app.figures_height(); wanted > shell.figures_most)
    shell.figures_most = wanted, shell.measured_anew = true;
  draw_question_card(shell, shell.presenting || shell.asks_beside ? parts.question : parts.app.stage);
  if (!shell.presenting) draw_invitation(app, parts.app.stage);
  else if (!shell.demo) draw_presentation(shell, parts.app.stage);
  for (const float x : {parts.column.width, parts.app.inspector.x}) {
    if (x < 1) continue;
    const float top = parts.app.stage.y;
    const app::Rect line{x - 1, top, 1, parts.window.height - top};
    const app::Pane edge(x < parts.window.width / 2 ? "##left edge" : "##right edge", line);
    edge.list()->AddRectFilled({line.x, line.y}, {x, parts.window.height}, app.look()->line);
  }
  draw_notice(shell, parts.app.stage);
}

void draw_course(Shell& shell, const Parts& parts, double now) {
  shell.app().frame({}, now);  // its fonts and palette
  draw_header(shell, parts.header);
  if (parts.strip.height >= 1) draw_strip(shell, parts.strip);
  const float below = parts.strip.y + parts.strip.height;
  shell.course.draw(shell, {0, below, parts.window.width, parts.window.height - below});
  draw_notice(shell, parts.window);
}

/// Where one is in the demo, in a corner that nothing else needs.
void draw_demo(const DemoPlay& demo, const app::Look& look, const Parts& parts) {
  constexpr float kSize = 12, kLeft = 10, kBelow = 20;
  ImDrawList* const list = ImGui::GetForegroundDrawList();
  const app::Rect& timeline = parts.app.timeline;
  app::text(list, look, app::Face::kRegular, kSize,
            {timeline.x + kLeft, timeline.y + timeline.height - look.px(kSize) - kBelow}, look->muted,
            demo.place_text());
}

/// Draws the whole window once into the bound framebuffer.
void draw(GlfwHost& host, Shell& shell, double now) {
  host.begin_frame();
  const Extent extent = host.extent();
  const bool refitted = shell.fit_words(extent.width, extent.height);
  const app::Look& look = shell.app().look();
  const Parts parts = parts_of(extent, look, shell);
  shell.measured_anew = refitted;
  shell.slider = -1, shell.tracks.clear();
  shell.focus.begin_frame(look->current);
  if (shell.course_shown) draw_course(shell, parts, now);
  else draw_stage_and_panels(shell, parts, now);
  draw_keys(shell, parts.window);
  if (!shell.course_shown) draw_vote(shell, parts.app.stage);
  shell.hall.draw(look, parts.window, now);
  draw_about(shell, parts.window);
  draw_loading(shell, shell.course_shown ? parts.window : parts.app.stage);
  draw_file_card(shell, parts.window);
  if (shell.demo) draw_demo(*shell.demo, look, parts);
  if (shell.hall.black)
    ImGui::GetForegroundDrawList()->AddRectFilled({0, 0}, {parts.window.width, parts.window.height}, 0xff000000);
  shell.focus.end_frame();
  finish(extent, shell.app(), shell.course_shown ? look->ground : look->panel);
}

/// Draws only the chart into the bound framebuffer.
void draw(GlfwHost& host, app::App& app, const app::Chart& chart) {
  host.begin_frame();
  app.frame({}, host.now());  // sets the fonts and palette
  const Extent extent = host.extent();
  const app::Look& look = app.look();
  app::ScreenPen pen(ImGui::GetBackgroundDrawList());
  app::draw_chart(pen, look, {0, 0, extent.width, extent.height}, chart);
  ImGui::Render();
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(app.settings().ground ? look->ground : 0);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, extent.device_width, extent.device_height);
  glClearColor(ground.x, ground.y, ground.z, ground.w);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

/// How a picture is written.
struct PictureFile {
  std::string path, address;  // of what it shows; empty for none
  bool transparent = false;
};

/// What draw draws, as PNG; empty, with a line on standard error, if there is none.
template <class Draw>
std::string png_of(GlfwHost& host, bool transparent, Draw&& draw) {
  const Extent extent = host.extent();
  const OffScreen picture(extent.device_width, extent.device_height);
  if (!picture.complete()) return stop("the graphics driver cannot draw off the screen at this size"), "";
  for (int i = 0; i < kFramesForPicture; ++i) {
    picture.bind();
    draw();
  }
  std::string png = picture.png(transparent);
  if (png.empty()) stop("the picture could not be encoded");
  return png;
}

int write_picture(const std::string& path, const std::string& bytes) {
  const auto written = write_file(path, bytes);
  return written ? 0 : stop(written.error().message());
}

/// Writes what draw draws to a file.
template <class Draw>
int take_picture(GlfwHost& host, const PictureFile& file, Draw&& draw) {
  const std::string png = png_of(host, file.transparent, draw);
  return png.empty() ? kBadInput : write_picture(file.path, with_source(png, file.address));
}

/// The stage as SVG, as large as frames are now.
std::string stage_svg(GlfwHost& host, app::App& app, const std::string& address) {
  for (int i = 0; i + 1 < kFramesForPicture; ++i) draw_stage(host, app, host.now());
  host.begin_frame();
  const Extent extent = host.extent();
  return app::stage_svg(app, {.width = extent.width, .height = extent.height, .address = address}, host.now());
}

/// Steps as an animation. pause: seconds from step to step.
template <class Draw>
int take_animation(GlfwHost& host, Shell& shell, const std::string& path, std::array<int, 2> steps, double pause,
                   Draw&& draw) {
  constexpr double kLast = 2.5;  // times as long as the others
  const Extent extent = host.extent();
  const OffScreen picture(extent.device_width, extent.device_height);
  if (!picture.complete()) return stop("the graphics driver cannot draw off the screen at this size");
  const auto [first, last] = steps;
  lesson::Session& session = shell.session();
  session.jump(first);
  Animation animation(extent.device_width, extent.device_height, shell.address());
  for (int step = first; step <= last; ++step) {
    session.jump(step);
    for (int i = 0; i < kFramesForPicture; ++i) {
      picture.bind();
      draw();
    }
    if (!animation.add(picture.pixels(), pause * (step == last ? kLast : 1)))
      return stop("the animation could not be encoded");
  }
  const std::string gif = animation.finish();
  if (gif.empty()) return stop("the animation could not be encoded");
  return write_picture(path, gif);
}

/// Restores how the window looked, as far as nothing else was asked for.
void restore_view(app::Settings& settings, const std::optional<KeptView>& view) {
  if (!view) return;
  if (std::getenv("SNUG_THEME") == nullptr) settings.theme = static_cast<app::Theme>(view->theme);
  settings.text_scale = view->text_scale;
}

app::Theme theme_named(std::string_view theme) {
  return theme == "dark"        ? app::Theme::kDark
         : theme == "contrast"  ? app::Theme::kHighContrast
         : theme == "projector" ? app::Theme::kProjector
                                : app::Theme::kLight;
}

/// The theme that SNUG_THEME names, for labs that set one for every seat.
app::Theme theme_of_environment(std::string_view otherwise = "") {
  const char* name = std::getenv("SNUG_THEME");
  return theme_named(name != nullptr ? name : otherwise);
}

/// Chooses an answer to the open question by a digit. Returns whether it did.
bool choose(Shell& shell, const std::string& key) {
  const lesson::Asked* asked = shell.session().conversation().asked();
  if (asked == nullptr || key.size() != 1 || key[0] < '1' || key[0] > '9') return false;
  const int choice = key[0] - '1';
  if (choice >= static_cast<int>(asked->choices.size())) return false;
  return shell.app().pick_choice(choice);
}

/// Closes what lies on top, or ends the presentation. Returns false if there was nothing to close.
bool put_away(Shell& shell) {
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) {
    // A popup closes itself in the next frame; staying where it is, the focus asks for the frames after that one.
    if (shell.focus.at() != 0) shell.focus.move(0);
    else shell.focus.go_to(0);
    return true;
  }
  if (shell.file_card.what != FileCard::What::kNone) return shell.file_card = {}, true;
  if (shell.about_shown) return shell.about_shown = false, true;
  if (shell.keys_shown) return shell.keys_shown = false, true;
  if (!shell.notice.empty()) return shell.notice.clear(), true;
  if (shell.presenting) return shell.present(false), true;
  return shell.focus.leave();
}

/// Moves the focus or presses the focused control. Returns whether the key did that.
bool move_focus(Shell& shell, const std::string& key, bool shift) {
  if (slide_by_key(shell, key)) return true;
  constexpr float kLine = 48;
  app::Focus& focus = shell.focus;
  const int way = key == "ArrowDown" ? 1 : key == "ArrowUp" ? -1 : 0;
  if (key == "Tab") return focus.move(shift ? -1 : 1), true;
  if (key == "Enter" || key == " ") return focus.press();
  if (way == 0) return false;
  if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup)) return focus.move(way), true;
  if (focus.part() != "##prose" && focus.part() != "##column") return false;
  // From link to link; where there is none, the prose scrolls.
  if (focus.part() == "##column" || !focus.move_within(way)) shell.scroll_by = kLine * static_cast<float>(way);
  return shell.measured_anew = true;
}

/// Runs a key of the presentation. Returns whether it was one.
bool present_by_key(Shell& shell, const std::string& key) {
  if (!shell.presenting || shell.demo) return false;
  const int by = key == "n" || key == "N" ? 1 : key == "p" || key == "P" ? -1 : 0;
  if (key == "t" || key == "T") return shell.text_shown = !shell.text_shown, true;
  if (by == 0) return false;
  if (const auto to = shell.beside(by)) shell.open_at_place(*to);
  return true;
}

void answer_key(GlfwHost& host, Shell& shell, const std::string& key, bool shift, bool control) {
  if (is_working(shell)) return key == "Escape" ? cancel_working(shell) : void();          // it has only just begun
  if (!shell.hall.taken.letters.empty()) return static_cast<void>(shell.hall.taken = {});  // any key puts the code away
  if (key == "Escape" && shell.hall.put_away()) return;
  if (shell.demo && key == "F5") return host.fill_screen(true);  // a clicker's key that begins a show must not end it
  if (shell.demo && !control && shell.demo->answer_key(shell, key)) return;
  if (shell.hall.black && !shell.demo) return static_cast<void>(shell.hall.black = false);
  if (!control && shell.presenting && shell.hall.answer_key(key)) return;
  if (!control && !shell.course_shown && (key == "q" || key == "Q")) return shell.show_code();
  if (!control && key == "D" && !shell.course_shown && shell.app().sitting() == nullptr) return shell.record();
  if (control && key == "s" && !shell.course_shown && (shell.app().cover() == nullptr || !shell.app().cover()->shown()))
    return shell.save_stage(shift ? "svg" : "png");
  if (key == "?") return static_cast<void>(shell.keys_shown = !shell.keys_shown);
  if (shell.keys_shown && (key == "ArrowDown" || key == "ArrowUp")) {
    constexpr float kRows = 81;  // three
    return shell.keys_scroll = key == "ArrowDown" ? kRows : -kRows, static_cast<void>(shell.measured_anew = true);
  }
  if (key == "F10" && !shell.presenting) return shell.focus.go_to(shell.first_menu);
  if (menu_by_key(shell, key, shift, control)) return;
  if (key == "P" && shift && !shell.presenting && !shell.course_shown) return shell.present(true);
  if (!shell.course_shown && shell.app().end_playing()) return;
  if (key == "Escape" && put_away(shell)) return;
  if (!control && move_focus(shell, key, shift)) return;
  if (shell.course_shown) return static_cast<void>(shell.course.answer_key(shell, control && key == "f" ? "/" : key));
  if (!control && (choose(shell, key) || present_by_key(shell, key))) return;
  if (control && key == "s" && shell.app().cover() != nullptr)
    return shell.save_cover(shell.app().cover()->formats().front());
  shell.app().command(shell.app().command_of_key(key, shift, control));
}

/// The same as it stands, as large as on the screen: its stage, or its chart.
int take_part(GlfwHost& host, Shell& shell, const PictureFile& file, const PictureHow& how, const app::Chart* chart) {
  app::App& app = shell.app();
  const auto frame = [&] { chart != nullptr ? draw(host, app, *chart) : draw_stage(host, app, host.now()); };
  const std::string ending = ending_of(file.path);
  if (ending == "gif") {
    constexpr double kPause = 0.8;
    const int step = shell.session().player().step();
    const int status = take_animation(host, shell, file.path, *how.steps, kPause, frame);
    shell.session().jump(step);
    return status;
  }
  if (ending != "svg") return take_picture(host, file, frame);
  if (chart == nullptr) return write_picture(file.path, stage_svg(host, app, file.address));
  frame();  // in its theme
  return write_picture(file.path, app::cover_svg(app, file.address));
}

/// Writes the chart that is shown, or else the stage. Returns whether that succeeded.
bool write_picture(GlfwHost& host, Shell& shell, const std::string& path, const PictureHow& how) {
  app::App& app = shell.app();
  const app::Cover* const cover = app.cover();
  const app::Chart* const shown = cover != nullptr && cover->shown() ? cover->picture() : nullptr;
  const std::optional<app::Chart> chart = shown != nullptr ? std::optional(*shown) : std::nullopt;
  const PictureFile file{path, shell.address(), how.transparent};
  Extent extent = host.extent();
  if (!chart) {
    const app::Rect stage = parts_of(extent, app.look(), shell).app.stage;
    extent.width = stage.width, extent.height = stage.height;
  }
  if (!how.steps) extent.scale *= static_cast<float>(how.scale);
  extent.device_width = static_cast<int>(extent.width * extent.scale);
  extent.device_height = static_cast<int>(extent.height * extent.scale);
  const app::Settings before = app.settings();
  app::Settings& settings = app.settings();
  settings.prose_in_canvas = settings.tools = false;
  settings.reduced_motion = true;
  settings.labels = how.labels, settings.ground = !how.transparent || how.steps;
  settings.theme = how.theme.value_or(settings.theme);
  host.draw_as(extent);
  const bool saved = take_part(host, shell, file, how, chart ? &*chart : nullptr) == 0;
  host.draw_as(std::nullopt);
  app.settings() = before;
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return saved;
}

void save_picture(GlfwHost& host, Shell& shell) {
  const std::string path = std::exchange(shell.picture_wanted, {});
  const bool saved = write_picture(host, shell, path, std::exchange(shell.picture_how, {}));
  if (saved) shell.say("Saved as " + path + ".");
  else shell.notice = "Not saved: the picture could not be written.";
  shell.measured_anew = true;  // the window is drawn again
}

/// Opens, draws or closes the window of the notes, as the demo wants it. Closed by hand, it is no longer wanted.
void show_notes(std::unique_ptr<SecondWindow>& notes, GlfwHost& host, Shell& shell, bool drawn) {
  if (notes != nullptr && !notes->open() && shell.demo) shell.demo->notes_wanted = false;
  const bool wanted = shell.demo && shell.demo->notes_wanted;
  if (!wanted) return notes.reset();
  if (notes == nullptr) {
    notes = SecondWindow::make("Notes – Snug", 960, 720);
    if (notes == nullptr) return static_cast<void>(shell.demo->notes_wanted = false);
    notes->on_key = [&](const std::string& key, bool held) {
      if (shell.demo && held) shell.demo->hold_key(shell, key);
      else if (shell.demo) shell.demo->answer_key(shell, key);
      shell.measured_anew = true;
    };
    drawn = true;
  }
  const double second = std::floor(host.now());  // the clock's
  if (!drawn && !notes->stale() && second == shell.demo->notes_second) return;
  shell.demo->notes_second = second;
  notes->draw(shell.app().look(), [&](ImDrawList* list, const app::Rect& rect) {
    draw_notes(list, shell.app().look(), rect, *shell.demo, shell.hall);
  });
}

/// Puts the picture on the clipboard by the desktop's own program, for GLFW's has text alone.
void copy_picture(GlfwHost& host, Shell& shell) {
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("snug-" + std::to_string(getpid()) + ".png");
  const bool wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  const std::string call = wayland ? "wl-copy --type image/png < " : "xclip -selection clipboard -t image/png -i ";
  const bool drawn = write_picture(host, shell, file.string(), {});
  const bool copied = drawn && std::system((call + file.string() + " 2>/dev/null").c_str()) == 0;
  std::error_code error;
  std::filesystem::remove(file, error);
  shell.notice = copied ? "The picture is on the clipboard."
                        : std::string("Not copied: pictures are copied by ") + (wayland ? "wl-copy" : "xclip") +
                              ", which is not installed. “Save picture” writes a file.";
  shell.measured_anew = true;
}

/// Does what a menu has asked for.
void grant(GlfwHost& host, Shell& shell) {
  const std::string wish = std::exchange(shell.wish, {});
  if (wish == "quit") host.close();
  if (wish == "full_screen") host.fill_screen(!host.fills_screen());
  if (wish == "copy_picture") copy_picture(host, shell);
}

/// Draws if there is something to draw, and otherwise sleeps.
void run(GlfwHost& host, Shell& shell) {
  host.on_key = [&](const std::string& key, bool shift, bool control) { answer_key(host, shell, key, shift, control); };
  host.on_held = [&](const std::string& key) { return shell.demo && shell.demo->hold_key(shell, key); };
  host.on_drop = [&](const std::vector<std::string>& paths) {
    shell.use_dropped(paths);
    shell.measured_anew = true;
  };
  ImGui::GetIO().UserData = &shell.focus;
  StateFile state(shell.app());
  std::string title;
  bool due = true, presented = false, anew = false;
  std::unique_ptr<SecondWindow> notes;
  double next_look = 0;
  std::array<int, 4> extent = host.windowed_extent();
  while (host.open()) {
    if (is_working(shell)) work(host, shell, state), due = true;
    if (!host.open()) break;
    const bool drawn = due;
    if (due) {
      shell.app().settings().prose_in_canvas = !shell.demo || shell.demo->shows("caption");
      draw(host, shell, host.now());
      if (!shell.hall.frozen) host.swap();
      shell.keep(ImGui::IsAnyMouseDown());
      state.write(shell, host.extent());  // last, so that what it tells is kept as well
    }
    if (const std::string next = shell.course_shown ? "Snug" : shell.session().lesson().title + " – Snug";
        next != title)
      host.set_title(title = next);
    if (presented != shell.presenting) host.fill_screen(presented = shell.presenting);
    shell.app().measure(kSlice);
    const app::Cover* const cover = shell.app().cover();
    if (!shell.wish.empty()) grant(host, shell);
    else if (!shell.picture_wanted.empty()) save_picture(host, shell);
    if (!host.open()) break;  // or it would sleep until the next key
    show_notes(notes, host, shell, drawn);
    const auto more = [&] {
      return shell.measured_anew || shell.hall.moves() || shell.focus.wants_frame() ||
             shell.app().wants_frame(host.now());
    };
    const bool measuring = cover != nullptr && cover->running();
    // While a window is moved or drawn larger it has many places and sizes: those which it ends with are kept.
    const auto now = host.windowed_extent();
    const bool moved = std::exchange(extent, now) != now;
    if (!moved) shell.keep_view(extent);
    const double rest = moved ? kSettled : shell.writing() || notes != nullptr ? kLook : -1;
    shell.poll_loading();
    const bool asks = poll_dialog(shell);
    const bool input = host.wait(measuring || more()             ? 0
                                 : asks || shell.app().playing() ? kTick
                                 : shell.loading() != nullptr    ? kBetweenSeconds
                                                                 : rest);
    if (host.now() >= next_look) {
      anew = shell.look_at_files();
      next_look = host.now() + kLook;
    }
    due = input || std::exchange(anew, false) || shell.loading() != nullptr || more();
  }
}

/// Whether a student who was not here before begins with the lesson that the class's defaults name.
bool begins_with_defaults(const Shell& shell) {
  return !defaults().first_lesson.empty() && !shell.writing() && shell.kept().last().empty();
}

/// The lesson to open first: the one that was asked for, or the one to start or go on with.
std::string first_lesson(const Shell& shell, const WindowOptions& options) {
  if (!options.lesson.empty()) return is_path(options.lesson) ? id_of(options.lesson) : options.lesson;
  if (begins_with_defaults(shell)) return defaults().first_lesson;
  return shell.lessons().empty() ? std::string() : shell.lessons()[shell.lead().first].lesson.id;
}

int open_first(Shell& shell, const WindowOptions& options) {
  if (options.demo) {
    shell.present(true);
    shell.demo.emplace(options.demo);
    shell.demo->show(shell, 0);
    return shell.notice.empty() ? 0 : stop(shell.notice);
  }
  if (options.attempt) {
    const auto opened = shell.watch(*options.attempt);
    return opened ? 0 : stop(opened.error().message());
  }
  if (!options.exercise.empty()) {
    const auto opened = shell.open_exercise(options.exercise, options.seed);
    return opened ? 0 : stop(opened.error().message());
  }
  const bool picture = !options.screenshot.empty();
  const bool bare = options.at.is_bare() && !options.seed && options.points_file.empty() && !picture;
  const bool begins = begins_with_defaults(shell);
  const std::string id = first_lesson(shell, options);
  if (const KeptLesson* kept = shell.kept_lesson(id))
    shell.app().keep_answers(id, lesson::kept_answers_of(kept->answers));
  if (shell.waits_for(id)) return 0;
  if (const auto opened = shell.open(id); !opened)
    return shell.writing() && !picture ? 0 : stop(opened.error().message());
  if (bare) shell.go_to_kept_place();
  shell.course_shown = bare && options.lesson.empty() && !begins;
  // A window opens at the lesson's start; a picture shows the step before the first.
  lesson::Place at = options.at;
  if (options.seed) at.seed = options.seed;
  if (picture && !at.step && at.question.empty()) at.step = 0;
  if (options.points != nullptr) {
    lesson::Place under{.situation = at.situation, .seed = at.seed};
    if (const auto gone = lesson::go_to(under, shell.session(), mesh_named); !gone)
      return stop(gone.error().error.message());
    const bool gave_way = shell.session().stage().give_way(options.at.is_bare());
    shell.use_points(*options.points, options.points_file);
    shell.session().stage().give_way(gave_way);
    if (!shell.notice.empty()) return stop(shell.notice);
    if (const auto gone = lesson::go_in_run(at, shell.session()); !gone) return stop(gone.error().message());
  } else if (const auto gone = lesson::go_to(at, shell.session(), mesh_named); !gone) {
    return stop(gone.error().error.message());
  }
  if (!at.camera.empty()) shell.app().look_from(at.camera);
  if (app::Cover* const cover = shell.app().cover(); cover != nullptr && at.step && *at.step != 0)
    cover->show(false);  // a step is shown on the stage
  return 0;
}

/// Draws each state of the demo, with all of its reveals: numbered pictures in a folder, or the pages of one PDF.
int take_pictures(GlfwHost& host, Shell& shell, const std::string& to) {
  const bool bound = ending_of(to) == "pdf";
  PictureBook book;
  shell.app().settings().reduced_motion = true;
  for (std::size_t i = 0; i < shell.demo->states().size(); ++i) {
    const lesson::DemoState& state = shell.demo->states()[i];
    shell.demo->show(shell, i, state.reveal.size());
    if (!shell.notice.empty()) return stop(shell.notice);
    shell.app().settings().prose_in_canvas = shell.demo->shows("caption");
    const std::string number = std::to_string(i + 1), name = std::string(number.size() < 2 ? 1 : 0, '0') + number;
    const std::string png = png_of(host, false, [&] { draw(host, shell, host.now()); });
    if (png.empty()) return kBadInput;
    const std::string address = shell.address(), title = name + '-' + state.lesson;
    if (bound) book.add(png, title, address);
    else if (const int status =
                 write_picture((std::filesystem::path(to) / (title + ".png")).string(), with_source(png, address));
             status != 0)
      return status;
  }
  return bound ? write_picture(to, book.pdf()) : 0;
}

/// The folder of the lessons, if they are one's own; empty for the course.
std::string folder_of(const WindowOptions& options) {
  if (!options.folder.empty() || !is_own(options)) return options.folder;
  const std::string folder = std::filesystem::path(options.lesson).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The lessons, and where they are one's own, the drafts that they come from.
struct Lessons {
  std::vector<LessonFile> files;
  std::optional<Drafts> drafts;
};

tl::expected<Lessons, InputError> lessons_of(const WindowOptions& options) {
  if (!is_own(options))
    return read_lessons("").and_then([](std::vector<LessonFile>&& files) {
      for (auto read : {read_sheets(""), read_cases()}) {
        if (!read) return tl::expected<Lessons, InputError>(tl::unexpect, std::move(read.error()));
        std::move(read->begin(), read->end(), std::back_inserter(files));
      }
      return tl::expected<Lessons, InputError>(Lessons{std::move(files), {}});
    });
  return Drafts::open(options.folder, is_path(options.lesson) ? options.lesson : "").map([](Drafts&& drafts) {
    return Lessons{{}, std::move(drafts)};
  });
}

/// Frames are so many times as fine from now on.
void refine(GlfwHost& host, int scale) {
  Extent extent = host.extent();
  extent.scale *= static_cast<float>(scale), extent.device_width *= scale, extent.device_height *= scale;
  host.draw_as(extent);
}

/// A picture, or an animation, of where the shell stands.
int render(GlfwHost& host, Shell& shell, const WindowOptions& options) {
  refine(host, options.scale);
  const auto frame = [&] {
    options.stage_alone ? draw_stage(host, shell.app(), host.now()) : draw(host, shell, host.now());
  };
  if (options.steps) return take_animation(host, shell, options.screenshot, *options.steps, options.pause, frame);
  const std::string address = shell.address();
  if (ending_of(options.screenshot) != "svg")
    return take_picture(host, {options.screenshot, address, options.transparent}, frame);
  const auto written = write_file(options.screenshot, stage_svg(host, shell.app(), address));
  return written ? 0 : stop(written.error().message());
}

}  // namespace

int run_window(const WindowOptions& options) {
  auto lessons = lessons_of(options);
  if (!lessons) return stop(lessons.error().message());
  std::optional<app::Chart> chart;
  if (!options.chart.empty()) {
    auto read = read_chart(options.chart, options.chart_then);
    if (!read) return stop(read.error().message());
    chart = std::move(*read);
  }
  if (font_bytes("Inter-Regular").empty())
    return stop((data_folder() / "assets" / "fonts").string() + " lacks the fonts: build the target snug_assets");
  const app::Theme theme = options.theme.empty() ? theme_of_environment() : theme_named(options.theme);
  if (chart && ending_of(options.screenshot) == "svg") {
    const auto written = write_file(options.screenshot, svg_of(*chart, static_cast<float>(options.width),
                                                               static_cast<float>(options.height), theme, font_bytes,
                                                               !options.transparent));
    return written ? 0 : stop(written.error().message());
  }
  const auto width = static_cast<float>(options.width), height = static_cast<float>(options.height);
  const bool shown = options.screenshot.empty() && options.pictures.empty();
  Kept kept = shown ? Kept(folder_of(options)) : Kept(Kept::Nothing{});
  GlfwHost::Size size{options.width, options.height, options.sized, chart ? app::picture_scale(width, height) : 1.0f};
  if (kept.view && !options.sized && kept.view->width >= kLeastWidth && kept.view->height >= kLeastHeight)
    size.width = kept.view->width, size.height = kept.view->height, size.place = {kept.view->x, kept.view->y};
  auto host = GlfwHost::make(size, shown);
  if (!host) return stop(host.error());
  // Work goes on beside the window, which answers and can cancel it after each piece.
  if (shown)
    lesson::patience() = {.shown = 300e9,
                          .held = 5e9,
                          .instead = ". In a terminal `snug fit` fits volumes to all of them, without steps"};
  const cost::Provenance here = native_provenance();
  app::App app({.font = font_bytes,
                .glsl_version = "#version 330 core",
                .clock = native_now,
                .longest_run = kLongestRun,
                .gives_way = shown,
                .here = here});
  if (!app.create_graphics()) return stop("the graphics driver refused a shader: " + app.graphics_error());
  app.settings().prose_in_canvas = true;
  app.settings().theme = theme_of_environment(options.screenshot.empty() ? defaults().theme : "");
  if (!options.theme.empty()) app.settings().theme = theme_named(options.theme);
  app.settings().labels = options.labels, app.settings().ground = !options.transparent;
  if (chart) {
    refine(**host, options.scale);
    const PictureFile file{options.screenshot, "", options.transparent};
    return take_picture(**host, file, [&] { draw(**host, app, *chart); });
  }
  restore_view(app.settings(), kept.view);
  Shell shell(app, std::move(lessons->files), std::move(kept), std::move(lessons->drafts));
  if (auto exercises = read_exercises(options.folder))
    if (auto sets = read_sets_of(options.folder)) shell.take_exercises(*std::move(exercises), *std::move(sets));
  shell.version = here.version, shell.parts = versions_of_parts();
  if (const int status = open_first(shell, options); status != 0) return status;
  if (!options.pictures.empty()) return take_pictures(**host, shell, options.pictures);
  if (!options.screenshot.empty()) {
    app.settings().reduced_motion = true;
    if (options.stage_alone) app.settings().prose_in_canvas = app.settings().tools = false;
    return render(**host, shell, options);
  }
  run(**host, shell);
  return 0;
}

}  // namespace snug::desktop
