#include "lesson/session/conversation.hpp"

#include <algorithm>
#include <numeric>

#include "io/text.hpp"
#include "lesson/decide.hpp"
#include "lesson/names.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/session/telling.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {

Conversation::Conversation(const Lesson& lesson, Stage& stage, Player& player, Log& log)
    : lesson_(&lesson), stage_(&stage), player_(&player), log_(&log), predicts_(lesson.subject->experiment == nullptr) {
}

/// Finds what is asked of a new run.
bool Conversation::follow(bool entered) {
  if (entered) predicts_ = lesson_->subject->experiment == nullptr;
  const Subject& subject = stage_->subject();
  const bool is_disturbed = subject.frames() != nullptr && subject.frames()->is_disturbed();
  asked_ = asked_on(*lesson_, name_in(*lesson_, *player_->method(0)), subject, player_->run(0),
                    stage_->is_own() && !is_disturbed);
  player_->mark(places(), player_->steps());
  forget();
  take_as_asked();
  return open_at(0) != nullptr;
}

/// Forgets what is chosen and told.
void Conversation::forget() {
  show_nothing();
  tried_.reset();
  unpick();
}

/// The places in the run where something is asked.
std::vector<int> Conversation::places() const {
  std::vector<int> places;
  for (const Asked& asked : asked_)
    if (asked.step != Asked::kAnytime) places.push_back(asked.step);
  return places;
}

void Conversation::set_step(int step) {
  if (!player_->set_step(step)) return;
  if (step >= shown_at_) deciding_ = false;
  if (!deciding_ && step != shown_at_) shown_outcome_ = -1;
  if (stage_->conduct().decides) {  // the marks to come would tell what is right
    int last = player_->steps();
    for (const Asked& asked : asked_)
      if (asked.step != Asked::kAnytime && is_open(*asked.question)) last = std::min(last, asked.step);
    player_->mark(places(), last);
  }
  unpick();
}

bool Conversation::is_open(const Question& question) const {
  const Outcome* outcome = log_->outcome_of(question.id, instance());
  return outcome == nullptr || outcome->passed;
}

std::uint64_t Conversation::instance() const {
  const std::uint64_t seed = stage_->subject().origin().seed;
  if (stage_->edited() || seed == stage_->own().origin().seed) return 0;
  const auto& outcomes = log_->outcomes();
  const bool practised = practice_ == seed || std::any_of(outcomes.begin(), outcomes.end(),
                                                          [&](const Outcome& one) { return one.on == seed; });
  return practised ? seed : 0;
}

bool Conversation::can_practise() const {
  return !asked_.empty() &&
         std::any_of(lesson_->questions.begin(), lesson_->questions.end(), [&](const Question& question) {
           return question.holds == Holds::kAlways && question.situation == stage_->situation() &&
                  question.gate.algorithm == name_in(*lesson_, *player_->method(0));
         });
}

bool Conversation::practise() {
  constexpr std::uint64_t kMostTried = 100;
  if (!can_practise()) return false;
  const Method& method = *player_->method(0);
  const std::uint64_t from = stage_->subject().origin().seed;
  for (std::uint64_t next = from + 1; next <= from + kMostTried; ++next) {
    const auto there = stage_->scattered(next);
    if (!there || !there->subject->suits(method)) continue;
    const auto run = there->subject->run(method, nullptr);
    if (asked_on(*lesson_, name_in(*lesson_, method), *there->subject, *run, false).empty()) continue;
    const std::uint64_t practised = std::exchange(practice_, next);
    const AtOnce at_once(*stage_);
    if (!stage_->scatter(next)) return practice_ = practised, false;
    summary_closed_ = false;
    set_step(0);
    return true;
  }
  return false;
}

Tally Conversation::tally() const {
  Tally tally;
  for (const Asked& asked : asked_) add_to(tally, outcome_of(asked));
  return tally;
}

/// The outcome of an answer, with what it was asked on.
Outcome Conversation::judged(const Asked& asked, const Answer& answer) const {
  Outcome outcome = judge(asked, answer, player_->run(0));
  outcome.on = instance();
  return outcome;
}

const Asked* Conversation::asked() const {
  const Asked* now = question_here();
  const bool comes_later = now != nullptr && player_->fresh() && now->step != Asked::kAnytime;
  return comes_later || deciding_ || outcome() != nullptr ? nullptr : now;
}

const Asked* Conversation::open_at(int step) const {
  const auto found = std::find_if(asked_.begin(), asked_.end(),
                                  [&](const Asked& asked) { return asked.step == step && is_open(*asked.question); });
  return found == asked_.end() ? nullptr : &*found;
}

