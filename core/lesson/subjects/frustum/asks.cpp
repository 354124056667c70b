// What can be asked about a test of a box against a frustum.
#include <algorithm>
#include <limits>

#include "lesson/decide.hpp"
#include "lesson/subjects/frustum/entries.hpp"

namespace snug::lesson {
namespace {

using query::Culling;

const query::PlaneTested<double, 3>& plane_of(const Asked& asked, const Run& run) {
  return *std::get_if<query::PlaneTested<double, 3>>(&frustum_run(run).trace()[asked.fact].step.fact);
}

/// The truth about the p- or n-vertex: every vertex that is equally far is right.
Truth vertex_truth(const Asked& asked, const query::PlaneTested<double, 3>& tested, bool along) {
  Truth truth;
  const int vertices = along ? tested.p_corners : tested.n_corners;
  for (int vertex = 0; vertex < 1 << asked.dim; ++vertex)
    if ((vertices >> vertex & 1) != 0) {
      truth.choices.push_back(vertex);
      truth.points.push_back(index_of(asked.dim, {BoxHandle::Kind::kCorner, 0, vertex}));
    }
  truth.happened = asked.names(truth.points);
  truth.sentence = truth.happened + " " + (truth.points.size() > 1 ? "lie" : "lies") + " farthest " +
                   (along ? "along" : "against") + " the normal of the " + plane_name(asked.dim, tested.plane) +
                   " plane.";
  return truth;
}

/// Where a point can be, of one plane: in the order of kCullingNames.
constexpr std::array<std::string_view, 3> kPointSides{"in the negative half-space", "on the plane",
                                                      "in the positive half-space"};

bool of_point(const query::PlaneTested<double, 3>& fact, const Run& run) {
  return !of_box(fact) && frustum_run(run).body() == "point";
}

Truth culling_truth(Culling culling, std::string sentence) {
  return {{static_cast<int>(culling)}, {}, culling_name(culling), std::move(sentence)};
}

}  // namespace

std::string about_center(const query::PlaneTested<double, 3>& fact, const std::string& body) {
  const double distance = center_distance(fact), radius = (fact.p_distance - fact.n_distance) / 2;
  const std::string away = number_text(std::abs(distance));
  if (body == "point") {
    const std::string value = "n · p + d is " + std::string(distance > 0 ? "+" : "") + number_text(distance);
    if (distance == 0 || fact.looked_closer)
      return value + ", within rounding error of 0; exact arithmetic says " + culling_name(fact.side) + ".";
    return value + (fact.side == Culling::kOutside ? ": the point is in its positive half-space, outside the frustum."
                                                   : ": the point is in its negative half-space.");
  }
  if (fact.looked_closer)
    return "the " + body + " touches it within rounding error; exact arithmetic says " + culling_name(fact.side) + ".";
  std::string words = "the centre is " + std::string(distance > 0 ? "outside" : "inside") + " by " + away +
                      ", and the radius is " + number_text(radius);
  if (fact.side == Culling::kOutside && !(fact.n_distance > 0))
    return words + ": n · c + d + r is above 0, so this test says outside.";
  switch (fact.side) {
    case Culling::kOutside: return words + ": the whole " + body + " is outside.";
    case Culling::kInside: return words + ": the whole " + body + " is inside.";
    case Culling::kIntersecting: break;
  }
  return words + ": the " + body + " crosses it.";
}

std::string rejected_words(const std::string& body) {
  return body == "point" ? "point is beyond" : "whole " + body + " is beyond";
}

const char* offer_vertices(Asked& asked, const Run& run) {
  if (!of_box(plane_of(asked, run))) return "\"p_vertex\" and \"n_vertex\" are asked of boxes";
  asked.of = plane_name(asked.dim, plane_of(asked, run).plane);
  if (plane_of(asked, run).skipped) return "\"p_vertex\" and \"n_vertex\" cannot be asked of a skipped plane";
  asked.stage_points = vertices_of(asked.dim, 0);
  for (int vertex = 0; vertex < 1 << asked.dim; ++vertex)
    asked.add_choice(sign_name(asked.dim, vertex), {asked.stage_points[vertex]});
  asked.on_stage = true;
  return nullptr;
}

const char* offer_cullings(Asked& asked, const Run&) {
  for (const std::string_view name : query::kCullingNames) asked.add_choice(std::string(name));
  return nullptr;
}

const char* offer_plane_sides(Asked& asked, const Run& run) {
  asked.of = plane_name(asked.dim, plane_of(asked, run).plane);
  if (!of_point(plane_of(asked, run), run)) return offer_cullings(asked, run);
  for (const std::string_view side : kPointSides) asked.add_choice(std::string(side));
  return nullptr;
}

Truth p_vertex_truth(const Asked& asked, const Run& run) { return vertex_truth(asked, plane_of(asked, run), true); }
Truth n_vertex_truth(const Asked& asked, const Run& run) { return vertex_truth(asked, plane_of(asked, run), false); }

Truth plane_side_truth(const Asked& asked, const Run& run) {
  const auto& tested = plane_of(asked, run);
  const std::string plane = " the " + plane_name(asked.dim, tested.plane) + " plane";
  if (!of_box(tested)) {
    Truth truth = culling_truth(tested.side, "For" + plane + ", " + about_center(tested, frustum_run(run).body()));
    if (!of_point(tested, run)) return truth;
    const auto side = center_distance(tested) == 0 ? 1 : static_cast<int>(tested.side);
    truth.choices = {side};
    truth.happened = kPointSides[static_cast<std::size_t>(side)];
    return truth;
  }
  switch (tested.side) {
    case Culling::kOutside:
      return culling_truth(tested.side, "Even the n-vertex is outside" + plane + ", so the whole box is.");
    case Culling::kInside:
      return culling_truth(tested.side, "Even the p-vertex is inside" + plane + ", so the whole box is.");
    case Culling::kIntersecting: break;
  }
  return culling_truth(tested.side,
                       "The p-vertex is outside" + plane + " and the n-vertex is not: the box crosses it.");
}

Truth culling_verdict_truth(const Asked& asked, const Run& run) {
  const auto& result = std::get_if<query::Classified>(&frustum_run(run).trace()[asked.fact].step.fact)->result;
  if (result.rejected_by >= 0)
    return culling_truth(result.verdict, "The " + rejected_words(frustum_run(run).body()) + " the " +
                                             plane_name(asked.dim, result.rejected_by) + " plane.");
  if (result.crossing != 0)
    return culling_truth(result.verdict, "The " + frustum_run(run).body() + " crosses " +
                                             plane_names(asked.dim, result.crossing) +
                                             " and is not entirely outside any.");
  return culling_truth(result.verdict, "This test says " + culling_name(result.verdict) + ".");
}

// ---- margins and wrong rules --------------------------------------------------------------------------------

namespace {

/// How far the nearer of a volume's two farthest points is from a plane.
double nearest_to(const query::PlaneTested<double, 3>& tested) {
  return std::min(std::abs(tested.p_distance), std::abs(tested.n_distance));
}

}  // namespace

/// How far the p-vertex is ahead of its neighbour along the normal; the n-vertex lies as far behind.
double vertex_margin(const Asked& asked, const Run& run) {
  const auto& tested = plane_of(asked, run);
  const Rows planes = asked.subject->with_volumes()->planes();
  const std::vector<double>& row = planes[tested.plane];
  Scores along;
  for (const Index handle : vertices_of(asked.dim, 0)) {
    double value = 0;
    for (int i = 0; i < asked.dim; ++i) value += row[i] * asked.subject->at(handle)[i];
    along.add(static_cast<int>(handle), value);
  }
  return along.lead() / extent_of(*asked.subject);
}

std::optional<Answer> vertex_against(const Asked& asked, const Run& run) {
  return by_choice(plane_of(asked, run).n_vertex);
}
std::optional<Answer> vertex_along(const Asked& asked, const Run& run) {
  return by_choice(plane_of(asked, run).p_vertex);
}

double plane_side_margin(const Asked& asked, const Run& run) {
  return nearest_to(plane_of(asked, run)) / extent_of(*asked.subject);
}

std::optional<Answer> side_of_center(const Asked& asked, const Run& run) {
  const auto& tested = plane_of(asked, run);
  const bool out = tested.p_distance + tested.n_distance > 0;
  return by_choice(static_cast<int>(out ? Culling::kOutside : Culling::kInside));
}
std::optional<Answer> side_of_p_vertex(const Asked& asked, const Run& run) {
  return by_choice(static_cast<int>(plane_of(asked, run).p_distance > 0 ? Culling::kOutside : Culling::kInside));
}

double culling_margin(const Asked& asked, const Run& run) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& entry : frustum_run(run).trace())
    if (const auto* tested = std::get_if<query::PlaneTested<double, 3>>(&entry.step.fact); tested && !tested->skipped)
      least = std::min(least, nearest_to(*tested));
  return least / extent_of(*asked.subject);
}

