#include "lesson/exercise/instance.hpp"

#include <algorithm>
#include <map>

#include "geometry/random.hpp"
#include "lesson/ask.hpp"
#include "lesson/exercise/build.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
namespace {

constexpr int kMostPassedOver = 1000;
constexpr int kSeedBits = 53;  // what a page's numbers can hold

std::uint64_t hash_of_name(std::string_view name, std::uint64_t seed) {
  Fnv1a hash;
  for (const char c : name) hash.add_bits(static_cast<unsigned char>(c));
  hash.add_bits(seed);
  return hash.value();
}

/// Each decision of the run as a question of its own, "grows/2", in the run's order.
std::vector<Question> questions_of(const Exercise& exercise, const Run& run) {
  std::vector<Question> all;
  std::map<std::string_view, int> counted;  // of each fact so far
  for (int i = 0; i < run.steps(); ++i) {
    if (!run.counts(i)) continue;
    const int occurrence = ++counted[run.fact(i)];
    for (std::size_t kind = 0; kind < exercise.decisions.size(); ++kind) {
      Question one = exercise.stage.questions[kind];
      if (run.fact(i) != one.gate.fact) continue;
      one.gate.occurrence = occurrence;
      one.id += '/' + std::to_string(occurrence);
      if (exercise.decisions[kind].at_once) {
        one.gate.after = all.empty() ? Gate::kStart : all.back().gate.fact;
        one.gate.after_nth = all.empty() ? 0 : all.back().gate.occurrence;
      }
      all.push_back(std::move(one));
    }
  }
  return all;
}

/// Whether a decision is nearer to a tie than the exercise allows.
bool too_near(const Exercise& exercise, const Asked& asked, const Run& run) {
  if (asked.kind->margin == nullptr) return true;
  return asked.kind->margin(asked, run) < exercise.apart && !(exercise.ties && has_tie(asked, run));
}

/// Leaves to the program what is too near to a tie, and what is asked often enough, where the exercise says so.
void leave_some(const Exercise& exercise, Lesson& lesson, const std::vector<Asked>& asked, const Run& run) {
  std::vector<std::string> skipped;
  std::vector<int> left(exercise.decisions.size());
  for (const Asked& one : asked) {
    const std::size_t kind = decision_of(exercise, *one.question);
    const Decision& decision = exercise.decisions[kind];
    if ((decision.skip_ties && too_near(exercise, one, run)) || left[kind] == decision.most)
      skipped.push_back(one.question->id);
    else ++left[kind];
  }
  std::erase_if(lesson.questions, [&](const Question& one) { return is_among(skipped, one.id); });
}

/// Whether not all of these have the same right answer.
bool varies(const std::vector<Asked>& asked, const Run& run, auto is_it) {
  std::optional<Answer> first;
  for (const Asked& one : asked) {
    if (!is_it(one)) continue;
    const Answer right = model_answer(one, run);
    if (first && !(*first == right)) return true;
    first = right;
  }
  return false;
}

/// Whether a first answer that is wrong leaves only right ones for the second.
bool gives_away(const Asked& asked, const Run& run) {
  if (asked.many || asked.ordered || asked.number || !has_tie(asked, run)) return false;
  const Truth truth = asked.kind->truth(asked, run);
  const std::size_t right = asked.choices.empty() ? truth.points.size() : truth.choices.size();
  return right + 1 == (asked.choices.empty() ? asked.stage_points.size() : asked.choices.size());
}

/// What the instance lacks of the promise, as a sentence fragment; empty for nothing.
/// varied: whether the right answers of a balanced decision differ.
std::string lacks(const Exercise& exercise, const std::vector<Asked>& asked, const Run& run, bool varied) {
  if (std::ssize(asked) < exercise.least) return "too few decisions";
  if (std::ssize(asked) > exercise.most) return "too many decisions";
  for (const Asked& one : asked)
    if (too_near(exercise, one, run)) return "a " + one.question->asks + " too near to a tie";
  if (std::any_of(asked.begin(), asked.end(), [&](const Asked& one) { return gives_away(one, run); }))
    return "too few wrong answers";
  if (exercise.ties && std::none_of(asked.begin(), asked.end(), [&](const Asked& one) { return has_tie(one, run); }))
    return "no tie";
  for (std::size_t kind = 0; kind < exercise.decisions.size(); ++kind) {
    const Decision& decision = exercise.decisions[kind];
    const auto is_it = [&](const Asked& one) { return decision_of(exercise, *one.question) == kind; };
    if (std::count_if(asked.begin(), asked.end(), is_it) < decision.least)
      return "too few of " + exercise.stage.questions[kind].id;
    if (decision.balanced && varies(asked, run, is_it) != varied)
      return varied ? "all right answers the same" : "right answers that differ";
    for (const RuleWords& words : decision.rules) {
      const auto shows = [&](const Asked& one) {
        const WrongRule* rule = is_it(one) ? find_rule(one, words.name) : nullptr;
        const auto answer = rule != nullptr ? rule->decides(one, run) : std::nullopt;
        return answer && answers(one, *answer) && !judge(one, *answer, run).right;
      };
      if (std::none_of(asked.begin(), asked.end(), shows)) return "the wrong rule " + words.name + " is nowhere wrong";
    }
  }
  return {};
}

/// What a stage to build on lacks of the promise.
std::string lacks_to_build(const Exercise& exercise, const Instance& instance) {
  const auto session = open_instance(exercise, instance);
  if (!session) return session.error().what;
  if (level_of(exercise, *session) > 0) return "something reached before the student begins";
  return find_model(exercise, *session) ? "" : "no way to reach all that is asked";
}

}  // namespace

