#include "core/query/tree_queries.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/query/exact_planes.hpp"
#include "core/query/grazing.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/cull.hpp"
#include "hierarchy/field.hpp"
#include "hierarchy/traverse_self.hpp"

namespace snug::test {
namespace {

using query::Culling;
using AllVerdicts = std::vector<Culling>;

constexpr std::size_t kInTree = 12, kInField = 80;

template <class Scalar, int Dim>
void draw_body(Aabb<Scalar, Dim>& box, const Vector<double, Dim>& middle, double size, Random& random) {
  for (int i = 0; i < Dim; ++i) {
    const double half = size * random.between(0.01, 0.4);
    box.min[i] = static_cast<Scalar>(middle[i] - half), box.max[i] = static_cast<Scalar>(middle[i] + half);
  }
}
template <class Scalar, int Dim>
void draw_body(Sphere<Scalar, Dim>& sphere, const Vector<double, Dim>& middle, double size, Random& random) {
  sphere = {middle.template cast<Scalar>(), static_cast<Scalar>(size * random.between(0.01, 0.4))};
}

/// Anywhere about the frustum; one in two touches one of its planes within some units in the last place.
template <class Body, class Scalar, int Dim>
Body body_near(const Scene<Scalar, Dim>& scene, Random& random) {
  Body body;
  const Vector<double, Dim> middle = scene.middle + scene.size * any_vector<Dim>(random, 1.4);
  draw_body<Scalar, Dim>(body, middle, scene.size, random);
  if (random.below(2) == 0) graze(scene.frustum[static_cast<int>(random.below(2 * Dim))], body, random);
  return body;
}

template <class Scalar, int Dim, class Body>
bool was_close(const Frustum<Scalar, Dim>& frustum, const Body& body) {
  query::ClassifyRecorder<Scalar, Dim> steps;
  query::classify(frustum, body, {}, steps);
  return std::any_of(steps.entries.begin(), steps.entries.end(), [](const auto& entry) {
    const auto* plane = std::get_if<query::PlaneTested<Scalar, Dim>>(&entry.step.fact);
    return plane != nullptr && plane->looked_closer;
  });
}

template <class Body>
hierarchy::Tree<Body> any_tree(const std::vector<Body>& bodies, Random& random) {
  const hierarchy::Options options{1 + static_cast<Index>(random.below(4))};
  switch (random.below(4)) {
    case 0: return hierarchy::build_median<Body>(bodies, options);
    case 1: return hierarchy::build_surface_area<Body>(bodies, options);
    case 2: return hierarchy::build_bottom_up<Body>(bodies);
    default: return hierarchy::build_by_insertion<Body>(bodies);
  }
}

/// None where a body is reported twice.
template <class Scalar, int Dim, class Body>
AllVerdicts culled(const hierarchy::Tree<Body>& tree, const std::vector<Body>& bodies,
                   const Frustum<Scalar, Dim>& frustum, bool masks) {
  AllVerdicts verdicts(bodies.size(), Culling::kOutside);
  bool twice = false;
  const auto take = [&](Index body, Culling verdict) {
    twice = twice || verdicts[body] != Culling::kOutside;
    verdicts[body] = verdict;
  };
  hierarchy::cull(tree, bodies, frustum, take, Ignore(), masks);
  return twice ? AllVerdicts(bodies.size(), Culling::kOutside) : verdicts;
}

template <class Body>
bool finds_each_pair_once(const hierarchy::Tree<Body>& tree, const std::vector<Body>& bodies) {
  std::vector<std::pair<Index, Index>> found, wanted;
  hierarchy::overlapping_pairs_within(tree, bodies, [&](Index i, Index j) { found.push_back(std::minmax(i, j)); });
  for (std::size_t j = 1; j < bodies.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (query::overlaps(bodies[i], bodies[j])) wanted.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
  std::sort(found.begin(), found.end()), std::sort(wanted.begin(), wanted.end());
  return found == wanted;
}

template <class Scalar, int Dim, class Body>
void count_all(QueryTally& tally, const Frustum<Scalar, Dim>& frustum, const std::vector<Body>& bodies,
               const std::vector<AllVerdicts>& answers, bool pairs_right) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Culling truth = exact::classify(frustum, exact::sum_of(bodies[i]));
    const bool right = std::all_of(answers.begin(), answers.end(), [&](const auto& all) { return all[i] == truth; });
    tally.count(static_cast<int>(truth), right && pairs_right, was_close(frustum, bodies[i]));
  }
}

template <class Body, class Scalar, int Dim>
void add_tree_of(QueryTally& tally, const Scene<Scalar, Dim>& scene, Random& random) {
  std::vector<Body> bodies(kInTree);
  for (Body& body : bodies) body = body_near<Body>(scene, random);
  hierarchy::Tree<Body> tree = any_tree(bodies, random);
  for (int round = 0; round < 2; ++round) {
    if (round > 0) {
      for (std::size_t i = 0; i < kInTree; i += 2) bodies[i] = body_near<Body>(scene, random);
      hierarchy::refit<Body>(tree, bodies);
    }
    const auto plain = culled(tree, bodies, scene.frustum, false), masked = culled(tree, bodies, scene.frustum, true);
    count_all(tally, scene.frustum, bodies, {plain, masked}, finds_each_pair_once(tree, bodies));
  }
}

}  // namespace

template <class Scalar, int Dim>
void add_tree(QueryTally& tally, Random& random) {
  const auto scene = any_scene<Scalar, Dim>(static_cast<int>(random.below(kFrustumKinds)), random);
  if (random.below(2) == 0) add_tree_of<Aabb<Scalar, Dim>>(tally, scene, random);
  else add_tree_of<Sphere<Scalar, Dim>>(tally, scene, random);
}

void add_field(QueryTally& tally, Random& random) {
  const auto scene = any_scene<double, 3>(static_cast<int>(random.below(kFrustumKinds)), random);
  std::vector<Aabb<double, 3>> boxes(kInField);
  for (auto& box : boxes) box = body_near<Aabb<double, 3>>(scene, random);
  const hierarchy::Field field(boxes);
  std::vector<std::int8_t> last(kInField);
  for (auto& plane : last) plane = static_cast<std::int8_t>(static_cast<int>(random.below(7)) - 1);
  std::vector<AllVerdicts> answers;
  for (std::size_t way = 0; way < hierarchy::kFieldWayNames.size(); ++way) {
    AllVerdicts verdicts(kInField);
    hierarchy::cull_field(field, scene.frustum, static_cast<hierarchy::FieldWay>(way), last, verdicts);
    answers.push_back(std::move(verdicts));
  }
  count_all(tally, scene.frustum, boxes, answers, true);
}

template void add_tree<float, 2>(QueryTally&, Random&);
template void add_tree<float, 3>(QueryTally&, Random&);
template void add_tree<double, 2>(QueryTally&, Random&);
template void add_tree<double, 3>(QueryTally&, Random&);

}  // namespace snug::test
