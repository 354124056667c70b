// A session's questions and the given answers.
#include <algorithm>
#include <array>
#include <numeric>

#include "io/text.hpp"
#include "lesson/names.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
const Outcome* Session::outcome_of(const std::string& question) const {
  const std::uint64_t on = instance();
  const auto found = std::find_if(outcomes_.begin(), outcomes_.end(),
                                  [&](const Outcome& one) { return one.question == question && one.on == on; });
  return found == outcomes_.end() ? nullptr : &*found;
}

bool Session::is_open(const Question& question) const {
  const Outcome* outcome = outcome_of(question.id);
  return outcome == nullptr || outcome->passed;
}

std::uint64_t Session::instance() const {
  if (edited() || seed() == own().origin().seed) return 0;
  const bool practised = practice_ == seed() || std::any_of(outcomes_.begin(), outcomes_.end(),
                                                            [&](const Outcome& one) { return one.on == seed(); });
  return practised ? seed() : 0;
}

bool Session::can_practise() const {
  return lesson_->subject->asks_of_steps && !asked_.empty() &&
         std::any_of(lesson_->questions.begin(), lesson_->questions.end(), [&](const Question& question) {
           return question.holds == Holds::kAlways && question.situation == situation() &&
                  question.gate.algorithm == name_in(*lesson_, *method(0));
         });
}

bool Session::practise() {
  constexpr std::uint64_t kMostTried = 100;
  if (!can_practise()) return false;
  const std::uint64_t practised = practice_, from = seed();
  const AtOnce at_once(*this);
  for (std::uint64_t next = from + 1; next <= from + kMostTried; ++next) {
    practice_ = next;
    scatter(next);
    if (seed() != next) break;
    if (!asked_.empty()) {
      summary_closed_ = false;
      stand(0);
      return true;
    }
    undo();
  }
  practice_ = practised;
  return false;
}

Tally Session::tally() const {
  Tally tally;
  for (const Asked& asked : asked_) add_to(tally, outcome_of(asked));
  return tally;
}

/// The outcome of an answer, with what it was asked on.
Outcome Session::judged(const Asked& asked, const Answer& answer) const {
  Outcome outcome = judge(asked, answer, run(0));
  outcome.on = instance();
  return outcome;
}

const Asked* Session::asked() const {
  const Asked* now = standing();
  const bool comes_later = now != nullptr && fresh_ && now->step != Asked::kAnytime;
  return comes_later || deciding_ || outcome() != nullptr ? nullptr : now;
}

const Asked* Session::open_at(int step) const {
  const auto found = std::find_if(asked_.begin(), asked_.end(),
                                  [&](const Asked& asked) { return asked.step == step && is_open(*asked.question); });
  return found == asked_.end() ? nullptr : &*found;
}

const Asked* Session::standing() const {
  if (const Asked* predicted = predicts_ ? to_predict() : nullptr) return predicted;
  return previewing_ ? nullptr : open_at(step_);
}

const Asked* Session::to_predict() const { return open_at(Asked::kAnytime); }

void Session::ask_predictions() {
  predicts_ = true;
  ++revision_;
}

Outcome& Session::outcome_for(const std::string& id) {
  if (const Outcome* own = outcome_of(id)) return outcomes_[own - outcomes_.data()];
  return outcomes_.emplace_back();
}

void Session::unpick() {
  picked_.reset();
  answer_says_.clear();
  skips_next_ = false;
  ++revision_;
}

bool Session::refuse(std::string why) {
  unpick();
  answer_says_ = std::move(why);
  return false;
}

const Answer* Session::picked() const { return picked_ && asked() != nullptr ? &*picked_ : nullptr; }

bool Session::commit() {
  if (picked() == nullptr) return false;
  return give(Answer(*picked_), false);
}

bool Session::skip() { return give({}, false); }

bool Session::pass_by() {
  if (asked() == nullptr) return false;
  if (conduct_.decides) return refuse(std::string(kNoSkipping)), true;
  if (skips_next_) return skip();
  unpick();
  answer_says_ = kPressToSkip;
  skips_next_ = true;
  return true;
}

const Answer* Session::tried() const {
  const Asked* question = asked();
  return tried_ && question != nullptr && question->question->id == tried_->question ? &tried_->answer : nullptr;
}

