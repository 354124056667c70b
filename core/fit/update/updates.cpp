#include "fit/update/updates.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "fit/aabb/aabb_min_max.hpp"
#include "fit/catalogue_rows.hpp"
#include "fit/counters.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/kdop/kdop_fit.hpp"
#include "fit/lift.hpp"
#include "fit/obb/obb_pca.hpp"
#include "fit/obb/obb_pca_rectangle.hpp"
#include "fit/sphere/pivot.hpp"
#include "fit/update/update_hill_climb.hpp"
#include "fit/update/update_kdop.hpp"
#include "fit/update/update_kdop_climb.hpp"
#include "fit/update/update_loose.hpp"
#include "fit/update/update_obb.hpp"
#include "fit/update/update_rebuild.hpp"
#include "fit/update/update_rotated_box.hpp"
#include "fit/update/update_sphere.hpp"
#include "query/contain/contains.hpp"

namespace snug::fit {
namespace {

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

// Each update is a struct: what it keeps of a body from frame to frame, the volume at a pose (volume_at), and the
// measure of the tightest volume of its kind there.

template <class Scalar, int Dim>
struct TransformedSphere {
  TransformedSphere(PointSpan<Scalar, Dim> points, int)
      : ball(pivot(points, Options{}).volume), local(local_error(ball)) {}
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) { return update_sphere(ball, local, pose, watch).volume; }
  [[nodiscard]] double tightest(const Pose<Scalar, Dim>&) const { return measure_of(lift(ball), Dim); }

  Sphere<Scalar, Dim> ball;
  Scalar local;
};

template <class Scalar, int Dim>
struct TransformedObb {
  TransformedObb(PointSpan<Scalar, Dim> points, int) {
    if constexpr (Dim == 2) box = obb_pca(points).volume;
    else box = obb_pca_rectangle(points).volume;
    local = local_error(box);
  }
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) { return update_obb(box, local, pose, watch).volume; }
  [[nodiscard]] double tightest(const Pose<Scalar, Dim>&) const { return measure_of(lift(box), Dim); }

  Obb<Scalar, Dim> box;
  Scalar local = 0;
};

/// What the updates of AABBs have in common.
template <class Scalar, int Dim>
struct UpdatedAabb {
  [[nodiscard]] double tightest(const Pose<Scalar, Dim>& pose) const {
    return measure_of(lift(update_rebuild(points, pose).volume), Dim);
  }

  PointSpan<Scalar, Dim> points;
};

template <class Scalar, int Dim>
struct LooseAabb : UpdatedAabb<Scalar, Dim> {
  LooseAabb(PointSpan<Scalar, Dim> points, int) : UpdatedAabb<Scalar, Dim>{points} {}
  /// Finds the farthest point, in the first frame.
  void prepare(auto& watch) {
    if (!reach) reach = loose_reach(this->points, watch);
  }
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) { return update_loose(*reach, pose, watch).volume; }

  std::optional<LooseReach<Scalar>> reach;
};

template <class Scalar, int Dim>
struct RebuiltAabb : UpdatedAabb<Scalar, Dim> {
  RebuiltAabb(PointSpan<Scalar, Dim> points, int) : UpdatedAabb<Scalar, Dim>{points} {}
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    return update_rebuild(this->points, pose, watch).volume;
  }
};

template <class Scalar, int Dim>
struct RotatedAabb : UpdatedAabb<Scalar, Dim> {
  RotatedAabb(PointSpan<Scalar, Dim> points, int)
      : UpdatedAabb<Scalar, Dim>{points}, box(aabb_min_max(points).volume) {}
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) { return update_rotated_box(box, pose, watch).volume; }

  Aabb<Scalar, Dim> box;
};

/// The hull of a body, and the climbs over it: along k / 2 axes, each both ways.
template <class Scalar, int Dim>
struct Climbed {
  Climbed(PointSpan<Scalar, Dim> points, int k)
      : hull(quickhull(points).volume), neighbors(hull_neighbors(hull)),
        climb(std::span<const Vector<Scalar, Dim>>(hull.vertices), neighbors, k,
              hull.vertices.size() == static_cast<std::size_t>(points.size())) {}
  Climbed(const Climbed&) = delete;  // climb refers to hull
  Climbed& operator=(const Climbed&) = delete;

  ConvexHull<Scalar, Dim> hull;
  HullNeighbors neighbors;
  HillClimb<Scalar, Dim> climb;
};

template <class Scalar, int Dim>
struct ClimbedAabb : UpdatedAabb<Scalar, Dim>, Climbed<Scalar, Dim> {
  ClimbedAabb(PointSpan<Scalar, Dim> points, int)
      : UpdatedAabb<Scalar, Dim>{points}, Climbed<Scalar, Dim>(points, 2 * Dim) {}
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    return update_hill_climb(this->climb, pose, watch).volume;
  }
};

