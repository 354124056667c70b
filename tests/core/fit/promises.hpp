// What every fitter of the catalogue promises on a cloud: it holds all points exactly, its support lies on its
// boundary, the smallest is proven so where it is claimed, the trace ends with a last step of the result, and being
// watched changes nothing.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "core/fit/volume_hash.hpp"
#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "geometry/tolerance.hpp"

namespace snug::test {

/// No volume is held by more points than fix it, where that is known.
inline std::size_t most_support(std::string_view volume, int dim) {
  const auto d = static_cast<std::size_t>(dim);
  return volume == "sphere"    ? d + 1
         : volume == "aabb"    ? 2 * d
         : volume == "capsule" ? d + 2
                               : std::numeric_limits<std::size_t>::max();
}

/// The edges are perpendicular, but for the rounding of the numbers that they were computed in.
inline void check_lozenge(const Lozenge<double, 3>& lozenge, bool is_float) {
  const double roundoff = is_float ? static_cast<double>(tolerance::kRoundoff<float>) : tolerance::kRoundoff<double>;
  const double sound =
      (is_float ? static_cast<double>(std::numeric_limits<float>::min()) : std::numeric_limits<double>::min()) /
      roundoff;
  const double first = scaled_norm<double, 3>(lozenge.edges[0]), second = scaled_norm<double, 3>(lozenge.edges[1]);
  if (first > sound && second > sound)
    CHECK(std::abs((lozenge.edges[0] / first).dot(lozenge.edges[1] / second)) <= 16 * roundoff);
}

/// One step a slab and the last, and each slab cuts off what it cuts off.
inline void check_slabs(const fit::Recording& run, int dim) {
  const auto& kdop = *std::get_if<Kdop<double, 3>>(&run.result.volume);
  CHECK(run.steps.size() == static_cast<std::size_t>(kdop.k / 2 + 1));
  if (std::abs(kdop.min[0]) > 1e6) return;
  double before = std::numeric_limits<double>::infinity();
  for (const auto& entry : run.steps) {
    if (!entry.step.has_volume) continue;
    const double now = fit::measure_of(entry.step.volume, dim);
    CHECK(now <= before * (1 + 1e-9) + 1e-12);
    before = now;
  }
}

inline void check_promises(const fit::Algorithm& algorithm, const AnyPointSet& set) {
  INFO(algorithm.volume << " " << algorithm.name);
  const fit::Recording run = algorithm.record(set, {});
  CHECK(run.certificate.contains);
  CHECK(run.certificate.max_outside == 0);
  CHECK(run.certificate.on_boundary);
  CHECK(run.certificate.optimal == (algorithm.exact ? std::optional(true) : std::nullopt));
  CHECK(run.result.support.size() >= 1);
  CHECK(run.result.support.size() <= most_support(algorithm.volume, fit::dim_of(set)));

  const fit::Result unwatched = algorithm.fit(set, {});
  CHECK(hash_of(unwatched.volume) == hash_of(run.result.volume));
  CHECK(unwatched.support == run.result.support);

  REQUIRE(!run.steps.empty());
  CHECK(fit::name_of(run.steps.back().step) == "finished");
  CHECK(hash_of(run.steps.back().step.volume) == hash_of(run.result.volume));
  const std::size_t lines = fit::pseudocode_of(algorithm, fit::dim_of(set)).size();
  for (const auto& entry : run.steps) {
    REQUIRE(static_cast<std::size_t>(entry.step.line) < lines);
    if (algorithm.volume == "aabb") CHECK(entry.step.has_volume);
  }
  if (const auto* lozenge = std::get_if<Lozenge<double, 3>>(&run.result.volume))
    check_lozenge(*lozenge,
                  std::holds_alternative<PointSet<float, 2>>(set) || std::holds_alternative<PointSet<float, 3>>(set));
  if (algorithm.volume == "kdop") check_slabs(run, fit::dim_of(set));
}

/// algorithms: those that take so many points in that dimension are held to it.
template <class Scalar, int Dim>
void check_promises(std::span<const fit::Algorithm> algorithms, const std::string& name,
                    const Cloud<Scalar, Dim>& points) {
  const AnyPointSet set = set_of<Scalar, Dim>(points);
  INFO(name << ", " << points.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  for (const fit::Algorithm& algorithm : algorithms)
    if (!algorithm.loses_points && fit::takes(algorithm, Dim) && fit::count_of(set) <= algorithm.max_points)
      check_promises(algorithm, set);
}

}  // namespace snug::test
