#include "lesson/patience.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "lesson/figures.hpp"

namespace snug::lesson {
namespace {

/// So many points are shown at once, whatever the lesson does with them.
constexpr Index kFewPoints = 1000;
/// A time below this says little about how the next one grows, ns.
constexpr double kTellingTime = 20e6;

/// A copy with every k-th point, about as many as wanted; null if the subject is not one of points.
std::unique_ptr<Subject> sample_of(const Subject& subject, Index count) {
  const Rows all = subject.rows();
  const auto n = static_cast<std::size_t>(subject.size());
  if (subject.points() == nullptr || all.size() != n) return nullptr;
  Rows some;
  for (Index i = 0; i < count; ++i)
    some.push_back(all[static_cast<std::size_t>(i) * n / static_cast<std::size_t>(count)]);
  auto sample = subject.clone();
  return sample->set_rows(some) ? std::move(sample) : nullptr;
}

/// "34 s", "12 min", "3 hours"
std::string long_time(double ns) {
  const double seconds = ns / 1e9;
  const auto said = [](double value, const char* unit) { return number_text(value, 2) + unit; };
  return seconds < 100    ? said(seconds, " s")
         : seconds < 6000 ? said(seconds / 60, " min")
                          : said(seconds / 3600, " hours");
}

/// Rounded down to one digit, so that it is a number to try.
Index round_number(double n) {
  const double power = std::pow(10, std::floor(std::log10(std::max(n, 1.0))));
  return static_cast<Index>(std::floor(n / power) * power);
}

}  // namespace

Estimate estimate_of(const std::function<double(Index)>& time_of, Index n) {
  double before = 0, power = 1;
  for (Index some = kFewPoints / 4;; some *= 2) {
    some = std::min(some, n);
    const double time = time_of(some);
    const bool grew = before > 0;  // so that the power is known
    if (grew) power = std::clamp(std::log2(time / before), 1.0, 4.0);
    before = time;
    const double whole = time * std::pow(static_cast<double>(n) / some, power);
    const bool too_long = grew && whole > kLongestShown && time > kTellingTime;
    if (!too_long && some < n / 8) continue;
    if (whole <= kLongestShown) return {whole, n};
    return {whole, round_number(some * std::pow(kLongestShown / time, 1 / power))};
  }
}

Done check_patience(const Lesson& lesson, const Subject& next, const std::array<const Method*, 2>& methods,
                    Clock clock) {
  if (clock == nullptr || next.points() == nullptr || next.size() <= kFewPoints) return {};
  bool known = true;
  const auto time_of = [&](Index count) {
    const auto sample = sample_of(next, count);
    if (sample == nullptr) return known = false, 1.0;
    const double begin = clock();
    std::array<std::unique_ptr<Run>, 2> runs;
    View view;
    for (std::size_t i = 0; i < methods.size(); ++i)
      if (methods[i] != nullptr)
        runs[i] = sample->run(*methods[i], nullptr), view.slots[i] = Slot{methods[i], runs[i].get()};
    view.step = view.run().steps();
    static_cast<void>(sample->rivals(lesson, view));
    return std::max(clock() - begin, 1.0);
  };
  const Estimate estimate = estimate_of(time_of, next.size());
  if (!known || estimate.whole <= kLongestShown) return {};
  return tl::unexpected(InputError{.what = "this lesson would take about " + long_time(estimate.whole) + " for " +
                                           count_text(next.size()) + " such points; up to about " +
                                           count_text(estimate.most) + " take less than ten seconds here"});
}

}  // namespace snug::lesson