/// What the updates of k-DOPs have in common.
template <class Scalar, int Dim>
struct UpdatedKdop {
  /// The tightest measure at a pose; 0 if a point is beyond the largest coordinate.
  [[nodiscard]] double tightest(const Pose<Scalar, Dim>& pose) const {
    std::vector<Vector<Scalar, Dim>> world;
    for (const auto& p : points) world.push_back(placed(pose, p));
    const auto set = PointSet<Scalar, Dim>::make(std::move(world));
    return set ? measure_of(lift(kdop_fit(set->span(), k).volume), Dim) : 0;
  }

  PointSpan<Scalar, Dim> points;
  int k;
};

template <class Scalar, int Dim>
struct ClimbedKdop : UpdatedKdop<Scalar, Dim>, Climbed<Scalar, Dim> {
  ClimbedKdop(PointSpan<Scalar, Dim> points, int k)
      : UpdatedKdop<Scalar, Dim>{points, k}, Climbed<Scalar, Dim>(points, k) {}
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    return update_kdop_climb(this->climb, this->k, pose, watch).volume;
  }
};

template <class Scalar, int Dim>
struct LooseKdop : UpdatedKdop<Scalar, Dim> {
  LooseKdop(PointSpan<Scalar, Dim> points, int k) : UpdatedKdop<Scalar, Dim>{points, k} {}
  /// Finds the farthest point, in the first frame.
  void prepare(auto& watch) {
    if (reach) return;
    reach = loose_reach(this->points).reach;
    watch.count(Operation::kPointsTouched, this->points.size());
    watch.count(Operation::kDistanceTests, this->points.size());
  }
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    return update_kdop_loose(*reach, this->k, pose, watch).volume;
  }

  std::optional<Scalar> reach;
};

template <class Scalar, int Dim>
struct RebuiltKdop : UpdatedKdop<Scalar, Dim> {
  RebuiltKdop(PointSpan<Scalar, Dim> points, int k) : UpdatedKdop<Scalar, Dim>{points, k} {}
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    return update_kdop_rebuild(this->points, this->k, pose, watch).volume;
  }
};

template <class Scalar, int Dim>
struct RotatedKdop : UpdatedKdop<Scalar, Dim> {
  RotatedKdop(PointSpan<Scalar, Dim> points, int k) : UpdatedKdop<Scalar, Dim>{points, k} {
    const Kdop<Scalar, Dim> local = kdop_fit(points, k).volume;
    size = magnitude_of(local);
    for (const auto& vertex : kdop_vertices(local)) vertices.push_back(vertex.template cast<Scalar>());
  }
  auto volume_at(const Pose<Scalar, Dim>& pose, auto& watch) {
    return update_kdop_rotated(std::span<const Vector<Scalar, Dim>>(vertices), size, this->k, pose, watch).volume;
  }

  std::vector<Vector<Scalar, Dim>> vertices;
  Scalar size;
};

/// Compiled once for each kind of volume, whatever the update.
template <class VolumeType, class Scalar, int Dim>
UpdatedFrame frame_of(const VolumeType& volume, PointSpan<Scalar, Dim> points, const Pose<Scalar, Dim>& pose,
                      double tightest) {
  const bool contains = std::all_of(points.begin(), points.end(),
                                    [&](const auto& p) { return query::contains(volume, placed(pose, p)); });
  const Volume3 lifted = lift(volume);
  return {.volume = lifted, .measure = measure_of(lifted, Dim), .tightest = tightest, .contains = contains};
}

template <class Scalar, int Dim>
double hull_measure(PointSpan<Scalar, Dim> points) {
  return measure_of(lift(quickhull(points).volume), Dim);
}

/// A body that is updated by one of these.
template <template <class, int> class Update, class Scalar, int Dim>
class Body final : public MovingBody {
 public:
  Body(const UpdateStrategy& strategy, PointSpan<Scalar, Dim> points) : update_(points, strategy.k), points_(points) {}

  UpdatedFrame watched(const Pose<double, 3>& pose, const SeeUpdateStep& see) override {
    Watch watch{see};
    UpdatedFrame frame = moved(own(pose), watch);
    if (!hull_measure_) hull_measure_ = hull_measure(points_);
    frame.hull = *hull_measure_;
    frame.counts = watch.counter.counts;
    frame.steps = watch.counter.steps;
    return frame;
  }

  UpdatedFrame unwatched(const Pose<double, 3>& pose) override {
    Ignore ignore;
    return moved(own(pose), ignore);
  }

  void give(std::span<const Pose<double, 3>> poses) override {
    for (const auto& pose : poses) poses_.push_back(own(pose));
  }

  double bare() override {
    Ignore ignore;
    prepare(ignore);
    made_.resize(poses_.size());
    for (std::size_t i = 0; i < poses_.size(); ++i) made_[i] = update_.volume_at(poses_[i], ignore);
    return made_.empty() ? 0 : static_cast<double>(anchor(made_.back())[0]);
  }

 private:
  static Pose<Scalar, Dim> own(const Pose<double, 3>& lifted) {
    return {lifted.rotation.template topLeftCorner<Dim, Dim>().template cast<Scalar>(),
            lifted.translation.head<Dim>().template cast<Scalar>()};
  }

