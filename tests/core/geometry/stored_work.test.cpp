// A volume that is updated as it is stored is the volume that was moved, turned or grown; and what that takes.
#include "geometry/stored_work.hpp"

#include <doctest/doctest.h>

#include "geometry/random.hpp"
#include "geometry/turn.hpp"

using namespace snug;

namespace {

constexpr double kClose = 1e-12;

template <int Dim>
Vector<double, Dim> any_vector(Random& random) {
  Vector<double, Dim> v;
  for (int i = 0; i < Dim; ++i) v[i] = random.between(-2, 2);
  return v;
}

template <int Dim>
Pose<double, Dim> any_pose(Random& random) {
  Pose<double, Dim> pose;
  if constexpr (Dim == 2) pose.rotation = turn(random.between(-3, 3));
  else pose.rotation = turn(any_vector<3>(random), random.between(-3, 3));
  pose.translation = any_vector<Dim>(random);
  return pose;
}

template <int Dim>
Obb<double, Dim> any_box(Random& random) {
  Obb<double, Dim> box{any_vector<Dim>(random), any_pose<Dim>(random).rotation, any_vector<Dim>(random).cwiseAbs()};
  return box;
}

/// The box that a pose makes of another, about the world's origin.
template <int Dim>
Obb<double, Dim> carried(const Obb<double, Dim>& box, const Pose<double, Dim>& pose) {
  return {pose.rotation * box.center + pose.translation, pose.rotation * box.axes, box.half_extents};
}

template <int Dim>
void check_box_forms(std::uint64_t seed) {
  Random random(seed);
  const Obb<double, Dim> box = any_box<Dim>(random);
  const Pose<double, Dim> pose = any_pose<Dim>(random);
  const Obb<double, Dim> due = carried(box, pose);
  Work vertices, planes, slabs, own;
  const auto v = placed<ObbVertices<double, Dim>, Dim>(vertices, vertices_of(box), pose);
  for (std::size_t i = 0; i < v.size(); ++i) CHECK((v[i] - vertices_of(due)[i]).norm() < kClose);
  const auto p = placed<ObbPlanes<double, Dim>, Dim>(planes, planes_of(box), pose);
  for (std::size_t i = 0; i < p.size(); ++i) {
    CHECK((p[i].normal - planes_of(due)[i].normal).norm() < kClose);
    CHECK(std::abs(p[i].d - planes_of(due)[i].d) < kClose);
  }
  const auto s = placed<ObbSlabs<double, Dim>, Dim>(slabs, slabs_of(box), pose);
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK((s[i].normal - slabs_of(due)[i].normal).norm() < kClose);
    CHECK(std::abs(s[i].min - slabs_of(due)[i].min) < kClose);
    CHECK(std::abs(s[i].max - slabs_of(due)[i].max) < kClose);
  }
  const auto o = placed<Obb<double, Dim>, Dim>(own, box, pose);
  CHECK((o.center - due.center).norm() < kClose);
  CHECK((o.axes - due.axes).norm() < kClose);
  CHECK(o.half_extents == due.half_extents);
  // A matrix times a vector takes Dim squared multiplications.
  constexpr int kProduct = Dim * Dim, kVertices = 1 << Dim, kPlanes = 2 * Dim;
  CHECK(vertices.multiplications == kVertices * kProduct);
  CHECK(planes.multiplications == kPlanes * (kProduct + Dim));
  CHECK(slabs.multiplications == Dim * (kProduct + Dim));
  CHECK(own.multiplications == kProduct + Dim * kProduct);  // one point and one matrix
}

template <class Volume, int Dim>
void check_swept(const Volume& volume, Random& random, int moved_numbers, int products) {
  const Pose<double, Dim> pose = any_pose<Dim>(random);
  const Vector<double, Dim> by = pose.translation;
  Work move, turn, grow;
  const Volume there = moved<Dim>(move, volume, by);
  const Volume due = moved(volume, by);
  const bool same = Volume::tie(there) == Volume::tie(due);
  CHECK(same);
  CHECK(move.additions == moved_numbers);
  CHECK(move.multiplications == 0);
  static_cast<void>(turned<Dim>(turn, volume, pose.rotation));
  CHECK(turn.multiplications == products * Dim * Dim);
  CHECK(grown<Dim>(grow, volume, 0.25).radius == volume.radius + 0.25);
  CHECK(grow.all() == 1);
}

}  // namespace

