#include "measure/false_positives.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "geometry/about_origin.hpp"
#include "geometry/convert.hpp"
#include "geometry/random.hpp"
#include "query/overlap/overlaps.hpp"

namespace snug::cost {
namespace {

/// Evenly among all rotations, as nearly as the generator's normals are normal.
template <int Dim>
Matrix<double, Dim> any_rotation(Random& random) {
  if constexpr (Dim == 3) {
    // Braces fix the order in which the random numbers are drawn, whatever the compiler.
    return matrix_of(normalized(Quaternion{random.normal(), random.normal(), random.normal(), random.normal()}));
  } else {
    const Vector<double, 2> drawn{random.normal(), random.normal()};
    Vector<double, 2> axis(1, 0);
    if (drawn.squaredNorm() > 0) axis = drawn.normalized();
    Matrix<double, 2> rotation;
    rotation << axis[0], -axis[1], axis[1], axis[0];
    return rotation;
  }
}

/// Evenly within the unit ball.
template <int Dim>
Vector<double, Dim> any_place(Random& random) {
  for (;;) {
    Vector<double, Dim> place;
    for (int i = 0; i < Dim; ++i) place[i] = random.between(-1, 1);
    if (place.squaredNorm() <= 1) return place;
  }
}

/// A body, and how each of its volumes follows it.
template <int Dim>
class FollowedBody {
 public:
  using Place = Pose<double, Dim>;
  using AnyVolume = Volume<double, Dim>;

  FollowedBody(const AnyPointSet& points, const std::vector<const fit::Algorithm*>& algorithms,
               const std::vector<fit::Volume3>& volumes, bool still, std::uint64_t seed)
      : still_(still), random_(seed) {
    const fit::Volume3 hull = fit::find_algorithm("hull", "quickhull")->fit(points, {}).volume;
    hull_ = converted<double, Dim>(*std::get_if<ConvexHull<double, 3>>(&hull));
    Vector<double, Dim> least = hull_.vertices.front(), most = least;
    for (const auto& vertex : hull_.vertices) {
      least = least.cwiseMin(vertex);
      most = most.cwiseMax(vertex);
    }
    center_ = (least + most) / 2;
    for (const auto& vertex : hull_.vertices) radius_ = std::max(radius_, (vertex - center_).norm());
    for (std::size_t i = 0; i < volumes.size(); ++i) follow_.push_back(follower(*algorithms[i], volumes[i]));
  }

  FollowedBody(const FollowedBody&) = delete;  // what follows refers to it
  FollowedBody& operator=(const FollowedBody&) = delete;

  void test_pair(std::vector<FalsePositives>& rows) {
    Matrix<double, Dim> own = Matrix<double, Dim>::Identity();
    if (!still_) own = any_rotation<Dim>(random_);
    const Matrix<double, Dim> rotation = any_rotation<Dim>(random_);
    const Vector<double, Dim> aside = any_place<Dim>(random_) * (FalsePositiveRun::kReach * radius_);
    const Place a = at(own, Vector<double, Dim>::Zero()), b = at(rotation, aside);
    const bool apart = !query::overlaps(posed(hull_, a), posed(hull_, b));
    for (std::size_t i = 0; i < follow_.size(); ++i) {
      const auto result = query::test_overlap<double, Dim>(follow_[i](a), follow_[i](b));
      ++rows[i].pairs;
      rows[i].tests += result.tests;
      rows[i].apart += apart ? 1 : 0;
      rows[i].passed += apart && result.overlap ? 1 : 0;
    }
  }

 private:
  using Follow = std::function<AnyVolume(const Place& place)>;

  /// The body rotates about its centre, which goes there.
  [[nodiscard]] Place at(const Matrix<double, Dim>& rotation, const Vector<double, Dim>& center) const {
    return {rotation, center - rotation * center_};
  }

  [[nodiscard]] Follow follower(const fit::Algorithm& algorithm, const fit::Volume3& lifted) const {
    return std::visit(
        [&](const auto& kind) -> Follow {
          const auto volume = converted<double, Dim>(kind);
          if constexpr (kRotatesWithBody<std::remove_const_t<decltype(volume)>>)
            return [volume](const Place& place) { return AnyVolume(posed(volume, place)); };
          else return [this, &algorithm](const Place& place) { return fitted_anew(algorithm, place); };
        },
        lifted);
  }

  /// The hull's vertices are enough for a volume that is convex.
  [[nodiscard]] AnyVolume fitted_anew(const fit::Algorithm& algorithm, const Place& place) const {
    const fit::Volume3 volume = algorithm.fit(*PointSet<double, Dim>::make(posed(hull_, place).vertices), {}).volume;
    return std::visit([](const auto& own) { return AnyVolume(converted<double, Dim>(own)); }, volume);
  }

  bool still_;
  Random random_;
  ConvexHull<double, Dim> hull_;
  Vector<double, Dim> center_;
  double radius_ = 0;
  std::vector<Follow> follow_;
};

}  // namespace

FalsePositiveRun::FalsePositiveRun(const AnyPointSet& points, const std::vector<const fit::Algorithm*>& algorithms,
                                   const std::vector<fit::Volume3>& volumes, bool still, std::uint64_t seed)
    : rows_(volumes.size()) {
  const auto begin = [&]<int Dim>() {
    auto bodies = std::make_shared<FollowedBody<Dim>>(points, algorithms, volumes, still, seed);
    test_pair_ = [bodies](std::vector<FalsePositives>& rows) { bodies->test_pair(rows); };
  };
  if (fit::dim_of(points) == 2) begin.template operator()<2>();
  else begin.template operator()<3>();
}

void FalsePositiveRun::step() {
  if (done()) return;
  test_pair_(rows_);
  ++done_;
}

}  // namespace snug::cost
