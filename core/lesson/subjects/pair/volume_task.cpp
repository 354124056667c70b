// What tasks on two volumes ask for.
#include <algorithm>

#include "lesson/figures.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "query/overlap/overlaps_spheres.hpp"

namespace snug::lesson {
namespace {

/// How the intervals of two axis-aligned boxes lie along a coordinate axis.
enum class Along { kApart, kTouching, kOverlapping };

/// How they lie along each axis, decided on the bounds as they are; empty for other volumes.
std::vector<Along> along_axes(const VolumePair& pair) {
  const auto* a = std::get_if<Aabb<double, 3>>(&pair.held[0].volume);
  const auto* b = std::get_if<Aabb<double, 3>>(&pair.held[1].volume);
  std::vector<Along> axes;
  for (int i = 0; a != nullptr && b != nullptr && i < pair.dim; ++i) {
    const bool apart = a->max[i] < b->min[i] || b->max[i] < a->min[i];
    const bool touching = a->max[i] == b->min[i] || b->max[i] == a->min[i];
    axes.push_back(apart ? Along::kApart : touching ? Along::kTouching : Along::kOverlapping);
  }
  return axes;
}

/// "x and y", of those axes along which the intervals lie so; empty for none.
std::string axes_text(const std::vector<Along>& axes, Along so) {
  std::string text;
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i] == so) text += (text.empty() ? "" : " and ") + std::string(1, "xyz"[i]);
  return text;
}

/// Whether two spheres overlap, and whether a test that adds the squares of their radii says so.
struct Spheres {
  bool both = false, overlap = false, by_squares = false;
};

Spheres spheres_of(const VolumePair& pair) {
  const auto* a = std::get_if<Sphere<double, 3>>(&pair.held[0].volume);
  const auto* b = std::get_if<Sphere<double, 3>>(&pair.held[1].volume);
  if (a == nullptr || b == nullptr) return {};
  const double distance = (b->center - a->center).squaredNorm();
  return {true, query::test_spheres(*a, *b).overlap, distance <= a->radius * a->radius + b->radius * b->radius};
}

}  // namespace

bool VolumesSubject::reaches(std::string_view goal) const {
  if (goal == "overlap") return !separation_of(pair_);
  if (goal == "sum_of_squares") return spheres_of(pair_).overlap && !spheres_of(pair_).by_squares;
  if (goal == "cylinders_apart") {
    const auto cylinders = as_cylinders(pair_);
    return cylinders && !cylinders->overlap && !separation_of(pair_);
  }
  const std::vector<Along> axes = along_axes(pair_);
  const auto so = [&](Along along) { return std::count(axes.begin(), axes.end(), along); };
  const auto others = static_cast<std::ptrdiff_t>(axes.size()) - 1;
  if (axes.empty()) return false;
  if (goal == "only_last_axis") return axes.back() == Along::kApart && so(Along::kApart) == 1;
  return so(Along::kTouching) == 1 && so(Along::kOverlapping) == others;
}

std::string VolumesSubject::goal_says(std::string_view goal) const {
  if (goal == "overlap") {
    const auto apart = separation_of(pair_);
    return apart ? "The volumes are apart by " + gap_text(apart->gap) + " units." : "The volumes overlap.";
  }
  if (goal == "sum_of_squares") {
    const auto [both, overlap, by_squares] = spheres_of(pair_);
    if (!both) return "These are not two spheres.";
    return std::string("The spheres ") + (overlap ? "overlap" : "are apart") + "; by the sum of the squares they " +
           (by_squares ? "overlap." : "are apart.");
  }
  if (goal == "cylinders_apart") {
    const auto cylinders = as_cylinders(pair_);
    if (!cylinders) return "These are not two capsules whose axes have a length.";
    return std::string("The capsules ") + (separation_of(pair_) ? "are apart" : "overlap") + "; the cylinders " +
           (cylinders->overlap ? "overlap." : "are apart by " + gap_text(cylinders->gap) + " units.");
  }
  const std::vector<Along> axes = along_axes(pair_);
  std::string text;
  const auto say = [&](Along so, const char* are) {
    if (const std::string names = axes_text(axes, so); !names.empty())
      text += (text.empty() ? "Along " : "; along ") + names + " the intervals " + are;
  };
  say(Along::kApart, "are apart");
  say(Along::kTouching, "touch");
  say(Along::kOverlapping, "overlap");
  return text + '.';
}

}  // namespace snug::lesson
