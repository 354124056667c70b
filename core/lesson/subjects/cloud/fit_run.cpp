#include "lesson/subjects/cloud/fit_run.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "geometry/tolerance.hpp"
#include "lesson/fact_run.hpp"
#include "lesson/subjects/cloud/axes_by_hand.hpp"
#include "lesson/subjects/cloud/entries.hpp"
#include "lesson/subjects/cloud/volume_check.hpp"
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

std::span<const WrongTest> FitRun::wrong_at(int i) const {
  if (!wrong_) return {};
  const auto before = [](const WrongTest& test, int step) { return test.step < step; };
  const auto from = std::lower_bound(wrong_->begin(), wrong_->end(), i, before);
  const auto to = std::lower_bound(from, wrong_->end(), i + 1, before);
  const std::size_t first = from - wrong_->begin();
  return std::span<const WrongTest>(*wrong_).subspan(first, to - from);
}

Index FitRun::outside_at(int i) const {
  if (outside_.step != i) outside_ = {i, count_outside(points_, trace()[i].step.volume)};
  return outside_.points;
}

std::string FitRun::Where::contradiction() const {
  using Truth = WrongTest::Truth;
  constexpr std::array<std::pair<Truth, const char*>, 4> kTruths{{{Truth::kOutside, "outside"},
                                                                  {Truth::kOnBoundary, "on the boundary"},
                                                                  {Truth::kInside, "inside"},
                                                                  {Truth::kNotOutside, "not outside"}}};
  std::string words;
  for (const auto& [truth, side] : kTruths) {
    std::vector<Index> so;
    for (const WrongTest& test : run.wrong_at(i))
      if (test.truth == truth) so.push_back(test.point);
    if (so.empty()) continue;
    words += (words.empty() ? " Wrong: in exact arithmetic " : ", and ") + names(so) +
             (so.size() == 1 ? " is " : " are ") + side;
  }
  return words.empty() ? words : words + ".";
}

Point3 FitRun::slab_axis(int i, int slab) const {
  if (!axes_.empty()) return axes_[slab];
  const int k = std::get_if<Kdop<double, 3>>(&trace()[i].step.volume)->k;
  Point3 axis = Point3::Zero();
  for (int j = 0; j < dim(); ++j) axis[j] = dim() == 2 ? kdop_axes<2>(k)[slab][j] : kdop_axes<3>(k)[slab][j];
  return axis;
}

std::string FitRun::slab_name(int i, int slab) const {
  return axes_.empty() ? axis_name(slab_axis(i, slab)) : direction_text(slab_axis(i, slab), dim());
}

double FitRun::gap_to(Index point, const fit::Sphere3& ball) const {
  return (fit::point_of(points_, point) - ball.center).norm() - ball.radius;
}

bool FitRun::is_rounding(int i) const {
  const auto* grown = std::get_if<fit::BallGrown<double, 3>>(&trace()[i].step.fact);
  if (grown == nullptr) return false;
  const double size = grown->before.radius + fit::point_of(points_, grown->point).cwiseAbs().maxCoeff();
  return gap_to(grown->point, grown->before) <= tolerance::kBoundaryRoundoffs * tolerance::roundoff<double>(size);
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
  std::vector<Index> all(points_alone_ ? static_cast<std::size_t>(fit::count_of(points_)) : 0);
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

}  // namespace snug::lesson
