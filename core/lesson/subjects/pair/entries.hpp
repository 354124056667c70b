// The entries of the facts that tests of two volumes report.
#pragma once

#include <algorithm>

#include "lesson/decide.hpp"
#include "lesson/held_volume.hpp"
#include "lesson/subjects/pair/feature.hpp"
#include "lesson/subjects/pair/pair.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {

using PairWhere = PairRun::Where;

[[nodiscard]] inline std::string name_of_axis(const query::SatAxis<double, 3>& axis, const PairWhere& where) {
  return axis_text(where.dim(), axis);
}

template <>
struct Entry<query::FramesRelated<double, 3>> : EntryDefaults {
  static std::string sentence(const query::FramesRelated<double, 3>&, const PairWhere& where) {
    return "B is expressed in A's frame, where A is axis-aligned and its face axes are x" +
           std::string(where.dim() == 2 ? " and y." : ", y and z.");
  }
};

/// "separates": whether the boxes are apart along it. "entries_b": which entries of R the projected radius of B takes.
const char* offer_of_axis(Asked& asked, const Run& run);
Truth separates_truth(const Asked& asked, const Run& run);
double separates_margin(const Asked& asked, const Run& run);
std::optional<Answer> without_b(const Asked& asked, const Run& run);
std::optional<Answer> with_full_widths(const Asked& asked, const Run& run);
inline constexpr std::array kSeparatesRules{WrongRule{"only_a", &without_b}, WrongRule{"widths", &with_full_widths}};
/// "radius_b": the projected radius of B, a number.
const char* offer_radius_b(Asked& asked, const Run& run);
Truth radius_b_truth(const Asked& asked, const Run& run);
void read_tolerance(TomlTable& table, Question& question);
std::optional<Answer> sum_of_half_extents(const Asked& asked, const Run& run);
std::optional<Answer> whole_width(const Asked& asked, const Run& run);
inline constexpr std::array kRadiusRules{WrongRule{"sum", &sum_of_half_extents}, WrongRule{"width", &whole_width}};
const char* offer_entries_b(Asked& asked, const Run& run);
Truth entries_b_truth(const Asked& asked, const Run& run);

template <>
struct Entry<query::AxisTested<double, 3>> : EntryDefaults {
  using Fact = query::AxisTested<double, 3>;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "separates",
                                                          .offer = &offer_of_axis,
                                                          .truth = &separates_truth,
                                                          .margin = &separates_margin,
                                                          .rules = kSeparatesRules},
                                             QuestionKind{.name = "radius_b",
                                                          .offer = &offer_radius_b,
                                                          .truth = &radius_b_truth,
                                                          .figure = "radius_b",
                                                          .read = &read_tolerance,
                                                          .margin = &no_tie,
                                                          .rules = kRadiusRules},
                                             QuestionKind{"entries_b", &offer_entries_b, &entries_b_truth}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const std::string axis = name_of_axis(fact.axis, where);
    if (fact.skipped) return "Along " + axis + " there is nothing to test: the edges are parallel.";
    if (const RowTruth* truth = where.truth(); truth != nullptr && is_wrong(fact, *truth))
      return "Along " + axis + " this test sees " +
             (fact.separates ? "a gap of " + gap_text(fact.axis.gap) : "no gap") + ". Wrong: " + truth_text(*truth) +
             ".";
    const std::string sum =
        "r_A\u00a0+\u00a0r_B = " + length_along(fact, fact.radius_a) + " + " + length_along(fact, fact.radius_b);
    const std::string distance = "Along " + axis + " the distance " + length_along(fact, fact.distance);
    if (fact.separates) return distance + " is greater than " + sum + ": a gap, so the boxes are apart.";
    return distance + (fact.distance > fact.radius_a + fact.radius_b
                           ? " is greater than " + sum + ", but by no more than the test's tolerance: no gap."
                           : " is not greater than " + sum + ": no gap.");
  }
  /// The vertices of B that come nearest to A.
  static std::vector<Index> handles(const Fact& fact, const PairWhere& where) {
    std::vector<Index> nearest;
    for (int bits = 0; bits < 8; ++bits)
      if ((fact.near_b >> bits & 1) != 0) nearest.push_back(index_of(where.dim(), {BoxHandle::Kind::kCorner, 1, bits}));
    return nearest;
  }
  static std::string predicate(const Fact&, const PairWhere&, bool plural) {
    return std::string(plural ? "come" : "comes") + " nearest to A along this axis";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const PairWhere& where) {
    if (const RowTruth* truth = where.truth(); truth != nullptr && is_wrong(fact, *truth)) return Mark::Kind::kWrong;
    return fact.separates ? std::optional(Mark::Kind::kBest) : std::nullopt;
  }
};