bool Session::pick(const Answer& chosen, bool gives) {
  const Asked* question = asked();
  if (question == nullptr || chosen.kind == Answer::Kind::kSkipped) return false;
  if (question->many || question->ordered) return pick_one_more(*question, chosen);
  const bool point = chosen.kind == Answer::Kind::kPoint && chosen.value >= 0 && chosen.value < size();
  if (!answers(*question, chosen))
    return point && question->on_stage ? refuse(no_target_text(name_of(chosen.value), target_names())) : false;
  if (tried() != nullptr && same_answer(*question, *tried(), chosen)) return refuse(std::string(kTriedAlready));
  if (conduct_.decides && gives) return propose(chosen);
  if (picked_ && same_answer(*question, *picked_, chosen)) return commit();
  unpick();
  picked_ = chosen;
  answer_says_ = chosen_text(*question, chosen, point ? name_of(chosen.value) : std::string());
  return true;
}

/// Where an answer has several parts: adds this one to what is chosen, or takes it out again.
bool Session::pick_one_more(const Asked& question, const Answer& chosen) {
  const bool point = chosen.kind == Answer::Kind::kPoint;
  if (point != question.on_stage) return false;
  const std::vector<Index> tappable = targets();
  if (point && std::find(tappable.begin(), tappable.end(), chosen.value) == tappable.end())
    return chosen.value >= 0 && chosen.value < size() ? refuse(no_target_text(name_of(chosen.value), target_names()))
                                                      : false;
  if (!point && (chosen.value < 0 || chosen.value >= static_cast<int>(question.choices.size()))) return false;
  Answer next = picked_.value_or(Answer{});
  unpick();
  if (!point && !question.ordered) {
    next = {Answer::Kind::kChoice, next.value ^ 1 << chosen.value};
    if (next.value == 0) return true;
  } else {
    next.kind = point ? Answer::Kind::kPoints : Answer::Kind::kOrder;
    if (std::erase(next.list, chosen.value) == 0) next.list.push_back(chosen.value);
    if (next.list.empty()) return true;
    if (point) std::sort(next.list.begin(), next.list.end());
  }
  answer_says_ = chosen_text(question, next, {});
  picked_ = std::move(next);
  return true;
}

bool Session::pick_number(const Asked& question, std::string_view typed) {
  const std::optional<double> number = typed_number(typed, question.unit);
  if (!number) return refuse(no_number_text(typed));
  const Answer meant{.kind = Answer::Kind::kNumber, .number = *number};
  if (tried() != nullptr && same_answer(question, *tried(), meant)) return refuse(std::string(kTriedAlready));
  unpick();
  picked_ = meant;
  answer_says_ = chosen_text(question, meant, {});
  return true;
}

/// Several names: "P3, P8 and P9" or "P3 P8 P9".
bool Session::pick_names(const Asked& question, std::string_view typed) {
  std::string words(typed);
  std::replace(words.begin(), words.end(), ',', ' ');
  Answer all{.kind = Answer::Kind::kPoints};
  const std::vector<Index> tappable = targets();
  for (std::string_view rest = words; !(rest = io::trim(rest)).empty();) {
    const std::string_view word = io::take_word(rest);
    if (word == "and") continue;
    const auto named = [&](Index i) { return plain_name(name_of(i)) == plain_name(word); };
    const auto found = std::find_if(tappable.begin(), tappable.end(), named);
    if (found == tappable.end()) return refuse(no_such_name_text(word, target_names()));
    if (std::find(all.list.begin(), all.list.end(), *found) == all.list.end()) all.list.push_back(*found);
  }
  if (all.list.empty()) return refuse(no_such_name_text(typed, target_names()));
  std::sort(all.list.begin(), all.list.end());
  unpick();
  answer_says_ = chosen_text(question, all, {});
  picked_ = std::move(all);
  return true;
}

bool Session::pick(std::string_view name) {
  const Asked* question = asked();
  if (question != nullptr && question->number) return pick_number(*question, name);
  if (question == nullptr || !question->on_stage) return false;
  if (question->many) return pick_names(*question, name);
  const std::string typed = plain_name(name);
  for (Index i = 0; i < size(); ++i) {
    if (plain_name(name_of(i)) != typed) continue;
    const Answer meant{Answer::Kind::kPoint, i};
    return (picked_ && same_answer(*question, *picked_, meant)) || pick(meant, false);
  }
  return refuse(no_such_name_text(name, target_names()));
}

