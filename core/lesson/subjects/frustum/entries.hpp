// The entries of the facts that tests of a box against a frustum report.
#pragma once

#include <cmath>

#include "lesson/subjects/frustum/frustum.hpp"

namespace snug::lesson {

using FrustumWhere = FrustumRun::Where;

[[nodiscard]] inline std::string culling_name(query::Culling culling) {
  return std::string(query::kCullingNames[static_cast<std::size_t>(culling)]);
}

const char* offer_vertices(Asked& asked, const Run& run);     // the vertices of the box
const char* offer_cullings(Asked& asked, const Run& run);     // inside, intersecting, outside
const char* offer_plane_sides(Asked& asked, const Run& run);  // the same; for a point, the half-spaces
Truth p_vertex_truth(const Asked& asked, const Run& run);
Truth n_vertex_truth(const Asked& asked, const Run& run);
Truth plane_side_truth(const Asked& asked, const Run& run);
Truth culling_verdict_truth(const Asked& asked, const Run& run);
double vertex_margin(const Asked& asked, const Run& run);  // of the p- and of the n-vertex: both lie opposite
std::optional<Answer> vertex_against(const Asked& asked, const Run& run);  // the n-vertex for the p-vertex
std::optional<Answer> vertex_along(const Asked& asked, const Run& run);    // the p-vertex for the n-vertex
double plane_side_margin(const Asked& asked, const Run& run);
std::optional<Answer> side_of_center(const Asked& asked, const Run& run);
std::optional<Answer> side_of_p_vertex(const Asked& asked, const Run& run);
double culling_margin(const Asked& asked, const Run& run);
std::optional<Answer> any_vertex_outside(const Asked& asked, const Run& run);
inline constexpr std::array kPVertexRules{WrongRule{"opposite", &vertex_against}};
inline constexpr std::array kNVertexRules{WrongRule{"opposite", &vertex_along}};
inline constexpr std::array kPlaneSideRules{WrongRule{"center", &side_of_center},
                                            WrongRule{"p_vertex", &side_of_p_vertex}};
inline constexpr std::array kVerdictRules{WrongRule{"any_outside", &any_vertex_outside}};
/// "planes_left": the planes that the children of the volume must still be tested against.
const char* offer_planes_left(Asked& asked, const Run& run);
Truth planes_left_truth(const Asked& asked, const Run& run);
std::optional<Answer> every_plane(const Asked& asked, const Run& run);
std::optional<Answer> planes_passed(const Asked& asked, const Run& run);
inline constexpr std::array kPlanesLeftRules{WrongRule{"every", &every_plane}, WrongRule{"passed", &planes_passed}};

/// Whether a plane was tested against a box, by its vertices; else against a ball or a point, by its centre.
[[nodiscard]] inline bool of_box(const query::PlaneTested<double, 3>& fact) { return fact.p_vertex >= 0; }
/// What the test of a plane says by the centre of a ball, or of a point. body: "circle"
[[nodiscard]] std::string about_center(const query::PlaneTested<double, 3>& fact, const std::string& body);
/// "whole box is beyond", "point is beyond"
[[nodiscard]] std::string rejected_words(const std::string& body);

template <>
struct Entry<query::PlaneTested<double, 3>> : EntryDefaults {
  using Fact = query::PlaneTested<double, 3>;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "p_vertex",
                                                          .offer = &offer_vertices,
                                                          .truth = &p_vertex_truth,
                                                          .margin = &vertex_margin,
                                                          .rules = kPVertexRules},
                                             QuestionKind{.name = "n_vertex",
                                                          .offer = &offer_vertices,
                                                          .truth = &n_vertex_truth,
                                                          .margin = &vertex_margin,
                                                          .rules = kNVertexRules},
                                             QuestionKind{.name = "plane_side",
                                                          .offer = &offer_plane_sides,
                                                          .truth = &plane_side_truth,
                                                          .margin = &plane_side_margin,
                                                          .rules = kPlaneSideRules}};
  static std::string sentence(const Fact& fact, const FrustumWhere& where) {
    std::string plane = plane_name(where.dim(), fact.plane) + " plane: ";
    plane.front() = static_cast<char>(plane.front() - 'a' + 'A');
    if (where.run.has_no_normal(fact.plane)) return plane + "no normal is left of it, so it rejects nothing.";
    if (!of_box(fact) && !fact.skipped) return plane + about_center(fact, where.body());
    const std::string p = "p-vertex " + sign_name(where.dim(), fact.p_vertex),
                      n = "n-vertex " + sign_name(where.dim(), fact.n_vertex);
    const std::string p_by = number_text(std::abs(fact.p_distance)), n_by = number_text(std::abs(fact.n_distance));
    if (fact.skipped) return plane + "skipped, since the parent is inside it.";
    if (fact.looked_closer)
      return plane + "a vertex lies within rounding error of it; exact arithmetic says " + culling_name(fact.side) +
             ".";
    if (fact.side == query::Culling::kOutside)
      return plane + "even the " + n + " is outside, by " + n_by + ", so the whole box is.";
    if (fact.side == query::Culling::kInside)
      return plane + "even the " + p + " is inside, by " + p_by + ", so the whole box is.";
    return plane + "the " + p + " is outside by " + p_by + " and the " + n + " inside by " + n_by +
           ", so the box crosses it.";
  }
  /// The p-vertex, then the n-vertex.
  static std::vector<Index> handles(const Fact& fact, const FrustumWhere& where) {
    if (!of_box(fact)) return {0};
    std::vector<Index> named;
    for (const int vertex : {fact.p_vertex, fact.n_vertex})
      if (!fact.skipped) named.push_back(index_of(where.dim(), {BoxHandle::Kind::kCorner, 0, vertex}));
    return named;
  }
  static std::string predicate(const Fact& fact, const FrustumWhere&, bool) {
    return of_box(fact) ? "are the p- and the n-vertex" : "is tested against the plane";
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const FrustumWhere& where) {
    if (fact.side != query::Culling::kOutside) return std::nullopt;
    return where.loses() ? Mark::Kind::kWrong : Mark::Kind::kBest;
  }
};

