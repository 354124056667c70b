#include "lesson/subjects/cloud/by_hand.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "fit/catalogue_rows.hpp"
#include "fit/kdop/kdop_by_hand.hpp"
#include "fit/obb/certify_obb.hpp"
#include "fit/obb/obb_by_hand.hpp"
#include "fit/sphere/certify_sphere.hpp"
#include "fit/swept/certify_swept.hpp"
#include "fit/swept/swept_by_hand.hpp"

namespace snug::lesson {
namespace {

constexpr Method by_hand(std::string_view volume, std::string_view name, std::string_view title,
                         std::span<const std::string_view> pseudocode) {
  return {.volume = volume,
          .name = name,
          .title = title,
          .source = "your own hand",
          .pseudocode = pseudocode,
          .by_hand = true};
}

constexpr std::array kHandMethods{
    by_hand("obb", kFitByHand, "By hand", fit::kObbByHandPseudocode),
    by_hand("obb", kEigenByHand, "Eigenvector by hand", fit::kObbEigenByHandPseudocode),
    by_hand("capsule", kFitByHand, "By hand", fit::kCapsuleByHandPseudocode),
    by_hand("lozenge", kFitByHand, "By hand", fit::kLozengeByHandPseudocode),
    by_hand("kdop", kFitByHand, "Directions by hand", fit::kKdopByHandPseudocode),
};

/// How each kind of volume is fitted. There is no other kind that a hand can set.
struct Fitter {
  bool eigen = false;
  template <class Scalar, int Dim, class Observer>
  auto operator()(const Obb<Scalar, Dim>& hand, PointSpan<Scalar, Dim> points, Observer& observe) const {
    return eigen ? fit::obb_eigen_by_hand(points, hand.axes, observe) : fit::obb_by_hand(points, hand.axes, observe);
  }
  template <class Scalar, int Dim, class Observer>
  auto operator()(const Capsule<Scalar, Dim>& hand, PointSpan<Scalar, Dim> points, Observer& observe) const {
    return fit::swept_by_hand<fit::CapsuleStep<Scalar, Dim>>(points, hand, observe);
  }
  template <class Scalar, int Dim, class Observer>
  auto operator()(const Lozenge<Scalar, Dim>& hand, PointSpan<Scalar, Dim> points, Observer& observe) const {
    return fit::swept_by_hand<fit::LozengeStep<Scalar, Dim>>(points, hand, observe);
  }
};

template <class Volume>
constexpr bool kSetByHand = false;
template <>
constexpr bool kSetByHand<Obb<double, 3>> = true;
template <>
constexpr bool kSetByHand<Capsule<double, 3>> = true;
template <>
constexpr bool kSetByHand<Lozenge<double, 3>> = true;

/// Calls with the hand's volume in the points' own scalar and dimension, and with their span.
template <class Call>
void with_hand(const fit::Volume3& hand, const AnyPointSet& points, Call call) {
  std::visit(
      [&]<class Volume, class Scalar, int Dim>(const Volume& held, const PointSet<Scalar, Dim>& set) {
        if constexpr (kSetByHand<Volume>) call(converted<Scalar, Dim>(held), set.span());
      },
      hand, points);
}

double degrees_between(const Point3& a, const Point3& b) {
  const double lengths = a.norm() * b.norm();
  if (!(lengths > 0)) return 0;
  const double along = a.dot(b);
  const Point3 across = b * a.squaredNorm() - a * along;  // the part of b across a, scaled
  return std::atan2(across.norm(), along * a.norm()) * 180 / std::numbers::pi;
}

}  // namespace

std::span<const Method> hand_methods() { return kHandMethods; }

fit::Recording record_by_hand(const Method& method, const fit::Volume3& hand, const AnyPointSet& points,
                              fit::Recording room) {
  fit::Recording recording{.steps = std::move(room.steps)};
  recording.steps.clear();
  const fit::SeeStep keep = [&](fit::Step3&& step, const OperationCounts& counts) {
    recording.steps.push_back({std::move(step), counts});
  };
  with_hand(hand, points, [&](const auto& held, auto span) {
    fit::LiftingObserver observer{keep};
    const auto fitted = Fitter{method.name == kEigenByHand}(held, span, observer);
    observer.counter.take();
    recording.counts = observer.counter.counts;
    recording.result = {fit::lift(fitted.volume), fit::indices_of(fitted.support)};
    recording.certificate = certify(fitted, span, false);
  });
  return recording;
}

fit::Volume3 fit_by_hand(const fit::Volume3& hand, const AnyPointSet& points) {
  fit::Volume3 volume = hand;
  with_hand(hand, points, [&](const auto& held, auto span) {
    Ignore ignore;
    volume = fit::lift(Fitter()(held, span, ignore).volume);
  });
  return volume;
}

std::optional<DirectionImage> image_after(const fit::Recording& recording, int steps) {
  const auto* box = std::get_if<Obb<double, 3>>(&recording.result.volume);
  for (int i = steps; box != nullptr && i-- > 0;)
    if (const auto* found = std::get_if<fit::CovarianceFound<double, 3>>(&recording.steps[i].step.fact)) {
      const Point3 direction = box->axes.col(0), image = found->covariance * direction;
      return DirectionImage{found->mean, direction, image, degrees_between(direction, image),
                            fit::principal_axes(*found).variances[2]};
    }
  return std::nullopt;
}

}  // namespace snug::lesson
