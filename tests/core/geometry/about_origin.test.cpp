// A volume that is updated as it is stored is the volume that was moved, turned or grown; and what that takes.
#include "geometry/about_origin.hpp"

#include <doctest/doctest.h>

#include "geometry/counted.hpp"
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

/// As a pose does with a form.
template <int Dim, class Scalar>
auto carried_form(const auto& form, const Pose<Scalar, Dim>& pose) {
  return moved(turned_about_origin(form, pose.rotation), pose.translation);
}

/// What that takes.
template <int Dim>
Work work_to_carry(const auto& form) {
  return work_of([&] { return carried_form<Dim>(form, Pose<Counted, Dim>()); });
}

template <int Dim>
void check_box_forms(std::uint64_t seed) {
  Random random(seed);
  const Obb<double, Dim> box = any_box<Dim>(random);
  const Pose<double, Dim> pose = any_pose<Dim>(random);
  const Obb<double, Dim> due = carried(box, pose);
  const auto v = carried_form<Dim>(vertices_of(box), pose);
  for (std::size_t i = 0; i < v.size(); ++i) CHECK((v[i] - vertices_of(due)[i]).norm() < kClose);
  const auto p = carried_form<Dim>(planes_of(box), pose);
  for (std::size_t i = 0; i < p.size(); ++i) {
    CHECK((p[i].normal - planes_of(due)[i].normal).norm() < kClose);
    CHECK(std::abs(p[i].d - planes_of(due)[i].d) < kClose);
  }
  const auto s = carried_form<Dim>(slabs_of(box), pose);
  for (std::size_t i = 0; i < s.size(); ++i) {
    CHECK((s[i].normal - slabs_of(due)[i].normal).norm() < kClose);
    CHECK(std::abs(s[i].min - slabs_of(due)[i].min) < kClose);
    CHECK(std::abs(s[i].max - slabs_of(due)[i].max) < kClose);
  }
  const auto o = carried_form<Dim>(box, pose);
  CHECK((o.center - due.center).norm() < kClose);
  CHECK((o.axes - due.axes).norm() < kClose);
  CHECK(o.half_extents == due.half_extents);
  CHECK((posed(box, pose).axes - due.axes).norm() < kClose);
  const Work vertices = work_to_carry<Dim>(ObbVertices<Counted, Dim>{});
  const Work planes = work_to_carry<Dim>(ObbPlanes<Counted, Dim>{});
  const Work slabs = work_to_carry<Dim>(ObbSlabs<Counted, Dim>{}), own = work_to_carry<Dim>(Obb<Counted, Dim>{});
  // A matrix times a vector takes Dim squared multiplications.
  constexpr int kProduct = Dim * Dim, kVertices = 1 << Dim, kPlanes = 2 * Dim;
  CHECK(vertices.multiplications == kVertices * kProduct);
  CHECK(planes.multiplications == kPlanes * (kProduct + Dim));
  CHECK(slabs.multiplications == Dim * (kProduct + Dim));
  CHECK(own.multiplications == kProduct + Dim * kProduct);  // one point and one matrix
}

template <template <class, int> class Kind, int Dim>
void check_swept(int moved_numbers, int products) {
  const Kind<Counted, Dim> volume;
  const Vector<Counted, Dim> by = Vector<Counted, Dim>::Zero();
  const Matrix<Counted, Dim> rotation = Matrix<Counted, Dim>::Identity();
  const Work move = work_of([&] { return moved(volume, by); });
  CHECK(move.additions == moved_numbers);
  CHECK(move.multiplications == 0);
  CHECK(work_of([&] { return turned_about_origin(volume, rotation); }).multiplications == products * Dim * Dim);
  CHECK(work_of([&] { return grown(volume, 0.25); }).all() == 1);
  CHECK(grown(Kind<double, Dim>(), 0.25).radius == 0.25);
}

}  // namespace

TEST_CASE(
    "each form of an oriented box that is placed is that form of the placed box, at the count that its size says") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) check_box_forms<2>(seed), check_box_forms<3>(seed);
}

