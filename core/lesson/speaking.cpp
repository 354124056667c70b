#include "lesson/speaking.hpp"

#include <algorithm>

#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kSupport = "support";

/// A mark that is a fact: its name, and which of its handles; 0: all of them.
struct FactMark {
  std::string_view fact;
  std::size_t which = 0;
};

std::optional<FactMark> fact_mark(const SubjectRow& subject, std::string_view mark) {
  const auto slash = std::min(mark.find('/'), mark.size());
  const std::string_view fact = mark.substr(0, slash), which = mark.substr(slash);
  if (!is_among(subject.facts(), fact)) return std::nullopt;
  if (which.empty()) return FactMark{fact};
  if (which.size() != 2 || which[1] < '1' || which[1] > '9') return std::nullopt;
  return FactMark{fact, static_cast<std::size_t>(which[1] - '0')};
}

/// The handles of a mark at step i, counted from 0, which has the mark's fact.
std::vector<Index> handles_at(const FactMark& mark, const Run& run, int i) {
  std::vector<Index> handles = run.handles(i);
  if (mark.which == 0) return handles;
  return mark.which <= handles.size() ? std::vector<Index>{handles[mark.which - 1]} : std::vector<Index>{};
}

/// The handles at the last step with the mark's fact, among the first so many steps.
std::vector<Index> handles_within(const FactMark& mark, const Run& run, int steps) {
  for (int i = steps; i-- > 0;)
    if (run.fact(i) == mark.fact) return handles_at(mark, run, i);
  return {};
}

bool is_among_handles(const std::vector<Index>& handles, Index handle) {
  return std::find(handles.begin(), handles.end(), handle) != handles.end();
}

bool is_about(const Section& section, std::string_view algorithm, std::string_view situation) {
  return (section.algorithm.empty() || section.algorithm == algorithm) &&
         (section.situation.empty() || section.situation == situation);
}

/// The first section about this algorithm and situation that names the fact.
std::optional<int> section_of(const Lesson& lesson, std::string_view fact, std::string_view algorithm,
                              std::string_view situation) {
  for (std::size_t i = 0; i < lesson.sections.size(); ++i) {
    const Section& section = lesson.sections[i];
    if (is_about(section, algorithm, situation) && is_among(section.facts, fact)) return static_cast<int>(i);
  }
  return std::nullopt;
}

std::optional<int> section_of(const Lesson& lesson, const Question& question) {
  for (std::size_t i = 0; i < lesson.sections.size(); ++i)
    if (!question.section.empty() && lesson.sections[i].title == question.section) return static_cast<int>(i);
  return section_of(lesson, question.gate.fact, question.gate.algorithm, question.situation);
}

/// The first section about a situation besides the lesson's own.
std::optional<int> section_of_situation(const Session& session) {
  const auto& sections = session.lesson().sections;
  if (session.lesson().situations.empty()) return std::nullopt;
  for (std::size_t i = 0; i < sections.size(); ++i)
    if (sections[i].situation == session.stage().situation()) return static_cast<int>(i);
  return std::nullopt;
}

/// Whether it lights something else than handles.
bool is_own_mark(const Subject& subject, std::string_view mark) {
  const auto marks = marks_on_subjects();
  return std::any_of(marks.begin(), marks.end(), [&](MarkOn known) { return known(subject, mark); });
}

}  // namespace

std::optional<Index> handle_named(const Subject& subject, std::string_view name) {
  for (Index i = 0; i < subject.size(); ++i)
    if (subject.name_of(i) == name) return i;
  return std::nullopt;
}

std::vector<Index> marked_handles(const Session& session, std::string_view mark) {
  if (session.conversation().asked() != nullptr && session.conversation().asked()->on_stage) return {};
  if (mark == kSupport) return session.player().support(0);
  if (const auto fact = fact_mark(*session.lesson().subject, mark))
    return handles_within(*fact, session.player().run(0), session.player().step());
  const auto handle = handle_named(session.stage().subject(), mark);
  return handle ? std::vector<Index>{*handle} : std::vector<Index>{};
}

std::vector<std::string_view> marks_of(const Lesson& lesson) {
  std::vector<std::string_view> marks;
  for (const Section& section : lesson.sections)
    for (const Stretch* stretch : stretches_of(section))
      if (stretch->link && stretch->link->kind == Link::Kind::kMark && !is_among(marks, stretch->link->target))
        marks.push_back(stretch->link->target);
  return marks;
}

std::vector<std::string_view> marks_at(const Session& session, Index handle) {
  std::vector<std::string_view> marks = marks_of(session.lesson());
  std::erase_if(marks, [&](std::string_view mark) { return !is_among_handles(marked_handles(session, mark), handle); });
  return marks;
}

bool is_mark(const Subject& subject, std::string_view mark) {
  return mark == kSupport || fact_mark(subject.row(), mark) || handle_named(subject, mark) ||
         is_own_mark(subject, mark);
}

bool lights(const Run& run, const Subject& subject, std::string_view mark) {
  if (mark == kSupport) return !run.support(run.steps()).empty();
  const auto fact = fact_mark(subject.row(), mark);
  if (!fact) return handle_named(subject, mark).has_value() || is_own_mark(subject, mark);
  for (int i = 0; i < run.steps(); ++i)
    if (run.fact(i) == fact->fact && !handles_at(*fact, run, i).empty()) return true;
  return false;
}

std::optional<int> section_at(const Session& session) {
  const Lesson& lesson = session.lesson();
  const Asked* const asked = session.conversation().asked();
  const Outcome* const told = session.conversation().outcome();
  const Asked* const about = asked != nullptr  ? asked
                             : told != nullptr ? session.conversation().question_of(*told)
                                               : nullptr;
  if (about != nullptr)
    if (const auto section = section_of(lesson, *about->question)) return section;
  if (session.player().method(0) == nullptr || session.player().previewing()) return section_of_situation(session);
  const std::string own = name_in(lesson, *session.player().method(0));
  for (int step = session.player().step(); step > 0; --step)
    if (const auto section =
            section_of(lesson, session.player().run(0).fact(step - 1), own, session.stage().situation()))
      return section;
  return section_of_situation(session);
}

}  // namespace snug::lesson
