#include "lesson/patience.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "lesson/figures.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

/// So many points are shown at once, whatever the lesson does with them.
constexpr Index kFewPoints = 1000;
/// How much longer a lesson takes than its runs and comparison: questions and prose look at some results again, and the
/// stage draws them. Measured on the lessons about boxes and hulls, 5,000 to 20,000 points on a sphere.
constexpr double kBesideRuns = 1.5;
/// A time below this says little about how the next one grows, ns.
constexpr double kTellingTime = 100e6;

/// A copy with so many of all of its points, evenly taken; null if it cannot have them.
std::unique_ptr<Subject> sample_of(const Subject& subject, const std::vector<Point3>& all, Index count) {
  io::PointFile some{subject.dim(), {}, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) some.points.push_back(all[i * all.size() / count]);
  auto sample = subject.clone();
  return sample->load(some, "sample") ? std::move(sample) : nullptr;
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
  std::vector<double> times;
  for (Index some = kFewPoints / 4;; some *= 2) {
    some = std::min(some, n);
    times.push_back(time_of(some));
    const double time = times.back();
    const std::size_t doublings = std::min<std::size_t>(times.size() - 1, 2);  // over two, noise counts half
    double power = 1;
    if (doublings > 0)
      power =
          std::clamp(std::log2(time / times[times.size() - 1 - doublings]) / static_cast<double>(doublings), 1.0, 4.0);
    const double whole = time * std::pow(static_cast<double>(n) / some, power);
    const bool too_long = doublings == 2 && whole > kLongestShown && time > kTellingTime;
    if (!too_long && some < n / 8) continue;
    if (whole <= kLongestShown) return {whole, n};
    return {whole, round_number(some * std::pow(kLongestShown / time, 1 / power))};
  }
}

Done check_patience(const Lesson& lesson, const Subject& next, const std::array<const Method*, 2>& methods,
                    Clock clock) {
  if (clock == nullptr || next.points() == nullptr || count_of(next) <= kFewPoints) return {};
  bool known = true;
  const std::vector<Point3> all = all_points(*next.points());
  const auto time_of = [&](Index count) {
    const auto sample = sample_of(next, all, count);
    if (sample == nullptr) return known = false, 1.0;
    const double begin = clock();
    std::array<std::unique_ptr<Run>, 2> runs;
    View view;
    for (std::size_t i = 0; i < methods.size(); ++i)
      if (methods[i] != nullptr)
        runs[i] = sample->run(*methods[i], nullptr), view.slots[i] = Slot{methods[i], runs[i].get()};
    view.step = view.run().steps();
    static_cast<void>(sample->rivals(lesson, view));
    for (const std::string& name : lesson.algorithms)  // whose counts the text may tell
      if (const Method* method = find_method(lesson, name); sample->suits(*method))
        static_cast<void>(sample->operations(*method));
    return std::max(kBesideRuns * (clock() - begin), 1.0);
  };
  const Estimate estimate = estimate_of(time_of, count_of(next));
  if (!known || estimate.whole <= kLongestShown) return {};
  return tl::unexpected(InputError{.what = "this lesson would take about " + long_time(estimate.whole) + " for " +
                                           count_text(count_of(next)) + " such points; up to about " +
                                           count_text(estimate.most) + " take less than ten seconds here"});
}

}  // namespace snug::lesson