TEST_CASE(
    "each form of an oriented box that is placed is that form of the placed box, at the count that its size says") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) check_box_forms<2>(seed), check_box_forms<3>(seed);
}

TEST_CASE("in space the centre with its axes takes 36 multiplications, and eight vertices 72") {
  Random random(5);
  const Obb<double, 3> box = any_box<3>(random);
  const Pose<double, 3> pose = any_pose<3>(random);
  Work vertices, own;
  static_cast<void>(placed<ObbVertices<double, 3>, 3>(vertices, vertices_of(box), pose));
  static_cast<void>(placed<Obb<double, 3>, 3>(own, box, pose));
  CHECK(vertices.multiplications == 72);
  CHECK(own.multiplications == 36);
}

TEST_CASE_TEMPLATE(
    "each form of an axis-aligned box that is moved or grown is the box that was, and half of it may stay", Dimension,
    std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
  constexpr int kDim = Dimension::value;
  using V = Vector<double, kDim>;
  // Coordinates that are sums of few powers of two: nothing is rounded.
  const V least = V::Constant(-1.25), greatest = V::Constant(0.5), by = V::Constant(0.375);
  const Aabb<double, kDim> box{least, greatest};
  Work min_max, min_widths, centered;
  CHECK(moved<kDim>(min_max, box, by).max == V(greatest + by));
  const auto widths = moved<kDim>(min_widths, min_widths_of(box), by);
  const auto center = moved<kDim>(centered, center_extents_of(box), by);
  CHECK(min_max_of(widths).min == V(least + by));
  CHECK(min_max_of(widths).max == V(greatest + by));
  CHECK(min_max_of(center).min == V(least + by));
  CHECK(min_max_of(center).max == V(greatest + by));
  CHECK(min_max.all() == 2 * kDim);
  CHECK(min_widths.all() == kDim);
  CHECK(centered.all() == kDim);
  Work grow_max, grow_widths, grow_center;
  const V more = V::Constant(0.125);
  CHECK(grown<kDim>(grow_max, box, 0.125).min == V(least - more));
  CHECK(min_max_of(grown<kDim>(grow_widths, min_widths_of(box), 0.125)).max == V(greatest + more));
  CHECK(min_max_of(grown<kDim>(grow_center, center_extents_of(box), 0.125)).min == V(least - more));
  CHECK(grow_center.all() == kDim);
  CHECK(grow_center.all() < grow_max.all());
  CHECK(grow_max.all() < grow_widths.all());
}

TEST_CASE("swept spheres move by their core and grow by their radius alone") {
  Random random(3);
  const auto v2 = [&] { return any_vector<2>(random); };
  const auto v3 = [&] { return any_vector<3>(random); };
  check_swept<Sphere<double, 2>, 2>({v2(), 0.5}, random, 2, 1);
  check_swept<Sphere<double, 3>, 3>({v3(), 0.5}, random, 3, 1);
  check_swept<Capsule<double, 2>, 2>({v2(), v2(), 0.5}, random, 4, 2);
  check_swept<Capsule<double, 3>, 3>({v3(), v3(), 0.5}, random, 6, 2);
  check_swept<Lozenge<double, 3>, 3>({v3(), {v3(), v3()}, 0.5}, random, 3, 3);
}

TEST_CASE("the bounds of a k-DOP move by sums alone, and grow by the length of their axes") {
  Kdop<double, 3> kdop{.k = 14};
  const auto axes = kdop_axes<3>(14);
  for (std::size_t i = 0; i < axes.size(); ++i) kdop.min[i] = -1, kdop.max[i] = 1 + 0.25 * static_cast<double>(i);
  const Vector<double, 3> by(0.5, -0.25, 1);
  Work move, grow;
  const auto there = moved<3>(move, kdop, by);
  const auto larger = grown<3>(grow, kdop, 0.5);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double along = project<double, 3>(axes[i], by);
    double square = 0;
    for (const int entry : axes[i]) square += entry * entry;
    CHECK(there.min[i] == kdop.min[i] + along);
    CHECK(there.max[i] == kdop.max[i] + along);
    CHECK(larger.max[i] == doctest::Approx(kdop.max[i] + 0.5 * std::sqrt(square)));
  }
  CHECK(move.multiplications == 0);
  CHECK(move.additions == 14 + 2 * 4);  // both bounds, and two sums for each diagonal
  CHECK(grow.multiplications == 4);     // the diagonals
}