template <>
struct Entry<query::LookedCloser> : EntryDefaults {
  static std::string sentence(const query::LookedCloser& fact, const PairWhere&) {
    return "Too close to call in floating point: " + std::to_string(fact.axes) +
           (fact.axes == 1 ? " axis is" : " axes are") + " tested again in exact arithmetic.";
  }
};

template <>
struct Entry<query::OutlinesCompared> : EntryDefaults {
  static std::string sentence(const query::OutlinesCompared& fact, const PairWhere&) {
    return std::string("Along ") + "xyz"[fact.axis] + " the extents of the two AABBs " +
           (fact.apart ? "are disjoint." : "overlap.");
  }
};

template <>
struct Entry<query::CornerTried> : EntryDefaults {
  using Fact = query::CornerTried;
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    return "Vertex " + place_name(where.dim(), handles(fact, where).front()) +
           (fact.inside ? " lies inside " : " lies outside ") + (fact.box == 0 ? "B." : "A.");
  }
  static std::vector<Index> handles(const Fact& fact, const PairWhere& where) {
    return {index_of(where.dim(), {BoxHandle::Kind::kCorner, fact.box, fact.corner})};
  }
  static std::string predicate(const Fact& fact, const PairWhere&, bool) {
    return fact.inside ? "lies inside the other box" : "lies outside the other box";
  }
};

template <>
struct Entry<query::Claimed> : EntryDefaults {
  using Fact = query::Claimed;
  static std::string sentence(const Fact& fact, const PairWhere&) {
    return std::string("This test says that the boxes ") + (fact.overlap ? "overlap" : "are apart") +
           "; the proof says whether that is right.";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const PairWhere&) { return Mark::Kind::kReplaced; }
};

/// "which_axis": which axis separates the boxes; the choices are the test's axes, and none.
const char* offer_tested_axes(Asked& asked, const Run& run);
Truth which_axis_truth(const Asked& asked, const Run& run);
/// "first_axis": the first one in the table's order that separates. "least_penetration": of overlapping boxes, the axis
/// along which they overlap least.
const char* offer_first_axis(Asked& asked, const Run& run);
Truth first_axis_of_test(const Asked& asked, const Run& run);
const char* offer_least_penetration(Asked& asked, const Run& run);
Truth least_penetration_truth(const Asked& asked, const Run& run);
double all_axes_margin(const Asked& asked, const Run& run);
double penetration_margin(const Asked& asked, const Run& run);

template <>
struct Entry<query::Verdict<double, 3>> : EntryDefaults {
  using Fact = query::Verdict<double, 3>;
  static constexpr std::array kQuestionKinds{
      QuestionKind{
          .name = "which_axis", .offer = &offer_tested_axes, .truth = &which_axis_truth, .margin = &all_axes_margin},
      QuestionKind{"first_axis", &offer_first_axis, &first_axis_of_test},
      QuestionKind{.name = "least_penetration",
                   .offer = &offer_least_penetration,
                   .truth = &least_penetration_truth,
                   .margin = &penetration_margin}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const auto& [overlap, tests, axis] = fact.result;
    const std::string name = name_of_axis(axis, where);
    const std::string all = std::to_string(axis_names(where.dim()).size());
    if (const RowTruth* truth = where.truth(); truth != nullptr)
      return (overlap ? "This test says overlap: none of its " + std::to_string(tests) + " axes shows a gap."
                      : "This test says apart: along " + name + " there is a gap of " + gap_text(axis.gap) + ".") +
             (overlap != truth->separates ? " Exact arithmetic says the same."
              : overlap                   ? " Wrong: in exact arithmetic the boxes are apart."
                                          : " Wrong: in exact arithmetic the boxes overlap.");
    if (overlap)
      return "Overlap: none of the " + all + " axes separates the boxes" +
             (name.empty()
                  ? "."
                  : "; the penetration is least along " + name + ", " + gap_text(std::max(0.0, -axis.gap)) + ".");
    return "Apart: along " + name + " there is a gap" + (axis.gap > 0 ? " of " + gap_text(axis.gap) : "") + "; " +
           std::to_string(tests) + " of " + all + (tests == 1 ? " axes was tested." : " axes were tested.");
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const PairWhere& where) {
    const RowTruth* truth = where.truth();
    return truth != nullptr && truth->separates == fact.result.overlap ? Mark::Kind::kWrong : Mark::Kind::kReplaced;
  }
};