std::vector<Index> Session::targets() const {
  const Asked* question = asked();
  if (question == nullptr || !question->on_stage) return {};
  std::vector<Index> all = question->stage_points;
  if (all.empty()) {
    all.resize(size());
    std::iota(all.begin(), all.end(), Index{0});
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::string> Session::target_names() const {
  std::vector<std::string> names;
  for (const Index i : targets()) names.push_back(name_of(i));
  return names;
}

std::string Session::score() const {
  if (standing() != nullptr || to_predict() != nullptr || deciding_) return {};
  const auto open = [](const Outcome& outcome) { return outcome.pending; };
  const bool of_steps = lesson_->subject->asks_of_steps;
  const bool over =
      of_steps ? step_ == steps() && !previewing_ : std::none_of(outcomes_.begin(), outcomes_.end(), open);
  if (!over) return {};
  std::string says = score_text(tally());
  for (const Slider* slider : sliders_to_move()) says += " Still to do: move the slider “" + slider->title + "”.";
  return says;
}

bool Session::at_summary() const {
  if (summary_closed_ || previewing_ || deciding_ || step_ != steps() || outcome() != nullptr) return false;
  const Tally all = tally();
  return lesson_->subject->asks_of_steps && all.all() > 0 && all.open == 0;
}

bool Session::comparing() const {
  if (!is_own()) return false;
  return std::any_of(lesson_->questions.begin(), lesson_->questions.end(), [&](const Question& question) {
    const Asking* asking = general_asking(question.asks, *lesson_->subject);
    return asking != nullptr && asking->figure == kComparedFigure && question.situation == situation() &&
           is_open(question);
  });
}

bool Session::awaits(const Method& of, std::string_view figure) const {
  if (!is_own()) return false;
  return std::any_of(lesson_->questions.begin(), lesson_->questions.end(), [&](const Question& question) {
    return (figure.empty() || question.figure == figure) && question.situation == situation() &&
           find_method(*lesson_, question.gate.algorithm) == &of && is_open(question);
  });
}

bool Session::hides_result(const Method& of) const {
  constexpr std::array<std::string_view, 3> kSizes{"radius", "measure", "excess"};
  return predicting() || comparing() || (&of == method(0) && is_hidden(kResultFigure)) ||
         std::any_of(kSizes.begin(), kSizes.end(), [&](std::string_view size) { return awaits(of, size); });
}

std::vector<const Method*> Session::waiting() const {
  std::vector<const Method*> methods;
  if (!is_own()) return methods;
  for (const std::string& name : lesson_->algorithms) {
    const bool open = std::any_of(lesson_->questions.begin(), lesson_->questions.end(), [&](const Question& question) {
      return question.gate.algorithm == name && question.situation == situation() && is_open(question);
    });
    const Method* offered = find_method(*lesson_, name);
    if (open && offered != method(0)) methods.push_back(offered);
  }
  return methods;
}

void Session::close_summary() {
  summary_closed_ = true;
  ++revision_;
}

bool Session::answer(const Answer& answer) { return give(answer, true); }

bool Session::give(const Answer& answer, bool for_good) {
  const Asked* question = asked();
  if (question == nullptr || !answers(*question, answer)) return false;
  if (conduct_.decides && answer.kind == Answer::Kind::kSkipped) return refuse(std::string(kNoSkipping));
  Outcome outcome_now = judged(*question, answer);
  const bool second = tried() != nullptr;
  given_.push_back({question->question->id, answer, outcome_now.right, seconds()});
  const bool again = !for_good && !second && conduct_.told && has_second_try(*question);
  if (standing_of(&outcome_now) == Standing::kWrong && again) {
    tried_ = Tried{question->question->id, answer};
    unpick();
    answer_says_ = question->ordered ? kTryOrderAgain : question->many ? kTryThoseAgain : kTryAgain;
    ProseFigures figures(*this);
    const Truth truth = question->asking->truth(*question, run(0));
    if (const std::string meaning = meaning_of(*question, answer, truth); !meaning.empty())
      answer_says_ += " " + plain_now(meaning, figures);
    return true;
  }
  if (second && !outcome_now.skipped) outcome_now.tries = 2;
  tried_.reset();
  Outcome& outcome = outcome_for(question->question->id);
  outcome = std::move(outcome_now);
  unpick();
  summary_closed_ = false;
  if (question->step == Asked::kAnytime) return ++revision_, true;
  shown_outcome_ = static_cast<int>(&outcome - outcomes_.data());
  shown_at_ = told_at(*question);
  answer_shown_ = false;
  deciding_ = shown_at_ - step_ > 1;
  if (!deciding_) stand(shown_at_);
  ++revision_;
  if (for_good || !play_answers_ || conduct_.decides) decide();
  if (conduct_.decides && (outcome.right || !conduct_.told)) acknowledge();
  return true;
}

double Session::seconds() const { return clock_ != nullptr ? (clock_() - opened_at_) * 1e-9 : 0; }

void Session::conduct(Conduct conduct) {
  conduct_ = conduct;
  if (conduct.builds) past_.clear(), future_.clear();
  if (!conduct.decides) return;
  past_.clear(), future_.clear();  // what led to this stage cannot be undone
  step_ = -1;                      // so that it stands anew, with the marks of an exercise
  go_to_next_decision();
}

/// What is routine is done for the student.
void Session::go_to_next_decision() {
  int to = steps();
  for (const Asked& asked : asked_)
    if (asked.step >= step_ && is_open(*asked.question)) to = std::min(to, asked.step);
  stand(to);
}

bool Session::take_back() {
  if (!conduct_.decides || conduct_.told || given_.empty()) return false;
  const std::string last = given_.back().question;
  const auto asked =
      std::find_if(asked_.begin(), asked_.end(), [&](const Asked& one) { return one.question->id == last; });
  std::erase_if(outcomes_, [&](const Outcome& outcome) { return outcome.question == last; });
  given_.pop_back();  // each has one try
  shown_outcome_ = -1;
  summary_closed_ = false;
  stand(asked->step);
  return ++revision_, true;
}

/// Where an outcome is told: where it is decided. If another question is open where it was asked, there instead, for
/// the step would answer that one.
int Session::told_at(const Asked& own) const {
  const auto waits = [&](const Asked& other) { return other.step == own.step && is_open(*other.question); };
  return std::any_of(asked_.begin(), asked_.end(), waits) ? own.step : own.until;
}

const Outcome* Session::deciding() const { return deciding_ ? &outcomes_[shown_outcome_] : nullptr; }

void Session::decide() {
  if (deciding_) stand(shown_at_);
}

const Outcome* Session::outcome() const {
  if (shown_outcome_ < 0 || deciding_ || previewing_ || step_ != shown_at_) return nullptr;
  return &outcomes_[shown_outcome_];
}

bool Session::acknowledge() {
  if (outcome() == nullptr) return false;
  shown_outcome_ = -1;
  ++revision_;
  if (conduct_.decides) go_to_next_decision();
  return true;
}

bool Session::can_watch_outcome() const {
  const Outcome* told = outcome();
  return told != nullptr && told->step == shown_at_ && told->step - told->from_step > 1;
}

bool Session::watch_outcome() {
  if (!can_watch_outcome()) return false;
  deciding_ = true;
  stand(outcomes_[shown_outcome_].from_step);
  return true;
}

bool Session::review(std::string_view question) {
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    const Outcome& past = outcomes_[i];
    const Asked* own = question_of(past);
    if (past.question != question || standing_of(&past) == Standing::kOpen || own == nullptr) continue;
    deciding_ = false;
    stand(conduct_.decides ? own->step : told_at(*own));  // in an exercise, what the student saw then
    shown_outcome_ = static_cast<int>(i);
    shown_at_ = step_;
    answer_shown_ = false;
    return ++revision_, true;
  }
  return false;
}

const Asked* Session::question_of(const Outcome& outcome) const {
  if (outcome.on != instance()) return nullptr;
  for (const Asked& asked : asked_)
    if (asked.question->id == outcome.question) return &asked;
  return nullptr;
}

const Outcome* Session::outcome_of(const Asked& asked) const { return outcome_of(asked.question->id); }

bool Session::can_show_answer() const {
  const Outcome* told = outcome();
  if (told == nullptr || standing_of(told) != Standing::kWrong) return false;
  const Asked* question = question_of(*told);
  return question != nullptr && (question->on_stage || question->choices.size() > 2);
}

bool Session::show_answer() {
  if (!can_show_answer()) return false;
  answer_shown_ = true;
  ++revision_;
  return true;
}

std::vector<int> Session::right_choices() const {
  const Outcome* told = outcome();
  const Asked* question = told != nullptr ? question_of(*told) : nullptr;
  return question != nullptr ? question->asking->truth(*question, run(0)).choices : std::vector<int>();
}

/// Decides predictions that were made before anything was known, again whenever more is known.
void Session::informed() {
  forget_grades();
  for (const Asked& asked : asked_)
    for (Outcome& outcome : outcomes_)
      if (asked.step == Asked::kAnytime && outcome.question == asked.question->id)
        outcome = judged(asked, outcome.given);
  ++revision_;
}

void Session::take_up_answers(std::vector<Outcome> outcomes) {
  std::erase_if(outcomes, [&](const Outcome& outcome) {
    return std::none_of(lesson_->questions.begin(), lesson_->questions.end(),
                        [&](const Question& question) { return question.id == outcome.question; });
  });
  outcomes_ = std::move(outcomes);
  shown_outcome_ = -1;
  deciding_ = false;
  ++revision_;
}

void Session::forget_answers() {
  outcomes_.clear();
  given_.clear();
  moved_.clear();
  unpick();
  tried_.reset();
  shown_outcome_ = -1;
  deciding_ = summary_closed_ = false;
  ++revision_;
}

}  // namespace snug::lesson