TEST_CASE("in space the centre with its axes takes 36 multiplications, and eight vertices 72") {
  CHECK(work_to_carry<3>(ObbVertices<Counted, 3>{}).multiplications == 72);
  CHECK(work_to_carry<3>(Obb<Counted, 3>{}).multiplications == 36);
  CHECK(work_to_carry<3>(Obb<Counted, 3>{}).additions == 27);
}

TEST_CASE_TEMPLATE(
    "each form of an axis-aligned box that is moved or grown is the box that was, and half of it may stay", Dimension,
    std::integral_constant<int, 2>, std::integral_constant<int, 3>) {
  constexpr int kDim = Dimension::value;
  using V = Vector<double, kDim>;
  // Coordinates that are sums of few powers of two: nothing is rounded.
  const V least = V::Constant(-1.25), greatest = V::Constant(0.5), by = V::Constant(0.375);
  const Aabb<double, kDim> box{least, greatest};
  CHECK(moved(box, by).max == V(greatest + by));
  const auto widths = moved(min_widths_of(box), by);
  const auto center = moved(center_extents_of(box), by);
  CHECK(min_max_of(widths).min == V(least + by));
  CHECK(min_max_of(widths).max == V(greatest + by));
  CHECK(min_max_of(center).min == V(least + by));
  CHECK(min_max_of(center).max == V(greatest + by));
  const V more = V::Constant(0.125);
  CHECK(grown(box, 0.125).min == V(least - more));
  CHECK(min_max_of(grown(min_widths_of(box), 0.125)).max == V(greatest + more));
  CHECK(min_max_of(grown(center_extents_of(box), 0.125)).min == V(least - more));

  const Vector<Counted, kDim> any = Vector<Counted, kDim>::Zero();
  const auto to_move = [&](const auto& form) { return work_of([&] { return moved(form, any); }).all(); };
  CHECK(to_move(Aabb<Counted, kDim>()) == 2 * kDim);
  CHECK(to_move(AabbMinWidths<Counted, kDim>()) == kDim);
  CHECK(to_move(AabbCenterExtents<Counted, kDim>()) == kDim);
  const auto to_grow = [&](const auto& form) { return work_of([&] { return grown(form, 0.125); }).all(); };
  CHECK(to_grow(AabbCenterExtents<Counted, kDim>()) == kDim);
  CHECK(to_grow(Aabb<Counted, kDim>()) == 2 * kDim);
  CHECK(to_grow(AabbMinWidths<Counted, kDim>()) == 2 * kDim + 1);
}

TEST_CASE("swept spheres move by their core and grow by their radius alone") {
  check_swept<Sphere, 2>(2, 1);
  check_swept<Sphere, 3>(3, 1);
  check_swept<Capsule, 2>(4, 2);
  check_swept<Capsule, 3>(6, 2);
  check_swept<Lozenge, 3>(3, 3);
}

TEST_CASE("the bounds of a k-DOP move by sums alone, and grow by the length of their axes") {
  Kdop<double, 3> kdop{.k = 14};
  const auto axes = kdop_axes<3>(14);
  for (std::size_t i = 0; i < axes.size(); ++i) kdop.min[i] = -1, kdop.max[i] = 1 + 0.25 * static_cast<double>(i);
  const Vector<double, 3> by(0.5, -0.25, 1);
  const auto there = moved(kdop, by);
  const auto larger = grown(kdop, 0.5);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const double along = project<double, 3>(axes[i], by);
    double square = 0;
    for (const int entry : axes[i]) square += entry * entry;
    CHECK(there.min[i] == kdop.min[i] + along);
    CHECK(there.max[i] == kdop.max[i] + along);
    CHECK(larger.max[i] == doctest::Approx(kdop.max[i] + 0.5 * std::sqrt(square)));
  }
  const Kdop<Counted, 3> counted{.k = 14};
  const Vector<Counted, 3> any = Vector<Counted, 3>::Zero();
  const Work move = work_of([&] { return moved(counted, any); });
  CHECK(move.multiplications == 0);
  CHECK(move.additions == 14 + 2 * 4);  // both bounds, and two sums for each diagonal
  CHECK(work_of([&] { return grown(counted, 0.5); }).multiplications == 4);  // the diagonals
}