const Asked* Conversation::question_here() const {
  if (const Asked* predicted = predicts_ ? to_predict() : nullptr) return predicted;
  return player_->previewing() ? nullptr : open_at(player_->step());
}

void Conversation::ask_predictions() {
  predicts_ = true;
  ++revision_;
}

void Conversation::unpick() {
  picked_.reset();
  answer_says_.clear();
  skips_next_ = false;
  ++revision_;
}

/// Chooses it, and says so. name: of a single handle.
void Conversation::choose(Answer answer, const std::string& name) {
  unpick();
  answer_says_ = chosen_text(*asked(), answer, name);
  picked_ = std::move(answer);
}

bool Conversation::refuse(std::string why) {
  unpick();
  answer_says_ = std::move(why);
  return false;
}

bool Conversation::commit() {
  if (picked() == nullptr) return false;
  return give(Answer(*picked_), false);
}

bool Conversation::pass_by() {
  if (asked() == nullptr) return false;
  if (stage_->conduct().decides) return refuse(std::string(kNoSkipping)), true;
  if (skips_next_) return give({}, false);
  unpick();
  answer_says_ = kPressToSkip;
  skips_next_ = true;
  return true;
}

const Answer* Conversation::tried() const {
  const Asked* question = asked();
  return tried_ && question != nullptr && question->question->id == tried_->question ? &tried_->answer : nullptr;
}

bool Conversation::pick(const Answer& chosen, bool gives) {
  const Asked* question = asked();
  if (question == nullptr || is_skipped(chosen)) return false;
  if (question->many || question->ordered) return pick_one_more(*question, chosen);
  const Subject& subject = stage_->subject();
  const auto* handle = std::get_if<OneHandle>(&chosen);
  if (handle != nullptr && (handle->handle < 0 || handle->handle >= subject.size())) return false;
  const std::string name = handle != nullptr ? subject.name_of(handle->handle) : std::string();
  if (!answers(*question, chosen))
    return handle != nullptr && question->on_stage ? refuse(no_target_text(name, target_names())) : false;
  if (tried() != nullptr && same_answer(*question, *tried(), chosen)) return refuse(std::string(kTriedAlready));
  if (stage_->conduct().decides && gives) return give(chosen, false);
  if (picked_ && same_answer(*question, *picked_, chosen)) return commit();
  choose(chosen, name);
  return true;
}

/// Where an answer has several parts: adds this one to what is chosen, or takes it out again.
bool Conversation::pick_one_more(const Asked& question, const Answer& chosen) {
  const auto* handle = std::get_if<OneHandle>(&chosen);
  const auto* choice = std::get_if<OneChoice>(&chosen);
  if (question.on_stage) return handle != nullptr && pick_one_more_handle(handle->handle);
  if (choice == nullptr || choice->choice < 0 || choice->choice >= std::ssize(question.choices)) return false;
  const std::span<const int> before = picked_ ? choices_of(*picked_) : std::span<const int>();
  std::vector<int> all(before.begin(), before.end());
  unpick();
  if (std::erase(all, choice->choice) == 0) all.push_back(choice->choice);
  if (all.empty()) return true;
  if (question.ordered) return choose(ChoicesInOrder{std::move(all)}), true;
  std::sort(all.begin(), all.end());
  choose(SeveralChoices{std::move(all)});
  return true;
}

bool Conversation::pick_one_more_handle(Index handle) {
  const std::vector<Index> tappable = targets();
  if (handle < 0 || handle >= stage_->subject().size()) return false;
  if (std::find(tappable.begin(), tappable.end(), handle) == tappable.end())
    return refuse(no_target_text(stage_->subject().name_of(handle), target_names()));
  SeveralHandles all;
  if (const auto* before = picked_ ? std::get_if<SeveralHandles>(&*picked_) : nullptr) all = *before;
  unpick();
  if (std::erase(all.handles, handle) == 0) all.handles.push_back(handle);
  if (all.handles.empty()) return true;
  std::sort(all.handles.begin(), all.handles.end());
  choose(std::move(all));
  return true;
}

bool Conversation::pick_number(const Asked& question, std::string_view typed) {
  const std::optional<double> number = typed_number(typed, question.unit);
  if (!number) return refuse(no_number_text(typed));
  const Answer meant = TypedNumber{*number};
  if (tried() != nullptr && same_answer(question, *tried(), meant)) return refuse(std::string(kTriedAlready));
  choose(meant);
  return true;
}