// ---- the tests of any two volumes ------------------------------------------------------------------------------

/// "separates" asks about an interval, "apart" about two cores or the end result: yes or no.
Truth slab_truth(const Asked& asked, const Run& run);
double slab_margin(const Asked& asked, const Run& run);
std::optional<Answer> one_way(const Asked& asked, const Run& run);
std::optional<Answer> contained_only(const Asked& asked, const Run& run);
inline constexpr std::array kSlabRules{WrongRule{"one_way", &one_way}, WrongRule{"contained", &contained_only}};
Truth cores_truth(const Asked& asked, const Run& run);
double cores_margin(const Asked& asked, const Run& run);
std::optional<Answer> without_radii(const Asked& asked, const Run& run);
inline constexpr std::array kCoresRules{WrongRule{"no_radii", &without_radii}};
Truth overlap_truth(const Asked& asked, const Run& run);
double overlap_margin(const Asked& asked, const Run& run);
/// "first_axis": the first axis whose intervals are apart; the choices are the coordinate axes, and none.
const char* offer_coordinate_axes(Asked& asked, const Run& run);
Truth first_axis_truth(const Asked& asked, const Run& run);

/// How far apart the intervals are, scene units; below 0 by how much they overlap.
[[nodiscard]] inline double slab_gap(const query::SlabTested& slab) {
  return std::max(slab.least_b - slab.greatest_a, slab.least_a - slab.greatest_b);
}

/// A bound of an interval, as a k-DOP stores it: along (1, 1), not along the unit vector of that direction. Its digits
/// show whether the intervals are apart.
[[nodiscard]] inline std::string bound_text(const query::SlabTested& fact, double bound) {
  const double gap = slab_gap(fact);
  return length_text(bound / fact.direction.cwiseAbs().maxCoeff(), decimals_showing(gap));
}

/// Whether two intervals have an end in common, and nothing else.
[[nodiscard]] inline bool touch(const query::SlabTested& fact) {
  return fact.greatest_a == fact.least_b || fact.greatest_b == fact.least_a;
}

/// Whether two volumes that overlap do no more than touch, by what their test has compared up to a step.
[[nodiscard]] inline bool only_touch(PairSteps steps) {
  return std::any_of(steps.begin(), steps.end(), [](const auto& entry) {
    const auto* slab = std::get_if<query::SlabTested>(&entry.step.fact);
    const auto* cores = std::get_if<query::CoresCompared>(&entry.step.fact);
    return (slab != nullptr && touch(*slab)) || (cores != nullptr && cores->distance == cores->radii);
  });
}

/// "The volumes overlap." steps: those of the test, up to its verdict.
[[nodiscard]] inline std::string overlap_text(PairSteps steps) {
  return only_touch(steps) ? "The volumes touch, and touching counts as overlapping." : "The volumes overlap.";
}

template <>
struct Entry<query::SlabTested> : EntryDefaults {
  using Fact = query::SlabTested;
  static constexpr std::array kQuestionKinds{QuestionKind{
      .name = "separates", .offer = &offer_of_axis, .truth = &slab_truth, .margin = &slab_margin, .rules = kSlabRules}};
  static std::string sentence(const Fact& fact, const PairWhere&) {
    const auto interval = [&](double least, double greatest) {
      return "[" + bound_text(fact, least) + ", " + bound_text(fact, greatest) + "]";
    };
    return "Along " + axis_name(fact.direction) + " A covers " + interval(fact.least_a, fact.greatest_a) + " and B " +
           interval(fact.least_b, fact.greatest_b) +
           (fact.separates ? ": the intervals are disjoint, so the volumes are apart."
            : touch(fact)  ? ": the intervals touch, and touching counts as overlapping."
                           : ": the intervals overlap.");
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const PairWhere&) {
    return fact.separates ? std::optional(Mark::Kind::kBest) : std::nullopt;
  }
};

