#include "desktop/working.hpp"

#include <algorithm>

#include "app/brush.hpp"
#include "app/widgets.hpp"
#include "lesson/patience.hpp"

namespace snug::desktop {
namespace {

constexpr double kPieces = 50e6;  // nanoseconds of them between two frames

}  // namespace

bool is_working(Shell& shell) { return shell.app().session() != nullptr && shell.session().preparing() != nullptr; }

void draw_working(Shell& shell, const app::Rect& window, double now) {
  shell.app().frame({}, now);  // its fonts and palette
  if (!is_working(shell)) return;
  const lesson::Preparation& work = *shell.session().preparing();
  const app::Look& look = shell.app().look();
  const app::Pane pane("##working", window, app::Pane::Kind::kOver);
  ImDrawList* const list = pane.list();
  list->AddRectFilled({window.x, window.y}, {window.x + window.width, window.y + window.height}, look->ground);
  const float middle = window.x + window.width / 2, y = window.y + window.height / 3;
  const float width = std::min(look.px(256), window.width - 32), left = middle - width / 2;
  const std::string says = work.says();
  app::text(list, look, app::Face::kRegular, 16, {middle - app::measure(look, app::Face::kRegular, 16, says).x / 2, y},
            look->ink, says);
  const float bar = y + look.px(36), done = width * static_cast<float>(work.share());
  list->AddRectFilled({left, bar}, {left + width, bar + 4}, look->line, 2);
  list->AddRectFilled({left, bar}, {left + done, bar + 4}, look->current, 2);
  const float wide = look.px(96);
  if (app::button(list, look,
                  {.id = "Cancel",
                   .rect = {middle - wide / 2, bar + look.px(28), wide, look.px(36)},
                   .words = "Cancel",
                   .kind = app::ButtonKind::kPrimary}))
    cancel_working(shell);
}

void go_on_working(Shell& shell) {
  if (!is_working(shell)) return;
  shell.tell(shell.session().go_on(kPieces));
  shell.measured_anew = true;
}

void cancel_working(Shell& shell) {
  if (!is_working(shell)) return;
  shell.session().give_up();
  shell.notice = "Cancelled: all is as it was.";
  shell.measured_anew = true;
}

}  // namespace snug::desktop
