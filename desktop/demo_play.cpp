#include "desktop/demo_play.hpp"

#include <algorithm>

#include "app/cover.hpp"
#include "desktop/shell.hpp"
#include "lesson/names.hpp"

namespace snug::desktop {

bool DemoPlay::shows(std::string_view part) const {
  return lesson::is_among(states()[at_].shows, part) || lesson::is_among(revealed(), part);
}

std::string DemoPlay::place_text() const { return std::to_string(at_ + 1) + " of " + std::to_string(states().size()); }

void DemoPlay::show(Shell& shell, std::size_t at, std::size_t revealed) {
  at_ = at, revealed_ = 0;
  ImGui::GetIO().ClearEventsQueue();  // what was pressed and not drawn yet was meant for what stood there before
  ImGui::GetIO().ClearInputMouse();
  const lesson::DemoState& state = states()[at];
  shell.app().forget_answers();  // what was answered in an earlier state is asked again
  shell.notice.clear();
  if (!shell.open(state.lesson)) return;
  if (const auto taken = lesson::take_state(state, shell.session(), mesh_named); !taken)
    shell.notice = at_key(*file_, state, taken.error().key, taken.error().error).message();
  if (!state.camera.empty()) shell.app().look_from(state.camera);
  if (app::Cover* const cover = shell.app().cover(); cover != nullptr && state.step != 0) cover->show(false);
  if (!lesson::is_among(state.reveal, lesson::kRevealAnswer)) lesson::pass_questions(shell.session());
  while (revealed_ < std::min(revealed, state.reveal.size())) reveal(shell, state.reveal[revealed_++], false);
  shell.text_shown = shows("prose");
  shell.measured_anew = true;
}

void DemoPlay::reveal(Shell& shell, const std::string& what, bool played) {
  lesson::Session& session = shell.session();
  if (what == lesson::kRevealSteps && !shell.app().playing()) lesson::pass_questions(session);
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

bool DemoPlay::vote_told() const { return lesson::is_among(revealed(), lesson::kRevealAnswer); }

bool DemoPlay::vote_over() const {
  const auto shown = revealed();
  const auto answer = std::find(shown.begin(), shown.end(), lesson::kRevealAnswer);
  return std::any_of(answer, shown.end(),
                     [](const std::string& one) { return lesson::is_among(lesson::kDemoParts, one); });
}

const lesson::Vote* DemoPlay::vote() const {
  const auto found = votes_.find(at_);
  return found != votes_.end() ? &found->second : nullptr;
}

/// A vote begins with its first key while its question stands open.
bool DemoPlay::vote_by_key(Shell& shell, const std::string& key) {
  const lesson::Session& session = shell.session();
  if (vote_told() || session.asked() == nullptr) return false;
  if (!votes_.contains(at_)) {
    lesson::Vote fresh(session.asked()->choices, session.target_names());
    if (!fresh.take_key(key)) return false;
    votes_.emplace(at_, std::move(fresh));
    return true;
  }
  return votes_.at(at_).take_key(key);
}

std::string DemoPlay::next_text() const {
  const lesson::DemoState& state = states()[at_];
  if (revealed_ == state.reveal.size())
    return at_ + 1 < states().size() ? "Next: " + states()[at_ + 1].slide : "This is the last state.";
  std::string text;
  for (std::size_t i = revealed_; i < state.reveal.size(); ++i)
    text += (text.empty() ? "Next: " : ", then ") + std::string(lesson::revealed_text(state.reveal[i]));
  return text;
}

bool DemoPlay::answer_key(Shell& shell, const std::string& key) {
  if (!black && vote_by_key(shell, key)) return shell.measured_anew = true;
  const auto is = [&](auto... names) { return ((key == names) || ...); };
  if (is("b", "B", ".")) return black = !black, shell.measured_anew = true;
  if (is("s", "S")) return notes_wanted = !notes_wanted, shell.measured_anew = true;
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