/// Several names: "P3, P8 and P9" or "P3 P8 P9".
bool Conversation::pick_names(std::string_view typed) {
  std::string words(typed);
  std::replace(words.begin(), words.end(), ',', ' ');
  std::vector<Index> all;
  const std::vector<Index> tappable = targets();
  for (std::string_view rest = words; !(rest = io::trim(rest)).empty();) {
    const std::string_view word = io::take_word(rest);
    if (word == "and") continue;
    const auto named = [&](Index i) { return plain_name(stage_->subject().name_of(i)) == plain_name(word); };
    const auto found = std::find_if(tappable.begin(), tappable.end(), named);
    if (found == tappable.end()) return refuse(no_such_name_text(word, target_names()));
    all.push_back(*found);
  }
  if (all.empty()) return refuse(no_such_name_text(typed, target_names()));
  choose(by_handles(std::move(all)));
  return true;
}

bool Conversation::pick(std::string_view name) {
  const Asked* question = asked();
  if (question != nullptr && question->number) return pick_number(*question, name);
  if (question == nullptr || !question->on_stage) return false;
  if (question->many) return pick_names(name);
  const std::string typed = plain_name(name);
  for (Index i = 0; i < stage_->subject().size(); ++i) {
    if (plain_name(stage_->subject().name_of(i)) != typed) continue;
    const Answer meant = OneHandle{i};
    return (picked_ && same_answer(*question, *picked_, meant)) || pick(meant, false);
  }
  return refuse(no_such_name_text(name, target_names()));
}