/// As if a box were outside as soon as one of its vertices is.
std::optional<Answer> any_vertex_outside(const Asked&, const Run& run) {
  bool out = false;
  for (const auto& entry : frustum_run(run).trace())
    if (const auto* tested = std::get_if<query::PlaneTested<double, 3>>(&entry.step.fact))
      out = out || tested->p_distance > 0;
  return by_choice(static_cast<int>(out ? Culling::kOutside : Culling::kInside));
}

// ---- the planes that children are tested against ------------------------------------------------------------

namespace {

PlaneSet crossed(const Asked& asked, const Run& run) {
  const auto& result = std::get_if<query::Classified>(&frustum_run(run).trace()[asked.fact].step.fact)->result;
  return result.rejected_by < 0 ? result.crossing : 0;
}

}  // namespace

const char* offer_planes_left(Asked& asked, const Run& run) {
  if (crossed(asked, run) == 0) return "\"planes_left\" can only be asked of a volume that crosses a plane";
  for (int plane = 0; plane < std::ssize(asked.subject->with_volumes()->planes()); ++plane)
    asked.add_choice(plane_name(asked.dim, plane));
  asked.many = true;
  return nullptr;
}

Truth planes_left_truth(const Asked& asked, const Run& run) {
  const PlaneSet planes = crossed(asked, run);
  Truth truth;
  for (int plane = 0; plane < std::ssize(asked.choices); ++plane)
    if ((planes >> plane & 1) != 0) truth.choices.push_back(plane);
  truth.happened = plane_names(asked.dim, planes);
  truth.sentence = "The " + frustum_run(run).body() + " crosses " + truth.happened +
                   ", and is inside every other plane, as all in it is.";
  return truth;
}

std::optional<Answer> every_plane(const Asked& asked, const Run&) { return by_every_choice(asked); }
/// Those that the volume is inside of.
std::optional<Answer> planes_passed(const Asked& asked, const Run& run) {
  SeveralChoices passed = by_every_choice(asked);
  std::erase_if(passed.choices, [&](int plane) { return (crossed(asked, run) >> plane & 1) != 0; });
  return passed.choices.empty() ? std::nullopt : std::optional<Answer>(std::move(passed));
}

}  // namespace snug::lesson
