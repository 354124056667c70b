#include "desktop/demo_play.hpp"

#include <algorithm>

#include "app/cover.hpp"
#include "desktop/shell.hpp"
#include "lesson/names.hpp"

namespace snug::desktop {
namespace {

/// Passes all questions of this run that are still open, and comes back: what plays then stops nowhere.
void pass_questions(lesson::Session& session) {
  const int step = session.step();
  for (std::size_t left = 3 * session.questions().size() + 3; left > 0; --left) {
    if (session.asked() != nullptr) session.skip();
    else if (session.deciding() != nullptr) session.decide();
    else if (session.outcome() != nullptr) session.acknowledge();
    else if (session.step() < session.steps()) session.go(session.steps());
    else break;
  }
  session.close_summary();
  session.jump(step);
}

}  // namespace

bool DemoPlay::shows(std::string_view part) const {
  const lesson::DemoState& state = states()[at_];
  const auto end = state.reveal.begin() + static_cast<std::ptrdiff_t>(revealed_);
  return lesson::is_among(state.shows, part) || std::find(state.reveal.begin(), end, part) != end;
}

std::string DemoPlay::place_text() const { return std::to_string(at_ + 1) + " of " + std::to_string(states().size()); }

void DemoPlay::show(Shell& shell, std::size_t at, std::size_t revealed) {
  at_ = at, revealed_ = 0;
  const lesson::DemoState& state = states()[at];
  shell.app().forget_answers();  // what was answered in an earlier state is asked again
  shell.notice.clear();
  if (!shell.open(state.lesson)) return;
  if (const auto taken = lesson::take_state(state, shell.session(), mesh_named); !taken)
    shell.notice = at_key(*file_, state, taken.error().key, taken.error().error).message();
  if (app::Cover* const cover = shell.app().cover(); cover != nullptr && state.step != 0) cover->show(false);
  if (!lesson::is_among(state.reveal, lesson::kRevealAnswer)) pass_questions(shell.session());
  while (revealed_ < std::min(revealed, state.reveal.size())) reveal(shell, state.reveal[revealed_++], false);
  shell.text_shown = shows("prose");
  shell.measured_anew = true;
}

void DemoPlay::reveal(Shell& shell, const std::string& what, bool played) {
  lesson::Session& session = shell.session();
  if (what == lesson::kRevealSteps && !shell.app().playing()) pass_questions(session);
  if (what == lesson::kRevealSteps && played && !shell.app().playing()) shell.app().command("play");
  if (what == lesson::kRevealSteps && !played) session.jump(session.steps());
  if (what != lesson::kRevealAnswer || session.asked() == nullptr) return;
  shell.app().command("skip_question");
  if (!played && session.deciding() != nullptr) session.decide();
}

void DemoPlay::next(Shell& shell) {
  const lesson::DemoState& state = states()[at_];
  if (revealed_ == state.reveal.size()) {
    if (at_ + 1 < states().size()) show(shell, at_ + 1);
    return;
  }
  reveal(shell, state.reveal[revealed_++], true);
  shell.text_shown = shows("prose");
  shell.measured_anew = true;
}

void DemoPlay::back(Shell& shell) {
  if (revealed_ > 0) return show(shell, at_, revealed_ - 1);
  if (at_ > 0) show(shell, at_ - 1, states()[at_ - 1].reveal.size());
}

bool DemoPlay::answer_key(Shell& shell, const std::string& key) {
  const auto is = [&](auto... names) { return ((key == names) || ...); };
  if (is("b", "B", ".")) return black = !black, shell.measured_anew = true;
  if (is("f", "F")) return frozen = !frozen, shell.measured_anew = true;
  const bool leads = is("PageDown", "ArrowRight", "PageUp", "ArrowLeft", "Home", "h", "H", "Escape");
  if (!leads) return false;
  // The first key brings the picture back, and does nothing else.
  if (black) return black = false, shell.measured_anew = true;
  if (is("PageDown", "ArrowRight")) next(shell);
  else if (is("PageUp", "ArrowLeft")) back(shell);
  else if (key != "Escape") show(shell, at_, revealed_);
  return key != "Escape";
}

}  // namespace snug::desktop
