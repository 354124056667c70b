// What every fitter of the catalogue promises on a cloud: it holds all points exactly, its support lies on its boundary, the
// smallest is proven so where it is claimed, the trace ends with a last step of the result, and being watched changes nothing.
#pragma once

#include <doctest/doctest.h>

#include <optional>
#include <string>
#include <vector>

#include "core/point_clouds.hpp"
#include "fit/catalogue.hpp"
#include "geometry/bits.hpp"

namespace snug::test {

/// The same, number by number: by what a trace's hash makes of them.
inline std::uint64_t hash_of(const fit::Volume3& volume) {
  const Recorder<fit::Step3>::Entry entry{{0, true, volume, fit::Finished{}}, {}};
  return fit::hash_of({&entry, 1});
}

inline void check_promises(const fit::Algorithm& algorithm, const AnyPointSet& set) {
  INFO(algorithm.volume << " " << algorithm.name);
  const fit::Recording run = algorithm.record(set, {});
  CHECK(run.certificate.contains);
  CHECK(run.certificate.max_outside == 0);
  CHECK(run.certificate.on_boundary);
  if (algorithm.exact) CHECK(run.certificate.optimal == true);
  else CHECK(run.certificate.optimal != false);
  CHECK(run.result.support.size() >= 1);

  const fit::Result unwatched = algorithm.fit(set, {});
  CHECK(hash_of(unwatched.volume) == hash_of(run.result.volume));
  CHECK(unwatched.support == run.result.support);

  REQUIRE(!run.steps.empty());
  CHECK(fit::name_of(run.steps.back().step) == "finished");
  CHECK(hash_of(run.steps.back().step.volume) == hash_of(run.result.volume));
  const std::size_t lines = fit::pseudocode_of(algorithm, fit::dim_of(set)).size();
  for (const auto& entry : run.steps) REQUIRE(static_cast<std::size_t>(entry.step.line) < lines);
}

/// algorithms: those that take so many points in that dimension are held to it.
template <class Scalar, int Dim>
void check_promises(std::span<const fit::Algorithm> algorithms, const std::string& name, const Cloud<Scalar, Dim>& points) {
  const AnyPointSet set = set_of<Scalar, Dim>(points);
  INFO(name << ", " << points.size() << " points, dim " << Dim << ", " << sizeof(Scalar) << " bytes");
  for (const fit::Algorithm& algorithm : algorithms)
    if (fit::takes(algorithm, Dim) && fit::size_of(set) <= algorithm.max_points) check_promises(algorithm, set);
}

}  // namespace snug::test
