#include "lesson/exercise/sitting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/random.hpp"
#include "lesson/exercise/build.hpp"
#include "lesson/figures.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"

namespace snug::lesson {
namespace {

constexpr double kLeadsOn = 0.8;  // a share of the marks

/// Half of what could be answered, the right answers among it, in words: "One of these is right: P3; P7; P9."
std::string narrowed(const Asked& asked, const Run& run, std::uint64_t seed) {
  const Truth truth = asked.kind->truth(asked, run);
  if (asked.number) return {};
  const bool handles = asked.choices.empty();
  std::vector<int> all(asked.choices.size());
  std::iota(all.begin(), all.end(), 0);
  if (handles) all.assign(asked.stage_points.begin(), asked.stage_points.end());
  if (handles && all.empty()) all.resize(asked.subject->size()), std::iota(all.begin(), all.end(), 0);
  const auto is_right = [&](int one) {
    return handles ? std::find(truth.points.begin(), truth.points.end(), one) != truth.points.end()
                   : std::find(truth.choices.begin(), truth.choices.end(), one) != truth.choices.end();
  };
  const auto right = std::stable_partition(all.begin(), all.end(), is_right) - all.begin();
  if (std::ssize(all) - right < 2) return {};
  Random random(seed);
  for (auto left = std::ssize(all); left > right + 1; --left)
    std::swap(all[left - 1], all[right + random.below(static_cast<std::uint32_t>(left - right))]);
  all.resize(right + std::max<std::ptrdiff_t>((std::ssize(all) - right) / 2, 1));
  std::sort(all.begin(), all.end());
  std::vector<std::string> names;
  for (const int one : all) names.push_back(handles ? asked.subject->name_of(one) : asked.choices[one]);
  return (asked.many ? "The whole answer is among these: " : "One of these is right: ") + listed(names, ", ") + '.';
}

/// "The answer: P9."
std::string told(const Asked& asked, const Run& run) {
  const Truth truth = asked.kind->truth(asked, run);
  if (asked.ordered) {
    std::string order = "The order:";
    int number = 0;
    for (const int choice : truth.choices) order += ' ' + std::to_string(++number) + ". " + asked.choices[choice] + ';';
    return order.back() = '.', order;
  }
  if (asked.many || truth.choices.size() < 2) return "The answer: " + truth.happened + '.';
  std::vector<std::string> right;
  for (const int choice : truth.choices) right.push_back(asked.choices[choice]);
  return "The answer: " + one_of(right) + '.';
}

/// What was decided, and what is right: "yours: P4; right: P7".
std::string beside(const Outcome& outcome) {
  if (outcome.right) return "yours: " + outcome.predicted + ", which is right";
  return "yours: " + outcome.predicted + "; right: " + outcome.happened;
}

std::string hint_text(const Exercise& exercise, const Session& session, std::size_t at, int hint) {
  const Asked& asked = session.conversation().questions()[at];
  if (hint == 0) return exercise.decisions[decision_of(exercise, *asked.question)].hint;
  const std::string half = hint == 1
                               ? narrowed(asked, session.player().run(0), session.stage().subject().origin().seed + at)
                               : std::string();
  return half.empty() ? told(asked, session.player().run(0)) : half;
}

/// How many hints there are: where half of the answers would be one, the second tells it.
int hints_for(const Session& session, std::size_t at) {
  const Asked& asked = session.conversation().questions()[at];
  return narrowed(asked, session.player().run(0), session.stage().subject().origin().seed + at).empty() ? kMostHints - 1
                                                                                                        : kMostHints;
}

/// A hint that tells the answer costs all of the mark.
double price_of(const Session& session, std::size_t at, int hints) {
  return hints > 0 && hints == hints_for(session, at) ? 1 : kHintPrices[hints];
}

/// Whether an answer is what a wrong rule decides: of numbers, within the tolerance.
bool follows(const Asked& asked, const Answer& decided, const Answer& answer) {
  const auto *decides = std::get_if<TypedNumber>(&decided), *typed = std::get_if<TypedNumber>(&answer);
  if (decides != nullptr && typed != nullptr)
    return std::abs(decides->number - typed->number) <= asked.question->tolerance;
  return same_answer(asked, decided, answer);
}

/// The answers to one question, in order.
std::vector<const Given*> given_to(const Session& session, const Question& question) {
  std::vector<const Given*> all;
  for (const Given& given : session.log().given())
    if (given.question == question.id) all.push_back(&given);
  return all;
}

/// A wrong answer other than that one; a right one if there is none.
Answer some_wrong(const Asked& asked, const Run& run, const Answer& other) {
  const auto is_wrong = [&](const Answer& one) {
    return answers(asked, one) && !judge(asked, one, run).right && !same_answer(asked, one, other);
  };
  Answer right = model_answer(asked, run);
  if (auto* typed = std::get_if<TypedNumber>(&right)) {
    const auto* before = std::get_if<TypedNumber>(&other);
    const double most = std::max(typed->number, before != nullptr ? before->number : 0);
    typed->number = most + 1 + 10 * asked.question->tolerance;
    return right;
  }
  if (auto* all = std::get_if<ChoicesInOrder>(&right)) {
    std::reverse(all->choices.begin(), all->choices.end());
    return right;
  }
  for (int i = 0; i < std::ssize(asked.choices); ++i)
    if (Answer one = asked.many ? Answer(SeveralChoices{{i}}) : OneChoice{i}; is_wrong(one)) return one;
  for (Index i = 0; i < asked.subject->size(); ++i)
    if (Answer one = asked.many ? Answer(SeveralHandles{{i}}) : OneHandle{i}; is_wrong(one)) return one;
  return right;
}

}  // namespace

std::size_t Sitting::at(const Session& session) const {
  if (exercise_->build) return over_ ? 1 : 0;
  const std::vector<Asked>& all = session.conversation().questions();
  if (const Outcome* told = session.conversation().outcome())
    if (const Asked* now = session.conversation().question_of(*told)) return static_cast<std::size_t>(now - all.data());
  // Wherever in the run one looks back.
  const auto is_open = [&](const Asked& one) {
    return answer_state_of(session.conversation().outcome_of(one)) == AnswerState::kOpen;
  };
  return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), is_open) - all.begin());
}

