#include "lesson/subjects/pair/feature.hpp"

#include <array>

namespace snug::lesson {
namespace {

using FeatureKind = RectangleFeature::Kind;

constexpr double kAtEnd = 1e-9;  // how far from an edge's end a point may be that counts as the end, in edges

const query::CoresCompared& cores_of(const Asked& asked, const Run& run) {
  return *std::get_if<query::CoresCompared>(&pair_run(run).trace()[asked.fact].step.fact);
}

/// Null where B is no lozenge.
const Lozenge<double, 3>* rectangle_of(const Asked& asked) {
  const auto* volumes = as<VolumesSubject>(*asked.subject);
  return volumes != nullptr ? std::get_if<Lozenge<double, 3>>(&volumes->pair().held[1].volume) : nullptr;
}

}  // namespace

RectangleFeature feature_at(const Lozenge<double, 3>& lozenge, const Point3& at) {
  std::vector<std::array<double, 2>> places{{0, 0}};  // of the vertices, in edges from the origin
  for (std::size_t i = 0; i < 2; ++i) {
    const Point3& edge = lozenge.edges[i];
    const double square = edge.squaredNorm();
    const double share = square > 0 ? (at - lozenge.origin).dot(edge) / square : 0;
    const bool inside = share > kAtEnd && share < 1 - kAtEnd;
    for (auto& place : places) place[i] = !inside && share > 0.5 ? 1 : 0;
    if (!inside) continue;
    for (std::size_t k = places.size(); k-- > 0;) {  // back along the other end, so that they stay in order around it
      places.push_back(places[k]);
      places.back()[i] = 1;
    }
  }
  RectangleFeature feature{places.size() == 1   ? FeatureKind::kVertex
                           : places.size() == 2 ? FeatureKind::kEdge
                                                : FeatureKind::kFace,
                           {}};
  for (const auto& [u, v] : places)
    feature.corners.push_back(lozenge.origin + u * lozenge.edges[0] + v * lozenge.edges[1]);
  return feature;
}

const char* offer_features(Asked& asked, const Run& run) {
  if (rectangle_of(asked) == nullptr) return "\"feature\" can only be asked where B is a lozenge";
  if (!(cores_of(asked, run).distance > 0)) return "\"feature\" can only be asked of cores that are apart";
  asked.add_choice("a vertex");
  asked.add_choice("an edge");
  if (asked.dim == 3) asked.add_choice("the face");  // in the plane a core outside never comes nearest to it
  return nullptr;
}

Truth feature_truth(const Asked& asked, const Run& run) {
  const int kind = static_cast<int>(feature_at(*rectangle_of(asked), cores_of(asked, run).on_b).kind);
  const std::string& choice = asked.choices[kind];
  return {{kind}, {}, choice, "The nearest point of B's rectangle lies on " + choice + "."};
}

}  // namespace snug::lesson
