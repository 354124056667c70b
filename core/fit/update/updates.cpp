#include "fit/update/updates.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "fit/aabb/aabb_min_max.hpp"
#include "fit/catalogue_rows.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/kdop/kdop_fit.hpp"
#include "fit/lift.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "fit/sphere/pivot.hpp"
#include "fit/tally.hpp"
#include "fit/update/update_hill_climb.hpp"
#include "fit/update/update_kdop_climb.hpp"
#include "fit/update/update_loose.hpp"
#include "fit/update/update_obb.hpp"
#include "fit/update/update_rebuild.hpp"
#include "fit/update/update_rotated_box.hpp"
#include "fit/update/update_sphere.hpp"
#include "query/contains.hpp"

namespace snug::fit {
namespace {

constexpr UpdateStrategy of_kdop(std::string_view name, std::string_view title, int k, bool plane, bool space) {
  return {"kdop", name, title, kEricson, kUpdateKdopClimbPseudocode, k, plane, space};
}

constexpr std::array kStrategies{
    UpdateStrategy{"sphere", "transform", "Transformed sphere", kEricson, kUpdateSpherePseudocode},
    UpdateStrategy{"aabb", "loose", "Loose AABB", kEricson, kUpdateLoosePseudocode},
    UpdateStrategy{"aabb", "rebuild", "Rebuilt AABB", kEricson, kUpdateRebuildPseudocode},
    UpdateStrategy{"aabb", "hill_climb", "AABB by hill climbing", kEricson, kUpdateHillClimbPseudocode},
    UpdateStrategy{"aabb", "rotated_box", "AABB of rotated AABB", kEricson, kUpdateRotatedBoxPseudocode},
    UpdateStrategy{"obb", "transform", "Transformed OBB", kEricson, kUpdateObbPseudocode},
    of_kdop("k4_hill_climb", "4-DOP by hill climbing", 4, true, false),
    of_kdop("k6_hill_climb", "6-DOP by hill climbing", 6, true, true),
    of_kdop("k8_hill_climb", "8-DOP by hill climbing", 8, true, false),
    of_kdop("k14_hill_climb", "14-DOP by hill climbing", 14, false, true),
    of_kdop("k18_hill_climb", "18-DOP by hill climbing", 18, false, true),
    of_kdop("k26_hill_climb", "26-DOP by hill climbing", 26, false, true),
};

struct Watch {
  const SeeUpdateStep& see;
  FullCounter counter{};
  template <class VolumeType, class... Facts>
  void operator()(const Step<VolumeType, Facts...>& step) {
    counter(step);
    if (!see) return;
    see({step.line, step.has_volume, lift(step.volume), step.fact});
    counter.pass();
  }
  void count(Operation operation, std::int64_t n) { counter.count(operation, n); }
};

/// The body with what its strategy keeps from frame to frame.
template <class Scalar, int Dim>
class Body {
 public:
  Body(const UpdateStrategy& strategy, PointSpan<Scalar, Dim> span)
      : strategy_(strategy), points_(span), box_(aabb_min_max(span).volume) {
    if (strategy.volume == "sphere") ball_ = pivot(span, Options{}).volume;
    if (strategy.volume == "obb") {
      if constexpr (Dim == 2) oriented_ = obb_pca(span).volume;
      else oriented_ = obb_pca_rectangle(span).volume;
    }
    if (!strategy.name.ends_with("hill_climb")) return;
    hull_ = quickhull(span).volume;
    neighbors_ = hull_neighbors(hull_);
    const bool all = hull_.vertices.size() == static_cast<std::size_t>(span.size());
    climb_.emplace(std::span<const Vector<Scalar, Dim>>(hull_.vertices), neighbors_,
                   strategy.k > 0 ? strategy.k : 2 * Dim, all);
  }
  Body(const Body&) = delete;  // climb_ walks over hull_
  Body& operator=(const Body&) = delete;

  [[nodiscard]] static Pose<Scalar, Dim> own(const Pose<double, 3>& lifted) {
    return {lifted.rotation.template topLeftCorner<Dim, Dim>().template cast<Scalar>(),
            lifted.translation.head<Dim>().template cast<Scalar>()};
  }

  UpdatedFrame to(const Pose<double, 3>& lifted, const SeeUpdateStep& see) {
    Watch watch{see};
    UpdatedFrame frame = moved(own(lifted), watch);
    if (!hull_measure_) hull_measure_ = measure_of(lift(quickhull(points_).volume), Dim);
    frame.hull = *hull_measure_;
    frame.counts = watch.counter.counts;
    frame.steps = watch.counter.steps;
    return frame;
  }

  UpdatedFrame to(const Pose<double, 3>& lifted) {
    Ignore ignore;
    return moved(own(lifted), ignore);
  }

