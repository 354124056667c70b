// The definitions of FactRun, which asks each fact's entry. Only files with all of a subject's entries include this.
#pragma once

#include "fit/field_hash.hpp"
#include "lesson/facts.hpp"
#include "trace/observer.hpp"

namespace snug::lesson {

template <class Own, class Step>
const Step& FactRun<Own, Step>::step_at(int i) const {
  if constexpr (requires { own().entry(i); }) return own().entry(i).step;
  else return own().trace()[i].step;
}
template <class Own, class Step>
template <class Call>
auto FactRun<Own, Step>::visit(int i, Call call) const {
  return std::visit(call, step_at(i).fact);
}
template <class Own, class Step>
auto FactRun<Own, Step>::where(int i, const Untold* untold) const {
  return typename Own::Where{own(), i, untold};
}

template <class Own, class Step>
int FactRun<Own, Step>::steps() const {
  return static_cast<int>(own().trace().size());
}
template <class Own, class Step>
std::string_view FactRun<Own, Step>::fact(int i) const {
  return visit(i, []<class Fact>(const Fact&) { return Fact::kName; });
}
template <class Own, class Step>
int FactRun<Own, Step>::line(int i) const {
  return step_at(i).line;
}
template <class Own, class Step>
std::string FactRun<Own, Step>::sentence(int i, const Untold& untold) const {
  return visit(i, [&]<class Fact>(const Fact& fact) { return Entry<Fact>::sentence(fact, where(i, &untold)); });
}
template <class Own, class Step>
std::vector<Index> FactRun<Own, Step>::handles(int i) const {
  return visit(i, [&]<class Fact>(const Fact& fact) { return Entry<Fact>::handles(fact, where(i)); });
}
template <class Own, class Step>
std::string FactRun<Own, Step>::predicate(int i, bool plural) const {
  return visit(i, [&]<class Fact>(const Fact& fact) { return Entry<Fact>::predicate(fact, where(i), plural); });
}
template <class Own, class Step>
std::optional<Mark::Kind> FactRun<Own, Step>::mark(int i) const {
  return visit(
      i, [&]<class Fact>(const Fact& fact) -> std::optional<Mark::Kind> { return Entry<Fact>::mark(fact, where(i)); });
}
template <class Own, class Step>
std::span<const QuestionKind> FactRun<Own, Step>::question_kinds(int i) const {
  return visit(i, []<class Fact>(const Fact&) { return std::span<const QuestionKind>(Entry<Fact>::kQuestionKinds); });
}
template <class Own, class Step>
bool FactRun<Own, Step>::counts(int i) const {
  return visit(i, []<class Fact>(const Fact& fact) { return Entry<Fact>::counts(fact); });
}
template <class Own, class Step>
const fit::Volume3* FactRun<Own, Step>::volume(int steps) const {
  if constexpr (requires(const Step& step) { step.volume; })
    if (steps > 0 && step_at(steps - 1).has_volume) return &step_at(steps - 1).volume;
  return nullptr;
}
template <class Own, class Step>
std::uint64_t FactRun<Own, Step>::hash() const {
  return fit::hash_of_steps(own().trace());
}

}  // namespace snug::lesson
