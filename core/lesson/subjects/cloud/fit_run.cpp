#include "lesson/subjects/cloud/fit_run.hpp"

#include <algorithm>
#include <numeric>

#include "lesson/fact_run.hpp"
#include "lesson/subjects/cloud/axes_by_hand.hpp"
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

Point3 FitRun::slab_axis(int i, int slab) const {
  if (!axes_.empty()) return axes_[static_cast<std::size_t>(slab)];
  const int k = std::get_if<Kdop<double, 3>>(&trace()[i].step.volume)->k;
  Point3 axis = Point3::Zero();
  for (int j = 0; j < dim(); ++j) axis[j] = dim() == 2 ? kdop_axes<2>(k)[slab][j] : kdop_axes<3>(k)[slab][j];
  return axis;
}

std::string FitRun::slab_name(int i, int slab) const {
  return axes_.empty() ? axis_name(slab_axis(i, slab)) : direction_text(slab_axis(i, slab), dim());
}

std::vector<Index> FitRun::support(int steps) const {
  const auto stated = []<class Fact>(const Fact& fact) { return Entry<Fact>::support(fact); };
  const auto added = []<class Fact>(const Fact& fact) { return Entry<Fact>::adds_to_support(fact); };
  std::optional<std::vector<Index>> support;
  int i = steps;
  while (i > 0 && !support) support = std::visit(stated, trace()[--i].step.fact);
  std::vector<Index> all = support.value_or(std::vector<Index>{});
  for (; i < steps; ++i)
    for (const Index point : std::visit(added, trace()[i].step.fact))
      if (std::find(all.begin(), all.end(), point) == all.end()) all.push_back(point);
  return all;
}

std::vector<Index> FitRun::candidates(int) const {
  std::vector<Index> all(points_alone_ ? static_cast<std::size_t>(fit::size_of(points_)) : 0);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

}  // namespace snug::lesson
