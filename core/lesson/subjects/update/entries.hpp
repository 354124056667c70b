// The entries of an update's facts.
#pragma once

#include <algorithm>
#include <vector>

#include "lesson/subjects/update/update_run.hpp"

namespace snug::lesson {

using UpdateWhere = UpdateRun::Where;

/// "extreme": whether a vertex of a climb is the extreme, where the climb ends.
Truth extreme_truth(const Asked& asked, const Run& run);
/// "climb_to": the neighbour to which a climb goes on, or the vertex where it ends.
const char* offer_climb(Asked& asked, const Run& run);
Truth climb_truth(const Asked& asked, const Run& run);
double climb_margin(const Asked& asked, const Run& run);
std::optional<Answer> first_higher(const Asked& asked, const Run& run);
std::optional<Answer> always_on(const Asked& asked, const Run& run);
inline constexpr std::array kClimbRules{WrongRule{"first_higher", &first_higher}, WrongRule{"goes_on", &always_on}};

/// Which of the AABBs of the lesson's updates, told by their widths, is that of one update.
inline constexpr std::array<std::string_view, 4> kToldApart{"loose", "rebuild", "hill_climb", "rotated_box"};
const char* offer_boxes(Asked& asked, const Run& run);
template <std::size_t kUpdate>
Truth box_truth(const Asked& asked, const Run& run);
template <std::size_t kUpdate>
double box_margin(const Asked& asked, const Run& run);
std::optional<Answer> tightest_box(const Asked& asked, const Run& run);
std::optional<Answer> loosest_box(const Asked& asked, const Run& run);
inline constexpr std::array kBoxRules{WrongRule{"tightest", &tightest_box}, WrongRule{"loosest", &loosest_box}};
template <std::size_t kUpdate>
constexpr QuestionKind box_asking(std::string_view name) {
  return {.name = name,
          .offer = &offer_boxes,
          .truth = &box_truth<kUpdate>,
          .margin = &box_margin<kUpdate>,
          .rules = kBoxRules};
}

template <>
struct Entry<fit::ReachFound> : EntryDefaults {
  static std::string sentence(const fit::ReachFound& fact, const UpdateWhere& where);
  static std::vector<Index> handles(const fit::ReachFound& fact, const UpdateWhere&) { return {fact.point}; }
  static std::string predicate(const fit::ReachFound&, const UpdateWhere&, bool) {
    return "is farthest from the pivot";
  }
};

template <>
struct Entry<PointPlaced> : EntryDefaults {
  static std::string sentence(const PointPlaced& fact, const UpdateWhere& where);
  static std::vector<Index> handles(const PointPlaced& fact, const UpdateWhere&) { return {fact.point}; }
  static std::string predicate(const PointPlaced&, const UpdateWhere&, bool) { return "lies outside the AABB so far"; }
};

template <>
struct Entry<fit::NeighborsCompared> : EntryDefaults {
  static constexpr std::array kQuestionKinds{
      QuestionKind{.name = "extreme", .offer = &offer_yes_no, .truth = &extreme_truth},
      QuestionKind{.name = "climb_to",
                   .offer = &offer_climb,
                   .truth = &climb_truth,
                   .margin = &climb_margin,
                   .rules = kClimbRules}};
  static std::string sentence(const fit::NeighborsCompared& fact, const UpdateWhere& where);
  static std::vector<Index> handles(const fit::NeighborsCompared& fact, const UpdateWhere&) { return {fact.best}; }
  static std::string predicate(const fit::NeighborsCompared& fact, const UpdateWhere& where, bool);
};

template <>
struct Entry<fit::ExtremeClimbed> : EntryDefaults {
  static std::string sentence(const fit::ExtremeClimbed& fact, const UpdateWhere& where);
  static std::vector<Index> handles(const fit::ExtremeClimbed& fact, const UpdateWhere&) { return {fact.path.back()}; }
  static std::string predicate(const fit::ExtremeClimbed& fact, const UpdateWhere& where, bool);
  static std::optional<Mark::Kind> mark(const fit::ExtremeClimbed&, const UpdateWhere&) { return Mark::Kind::kBest; }
};

template <>
struct Entry<fit::BoundsRotated> : EntryDefaults {
  static std::string sentence(const fit::BoundsRotated& fact, const UpdateWhere& where);
  static std::optional<Mark::Kind> mark(const fit::BoundsRotated&, const UpdateWhere&) { return Mark::Kind::kBest; }
};

template <>
struct Entry<fit::CenterMoved> : EntryDefaults {
  static std::string sentence(const fit::CenterMoved& fact, const UpdateWhere& where);
};

template <>
struct Entry<fit::AxesTurned> : EntryDefaults {
  static std::string sentence(const fit::AxesTurned& fact, const UpdateWhere& where);
};

template <>
struct Entry<VolumeUpdated> : EntryDefaults {
  static constexpr std::array kQuestionKinds{box_asking<0>("loose_box"), box_asking<1>("rebuilt_box"),
                                             box_asking<2>("climbed_box"), box_asking<3>("rotated_box")};
  static std::string sentence(const VolumeUpdated& fact, const UpdateWhere& where);
  static std::vector<Index> handles(const VolumeUpdated& fact, const UpdateWhere&) { return fact.support; }
  static std::string predicate(const VolumeUpdated&, const UpdateWhere& where, bool plural) {
    return (plural ? "support the " : "supports the ") + where.volume();
  }
  static std::optional<Mark::Kind> mark(const VolumeUpdated&, const UpdateWhere&) { return Mark::Kind::kReplaced; }
};

}  // namespace snug::lesson
