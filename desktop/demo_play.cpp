#include "desktop/demo_play.hpp"

#include <algorithm>

#include "app/cover.hpp"
#include "desktop/shell.hpp"
#include "lesson/names.hpp"

namespace snug::desktop {
namespace {

constexpr int kHeld = 4;  // repetitions, a moment after the first: nobody presses a clicker that long by mistake

bool leads_on(std::string_view key) { return key == "PageDown" || key == "ArrowRight"; }
bool leads_back(std::string_view key) { return key == "PageUp" || key == "ArrowLeft"; }

}  // namespace

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
  if (const auto taken = lesson::go_to(state, shell.session(), mesh_named); !taken)
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
  if (what == lesson::kRevealSteps && !played) session.jump(session.player().steps());
  if (what != lesson::kRevealAnswer || session.conversation().asked() == nullptr) return;
  shell.app().command("reveal_answer");
  if (played) shell.app().command("watch_outcome");
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
  if (vote_told() || session.conversation().asked() == nullptr) return false;
  if (!votes_.contains(at_)) {
    lesson::Vote fresh(session.conversation().asked()->choices, session.conversation().target_names());
    if (!fresh.take_key(key)) return false;
    votes_.emplace(at_, std::move(fresh));
    return true;
  }
  return votes_.at(at_).take_key(key);
}

std::string DemoPlay::next_text() const {
  const lesson::DemoState& state = states()[at_];
  const bool last = at_ + 1 == states().size(), all = revealed_ == state.reveal.size();
  std::string text;
  for (std::size_t i = revealed_; i < state.reveal.size(); ++i)
    text += (text.empty() ? "Next: " : ", then ") + std::string(lesson::revealed_text(state.reveal[i]));
  if (last) return text + (all ? "" : ". ") + "This is the last state.";
  return text + (all ? "Next: " : ". After that: ") + states()[at_ + 1].slide;
}

bool DemoPlay::answer_key(Shell& shell, const std::string& key) {
  bool& black = shell.hall.black;
  if (!black && vote_by_key(shell, key)) return shell.measured_anew = true;
  if (shell.hall.curtain_key(key)) return shell.measured_anew = true;
  if (key == "s" || key == "S") return notes_wanted = !notes_wanted, shell.measured_anew = true;
  const bool again = key == "Home" || key == "h" || key == "H";
  if (!leads_on(key) && !leads_back(key) && !again && key != "Escape") return false;
  repeated_ = 0;
  // The first key brings the picture back, and does nothing else.
  if (black) return repeated_ = kHeld, black = false, shell.measured_anew = true;
  before_ = {at_, revealed_};
  if (leads_on(key)) next(shell);
  else if (leads_back(key)) back(shell);
  else if (again) show(shell, at_, revealed_);
  return key != "Escape";
}

bool DemoPlay::hold_key(Shell& shell, const std::string& key) {
  if (!leads_on(key) && !leads_back(key)) return false;
  if (++repeated_ == kHeld) show(shell, before_.first, before_.second);
  return true;
}

}  // namespace snug::desktop