template <>
struct Entry<query::CoresCompared> : EntryDefaults {
  using Fact = query::CoresCompared;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "apart",
                                                          .offer = &offer_yes_no,
                                                          .truth = &cores_truth,
                                                          .margin = &cores_margin,
                                                          .rules = kCoresRules},
                                             QuestionKind{"feature", &offer_features, &feature_truth}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const auto [distance, radii] = number_texts_apart(fact.distance, fact.radii);
    const std::string least =
        fact.tests > 1 ? ", the least of " + std::to_string(fact.tests) + " pairs of features," : ",";
    return "The " + where.compared() + " are " + distance + " apart" + least + " and the radii add up to " + radii +
           (fact.apart                    ? ": the distance is greater, so the volumes are apart."
            : fact.distance == fact.radii ? ": the distance is not greater, so the volumes touch."
                                          : ": the distance is not greater, so the volumes overlap.");
  }
  static std::optional<Mark::Kind> mark(const Fact&, const PairWhere&) { return Mark::Kind::kBest; }
};

/// The handles of these vertices, A's and B's by turns, each once.
[[nodiscard]] inline std::vector<Index> handles_of_vertices(std::span<const Index> vertices, const PairWhere& where) {
  std::vector<Index> handles;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (const Index handle = where.vertex(static_cast<int>(i % 2), vertices[i]).handle; handle != kNoIndex)
      handles.push_back(handle);
  std::sort(handles.begin(), handles.end());
  handles.erase(std::unique(handles.begin(), handles.end()), handles.end());
  return handles;
}

/// "A3 − B0", on one line
[[nodiscard]] inline std::string difference_name(Index a, Index b, const PairWhere& where) {
  return where.vertex(0, a).name + "\u00a0−\u00a0" + where.vertex(1, b).name;
}

/// Whether GJK ends at a simplex because it contains the origin.
[[nodiscard]] inline bool contains_origin(PairSteps steps, int simplex) {
  const auto next = static_cast<std::size_t>(simplex) + 1;
  const auto* end = next < steps.size() ? std::get_if<query::DistanceFound>(&steps[next].step.fact) : nullptr;
  return end != nullptr && !(end->gap > 0);
}

/// "next_vertex": which vertex of A - B is farthest along -v; "contains_origin": whether the simplex contains the
/// origin; "cheaper": the pair's own test or GJK.
const char* offer_difference(Asked& asked, const Run& run);
Truth next_vertex_truth(const Asked& asked, const Run& run);
double next_vertex_margin(const Asked& asked, const Run& run);
std::optional<Answer> vertex_along_v(const Asked& asked, const Run& run);
std::optional<Answer> vertex_nearest_origin(const Asked& asked, const Run& run);
inline constexpr std::array kNextVertexRules{WrongRule{"wrong_sign", &vertex_along_v},
                                             WrongRule{"nearest", &vertex_nearest_origin}};
Truth contains_origin_truth(const Asked& asked, const Run& run);
/// "kept": the vertices of the simplex, with the one found last, that its point nearest to the origin needs.
const char* offer_simplex(Asked& asked, const Run& run);
Truth kept_truth(const Asked& asked, const Run& run);
double kept_margin(const Asked& asked, const Run& run);
std::optional<Answer> keep_all(const Asked& asked, const Run& run);
std::optional<Answer> keep_newest(const Asked& asked, const Run& run);
inline constexpr std::array kKeptRules{WrongRule{"all", &keep_all}, WrongRule{"newest", &keep_newest}};
const char* offer_own_and_gjk(Asked& asked, const Run& run);
Truth cheaper_truth(const Asked& asked, const Run& run);

