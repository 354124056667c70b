// The steps and volumes of every algorithm, scalar and dimension, as double and 3-D, for code that only reads them.
#pragma once

#include <type_traits>
#include <variant>
#include <vector>

#include "fit/aabb/aabb_steps.hpp"
#include "fit/hull/hull_steps.hpp"
#include "fit/kdop/kdop_steps.hpp"
#include "fit/obb/obb_steps.hpp"
#include "fit/sphere/naive_steps.hpp"
#include "fit/sphere/sphere_steps.hpp"
#include "fit/swept/capsule_steps.hpp"
#include "fit/swept/lozenge_steps.hpp"
#include "geometry/volume.hpp"

namespace snug::fit {

using Sphere3 = Sphere<double, 3>;
/// A result in double and 3-D, whatever it was computed in; in 2-D z is 0, and a box's third axis is z.
using Volume3 = Volume<double, 3>;

template <class Known, class... Facts>
struct AddFacts {
  using Type = Known;
};
template <class... Known, class Fact, class... Facts>
struct AddFacts<std::variant<Known...>, Fact, Facts...>
    : AddFacts<std::conditional_t<(std::is_same_v<Known, Fact> || ...), std::variant<Known...>,
                                  std::variant<Known..., Fact>>,
               Facts...> {};

/// The union of several variants: every alternative once.
template <class First, class... Others>
struct Union {
  using Type = First;
};
template <class First, class... Facts, class... Others>
struct Union<First, std::variant<Facts...>, Others...> : Union<typename AddFacts<First, Facts...>::Type, Others...> {};

/// The same alternatives, with one of them (not the first) moved to the end.
template <class Facts, class Last>
struct MovedToEnd;
template <class First, class... Facts, class Last>
struct MovedToEnd<std::variant<First, Facts...>, Last>
    : AddFacts<std::variant<First>, std::conditional_t<std::is_same_v<Facts, Last>, First, Facts>..., Last> {};

/// Every fact that a fitter reports. New ones come last: a trace's hash counts them.
using Fact3 = MovedToEnd<Union<SphereStep<double, 3>::Fact, ObbStep<double, 3>::Fact, AabbStep<double, 3>::Fact,
                               CapsuleStep<double, 3>::Fact, LozengeStep<double, 3>::Fact, KdopStep<double, 3>::Fact,
                               HullStep<double, 3>::Fact, NaiveSphereStep<double, 3>::Fact>::Type,
                         RotationTried<double, 3>>::Type;

struct Step3 {
  using Fact = Fact3;
  int line = 0;             // of the algorithm's pseudocode, counted from 0
  bool has_volume = false;  // whether there is a volume yet
  Volume3 volume;           // as it stands after this step
  Fact fact;
};

/// The result of an algorithm. ball_of takes only one whose volume is a ball.
struct Result {
  Volume3 volume;
  std::vector<Index> support;
};

[[nodiscard]] inline const Sphere3& ball_of(const Result& result) { return *std::get_if<Sphere3>(&result.volume); }

/// The step's volume as a ball; null if it is not a ball, or if there is no volume yet.
[[nodiscard]] inline const Sphere3* ball_of(const Step3& step) {
  return step.has_volume ? std::get_if<Sphere3>(&step.volume) : nullptr;
}

}  // namespace snug::fit
