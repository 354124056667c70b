// What a student decides in a fitter's place: each with its margin, and the rules that many follow by mistake.
#pragma once

#include "lesson/facts.hpp"

namespace snug::lesson {

struct Scores;

/// How far each point reaches along a direction.
[[nodiscard]] Scores reach_along(const Run& run, const Point3& direction);

/// "farthest": which point is farthest from the centre that was found.
const char* offer_farthest(Asked& asked, const Run& run);
Truth farthest_truth(const Asked& asked, const Run& run);
double farthest_margin(const Asked& asked, const Run& run);
std::optional<Answer> nearest_point(const Asked& asked, const Run& run);
std::optional<Answer> farthest_along_an_axis(const Asked& asked, const Run& run);

/// "axis", of fit_asks.hpp.
double axis_margin(const Asked& asked, const Run& run);
std::optional<Answer> nearest_pair(const Asked& asked, const Run& run);
std::optional<Answer> widest_pair(const Asked& asked, const Run& run);

/// The choices are the points, and none.
const char* offer_points_or_none(Asked& asked, const Run& run);

/// "next_outside": which point is the next in the list that lies outside the ball.
Truth next_outside_truth(const Asked& asked, const Run& run);
double next_outside_margin(const Asked& asked, const Run& run);
std::optional<Answer> farthest_outside(const Asked& asked, const Run& run);
std::optional<Answer> nearest_outside(const Asked& asked, const Run& run);

/// "side": whether a point lies inside the ball or outside.
const char* offer_sides(Asked& asked, const Run& run);
Truth side_truth(const Asked& asked, const Run& run);
double side_margin(const Asked& asked, const Run& run);
std::optional<Answer> inside_the_box(const Asked& asked, const Run& run);
std::optional<Answer> always_inside(const Asked& asked, const Run& run);

/// "leaves", of fit_asks.hpp.
double leaves_margin(const Asked& asked, const Run& run);
std::optional<Answer> nearest_leaves(const Asked& asked, const Run& run);
std::optional<Answer> none_leaves(const Asked& asked, const Run& run);

/// "extremes": the points that reach farthest both ways along each axis, or along a slab's.
const char* offer_extremes(Asked& asked, const Run& run);
Truth extremes_truth(const Asked& asked, const Run& run);
double extremes_margin(const Asked& asked, const Run& run);
std::optional<Answer> extremes_of_one_axis(const Asked& asked, const Run& run);
std::optional<Answer> farthest_apart(const Asked& asked, const Run& run);
std::optional<Answer> extremes_along_x(const Asked& asked, const Run& run);

/// "eye": which of a facet's points is farthest from its line or plane.
const char* offer_eye(Asked& asked, const Run& run);
Truth eye_truth(const Asked& asked, const Run& run);
double eye_margin(const Asked& asked, const Run& run);
std::optional<Answer> farthest_from_the_middle(const Asked& asked, const Run& run);
std::optional<Answer> nearest_to_the_facet(const Asked& asked, const Run& run);

/// "faces", of facet_asks.hpp.
double faces_margin(const Asked& asked, const Run& run);
std::optional<Answer> its_own_face(const Asked& asked, const Run& run);
inline constexpr std::array kFacesRules{WrongRule{"own", &its_own_face}};

/// "sign", of fit_asks.hpp.
double sign_margin(const Asked& asked, const Run& run);
std::optional<Answer> sign_of_x(const Asked& asked, const Run& run);
std::optional<Answer> sign_about_origin(const Asked& asked, const Run& run);

/// "smaller", of facet_asks.hpp.
double smaller_margin(const Asked& asked, const Run& run);

/// "better" of a pass, of fit_asks.hpp.
double better_margin(const Asked& asked, const Run& run);
std::optional<Answer> always_better(const Asked& asked, const Run& run);
inline constexpr std::array kBetterRules{WrongRule{"always", &always_better}};

inline constexpr std::array kFarthestRules{WrongRule{"nearest", &nearest_point},
                                           WrongRule{"one_axis", &farthest_along_an_axis}};
inline constexpr std::array kAxisRules{WrongRule{"nearest", &nearest_pair}, WrongRule{"widest", &widest_pair}};
inline constexpr std::array kNextRules{WrongRule{"farthest", &farthest_outside},
                                       WrongRule{"nearest", &nearest_outside}};
inline constexpr std::array kSideRules{WrongRule{"box", &inside_the_box}, WrongRule{"inside", &always_inside}};
inline constexpr std::array kLeavesRules{WrongRule{"nearest", &nearest_leaves}, WrongRule{"none", &none_leaves}};
inline constexpr std::array kExtremesRules{WrongRule{"one_axis", &extremes_of_one_axis},
                                           WrongRule{"farthest_apart", &farthest_apart},
                                           WrongRule{"along_x", &extremes_along_x}};
inline constexpr std::array kEyeRules{WrongRule{"middle", &farthest_from_the_middle},
                                      WrongRule{"nearest", &nearest_to_the_facet}};
inline constexpr std::array kSignRules{WrongRule{"only_x", &sign_of_x}, WrongRule{"origin", &sign_about_origin}};

inline constexpr QuestionKind kFarthest{.name = "farthest",
                                        .offer = &offer_farthest,
                                        .truth = &farthest_truth,
                                        .figure = "outside",
                                        .margin = &farthest_margin,
                                        .rules = kFarthestRules};
inline constexpr QuestionKind kNextOutside{.name = "next_outside",
                                           .offer = &offer_points_or_none,
                                           .truth = &next_outside_truth,
                                           .figure = "outside",
                                           .margin = &next_outside_margin,
                                           .rules = kNextRules};
inline constexpr QuestionKind kSide{.name = "side",
                                    .offer = &offer_sides,
                                    .truth = &side_truth,
                                    .figure = "outside",
                                    .margin = &side_margin,
                                    .rules = kSideRules};
inline constexpr QuestionKind kExtremes{.name = "extremes",
                                        .offer = &offer_extremes,
                                        .truth = &extremes_truth,
                                        .margin = &extremes_margin,
                                        .rules = kExtremesRules};
inline constexpr QuestionKind kEye{
    .name = "eye", .offer = &offer_eye, .truth = &eye_truth, .margin = &eye_margin, .rules = kEyeRules};

}  // namespace snug::lesson