std::vector<Index> Conversation::targets() const {
  const Asked* question = asked();
  if (question == nullptr || !question->on_stage) return {};
  std::vector<Index> all = question->stage_points;
  if (all.empty()) {
    all.resize(stage_->subject().size());
    std::iota(all.begin(), all.end(), Index{0});
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::string> Conversation::target_names() const {
  std::vector<std::string> names;
  for (const Index i : targets()) names.push_back(stage_->subject().name_of(i));
  return names;
}

std::string Conversation::score() const {
  if (question_here() != nullptr || to_predict() != nullptr || deciding_) return {};
  const auto open = [](const Outcome& outcome) { return outcome.pending; };
  const auto& outcomes = log_->outcomes();
  const bool over =
      lesson_->subject->experiment == nullptr ? player_->over() : std::none_of(outcomes.begin(), outcomes.end(), open);
  if (!over) return {};
  std::string says = score_text(tally());
  for (const Slider* slider : log_->to_move()) says += " Still to do: move the slider “" + slider->title + "”.";
  return says;
}

bool Conversation::at_summary() const {
  if (summary_closed_ || deciding_ || !player_->over() || outcome() != nullptr) return false;
  const Tally all = tally();
  return lesson_->subject->experiment == nullptr && all.all() > 0 && all.open == 0;
}

std::vector<const Method*> Conversation::waiting() const {
  std::vector<const Method*> methods;
  if (!stage_->is_own()) return methods;
  for (const std::string& name : lesson_->algorithms) {
    const bool open = std::any_of(lesson_->questions.begin(), lesson_->questions.end(), [&](const Question& question) {
      return question.gate.algorithm == name && question.situation == stage_->situation() && is_open(question);
    });
    const Method* offered = find_method(*lesson_, name);
    if (open && offered != player_->method(0)) methods.push_back(offered);
  }
  return methods;
}

void Conversation::close_summary() {
  summary_closed_ = true;
  ++revision_;
}

bool Conversation::give(const Answer& given, bool for_good) {
  const Asked* question = asked();
  if (question == nullptr) return false;
  const Answer answer = as_asked(*question, given);
  if (!answers(*question, answer)) return false;
  const Conduct& conduct = stage_->conduct();
  if (conduct.decides && is_skipped(answer)) return refuse(std::string(kNoSkipping));
  Outcome outcome = judged(*question, answer);
  const bool second = tried() != nullptr, right = outcome.right;
  log_->add(question->question->id, answer, right);
  const bool again = !for_good && !second && conduct.told && has_second_try(*question);
  if (answer_state_of(&outcome) == AnswerState::kWrong && again) return try_again(*question, answer);
  if (second && !outcome.skipped) outcome.tries = 2;
  tried_.reset();
  const std::size_t place = log_->add(std::move(outcome));
  unpick();
  summary_closed_ = false;
  if (question->step == Asked::kAnytime) return true;
  shown_outcome_ = static_cast<int>(place);
  shown_at_ = told_at(*question);
  answer_shown_ = false;
  deciding_ = shown_at_ - player_->step() > 1;
  if (!deciding_) set_step(shown_at_);
  if (for_good || !play_answers_ || conduct.decides) decide();
  if (conduct.decides && (right || !conduct.told)) acknowledge();
  return true;
}

/// Only calls a wrong first answer wrong, with what the lesson says to it.
bool Conversation::try_again(const Asked& question, const Answer& answer) {
  tried_ = Tried{question.question->id, answer};
  unpick();
  answer_says_ = question.ordered ? kTryOrderAgain : question.many ? kTryThoseAgain : kTryAgain;
  ProseFigures figures(*this);
  const Truth truth = question.kind->truth(question, player_->run(0));
  if (const std::string meaning = meaning_of(question, answer, truth); !meaning.empty())
    answer_says_ += " " + plain_now(meaning, figures);
  return true;
}

/// What is routine is done for the student.
void Conversation::go_to_next_decision() {
  int to = player_->steps();
  for (const Asked& asked : asked_)
    if (asked.step >= player_->step() && is_open(*asked.question)) to = std::min(to, asked.step);
  set_step(to);
}

bool Conversation::take_back() {
  if (!stage_->conduct().decides || stage_->conduct().told || log_->given().empty()) return false;
  const std::string last = log_->given().back().question;
  const auto asked =
      std::find_if(asked_.begin(), asked_.end(), [&](const Asked& one) { return one.question->id == last; });
  log_->take_back();  // each has one try
  shown_outcome_ = -1;
  summary_closed_ = false;
  set_step(asked->step);
  return ++revision_, true;
}

/// Where an outcome is told: where it is decided. If another question is open where it was asked, there instead, for
/// the step would answer that one.
int Conversation::told_at(const Asked& own) const {
  const auto waits = [&](const Asked& other) { return other.step == own.step && is_open(*other.question); };
  return std::any_of(asked_.begin(), asked_.end(), waits) ? own.step : own.until;
}

void Conversation::decide() {
  if (deciding_) set_step(shown_at_);
}

const Outcome* Conversation::outcome() const {
  if (shown_outcome_ < 0 || deciding_ || player_->previewing() || player_->step() != shown_at_) return nullptr;
  return &log_->outcomes()[shown_outcome_];
}

bool Conversation::acknowledge() {
  if (outcome() == nullptr) return false;
  shown_outcome_ = -1;
  ++revision_;
  if (stage_->conduct().decides) go_to_next_decision();
  return true;
}

bool Conversation::can_watch_outcome() const {
  const Outcome* told = outcome();
  return told != nullptr && told->step == shown_at_ && told->step - told->from_step > 1;
}

bool Conversation::watch_outcome() {
  if (!can_watch_outcome()) return false;
  deciding_ = true;
  set_step(log_->outcomes()[shown_outcome_].from_step);
  return true;
}

bool Conversation::review(std::string_view question) {
  for (std::size_t i = 0; i < log_->outcomes().size(); ++i) {
    const Outcome& past = log_->outcomes()[i];
    const Asked* own = question_of(past);
    if (past.question != question || answer_state_of(&past) == AnswerState::kOpen || own == nullptr) continue;
    deciding_ = false;
    set_step(stage_->conduct().decides ? own->step : told_at(*own));  // in an exercise, what the student saw then
    shown_outcome_ = static_cast<int>(i);
    shown_at_ = player_->step();
    answer_shown_ = false;
    return ++revision_, true;
  }
  return false;
}

const Asked* Conversation::question_of(const Outcome& outcome) const {
  if (outcome.on != instance()) return nullptr;
  for (const Asked& asked : asked_)
    if (asked.question->id == outcome.question) return &asked;
  return nullptr;
}

const Outcome* Conversation::outcome_of(const Asked& asked) const {
  return log_->outcome_of(asked.question->id, instance());
}

bool Conversation::can_show_answer() const {
  const Outcome* told = outcome();
  if (told == nullptr || answer_state_of(told) != AnswerState::kWrong) return false;
  const Asked* question = question_of(*told);
  return question != nullptr && (question->on_stage || question->choices.size() > 2);
}

bool Conversation::show_answer() {
  if (!can_show_answer()) return false;
  answer_shown_ = true;
  ++revision_;
  return true;
}

std::vector<int> Conversation::right_choices() const {
  const Outcome* told = outcome();
  const Asked* question = told != nullptr ? question_of(*told) : nullptr;
  return question != nullptr ? question->kind->truth(*question, player_->run(0)).choices : std::vector<int>();
}

/// Only its question knows what a kept answer means.
void Conversation::take_as_asked() {
  for (const Asked& asked : asked_) log_->take_as_asked(asked);
}

void Conversation::judge_again() {
  for (const Asked& asked : asked_) {
    const Outcome* const known = outcome_of(asked);
    if (asked.step == Asked::kAnytime && known != nullptr) log_->add(judged(asked, known->given));
  }
  ++revision_;
}

}  // namespace snug::lesson
