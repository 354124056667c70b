#include "lesson/stand.hpp"

#include <algorithm>

#include "lesson/names.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

Done refused(std::string why) { return tl::unexpected(InputError{.what = std::move(why)}); }

/// Finds a question by its id; null for none.
const Question* find_question(const Lesson& lesson, std::string_view id) {
  const auto found = std::find_if(lesson.questions.begin(), lesson.questions.end(),
                                  [&](const Question& question) { return question.id == id; });
  return found != lesson.questions.end() ? &*found : nullptr;
}

Done no_question(const Lesson& lesson, const std::string& id) {
  std::vector<std::string_view> ids;
  for (const Question& question : lesson.questions) ids.push_back(question.id);
  return refused(ids.empty() ? "the lesson has no questions" : "the question " + none_of_text(id, ids));
}

Done use(Session& session, const std::string& algorithm) {
  const Lesson& lesson = session.lesson();
  if (!is_among(lesson.algorithms, algorithm))
    return refused("the lesson's algorithm " + none_of_text(algorithm, lesson.algorithms));
  return session.choose(0, algorithm);
}

/// Goes to where a question of the run is asked, past the others.
Done open_question(Session& session, const std::string& id) {
  const auto& all = session.questions();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Asked& one) { return one.question->id == id; });
  if (it == all.end()) return refused("the question " + id + " does not come on what is on the stage");
  if (it->step != Asked::kAnytime) session.jump(it->step);
  else session.ask_predictions();
  for (std::size_t others = all.size(); others > 0; --others) {
    const Asked* asked = session.asked();
    if (asked == nullptr) break;
    if (asked->question->id == id) return {};
    session.skip();
  }
  return refused("the question " + id + " comes while another one is open");
}

Done stand_at_question(Session& session, const Standpoint& at) {
  const Question* question = find_question(session.lesson(), at.question);
  if (question == nullptr) return no_question(session.lesson(), at.question);
  const std::string& own = question->gate.algorithm;
  if (!at.algorithm.empty() && !own.empty() && at.algorithm != own)
    return refused("the question " + at.question + " is about " + own + ", not about " + at.algorithm);
  if (!at.situation.empty() && at.situation != question->situation)
    return refused("the question " + at.question + " is asked in " + question->situation + ", not in " + at.situation);
  if (Done shown = session.show_situation(question->situation); !shown) return shown;
  if (!own.empty())
    if (Done used = use(session, own); !used) return used;
  if (at.answered && !session.lesson().subject->asks_of_steps)
    return refused("the question " + at.question + " is decided by what is measured then, and has no outcome before");
  if (Done opened = open_question(session, at.question); !opened) return opened;
  if (at.answered) session.answer(model_answer(*session.asked(), session.run(0)));
  return {};
}

}  // namespace

Done stand_at(Session& session, const Standpoint& at) {
  if (!at.situation.empty())
    if (Done shown = session.show_situation(at.situation); !shown) return shown;
  if (!at.algorithm.empty())
    if (Done used = use(session, at.algorithm); !used) return used;
  if (!at.question.empty()) return stand_at_question(session, at);
  if (!at.step) return {};
  const int steps = session.steps();
  if (*at.step > steps)
    return refused("there is no " + std::string(session.lesson().subject->step_word) + ' ' + std::to_string(*at.step) +
                   ": " + name_in(session.lesson(), *session.method(0)) + " has " + std::to_string(steps));
  session.jump(*at.step == Standpoint::kLastStep ? steps : *at.step);
  return {};
}

}  // namespace snug::lesson
