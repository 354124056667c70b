// The steps of the axis-aligned box's fitter.
#pragma once

#include <span>
#include <string_view>

#include "fit/facts.hpp"
#include "fit/fit.hpp"
#include "geometry/aabb.hpp"
#include "trace/fields.hpp"

namespace snug::fit {

/// The box was widened to the point. The first box is the first point alone.
struct BoxWidened {
  static constexpr std::string_view kName = "box_widened";
  Index point = kNoIndex;
  SNUG_FIELDS(point);
};

template <class Scalar, int Dim>
using AabbStep = Step<Aabb<Scalar, Dim>, BoxWidened, ExtremesFound<Scalar, Dim>, Finished>;

/// What fits axis-aligned boxes.
[[nodiscard]] std::span<const Algorithm> rows_of(const Aabb<double, 3>*);

}  // namespace snug::fit
