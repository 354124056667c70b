// The controls of a cover: what it shows, its work, its files, and the results of the predictions about it.
#include "app/cover.hpp"
#include "app/cover_picture.hpp"
#include "app/marks.hpp"
#include "desktop/lower_panel.hpp"
#include "desktop/prose.hpp"
#include "desktop/prose_panel.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

using app::CoverButton;
using app::Face;

/// Draws a row of buttons and runs the command of the clicked one.
void draw_choices(Shell& shell, Column& column, const std::vector<CoverButton>& buttons) {
  std::vector<std::string> words;
  std::vector<bool> enabled;
  int chosen = -1;
  for (const CoverButton& button : buttons) {
    if (button.chosen) chosen = static_cast<int>(words.size());
    words.push_back(button.words), enabled.push_back(button.enabled);
  }
  const int clicked = column.buttons("choice", words, chosen, enabled);
  if (clicked >= 0) shell.app().command(buttons[clicked].command);
}

/// Draws the button that starts or stops the work, and a button for each file format.
void draw_work(Shell& shell, Column& column, const app::Cover& cover) {
  const CoverButton work = cover.work_buttons(shell.session())[cover.running() ? 1 : 0];
  std::vector<std::string> words{work.words};
  std::vector<bool> enabled{work.enabled};
  const bool any = !cover.file(cover.formats().front()).empty();
  const std::vector<std::string_view> formats = app::formats_of(cover);
  for (const std::string_view format : formats) {
    std::string ending(format);
    for (char& c : ending) c = static_cast<char>(std::toupper(c));
    words.push_back("Save " + ending), enabled.push_back(any);
  }
  const int clicked = column.buttons("work", words, -1, enabled);
  if (clicked == 0) shell.app().command(work.command);
  if (clicked > 0) shell.save_cover(formats[clicked - 1]);
}

void draw_progress(Column& column, double progress) {
  const float share = column.width() * static_cast<float>(progress);
  const ImVec2 from{column.x(), column.y()};
  column.list()->AddRectFilled(from, {from.x + column.width(), from.y + 4}, column.look()->track, 2);
  column.list()->AddRectFilled(from, {from.x + share, from.y + 4}, column.look()->current, 2);
}

/// What came of one of the questions, which are decided all at once.
void draw_outcome(Column& column, const lesson::Outcome& outcome, lesson::ProseFigures& figures) {
  const app::Look& look = column.look();
  column.begin_card();
  const bool open = outcome.skipped || outcome.pending;  // neither right nor wrong
  const app::Color color = outcome.right ? look->optimum_text : open ? look->muted : look->wrong_text;
  const float middle = column.y() + look.px(10);
  if (outcome.right) app::tick(column.list(), {column.x() + 6, middle}, 6, look->optimum, 2.25f);
  else if (!open) app::cross(column.list(), {column.x() + 6, middle}, 5, look->wrong, 2.25f);
  Column beside(look, column.x() + (open ? 0 : 22), column.y(), column.width());
  beside.heading(lesson::verdict_text(outcome), color);
  column.gap(look.px(24));
  if (!open) column.words(std::string(lesson::kPredictionWord) + ": " + outcome.predicted, Face::kSemiBold, 14);
  column.words(outcome.says);
  if (!outcome.because.empty() && !outcome.pending) {
    column.gap(6);
    draw_prompt(column, outcome.because, figures, {14, 21, Face::kRegular, look->muted, look->panel});
  }
  column.end_card();
}

/// How what was predicted came out; of a run's steps, the card on the stage says it.
void draw_score(Shell& shell, Column& column) {
  const std::string score = shell.session().conversation().score();
  if (score.empty()) return;
  column.begin_card();
  column.words(score, Face::kSemiBold, 14);
  column.gap(8);
  const bool again = column.buttons("again", {std::string(lesson::kPredictAgainWord)}) == 0;
  column.end_card();
  if (again) shell.app().command("predict_again");
}

}  // namespace

void draw_cover_panel(Shell& shell, const app::Rect& rect) {
  draw_lower(shell, "##pinned", rect, shell.pinned_height, [&](Column& column) {
    const app::Cover& cover = *shell.app().cover();
    const lesson::Session& session = shell.session();
    draw_choices(shell, column, cover.choices(session));
    draw_work(shell, column, cover);
    if (cover.running()) draw_progress(column, cover.progress());
    column.gap(12);
    column.words(cover.status(session), Face::kRegular, 13, column.look()->muted);
    column.gap(8);
    if (shell.tab == Shell::Tab::kSheet) return;  // which needs the room
    lesson::ProseFigures figures(session.conversation());
    if (session.conversation().asked() == nullptr && !cover.running() && cover.decided(session))
      for (const lesson::Asked& asked :
           session.conversation().questions())  // those of this situation: the score counts no others
        if (const lesson::Outcome* outcome = session.conversation().outcome_of(asked))
          draw_outcome(column, *outcome, figures), column.gap(8);
    if (session.lesson().subject->experiment != nullptr) draw_score(shell, column);
  });
}

}  // namespace snug::desktop