bool Sitting::finished(const Session& session) const { return exercise_->build ? over_ : all_decided(session); }

std::vector<Marked> Sitting::marked(const Session& session) const {
  const bool tells = tells_at_once() || finished(session);
  std::vector<Marked> all;
  if (exercise_->build) return all;
  for (std::size_t i = 0; i < session.conversation().questions().size(); ++i) {
    const Asked& asked = session.conversation().questions()[i];
    Marked one{&asked, tells ? answer_state_of(session.conversation().outcome_of(asked)) : AnswerState::kOpen,
               hints_[i], 0};
    const auto tries = given_to(session, *asked.question);
    if (!tries.empty() && tries.back()->right)
      one.mark = std::max((tries.size() == 1 ? 1 : 0.5) - (practises_ ? 0 : price_of(session, i, hints_[i])), 0.0);
    all.push_back(one);
  }
  return all;
}

bool Sitting::leads_on(const Session& session) const {
  return exercise_->level < static_cast<int>(exercise_->harder.size()) && finished(session) &&
         mark(session) >= kLeadsOn * of();
}

double Sitting::mark(const Session& session) const {
  if (exercise_->build)
    return std::max((best_ ? best_->level : 0) - (practises_ ? 0 : of() * kHintPrices[hints_.front()]), 0.0);
  double sum = 0;
  for (const Marked& one : marked(session)) sum += one.mark;
  return sum;
}

void Sitting::see(const Session& session) {
  if (!exercise_->build || over_ || session.stage().dragging() || seen_ == session.revision()) return;
  seen_ = session.revision();
  const int level = level_of(*exercise_, session);
  if (level <= (best_ ? best_->level : 0)) return;
  best_ = Built{session.stage().subject().rows(), level, session.log().seconds()};
  over_ = best_->level == of();
  ++changes_;
}

bool Sitting::back_to_best(Session& session) const {
  if (!best_ || session.stage().subject().rows() == best_->rows) return false;
  return session.stage().set_rows(best_->rows).has_value();
}

bool Sitting::finish() {
  if (!best_ || over_) return false;
  over_ = true;
  ++changes_;
  return true;
}