template <>
struct Entry<query::NearestFound> : EntryDefaults {
  using Fact = query::NearestFound;
  static constexpr std::array kQuestionKinds{
      QuestionKind{"contains_origin", &offer_yes_no, &contains_origin_truth},
      QuestionKind{
          .name = "kept", .offer = &offer_simplex, .truth = &kept_truth, .margin = &kept_margin, .rules = kKeptRules}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const auto& pairs = fact.corners;
    std::string names;
    for (std::size_t i = 0; i < pairs.size(); i += 2)
      names += (i == 0 ? "" : i + 2 == pairs.size() ? " and " : ", ") + difference_name(pairs[i], pairs[i + 1], where);
    if (contains_origin(where.run.trace(), where.i)) return "The simplex of " + names + " contains the origin.";
    const std::string distance = number_text(fact.distance);
    if (pairs.size() == 2) return names + " is " + distance + " from the origin.";
    return "The nearest point of the simplex of " + names + " is " + distance + " from the origin.";
  }
  static std::vector<Index> handles(const Fact& fact, const PairWhere& where) {
    return handles_of_vertices(fact.corners, where);
  }
  static std::string predicate(const Fact&, const PairWhere&, bool plural) {
    return plural ? "span the simplex" : "spans the simplex";
  }
};

template <>
struct Entry<query::SupportFound> : EntryDefaults {
  using Fact = query::SupportFound;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "next_vertex",
                                                          .offer = &offer_difference,
                                                          .truth = &next_vertex_truth,
                                                          .margin = &next_vertex_margin,
                                                          .rules = kNextVertexRules}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const std::string found = "The vertex of A − B farthest along −v is " + difference_name(fact.a, fact.b, where);
    const double known = proved_distance(where.run.trace().first(where.i)).value_or(0);
    if (!(fact.gap > 0)) return found + ", beyond the origin: nothing is proved " + (known > 0 ? "by it." : "yet.");
    const std::string gap = number_text(fact.gap), best = number_text(known);
    if (fact.gap < known && gap != best)
      return found + ": a bound of " + gap + ", weaker than the one so far, " + best + ".";
    return found + ": the " + where.compared() + " are at least " + gap + " apart.";
  }
  static std::vector<Index> handles(const Fact& fact, const PairWhere& where) {
    return handles_of_vertices(std::array{fact.a, fact.b}, where);
  }
  static std::string predicate(const Fact&, const PairWhere&, bool plural) {
    return plural ? "are the supporting vertices" : "is the supporting vertex";
  }
};

template <>
struct Entry<query::DigitsDoubled> : EntryDefaults {
  static std::string sentence(const query::DigitsDoubled&, const PairWhere&) {
    return "Rounding hides which simplex is nearer: the search goes on with twice as many digits.";
  }
};

template <>
struct Entry<query::DistanceFound> : EntryDefaults {
  using Fact = query::DistanceFound;
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    if (!(fact.gap > 0)) return "The simplex contains the origin: the " + where.compared() + " have a point in common.";
    return "Both bounds meet: the " + where.compared() + " are " + number_text(fact.distance) + " apart.";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const PairWhere&) { return Mark::Kind::kBest; }
};

template <>
struct Entry<OverlapDecided> : EntryDefaults {
  static constexpr std::array kQuestionKinds{
      QuestionKind{.name = "apart", .offer = &offer_yes_no, .truth = &overlap_truth, .margin = &overlap_margin},
      QuestionKind{"first_axis", &offer_coordinate_axes, &first_axis_truth},
      QuestionKind{.name = "cheaper", .offer = &offer_own_and_gjk, .truth = &cheaper_truth, .figure = "operations"}};
  static std::string sentence(const OverlapDecided& fact, const PairWhere& where) {
    const PairSteps steps = where.run.trace().first(static_cast<std::size_t>(where.i));
    if (fact.overlap) return overlap_text(steps);
    if (fact.distance >= 0) return "Apart: the distance between the volumes is " + gap_text(fact.distance) + ".";
    const auto* slab = steps.empty() ? nullptr : std::get_if<query::SlabTested>(&steps.back().step.fact);
    const std::string axis = slab != nullptr ? axis_name(slab->direction) : "the separating axis";
    return "Apart: along " + axis + " there is a gap of " + gap_text(fact.gap) + ".";
  }
  static std::optional<Mark::Kind> mark(const OverlapDecided&, const PairWhere&) { return Mark::Kind::kReplaced; }
};

}  // namespace snug::lesson
