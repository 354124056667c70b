#include "query/distance/gjk.hpp"

#include "number/power_of_two.hpp"

namespace snug::query {

template class Gjk<Ignore>;
SNUG_GJK(, float, 2)
SNUG_GJK(, float, 3)
SNUG_GJK(, double, 2)
SNUG_GJK(, double, 3)

template <class Scalar, int Dim>
Cores<Scalar, Dim> cores_of(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  const Vector<Scalar, Dim> origin = anchor_of(a) / 2 + anchor_of(b) / 2;
  const auto core_of = [&](const Volume<Scalar, Dim>& volume) {
    return std::visit([&](const auto& own) { return grown_core(own, origin); }, volume);
  };
  return {core_of(a), core_of(b), origin};
}

template <class Scalar, int Dim>
std::optional<Separation<Scalar, Dim>> gjk(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  auto [first, second, origin] = cores_of(a, b);
  Ignore ignore;
  return separation_of<Scalar, Dim>(std::move(first), std::move(second), origin, false, ignore);
}

#define SNUG_GJK_OF_ANY(Scalar, Dim)                                                                                   \
  template Cores<Scalar, Dim> cores_of(const Volume<Scalar, Dim>&, const Volume<Scalar, Dim>&);                        \
  template std::optional<Separation<Scalar, Dim>> gjk(const Volume<Scalar, Dim>&, const Volume<Scalar, Dim>&);
SNUG_GJK_OF_ANY(float, 2)
SNUG_GJK_OF_ANY(float, 3)
SNUG_GJK_OF_ANY(double, 2)
SNUG_GJK_OF_ANY(double, 3)

SupportMapping support_mapping(const Corners<3>& corners) {
  const auto farthest = [](const void* core, const Vector<double, 3>& direction) {
    const auto& all = *static_cast<const Corners<3>*>(core);
    const std::size_t i = farthest_corner<3>(all, direction);
    return Supported{all[i], static_cast<Index>(i)};
  };
  const auto vertex = [](const void* core, Index index) {
    return Supported{(*static_cast<const Corners<3>*>(core))[index], index};
  };
  return {&corners, farthest, {corners.front(), 0}, static_cast<std::int64_t>(corners.size()), vertex};
}

SupportMapping support_mapping(const GrownCore& core) {
  if (!core.farthest) return support_mapping(core.corners);
  const auto farthest = [](const void* smooth, const Vector<double, 3>& direction) {
    return Supported{static_cast<const GrownCore*>(smooth)->farthest(direction), kNoIndex};
  };
  return {&core, farthest, farthest(&core, Vector<double, 3>::UnitX())};
}

namespace {

double largest_coordinate(const GrownCore& core) {
  double largest = std::max(core.radius, core.reach);
  for (const auto& corner : core.corners) largest = std::max(largest, corner.cwiseAbs().maxCoeff());
  return largest;
}

void divide(GrownCore& core, double unit) {
  core.radius /= unit;
  core.reach /= unit;
  for (auto& corner : core.corners) corner *= 1 / unit;
  if (core.farthest)
    core.farthest = [whole = std::move(core.farthest), unit](const Vector<double, 3>& direction) {
      return Vector<double, 3>(whole(direction) / unit);
    };
}

}  // namespace

double scale_to_unit(GrownCore& a, GrownCore& b) {
  const double unit = power_of_two_above(std::max(largest_coordinate(a), largest_coordinate(b)));
  for (GrownCore* core : {&a, &b}) divide(*core, unit);
  return unit;
}

}  // namespace snug::query