  /// Which update it is, is decided once for all poses: beside a box's few sums that would count.
  double bare(const std::vector<Pose<Scalar, Dim>>& poses) {
    Ignore ignore;
    const auto through = [&](auto&& number_at) {
      Scalar sum = 0;
      for (const auto& pose : poses) sum += number_at(pose);
      return static_cast<double>(sum);
    };
    const auto boxes = [&](auto&& box_at) {
      return through([&](const Pose<Scalar, Dim>& pose) {
        const Aabb<Scalar, Dim> box = box_at(pose);
        return box.min.sum() + box.max.sum();
      });
    };
    if (strategy_.volume == "sphere")
      return through([&](const auto& pose) {
        const Sphere<Scalar, Dim> ball = update_sphere(ball_, pose, ignore).volume;
        return ball.center.sum() + ball.radius;
      });
    if (strategy_.volume == "obb")
      return through([&](const auto& pose) {
        const Obb<Scalar, Dim> box = update_obb(oriented_, pose, ignore).volume;
        return box.center.sum() + box.axes.sum() + box.half_extents.sum();
      });
    if (strategy_.volume == "kdop")
      return through(
          [&](const auto& pose) { return update_kdop_climb(*climb_, strategy_.k, pose, ignore).volume.min[0]; });
    if (strategy_.name == "rebuild")
      return boxes([&](const auto& pose) { return update_rebuild(points_, pose, ignore).volume; });
    if (strategy_.name == "hill_climb")
      return boxes([&](const auto& pose) { return update_hill_climb(*climb_, pose, ignore).volume; });
    if (strategy_.name == "rotated_box")
      return boxes([&](const auto& pose) { return update_rotated_box(box_, pose, ignore).volume; });
    if (!reach_) reach_ = loose_reach(points_, ignore);
    return boxes([&](const auto& pose) { return update_loose(*reach_, pose, ignore).volume; });
  }

 private:
  UpdatedFrame moved(const Pose<Scalar, Dim>& pose, auto& watch) {
    if (strategy_.volume == "sphere")
      return frame_of(update_sphere(ball_, pose, watch).volume, pose, measure_of(lift(ball_), Dim));
    if (strategy_.volume == "obb")
      return frame_of(update_obb(oriented_, pose, watch).volume, pose, measure_of(lift(oriented_), Dim));
    if (strategy_.volume == "kdop")
      return frame_of(update_kdop_climb(*climb_, strategy_.k, pose, watch).volume, pose, tightest_kdop(pose));
    return frame_of(box_at(pose, watch), pose, measure_of(lift(update_rebuild(points_, pose).volume), Dim));
  }

  Aabb<Scalar, Dim> box_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    if (strategy_.name == "rebuild") return update_rebuild(points_, pose, watch).volume;
    if (strategy_.name == "hill_climb") return update_hill_climb(*climb_, pose, watch).volume;
    if (strategy_.name == "rotated_box") return update_rotated_box(box_, pose, watch).volume;
    if (!reach_) reach_ = loose_reach(points_, watch);
    return update_loose(*reach_, pose, watch).volume;
  }

  double tightest_kdop(const Pose<Scalar, Dim>& pose) const {
    std::vector<Vector<Scalar, Dim>> world;
    for (const auto& p : points_) world.push_back(placed(pose, p));
    const auto set = PointSet<Scalar, Dim>::make(std::move(world));
    return set ? measure_of(lift(kdop_fit(set->span(), strategy_.k).volume), Dim)
               : 0;  // none: beyond the largest coordinate
  }

  template <class VolumeType>
  UpdatedFrame frame_of(const VolumeType& volume, const Pose<Scalar, Dim>& pose, double tightest) const {
    const bool contains = std::all_of(points_.begin(), points_.end(),
                                      [&](const auto& p) { return query::contains(volume, placed(pose, p)); });
    const Volume3 lifted = lift(volume);
    return {.volume = lifted, .measure = measure_of(lifted, Dim), .tightest = tightest, .contains = contains};
  }

  const UpdateStrategy& strategy_;
  PointSpan<Scalar, Dim> points_;
  Aabb<Scalar, Dim> box_;
  Sphere<Scalar, Dim> ball_;
  Obb<Scalar, Dim> oriented_;
  std::optional<LooseReach<Scalar>> reach_;
  ConvexHull<Scalar, Dim> hull_;
  std::optional<double> hull_measure_;  // worked out when first asked for
  HullNeighbors neighbors_;
  std::optional<HillClimb<Scalar, Dim>> climb_;
};

}  // namespace

std::span<const UpdateStrategy> update_strategies() { return kStrategies; }

const UpdateStrategy* find_update(std::string_view volume, std::string_view name) {
  const auto* const found = std::find_if(kStrategies.begin(), kStrategies.end(), [&](const UpdateStrategy& strategy) {
    return strategy.volume == volume && strategy.name == name;
  });
  return found == kStrategies.end() ? nullptr : found;
}

UpdateBody start_updates(const UpdateStrategy& strategy, const AnyPointSet& points) {
  return with_span<UpdateBody>(points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) -> UpdateBody {
    auto body = std::make_shared<Body<Scalar, Dim>>(strategy, span);
    return [body](const Pose<double, 3>& pose, const SeeUpdateStep& see) { return body->to(pose, see); };
  });
}

std::function<UpdatedFrame(const Pose<double, 3>& pose)> start_unwatched_updates(const UpdateStrategy& strategy,
                                                                                 const AnyPointSet& points) {
  using Moved = std::function<UpdatedFrame(const Pose<double, 3>& pose)>;
  return with_span<Moved>(points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) -> Moved {
    auto body = std::make_shared<Body<Scalar, Dim>>(strategy, span);
    return [body](const Pose<double, 3>& pose) { return body->to(pose); };
  });
}

std::function<double()> start_bare_updates(const UpdateStrategy& strategy, const AnyPointSet& points,
                                           std::span<const Pose<double, 3>> poses) {
  return with_span<std::function<double()>>(
      points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) -> std::function<double()> {
        auto body = std::make_shared<Body<Scalar, Dim>>(strategy, span);
        std::vector<Pose<Scalar, Dim>> own;
        for (const auto& pose : poses) own.push_back(body->own(pose));
        return [body, own = std::move(own)] { return body->bare(own); };
      });
}

}  // namespace snug::fit
