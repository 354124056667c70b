#include "core/query/box_pairs.hpp"

#include <cmath>
#include <limits>

namespace snug::test {

namespace {

/// Moves b so that a place on its surface lies beside one on a's, outwards from it by gap: faces, edges and corners
/// meet.
template <class Scalar, int Dim>
void bring_together(BoxPair<Scalar, Dim>& pair, double gap, Random& random) {
  const auto place = [&](const Obb<Scalar, Dim>& box, int face, double side) {
    Vector<double, Dim> local;
    for (int i = 0; i < Dim; ++i) {
      const unsigned kind = random.below(3);
      const double share = i == face ? side : kind == 0 ? -1 : kind == 1 ? 1 : random.between(-1, 1);
      local[i] = share * static_cast<double>(box.half_extents[i]);
    }
    return Vector<double, Dim>(box.axes.template cast<double>() * local);
  };
  const int face = static_cast<int>(random.below(Dim));
  const double side = random.below(2) == 0 ? -1 : 1;
  const Vector<double, Dim> outwards = side * pair.a.axes.col(face).template cast<double>();
  const int face_of_b = static_cast<int>(random.below(Dim));
  const double side_of_b = random.below(2) == 0 ? -1 : 1;
  Vector<double, Dim> on_b = place(pair.b, face_of_b, side_of_b);
  if (on_b.dot(outwards) > 0) on_b = -on_b;
  pair.b.center = (pair.a.center.template cast<double>() + place(pair.a, face, side) + gap * outwards - on_b)
                      .template cast<Scalar>();
}

template <class Scalar, int Dim>
void orient(BoxPair<Scalar, Dim>& pair, Orientation how, Random& random) {
  using Turn = Matrix<double, Dim>;
  const Turn base = random.below(3) == 0 ? Turn(Turn::Identity()) : any_turn<Dim>(random);
  Turn other = any_turn<Dim>(random);
  pair.a.axes = base.template cast<Scalar>();
  if (how == Orientation::kSharedAxis) {
    if constexpr (Dim == 3) {
      const Vector<double, 3> shared = Vector<double, 3>::Unit(static_cast<int>(random.below(3)));
      other = base * turn(shared, random.between(-3, 3));
    }
  } else if (how == Orientation::kTilted) {
    const double tilt = std::pow(10.0, -2 - static_cast<int>(random.below(7)));
    if constexpr (Dim == 2) other = turn(tilt) * base;
    else other = turn(any_vector<3>(random), tilt) * base;
  }
  pair.b.axes = other.template cast<Scalar>();
  if (how == Orientation::kSame || how == Orientation::kPermuted) pair.b.axes = pair.a.axes;
  if (how == Orientation::kPermuted)
    for (int i = 0; i < Dim; ++i)
      pair.b.axes.col(i) = pair.a.axes.col((i + 1) % Dim) * Scalar(random.below(2) == 0 ? 1 : -1);
  if (how == Orientation::kCrooked)  // as far from unit and perpendicular as a box may be
    for (int i = 0; i < Dim; ++i)
      for (int j = 0; j < Dim; ++j)
        for (auto* box : {&pair.a, &pair.b})
          box->axes(i, j) *=
              1 + static_cast<Scalar>(random.between(-8, 8)) * std::numeric_limits<Scalar>::epsilon() / 2;
}

template <class Scalar, int Dim>
void size_up(Obb<Scalar, Dim>& box, Extents how, Random& random) {
  for (int i = 0; i < Dim; ++i) box.half_extents[i] = static_cast<Scalar>(random.between(0.2, 1));
  const int odd = static_cast<int>(random.below(Dim));
  switch (how) {
    case Extents::kAny: break;
    case Extents::kMixed:
      for (int i = 0; i < Dim; ++i)
        box.half_extents[i] *= static_cast<Scalar>(std::pow(10.0, static_cast<int>(random.below(8)) - 4));
      break;
    case Extents::kSlivers: box.half_extents[odd] *= Scalar(1e-6); break;
    case Extents::kFlats: box.half_extents[odd] = 0; break;
    case Extents::kLines:
      for (int i = 0; i < Dim; ++i)
        if (i != odd) box.half_extents[i] = 0;
      break;
    case Extents::kPoints: box.half_extents.setZero(); break;
  }
}

}  // namespace

template <class Scalar, int Dim>
BoxPair<Scalar, Dim> pair_of(Orientation orientation, Extents extents, double gap, double offset, Random& random) {
  BoxPair<Scalar, Dim> pair;
  orient(pair, orientation, random);
  size_up(pair.a, extents, random);
  size_up(pair.b, random.below(2) == 0 ? extents : static_cast<Extents>(random.below(kExtents)), random);
  pair.a.center = (any_vector<Dim>(random, 0.5) + Vector<double, Dim>::Constant(offset)).template cast<Scalar>();
  bring_together(pair, gap, random);
  return pair;
}

template BoxPair<float, 2> pair_of(Orientation, Extents, double, double, Random&);
template BoxPair<float, 3> pair_of(Orientation, Extents, double, double, Random&);
template BoxPair<double, 2> pair_of(Orientation, Extents, double, double, Random&);
template BoxPair<double, 3> pair_of(Orientation, Extents, double, double, Random&);

}  // namespace snug::test
