// Tiny points, whose squared lengths would lose digits to underflow, are fitted a power of two times as large: that
// changes no digit. What the catalogue's rows of spheres do around their fitters; the rows of other volumes square no
// lengths, or scale by themselves.
#pragma once

#include "fit/catalogue_rows.hpp"

namespace snug::fit {

/// The fit and the watched run of points of any size. Steps, volume and proof are told in the points' own units.
[[nodiscard]] Result fit_of_any_size(const AnyPointSet& points, const Options& options, decltype(Algorithm::fit) fit);
[[nodiscard]] Watched watch_of_any_size(const AnyPointSet& points, const Options& options, const SeeStep& see,
                                        decltype(Algorithm::watch) watch);

/// A row whose fitter takes points of any size.
template <auto kFitter, bool kExact = false>
constexpr Algorithm sphere_row(const About& about) {
  Algorithm algorithm = row<kFitter, kExact>(about);
  algorithm.fit = [](const AnyPointSet& points, const Options& options) {
    return fit_of_any_size(points, options, &fit_any<kFitter>);
  };
  algorithm.watch = [](const AnyPointSet& points, const Options& options, const SeeStep& see) {
    return watch_of_any_size(points, options, see, &watch_any<kFitter, kExact>);
  };
  return algorithm;
}

}  // namespace snug::fit