bool Sitting::show_model(Session& session) const {
  if (!exercise_->build || !over_) return false;
  session.stage().reset();
  const auto model = find_model(*exercise_, session);
  return model && session.stage().set_rows(*model);
}

bool Sitting::take_hint(const Session& session) {
  if (!has_hint(session)) return false;
  ++hints_[at(session)];
  ++changes_;
  return true;
}

bool Sitting::has_hint(const Session& session) const {
  if (exercise_->build) return !over_ && hints_.front() == 0;
  const std::size_t now = at(session);
  return session.conversation().asked() != nullptr && now < hints_.size() && hints_[now] < hints_for(session, now);
}

std::vector<std::string> Sitting::hints(const Session& session) const {
  std::vector<std::string> texts;
  if (exercise_->build && hints_.front() > 0) return {exercise_->stage.tasks.front().hint};
  const std::size_t now = at(session);
  if (now == hints_.size() || session.conversation().asked() == nullptr) return texts;
  for (int i = 0; i < hints_[now]; ++i) texts.push_back(hint_text(*exercise_, session, now, i));
  return texts;
}

std::string Sitting::hint_words(const Session& session) const {
  if (!has_hint(session)) return {};
  const std::size_t now = at(session);
  const bool tells = !exercise_->build && hints_[now] + 1 == hints_for(session, now);
  if (tells) return std::string(kShowAnswerWord) + (practises_ ? "" : " (no mark)");
  if (practises_) return std::string(kHintWord);
  const double price = next_price(session) * (exercise_->build ? of() : 1);
  return std::string(kHintWord) + " (costs " + plain_number(price) + ')';
}

double Sitting::next_price(const Session& session) const {
  if (practises_ || !has_hint(session)) return 0;
  if (exercise_->build) return kHintPrices[1];
  const std::size_t now = at(session);
  return price_of(session, now, hints_[now] + 1) - price_of(session, now, hints_[now]);
}

/// The words of the wrong rule that gives this answer; null for none.
const std::string* Sitting::rule_of(const Session& session, const Asked& asked, const Answer& answer) const {
  const std::string* best = nullptr;
  int most = -1;
  for (const RuleWords& words : exercise_->decisions[decision_of(*exercise_, *asked.question)].rules) {
    const WrongRule* rule = find_rule(asked, words.name);
    const auto decided = rule->decides(asked, session.player().run(0));
    if (!decided || !follows(asked, *decided, answer)) continue;
    int before = 0;  // how many wrong answers it explains
    for (const Given& given : session.log().given())
      for (const Asked& other : session.conversation().questions()) {
        if (given.right || other.question->id != given.question || other.kind != asked.kind) continue;
        const auto there = rule->decides(other, session.player().run(0));
        before += there && follows(other, *there, given.answer);
      }
    if (before > most) best = &words.says, most = before;
  }
  return best;
}

std::string Sitting::rule_says(const Session& session) const {
  const std::size_t now = at(session);
  if (now == hints_.size() || exercise_->build || !(tells_at_once() || finished(session))) return {};
  const auto tries = given_to(session, *session.conversation().questions()[now].question);
  if (tries.empty() || tries.back()->right) return {};
  const std::string* says = rule_of(session, session.conversation().questions()[now], tries.back()->answer);
  return says != nullptr ? *says : std::string();
}

std::vector<std::string> Sitting::rules_followed(const Session& session) const {
  std::vector<std::string> all;
  const Run& run = session.player().run(0);
  for (std::size_t kind = 0; kind < exercise_->decisions.size(); ++kind)
    for (const RuleWords& words : exercise_->decisions[kind].rules) {
      int differs = 0, followed = 0;
      for (const Asked& asked : session.conversation().questions()) {
        if (decision_of(*exercise_, *asked.question) != kind) continue;
        const auto decided = find_rule(asked, words.name)->decides(asked, run);
        const auto tries = given_to(session, *asked.question);
        if (!decided || tries.empty() || judge(asked, *decided, run).right) continue;
        ++differs;
        followed += follows(asked, *decided, tries.front()->answer);
      }
      if (differs >= 2 && followed == differs) all.push_back(words.says);
    }
  return all;
}

