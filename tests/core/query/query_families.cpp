#include "core/query/query_families.hpp"

#include "core/query/box_pairs.hpp"
#include "core/query/exact_boxes.hpp"
#include "core/query/exact_planes.hpp"
#include "core/query/grazing.hpp"
#include "core/query/lattice_pairs.hpp"
#include "core/query/tree_queries.hpp"
#include "query/cull/classify.hpp"
#include "query/overlap/obb_sat.hpp"

namespace snug::test {
namespace {

template <class Scalar, int Dim>
bool looked_closer(const auto& steps) {
  for (const auto& entry : steps.entries)
    if (std::holds_alternative<query::LookedCloser>(entry.step.fact)) return true;
  return false;
}

/// Slivers, needles and flat boxes among them, of any orientation, a corner of one on a face of the other.
template <class Scalar, int Dim>
void add_boxes(QueryTally& tally, Random& random) {
  constexpr std::array kGaps{0.0, 0.0, 1e-15, -1e-15, 1e-7, -1e-7, 1e-3, -1e-3};
  const auto orientation = static_cast<Orientation>(random.below(kOrientations));
  const auto extents = static_cast<Extents>(random.below(kExtents));
  const double gap = kGaps[random.below(8)];
  const double offset = random.below(2) * 1e5;
  const auto pair = pair_of<Scalar, Dim>(orientation, extents, gap, offset, random);
  const bool flat = pair.a.half_extents.minCoeff() == 0 || pair.b.half_extents.minCoeff() == 0;
  const bool overlap = flat ? exact::overlap_by_simplex(pair.a, pair.b) : exact::overlap_by_corners(pair.a, pair.b);
  Recorder<query::SatStep<Scalar, Dim>> steps;
  const auto found = query::obb_sat(pair.a, pair.b, query::SatExtent::kFirst, steps);
  const bool right = found.overlap == overlap && query::obbs_overlap(pair.a, pair.b) == overlap &&
                     query::obbs_overlap(pair.b, pair.a) == overlap;
  tally.count(overlap ? 1 : 0, right, looked_closer<Scalar, Dim>(steps));
}

template <class Scalar, int Dim>
class Cull {
 public:
  Cull(QueryTally& tally, const Scene<Scalar, Dim>& scene, Random& random)
      : tally_(tally), scene_(scene), random_(random) {}

  void run() {
    const auto size = [&] { return static_cast<Scalar>(scene_.size * random_.between(0.01, 0.4)); };
    switch (random_.below(5)) {
      case 0: return add_shape(somewhere());
      case 1: return add_shape(Sphere<Scalar, Dim>{somewhere(), size()});
      case 2: return add_shape(AabbCenterExtents<Scalar, Dim>{somewhere(), Vector<Scalar, Dim>::Constant(size())});
      case 3: {
        auto box = any_box<Scalar, Dim>(random_, 1, 0.01, 1);
        box.center = somewhere();
        box.half_extents *= size();
        return add_shape(box);
      }
      default: {
        const auto axes = any_turn<Dim>(random_);
        Lozenge<Scalar, Dim> lozenge{somewhere()};
        for (std::size_t i = 0; i < 2; ++i)
          lozenge.edges[i] = (axes.col(static_cast<int>(i)) * static_cast<double>(size())).template cast<Scalar>();
        lozenge.radius = size();
        return add_shape(lozenge);
      }
    }
  }

 private:
  Vector<Scalar, Dim> somewhere() {
    return (scene_.middle + scene_.size * any_vector<Dim>(random_, 1.4)).template cast<Scalar>();
  }

  template <class Shape>
  void add_shape(Shape shape) {
    graze(scene_.frustum[static_cast<int>(random_.below(2 * Dim))], shape, random_);
    query::ClassifyRecorder<Scalar, Dim> steps;
    const auto found = query::classify(scene_.frustum, shape, {}, steps).verdict;
    bool hard = false;
    for (const auto& entry : steps.entries)
      if (const auto* plane = std::get_if<query::PlaneTested<Scalar, Dim>>(&entry.step.fact))
        hard = hard || plane->looked_closer;
    const auto right = exact::classify(scene_.frustum, exact::sum_of(shape));
    tally_.count(static_cast<int>(right), found == right, hard);
  }

  QueryTally& tally_;
  const Scene<Scalar, Dim>& scene_;
  Random& random_;
};

template <class Scalar, int Dim>
Scene<Scalar, Dim> deep_scene(Random& random) {
  FrustumCamera<Scalar, Dim> camera;
  camera.position = any_vector<Dim>(random, 4).template cast<Scalar>();
  camera.axes = any_turn<Dim>(random).template cast<Scalar>();
  for (int i = 0; i < Dim - 1; ++i) camera.half_tangents[i] = static_cast<Scalar>(random.between(0.3, 1.5));
  camera.far = static_cast<Scalar>(random.between(8, 1000));
  camera.near = camera.far * static_cast<Scalar>(1e-6);
  const double size = random.below(2) == 0 ? static_cast<double>(camera.far) / 2 : 4 * static_cast<double>(camera.near);
  const Vector<double, Dim> back = camera.axes.col(Dim - 1).template cast<double>();
  return {*frustum_of_camera(camera), camera.position.template cast<double>() - size * back, size};
}

}  // namespace

template <class Scalar, int Dim>
void add_query(QueryTally& tally, std::size_t family, std::uint64_t seed) {
  Random random(seed * 8 + family);
  if (family == 0) return add_boxes<Scalar, Dim>(tally, random);
  if (family == 3) return add_lattice_pairs<Scalar, Dim>(tally, random);
  if (family == 4) return add_tree<Scalar, Dim>(tally, random);
  if (family == 5) {
    if constexpr (std::is_same_v<Scalar, double> && Dim == 3) add_field(tally, random);
    return;
  }
  const auto scene = family == 1 ? any_scene<Scalar, Dim>(static_cast<int>(random.below(kFrustumKinds)), random)
                                 : deep_scene<Scalar, Dim>(random);
  Cull<Scalar, Dim>(tally, scene, random).run();
}

template void add_query<float, 2>(QueryTally&, std::size_t, std::uint64_t);
template void add_query<float, 3>(QueryTally&, std::size_t, std::uint64_t);
template void add_query<double, 2>(QueryTally&, std::size_t, std::uint64_t);
template void add_query<double, 3>(QueryTally&, std::size_t, std::uint64_t);

}  // namespace snug::test
