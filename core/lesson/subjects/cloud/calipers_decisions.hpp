// What a student decides in the calipers' place, in the plane.
#pragma once

#include "lesson/facts.hpp"

namespace snug::lesson {

/// "touched", of a box on an edge: the points that its other three sides touch, without the edge's own ends.
const char* offer_touched(Asked& asked, const Run& run);
Truth touched_truth(const Asked& asked, const Run& run);
double touched_margin(const Asked& asked, const Run& run);
std::optional<Answer> only_opposite(const Asked& asked, const Run& run);
std::optional<Answer> touched_by_aabb(const Asked& asked, const Run& run);
/// "smallest_edge", once all were tried: the edge whose box was the smallest.
const char* offer_tried_edges(Asked& asked, const Run& run);
Truth smallest_edge_truth(const Asked& asked, const Run& run);
double smallest_edge_margin(const Asked& asked, const Run& run);
std::optional<Answer> last_tried(const Asked& asked, const Run& run);
std::optional<Answer> least_perimeter(const Asked& asked, const Run& run);

inline constexpr std::array kTouchedRules{WrongRule{"opposite", &only_opposite}, WrongRule{"aabb", &touched_by_aabb}};
inline constexpr std::array kSmallestEdgeRules{WrongRule{"last", &last_tried},
                                               WrongRule{"perimeter", &least_perimeter}};

inline constexpr QuestionKind kTouched{.name = "touched",
                                       .offer = &offer_touched,
                                       .truth = &touched_truth,
                                       .margin = &touched_margin,
                                       .rules = kTouchedRules},
    kSmallestEdge{.name = "smallest_edge",
                  .offer = &offer_tried_edges,
                  .truth = &smallest_edge_truth,
                  .margin = &smallest_edge_margin,
                  .rules = kSmallestEdgeRules};

}  // namespace snug::lesson