std::uint64_t seed_of(std::string_view name) { return hash_of_name(plain_name(name), 0) >> (64 - kSeedBits); }

std::size_t decision_of(const Exercise& exercise, const Question& question) {
  const std::string_view id = std::string_view(question.id).substr(0, question.id.rfind('/'));
  const auto& kinds = exercise.stage.questions;
  return std::find_if(kinds.begin(), kinds.end(), [&](const Question& kind) { return kind.id == id; }) - kinds.begin();
}

const WrongRule* find_rule(const Asked& asked, std::string_view name) {
  for (const WrongRule& rule : asked.kind->rules)
    if (rule.name == name) return &rule;
  return nullptr;
}

tl::expected<Instance, InputError> make_instance(const Exercise& exercise, std::uint64_t seed) {
  Instance instance{.lesson = exercise.stage};
  Lesson& lesson = instance.lesson;
  const auto own = lesson.subject->open(lesson, std::nullopt, nullptr);
  if (!own) return tl::unexpected(own.error());
  const Method& method = *find_method(lesson, lesson.algorithms.front());
  const auto level = static_cast<std::uint64_t>(exercise.level);  // each has instances of its own
  Random random(hash_of_name(exercise.id, seed | level << kSeedBits));
  const bool varied = random.below(2) == 1;
  std::map<std::string, int> lacking;
  for (; instance.passed_over < kMostPassedOver; ++instance.passed_over) {
    instance.own = random.bits() >> (64 - kSeedBits);
    const auto subject = (*own)->clone();
    subject->scatter(instance.own, **own);
    if (!subject->suits(method)) continue;
    if (exercise.build) {
      const std::string lack = lacks_to_build(exercise, instance);
      if (lack.empty()) return instance;
      ++lacking[lack];
      continue;
    }
    const auto run = subject->run(method, nullptr);
    lesson.questions = questions_of(exercise, *run);
    for (Question& question : lesson.questions) question.shuffled = instance.own;
    const auto all = [&] { return asked_on(lesson, lesson.algorithms.front(), *subject, *run, false); };
    leave_some(exercise, lesson, all(), *run);
    const std::vector<Asked> asked = all();
    const std::string lack = lacks(exercise, asked, *run, varied);
    if (lack.empty()) return instance;
    ++lacking[lack];
  }
  const auto most = std::max_element(lacking.begin(), lacking.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return tl::unexpected(InputError{.what = "none of " + std::to_string(kMostPassedOver) + " instances of " +
                                           exercise.id + " keeps the promise; most have " +
                                           (most == lacking.end() ? "no run" : most->first)});
}

tl::expected<Session, InputError> open_instance(const Exercise& exercise, const Instance& instance, Clock clock,
                                                bool practises) {
  auto session = Session::open(instance.lesson, std::nullopt, clock);
  if (!session) return session;
  session->stage().scatter(instance.own);
  if (exercise.build) {
    session->stage().settle();
    session->stage().start_task();
    session->conduct({.builds = true});
  } else {
    session->conduct({.decides = true, .told = practises || exercise.told_at_once});
  }
  return session;
}

}  // namespace snug::lesson
