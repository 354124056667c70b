// What can be asked of the facts of fitters, besides "point" and "choice".
#pragma once

#include "lesson/subjects/cloud/decisions.hpp"

namespace snug::lesson {

/// "axis": which pair of extremes; the choices are the pairs.
const char* offer_axes(Asked& asked, const Run& run);
Truth axis_truth(const Asked& asked, const Run& run);
/// "grows": whether the volume is larger after the step than where the question is asked.
Truth grows_truth(const Asked& asked, const Run& run);
/// "leaves": which point leaves the support set; the choices are its points, and none.
const char* offer_support(Asked& asked, const Run& run);
Truth leaves_truth(const Asked& asked, const Run& run);
/// "better": whether the ball becomes the best so far.
Truth better_truth(const Asked& asked, const Run& run);
/// "holds": how many points support the ball.
const char* offer_counts(Asked& asked, const Run& run);
Truth holds_truth(const Asked& asked, const Run& run);
/// "outside": which point the finished sphere leaves outside, in exact arithmetic.
const char* offer_left_outside(Asked& asked, const Run& run);
Truth left_outside_truth(const Asked& asked, const Run& run);
/// "first_wrong": which point is the first that a naive algorithm's rounded test is wrong about.
const char* offer_first_wrong(Asked& asked, const Run& run);
Truth first_wrong_truth(const Asked& asked, const Run& run);
/// The place after the step; for a point forced onto the boundary, after the end of its recursion.
int after_recursion(const Run& run, int fact);

inline constexpr QuestionKind kGrows{"grows", &offer_yes_no, &grows_truth, &after_recursion};
inline constexpr QuestionKind kLeaves{.name = "leaves",
                                      .offer = &offer_support,
                                      .truth = &leaves_truth,
                                      .decided = &after_recursion,
                                      .margin = &leaves_margin,
                                      .rules = kLeavesRules};
inline constexpr QuestionKind kAxis{
    .name = "axis", .offer = &offer_axes, .truth = &axis_truth, .margin = &axis_margin, .rules = kAxisRules};
inline constexpr QuestionKind kBetter{.name = "better",
                                      .offer = &offer_yes_no,
                                      .truth = &better_truth,
                                      .figure = kResultFigure,
                                      .margin = &better_margin,
                                      .rules = kBetterRules};
inline constexpr QuestionKind kHolds{"holds", &offer_counts, &holds_truth};
inline constexpr QuestionKind kOutside{
    .name = "outside", .offer = &offer_left_outside, .truth = &left_outside_truth, .figure = "outside_count"};
inline constexpr QuestionKind kFirstWrong{
    .name = "first_wrong", .offer = &offer_first_wrong, .truth = &first_wrong_truth, .figure = "wrong_tests"};

}  // namespace snug::lesson
