#include "query/wrong_corners_outside.hpp"

#include "query/frustum_sat.hpp"

namespace snug::query {

template <class Scalar, int Dim>
std::optional<LostBox<Scalar, Dim>> against_corners_outside(const Frustum<Scalar, Dim>& frustum, std::uint64_t seed,
                                                            int tries) {
  const auto exact = FrustumSat<Scalar, Dim>::make(frustum);
  const auto corners = corners_of(frustum);
  if (!exact || !corners) return std::nullopt;
  Vector<Scalar, Dim> middle = Vector<Scalar, Dim>::Zero();
  for (const auto& corner : *corners) middle += corner / static_cast<Scalar>(corners->size());
  Scalar size = 0;
  for (const auto& corner : *corners) size = std::max(size, (corner - middle).cwiseAbs().maxCoeff());
  Random random(seed);
  for (int i = 0; i < tries; ++i) {
    Obb<Scalar, Dim> box = random_box<Scalar, Dim>(random);
    box.center = middle + box.center * size;
    box.half_extents *= size;
    if (corners_outside(frustum, box).verdict == Culling::kOutside && exact->overlaps(box))
      return LostBox<Scalar, Dim>{box, i};
  }
  return std::nullopt;
}

template std::optional<LostBox<float, 2>> against_corners_outside(const Frustum<float, 2>&, std::uint64_t, int);
template std::optional<LostBox<float, 3>> against_corners_outside(const Frustum<float, 3>&, std::uint64_t, int);
template std::optional<LostBox<double, 2>> against_corners_outside(const Frustum<double, 2>&, std::uint64_t, int);
template std::optional<LostBox<double, 3>> against_corners_outside(const Frustum<double, 3>&, std::uint64_t, int);

}  // namespace snug::query
