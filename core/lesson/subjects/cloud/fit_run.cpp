#include "lesson/subjects/cloud/fit_run.hpp"

#include "lesson/fact_run.hpp"
#include "lesson/subjects/cloud/entries.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {

template class FactRun<FitRun, fit::Step3>;

std::string FitRun::Where::ball() const { return ball_word(dim()); }

double FitRun::Where::radius() const {
  const fit::Sphere3* own = ball_of(step());
  return own != nullptr ? own->radius : 0;
}

std::string FitRun::Where::size() const {
  if (ball_of(step()) != nullptr) return "radius " + number_text(radius());
  return size_word() + number_text(fit::size_of(step().volume, dim()));
}

std::vector<Index> FitRun::support(int steps) const {
  const auto stated = []<class Fact>(const Fact& fact) { return Entry<Fact>::support(fact); };
  for (int i = steps; i-- > 0;)
    if (auto support = std::visit(stated, trace()[i].step.fact)) return *std::move(support);
  return {};
}

}  // namespace snug::lesson
