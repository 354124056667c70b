// The entries of the facts that tests of two boxes tell.
#pragma once

#include <algorithm>

#include "lesson/subjects/pair/pair.hpp"

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

/// "separates": whether the boxes are apart along it.
Truth separates_truth(const Asked& asked, const Run& run);

template <>
struct Entry<query::AxisTested<double, 3>> : EntryDefaults {
  using Fact = query::AxisTested<double, 3>;
  static constexpr std::array kAskings{Asking{"separates", &offer_yes_no, &separates_truth}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const std::string axis = name_of_axis(fact.axis, where);
    if (fact.skipped) return "Along " + axis + " there is nothing to test: the edges are parallel.";
    const std::string sum = "r_A + r_B = " + number_text(fact.radius_a) + " + " + number_text(fact.radius_b);
    return "Along " + axis + " the distance " + number_text(fact.distance) +
           (fact.separates ? " is greater than " + sum + ": a gap, so the boxes are apart."
                           : " is not greater than " + sum + ": no gap.");
  }
  /// The vertices of B that come nearest to A.
  static std::vector<Index> handles(const Fact& fact, const PairWhere& where) {
    std::vector<Index> nearest;
    for (int bits = 0; bits < 8; ++bits)
      if ((fact.near_b >> bits & 1) != 0) nearest.push_back(index_of(where.dim(), {Place::Kind::kCorner, 1, bits}));
    return nearest;
  }
  static std::string predicate(const Fact&, const PairWhere&, bool plural) {
    return std::string(plural ? "come" : "comes") + " nearest to A along this axis";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const PairWhere&) {
    return fact.separates ? std::optional(Mark::Kind::kBest) : std::nullopt;
  }
};

template <>
struct Entry<query::LookedCloser> : EntryDefaults {
  static std::string sentence(const query::LookedCloser& fact, const PairWhere&) {
    return "Too close to call for rounded numbers: " + std::to_string(fact.axes) +
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
    return {index_of(where.dim(), {Place::Kind::kCorner, fact.box, fact.corner})};
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
           "; the proof tells whether it is right.";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const PairWhere&) { return Mark::Kind::kReplaced; }
};

/// "which_axis": which axis separates the boxes; the choices are the test's axes and none.
const char* offer_tested_axes(Asked& asked, const Run& run);
Truth which_axis_truth(const Asked& asked, const Run& run);

template <>
struct Entry<query::Verdict<double, 3>> : EntryDefaults {
  using Fact = query::Verdict<double, 3>;
  static constexpr std::array kAskings{Asking{"which_axis", &offer_tested_axes, &which_axis_truth}};
  static std::string sentence(const Fact& fact, const PairWhere& where) {
    const auto& [overlap, tests, axis] = fact.result;
    const std::string name = name_of_axis(axis, where);
    const std::string all = std::to_string(axis_names(where.dim()).size());
    if (overlap)
      return "Overlap: none of the " + all + " axes separates the boxes" +
             (name.empty()
                  ? "."
                  : "; penetration is least along " + name + ", " + number_text(std::max(0.0, -axis.gap)) + ".");
    return "Apart: along " + name + " there is a gap" + (axis.gap > 0 ? " of " + number_text(axis.gap) : "") + "; " +
           std::to_string(tests) + " of " + all + " axes were tested.";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const PairWhere&) { return Mark::Kind::kReplaced; }
};

}  // namespace snug::lesson