  void prepare(auto& watch) {
    if constexpr (requires { update_.prepare(watch); }) update_.prepare(watch);
  }

  UpdatedFrame moved(const Pose<Scalar, Dim>& pose, auto& watch) {
    prepare(watch);
    return frame_of(update_.volume_at(pose, watch), points_, pose, update_.tightest(pose));
  }

  Update<Scalar, Dim> update_;
  PointSpan<Scalar, Dim> points_;
  std::optional<double> hull_measure_;  // computed when first needed
  using Made = decltype(std::declval<Update<Scalar, Dim>&>().volume_at(Pose<Scalar, Dim>(), std::declval<Ignore&>()));
  std::vector<Pose<Scalar, Dim>> poses_;
  std::vector<Made> made_;  // kept, so that no compiler leaves the work out
};

template <template <class, int> class Update>
std::shared_ptr<MovingBody> start(const UpdateStrategy& strategy, const AnyPointSet& points) {
  using Started = std::shared_ptr<MovingBody>;
  return with_span<Started>(points, [&]<class Scalar, int Dim>(PointSpan<Scalar, Dim> span) -> Started {
    return std::make_shared<Body<Update, Scalar, Dim>>(strategy, span);
  });
}

template <template <class, int> class Update>
constexpr UpdateStrategy row(std::string_view volume, std::string_view name, std::string_view title,
                             std::span<const std::string_view> pseudocode, int k = 0, bool plane = true,
                             bool space = true) {
  return {volume, name, title, kEricson, pseudocode, k, plane, space, &start<Update>};
}

constexpr UpdateStrategy kdop_row(std::string_view name, std::string_view title, int k, bool plane, bool space) {
  return row<ClimbedKdop>("kdop", name, title, kUpdateKdopClimbPseudocode, k, plane, space);
}

template <template <class, int> class Update>
constexpr UpdateStrategy kdop_row(std::string_view name, std::string_view title, int k,
                                  std::span<const std::string_view> pseudocode) {
  return row<Update>("kdop", name, title, pseudocode, k, k == 8, k == 14);
}

constexpr std::array kStrategies{
    row<TransformedSphere>("sphere", "transform", "Transformed sphere", kUpdateSpherePseudocode),
    row<LooseAabb>("aabb", "loose", "Loose AABB", kUpdateLoosePseudocode),
    row<RebuiltAabb>("aabb", "rebuild", "Rebuilt AABB", kUpdateRebuildPseudocode),
    row<ClimbedAabb>("aabb", "hill_climb", "AABB by hill climbing", kUpdateHillClimbPseudocode),
    row<RotatedAabb>("aabb", "rotated_box", "AABB of rotated AABB", kUpdateRotatedBoxPseudocode),
    row<TransformedObb>("obb", "transform", "Transformed OBB", kUpdateObbPseudocode),
    kdop_row("k4_hill_climb", "4-DOP by hill climbing", 4, true, false),
    kdop_row("k6_hill_climb", "6-DOP by hill climbing", 6, true, true),
    kdop_row("k8_hill_climb", "8-DOP by hill climbing", 8, true, false),
    kdop_row("k14_hill_climb", "14-DOP by hill climbing", 14, false, true),
    kdop_row("k18_hill_climb", "18-DOP by hill climbing", 18, false, true),
    kdop_row("k26_hill_climb", "26-DOP by hill climbing", 26, false, true),
    kdop_row<LooseKdop>("k8_loose", "Loose 8-DOP", 8, kUpdateKdopLoosePseudocode),
    kdop_row<RebuiltKdop>("k8_rebuild", "Rebuilt 8-DOP", 8, kUpdateKdopRebuildPseudocode),
    kdop_row<RotatedKdop>("k8_rotated", "8-DOP of rotated 8-DOP", 8, kUpdateKdopRotatedPseudocode),
    kdop_row<LooseKdop>("k14_loose", "Loose 14-DOP", 14, kUpdateKdopLoosePseudocode),
    kdop_row<RebuiltKdop>("k14_rebuild", "Rebuilt 14-DOP", 14, kUpdateKdopRebuildPseudocode),
    kdop_row<RotatedKdop>("k14_rotated", "14-DOP of rotated 14-DOP", 14, kUpdateKdopRotatedPseudocode),
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
  return [body = strategy.start(strategy, points)](const Pose<double, 3>& pose, const SeeUpdateStep& see) {
    return body->watched(pose, see);
  };
}

std::function<UpdatedFrame(const Pose<double, 3>& pose)> start_unwatched_updates(const UpdateStrategy& strategy,
                                                                                 const AnyPointSet& points) {
  return [body = strategy.start(strategy, points)](const Pose<double, 3>& pose) { return body->unwatched(pose); };
}

std::function<double()> start_bare_updates(const UpdateStrategy& strategy, const AnyPointSet& points,
                                           std::span<const Pose<double, 3>> poses) {
  auto body = strategy.start(strategy, points);
  body->give(poses);
  return [body] { return body->bare(); };
}

}  // namespace snug::fit
