// Questions that an edge, a face or a slab answers.
#pragma once

#include "lesson/subjects/cloud/decisions.hpp"

namespace snug::lesson {

/// "faces": which of the hull's faces the eye sees. Any number may be right.
const char* offer_faces(Asked& asked, const Run& run);
Truth faces_truth(const Asked& asked, const Run& run);
/// "edge" of a rectangle: which of the hull's edges it lies on, in space of the projection's, where the calipers turned
/// around it step by step.
const char* offer_hull_edges(Asked& asked, const Run& run);
Truth hull_edge_truth(const Asked& asked, const Run& run);
/// "smaller": whether the rectangle on which the calipers stand is smaller than those before it on this projection.
Truth smaller_truth(const Asked& asked, const Run& run);
/// "slab": which slab of the k-DOP is the narrowest.
const char* offer_narrowest(Asked& asked, const Run& run);
Truth narrowest_truth(const Asked& asked, const Run& run);

inline constexpr QuestionKind kFaces{
    .name = "faces", .offer = &offer_faces, .truth = &faces_truth, .margin = &faces_margin, .rules = kFacesRules},
    kHullEdge{"edge", &offer_hull_edges, &hull_edge_truth},
    kSmaller{.name = "smaller", .offer = &offer_yes_no, .truth = &smaller_truth, .margin = &smaller_margin},
    kSlab{"slab", &offer_narrowest, &narrowest_truth};

}  // namespace snug::lesson