Sitting::Looked Sitting::looks_at(const Session& session) const {
  if (exercise_->build || !finished(session)) return Looked::kNeither;
  if (session.conversation().outcome() != nullptr) return Looked::kOwn;
  return session.player().step() < session.player().steps() ? Looked::kRight : Looked::kNeither;
}

bool Sitting::show(Session& session, std::size_t decision) const {
  if (!session.conversation().review(session.conversation().questions()[decision].question->id)) return false;
  session.conversation().show_answer();
  return true;
}

bool Sitting::change_run(Session& session) const {
  if (exercise_->build || !finished(session)) return false;
  const std::vector<Asked>& all = session.conversation().questions();
  if (looks_at(session) == Looked::kOwn) {
    const int here = all[at(session)].step;
    session.conversation().acknowledge();
    return session.go(here), true;
  }
  const auto is_next = [&](const Asked& one) {
    return session.player().step() == session.player().steps() ? !session.conversation().outcome_of(one)->right
                                                               : one.step >= session.player().step();
  };
  const auto found = std::find_if(all.begin(), all.end(), is_next);
  const bool past = found == all.end() && session.player().step() < session.player().steps();
  return show(session, past ? all.size() - 1 : found == all.end() ? 0 : found - all.begin());
}

bool Sitting::step_own(Session& session, int by) const {
  const std::size_t next = at(session) + by;  // it wraps below the first
  return looks_at(session) == Looked::kOwn && next < session.conversation().questions().size() && show(session, next);
}

std::string Sitting::compared(const Session& session) const {
  std::string says;
  if (looks_at(session) != Looked::kRight) return says;
  const std::vector<Asked>& all = session.conversation().questions();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].step == session.player().step())
      says += (says.empty() ? "" : " ") + ("Decision " + std::to_string(i + 1)) + " (" +
              beside(*session.conversation().outcome_of(all[i])) + ").";
  return says.empty() ? "Nothing is decided at this step." : says;
}

std::string Sitting::first_difference(const Session& session) const {
  const Asked* const first = exercise_->build ? nullptr : first_wrong(session);
  if (first == nullptr) return {};
  return "Your run first differs from the right one at decision " +
         std::to_string(first - session.conversation().questions().data() + 1) +
         (first->ordered ? "" : " (" + beside(*session.conversation().outcome_of(*first)) + ')') +
         ". After a mistake, it goes on from the right step.";
}

Attempt Sitting::attempt(const Session& session) const {
  Attempt attempt{exercise_->id, exercise_->hash, seed_, exercise_->level, {}};
  if (exercise_->build) {
    if (best_) attempt.made.push_back({hints_.front(), {}, best_->rows, best_->seconds});
    else if (hints_.front() > 0) attempt.made.push_back({hints_.front(), {}, {}, 0});
    return attempt;
  }
  for (std::size_t i = 0; i < session.conversation().questions().size(); ++i) {
    Made made{hints_[i], {}, {}, 0};
    for (const Given* given : given_to(session, *session.conversation().questions()[i].question))
      made.tries.push_back(given->answer), made.seconds = given->seconds;
    if (made.tries.empty() && made.hints == 0) break;
    attempt.made.push_back(std::move(made));
  }
  return attempt;
}

/// The stage that was built is put up again, and says itself what it reaches.
tl::expected<void, InputError> Sitting::take_up_built(Session& session, const Attempt& attempt) {
  if (attempt.made.empty()) return {};
  const Made& made = attempt.made.front();
  const auto refuse = [](const std::string& why) { return tl::unexpected(InputError{.what = why}); };
  if (attempt.made.size() > 1 || !made.tries.empty()) return refuse("what was built is one stage");
  for (int hint = 0; hint < made.hints; ++hint)
    if (!take_hint(session)) return refuse("what was built has more hints than there are");
  if (made.built.empty()) return {};
  if (const auto put = session.stage().set_rows(made.built); !put) return tl::unexpected(put.error());
  see(session);
  if (!best_) return refuse("what was built reaches nothing that is asked");
  best_->seconds = made.seconds;
  return {};
}

