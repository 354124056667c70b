#include "desktop/working.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>
#include <snug_gl.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <utility>

#include "app/brush.hpp"
#include "app/font_atlas.hpp"
#include "app/widgets.hpp"
#include "lesson/patience.hpp"

namespace snug::desktop {
namespace {

constexpr double kPieces = 50e6;  // nanoseconds of them between two looks at the session
// Seconds between frames while a piece takes longer, if nobody does anything: drawing takes the piece's time, by which
// the session judges how long it takes.
constexpr double kBetweenFrames = 0.25;

/// What the panel says; the session itself belongs to the thread.
struct Panel {
  std::string says, time;
  double share = 0;
};

/// Draws it over the whole window, in place of all else. Returns whether Cancel was pressed.
bool draw_panel(const app::Look& look, const app::Rect& window, const Panel& panel) {
  const app::Pane pane("##working", window, app::Pane::Kind::kOver);
  ImDrawList* const list = pane.list();
  list->AddRectFilled({window.x, window.y}, {window.x + window.width, window.y + window.height}, look->ground);
  const float middle = window.x + window.width / 2, y = window.y + window.height / 3;
  const float width = std::min(look.px(256), window.width - 32), left = middle - width / 2;
  const auto centred = [&](float top, float size, app::Color color, const std::string& words) {
    app::text(list, look, app::Face::kRegular, size,
              {middle - app::measure(look, app::Face::kRegular, size, words).x / 2, top}, color, words);
  };
  centred(y, 16, look->ink, panel.says);
  const float bar = y + look.px(36), done = width * static_cast<float>(panel.share);
  list->AddRectFilled({left, bar}, {left + width, bar + 4}, look->line, 2);
  list->AddRectFilled({left, bar}, {left + done, bar + 4}, look->current, 2);
  centred(bar + look.px(16), 13, look->muted, panel.time);
  const float wide = look.px(96);
  return app::button(list, look,
                     {.id = "Cancel",
                      .rect = {middle - wide / 2, bar + look.px(48), wide, look.px(36)},
                      .words = "Cancel",
                      .kind = app::ButtonKind::kPrimary});
}

/// A frame that touches nothing of the session. Returns whether Cancel was pressed.
bool draw_alone(GlfwHost& host, Shell& shell, const Panel& panel) {
  const app::Look& look = shell.app().look();
  const Extent extent = host.extent();
  shell.focus.begin_frame(look->current);
  const bool pressed = draw_panel(look, {0, 0, extent.width, extent.height}, panel);
  shell.focus.end_frame();
  app::whiten(*ImGui::GetIO().Fonts);
  ImGui::Render();
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, extent.device_width, extent.device_height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  host.swap();
  return pressed;
}

/// While a thread has the session, keys and files that would reach it do not.
class OwnKeys {
 public:
  OwnKeys(GlfwHost& host, Shell& shell, bool& cancelled)
      : host_(host), key_(std::move(host.on_key)), drop_(std::move(host.on_drop)) {
    host.on_key = [&](const std::string& key, bool shift, bool) {
      if (key == "Escape") cancelled = true;
      if (key == "Tab") shell.focus.move(shift ? -1 : 1);
      if (key == "Enter" || key == " ") shell.focus.press();
    };
    host.on_drop = nullptr;
  }
  ~OwnKeys() { host_.on_key = std::move(key_), host_.on_drop = std::move(drop_); }
  OwnKeys(const OwnKeys&) = delete;
  OwnKeys& operator=(const OwnKeys&) = delete;

 private:
  GlfwHost& host_;
  decltype(GlfwHost::on_key) key_;
  decltype(GlfwHost::on_drop) drop_;
};

/// Tells the window of a thread's end, however it comes.
struct AtEnd {
  std::atomic<bool>& ready;
  ~AtEnd() {
    ready = true;
    GlfwHost::wake();
  }
};

}  // namespace

std::string time_so_far(double seconds, double left) {
  if (seconds < 1) return {};
  const auto words = [](double value) { return lesson::long_time(std::ceil(value) * 1e9); };
  return words(std::floor(seconds)) + " so far" + (left > 0 ? ", about " + words(left) + " left" : "");
}

bool is_working(Shell& shell) {
  return shell.app().session() != nullptr && shell.session().stage().preparing() != nullptr;
}

void work(GlfwHost& host, Shell& shell, StateFile& state) {
  bool cancelled = false;
  const OwnKeys keys(host, shell, cancelled);
  const double begun = host.now();
  while (host.open() && is_working(shell) && !cancelled) {
    const lesson::Preparation& now = *shell.session().stage().preparing();
    const double at = host.now(), left = now.left() / 1e9, share = now.share();
    Panel panel{now.says(), time_so_far(at - begun, left), share};
    host.begin_frame();
    shell.app().frame({}, host.now());  // its fonts and palette, and how often it was drawn
    cancelled = draw_alone(host, shell, panel) || cancelled;
    state.write(shell, host.extent());
    std::atomic<bool> ready = false;
    std::future<lesson::Done> piece = std::async(std::launch::async, [&] {
      const AtEnd told{ready};
      return shell.session().stage().go_on(kPieces);
    });
    for (host.wait(kBetweenFrames); !ready; host.wait(kBetweenFrames)) {  // at least once: somebody may press Cancel
      if (cancelled) panel.says = "Cancelling: it ends after this part";
      // The piece tells nothing until its end: what was foretold goes on meanwhile.
      const double passed = host.now() - at, done = left > 0 ? std::min(passed / left, 0.99) : 0;
      panel.share = share + (1 - share) * done;
      panel.time = time_so_far(host.now() - begun, std::max(left - passed, std::min(left, 1.0)));
      host.begin_frame();
      cancelled = draw_alone(host, shell, panel) || cancelled;
      state.write_beside(panel.time);
    }
    shell.tell(piece.get());
  }
  if (cancelled) cancel_working(shell);
  shell.measured_anew = true;
}

void cancel_working(Shell& shell) {
  if (!is_working(shell)) return;
  shell.session().stage().give_up();
  shell.notice = "Cancelled: all is as it was.";
  shell.measured_anew = true;
}

}  // namespace snug::desktop
