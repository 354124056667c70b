// The entries of the facts that culling a field reports.
#pragma once

#include "lesson/subjects/field/field_run.hpp"

namespace snug::lesson {

using FieldWhere = FieldRun::Where;

const char* offer_planes(Asked& asked, const Run& run);
Truth rejects_most_truth(const Asked& asked, const Run& run);
/// The place after the last plane.
int after_sweeps(const Run& run, int fact);

/// "1 object", "10,000 objects".
[[nodiscard]] inline std::string objects_text(std::int64_t n) {
  return count_text(n) + (n == 1 ? " object" : " objects");
}
/// "1 is", "12 are", "none is".
[[nodiscard]] inline std::string are_text(std::int64_t n) {
  return n == 0 ? "none is" : count_text(n) + (n == 1 ? " is" : " are");
}
[[nodiscard]] inline std::string objects_are(std::int64_t n) {
  return n == 0 ? "no object is" : objects_text(n) + (n == 1 ? " is" : " are");
}
/// How many objects have no answer yet.
[[nodiscard]] inline std::string left_text(std::int64_t n) { return objects_are(n) + " left"; }

template <>
struct Entry<PlaneSwept> : EntryDefaults {
  static constexpr std::array kQuestionKinds{QuestionKind{
      .name = "rejects_most", .offer = &offer_planes, .truth = &rejects_most_truth, .decided = &after_sweeps}};
  static std::string sentence(const PlaneSwept& fact, const FieldWhere& where) {
    std::string plane(kFrustumPlaneNames<3>[fact.plane]);
    plane.front() = static_cast<char>(plane.front() - 'a' + 'A');
    if (fact.tested == 0) return plane + " plane: no object has to be tested against it.";
    const bool all = where.run.way() == hierarchy::FieldWay::kAllVertices;
    return plane + " plane: " + objects_are(fact.tested) + " tested" + (all ? ", all eight vertices of each; " : "; ") +
           are_text(fact.rejected) + (all && fact.plane > 0 ? " newly outside, and " : " outside, and ") +
           left_text(fact.left) + ".";
  }
  static std::optional<Mark::Kind> mark(const PlaneSwept& fact, const FieldWhere&) {
    return fact.rejected > 0 ? std::optional(Mark::Kind::kBest) : std::nullopt;
  }
};

template <>
struct Entry<SpheresTested> : EntryDefaults {
  static std::string sentence(const SpheresTested& fact, const FieldWhere& where) {
    return "The sphere around each of " + objects_text(where.run.objects()) + " is tested: " + are_text(fact.outside) +
           " outside, " + are_text(fact.inside) + " inside, and " + left_text(fact.left) + " for the test of its box.";
  }
  static std::optional<Mark::Kind> mark(const SpheresTested&, const FieldWhere&) { return Mark::Kind::kBest; }
};

template <>
struct Entry<LastPlanesTested> : EntryDefaults {
  static std::string sentence(const LastPlanesTested& fact, const FieldWhere&) {
    if (fact.tested == 0) return "No object was rejected in the frame before, so there is no plane to try first.";
    return "The frame before rejected " + objects_text(fact.tested) + ": " + are_text(fact.rejected) +
           " rejected again by the same plane, with one test each, and " + left_text(fact.left) + ".";
  }
  static std::optional<Mark::Kind> mark(const LastPlanesTested&, const FieldWhere&) { return Mark::Kind::kBest; }
};

template <>
struct Entry<PlanesSkipped> : EntryDefaults {
  static std::string sentence(const PlanesSkipped& fact, const FieldWhere&) {
    return "Level " + std::to_string(fact.level) + ": " + count_text(fact.skipped) +
           (fact.skipped == 1 ? " test of a plane is" : " tests of planes are") +
           " skipped, since the parent is inside those planes; " + count_text(fact.planes) +
           (fact.planes == 1 ? " is made." : " are made.");
  }
};

template <>
struct Entry<LevelTested> : EntryDefaults {
  static std::string sentence(const LevelTested& fact, const FieldWhere&) {
    return "Level " + std::to_string(fact.level) + ": " + count_text(fact.volumes) +
           (fact.volumes == 1 ? " box is" : " boxes are") + " tested; " + objects_are(fact.left_out) + " left out, " +
           are_text(fact.taken) + " taken as inside, and " + left_text(fact.left) + ".";
  }
  static std::optional<Mark::Kind> mark(const LevelTested& fact, const FieldWhere&) {
    return fact.left_out + fact.taken > 0 ? std::optional(Mark::Kind::kBest) : std::nullopt;
  }
};

template <>
struct Entry<LanesTested> : EntryDefaults {
  static std::string sentence(const LanesTested& fact, const FieldWhere& where) {
    return "All " + objects_text(where.run.objects()) + " are tested against all six planes, eight at once; of the " +
           count_text(fact.groups) + " groups, " + are_text(fact.empty) +
           " done after the n-vertices, because all eight are outside.";
  }
  static std::optional<Mark::Kind> mark(const LanesTested&, const FieldWhere&) { return Mark::Kind::kBest; }
};

template <>
struct Entry<FieldCulled> : EntryDefaults {
  static std::string sentence(const FieldCulled& fact, const FieldWhere& where) {
    const std::int64_t seen = fact.inside + fact.intersecting;
    if (seen == 0)
      return "The end: nothing is drawn. All " + objects_text(where.run.objects()) + " are outside, after " +
             count_text(fact.planes) + " tests of planes.";
    return "The end: " + objects_are(seen) + " drawn, " + count_text(fact.inside) + " inside and " +
           count_text(fact.intersecting) + " intersecting, of " + count_text(where.run.objects()) + ", after " +
           count_text(fact.planes) + " tests of planes.";
  }
  static std::optional<Mark::Kind> mark(const FieldCulled&, const FieldWhere&) { return Mark::Kind::kReplaced; }
};

}  // namespace snug::lesson