tl::expected<void, InputError> Sitting::take_up(Session& session, const Attempt& attempt) {
  if (exercise_->build) return take_up_built(session, attempt);
  const auto refuse = [](std::size_t i, const std::string& why) {
    return tl::unexpected(InputError{.what = "decision " + std::to_string(i + 1) + ' ' + why});
  };
  for (std::size_t i = 0; i < attempt.made.size(); ++i) {
    if (finished(session)) return refuse(i, "is one too many: there are " + std::to_string(of()));
    for (int hint = 0; hint < attempt.made[i].hints; ++hint)
      if (!take_hint(session)) return refuse(i, "has more hints than there are");
    for (const Answer& answer : attempt.made[i].tries)
      if (is_skipped(answer) || at(session) != i || !session.conversation().give(answer, false))
        return refuse(i, "cannot be answered like that");
    while (session.conversation().acknowledge()) {
    }
    if (at(session) == i && i + 1 < attempt.made.size()) return refuse(i, "was not made to its end");
  }
  return {};
}

tl::expected<Graded, InputError> grade(std::shared_ptr<const Exercise> exercise, const Attempt& attempt) {
  exercise = std::make_shared<const Exercise>(at_level(*exercise, attempt.level));
  const auto instance = make_instance(*exercise, attempt.seed);
  if (!instance) return tl::unexpected(instance.error());
  auto session = open_instance(*exercise, *instance);
  if (!session) return tl::unexpected(session.error());
  Sitting sitting(std::move(exercise), attempt.seed, *session);
  if (const auto taken = sitting.take_up(*session, attempt); !taken) return tl::unexpected(taken.error());
  // What was not finished earns what was decided, told or not.
  return Graded{sitting.mark(*session), sitting.of(), static_cast<int>(sitting.at(*session))};
}

tl::expected<Attempt, InputError> model_attempt(const Exercise& exercise, std::uint64_t seed, int wrong,
                                                std::string_view rule) {
  const auto instance = make_instance(exercise, seed);
  if (!instance) return tl::unexpected(instance.error());
  const auto session = open_instance(exercise, *instance);
  if (!session) return tl::unexpected(session.error());
  if (exercise.build) {
    if (wrong > 1 || !rule.empty()) return tl::unexpected(InputError{.what = "what is built has no such decision"});
    const auto model = wrong > 0 ? std::nullopt : find_model(exercise, *session);
    Attempt attempt{exercise.id, exercise.hash, seed, exercise.level, {}};
    if (model) attempt.made.push_back({0, {}, *model, 0});
    return attempt;
  }
  const std::vector<Asked>& all = session->conversation().questions();
  if (wrong > std::ssize(all))
    return tl::unexpected(InputError{.what = "there are only " + std::to_string(all.size()) + " decisions"});
  Attempt attempt{exercise.id, exercise.hash, seed, exercise.level, {}};
  const Run& run = session->player().run(0);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Answer answer = model_answer(all[i], run);
    if (static_cast<int>(i) + 1 == wrong) {
      const WrongRule* known = find_rule(all[i], rule);
      const auto decided = known != nullptr ? known->decides(all[i], run) : std::nullopt;
      if (!rule.empty() && (!decided || judge(all[i], *decided, run).right))
        return tl::unexpected(InputError{.what = "decision " + std::to_string(wrong) + " has no wrong rule " +
                                                 std::string(rule) + " that decides otherwise"});
      answer = rule.empty() ? some_wrong(all[i], run, {}) : *decided;
    }
    const bool right = judge(all[i], answer, run).right;
    attempt.made.push_back({0, {answer}, {}, 0});
    if (!right && exercise.told_at_once && has_second_try(all[i]))
      attempt.made.back().tries.push_back(some_wrong(all[i], run, answer));
  }
  return attempt;
}

bool all_decided(const Session& session) {
  const std::vector<Asked>& all = session.conversation().questions();
  return std::all_of(all.begin(), all.end(), [&](const Asked& one) {
    return answer_state_of(session.conversation().outcome_of(one)) != AnswerState::kOpen;
  });
}

const Asked* first_wrong(const Session& session) {
  if (!all_decided(session)) return nullptr;
  for (const Asked& asked : session.conversation().questions())
    if (!session.conversation().outcome_of(asked)->right) return &asked;
  return nullptr;
}

}  // namespace snug::lesson