template <>
struct Entry<query::CornerTested<double, 3>> : EntryDefaults {
  using Fact = query::CornerTested<double, 3>;
  static std::string sentence(const Fact& fact, const FrustumWhere& where) {
    const std::string vertex = "Vertex " + sign_name(where.dim(), fact.corner);
    if (fact.plane < 0) return vertex + " is inside every plane, so it lies in the frustum.";
    const std::string by = fact.distance == 0 ? "" : ", by " + number_text(std::abs(fact.distance));
    return vertex + (fact.outside ? " is outside the " : " is inside the ") + plane_name(where.dim(), fact.plane) +
           " plane" + by + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const FrustumWhere& where) {
    return {index_of(where.dim(), {BoxHandle::Kind::kCorner, 0, fact.corner})};
  }
  static std::string predicate(const Fact&, const FrustumWhere&, bool) { return "is tested against the frustum"; }
};

template <>
struct Entry<query::Classified> : EntryDefaults {
  using Fact = query::Classified;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "verdict",
                                                          .offer = &offer_cullings,
                                                          .truth = &culling_verdict_truth,
                                                          .figure = "verdict",
                                                          .margin = &culling_margin,
                                                          .rules = kVerdictRules},
                                             QuestionKind{.name = "planes_left",
                                                          .offer = &offer_planes_left,
                                                          .truth = &planes_left_truth,
                                                          .figure = "verdict",
                                                          .margin = &culling_margin,
                                                          .rules = kPlanesLeftRules}};
  static std::string sentence(const Fact& fact, const FrustumWhere& where) {
    using query::Culling;
    const query::CullResult& result = fact.result;
    const std::string wrong = where.loses() ? " Wrong: the " + where.body() + " reaches into the frustum." : "";
    if (result.rejected_by >= 0)
      return "Outside: the " + rejected_words(where.body()) + " the " + plane_name(where.dim(), result.rejected_by) +
             " plane; " + std::to_string(result.planes_tested) +
             (result.planes_tested == 1 ? " plane was tested." : " planes were tested.") + wrong;
    if (result.verdict == Culling::kOutside)
      return (where.body() == "box" ? "No vertex lies in the frustum"
                                    : "Part of the " + where.body() + " is outside a plane") +
             ", so this test says outside." + wrong;
    if (result.verdict == Culling::kInside)
      return where.body() == "box" ? "Inside: every vertex of the box is inside every plane."
                                   : "Inside: the " + where.body() + " is inside every plane.";
    if (result.crossing == 0) return "Intersecting: some vertices lie in the frustum and some do not.";
    return "Intersecting: the " + where.body() + " crosses " + plane_names(where.dim(), result.crossing) +
           " and is not entirely outside any.";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const FrustumWhere& where) {
    return where.loses() ? Mark::Kind::kWrong : Mark::Kind::kReplaced;
  }
};

}  // namespace snug::lesson
