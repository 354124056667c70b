// What a test and an update cost beside the textbook's plain lines, in one run: verdicts alone, one kind of pair a
// batch. Prints the tables of "What a test costs" in RESULTS.md; it runs natively and under Node.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "bench/plain_tests.hpp"
#include "bench/ratio.hpp"
#include "fit/aabb/aabb_min_max.hpp"
#include "fit/hull/quickhull.hpp"
#include "fit/kdop/kdop_fit.hpp"
#include "fit/update/update_obb.hpp"
#include "fit/update/update_rotated_box.hpp"
#include "fit/update/update_sphere.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "query/cull/culler.hpp"
#include "query/overlap/overlaps.hpp"

using namespace snug;

namespace {

constexpr int kPairs = 512;
constexpr int kRounds = 101;
constexpr double kTouching = 0.9, kApart = 1.1;  // of the distance at which a pair touches
constexpr double kSpread = 4;                    // how far bodies of a scene lie at most, in each coordinate

/// Volumes about the origin, each kind about as large as the others.
template <class Scalar>
class Maker {
 public:
  using Point = Vector<Scalar, 3>;

  explicit Maker(Random& random) : random_(random) {}

  void make(Sphere<Scalar, 3>& sphere) { sphere = {Point::Zero(), length(0.4, 1)}; }
  void make(Aabb<Scalar, 3>& box) {
    box.max = extents();
    box.min = -box.max;
  }
  void make(Obb<Scalar, 3>& box) { box = {Point::Zero(), axes(), extents()}; }
  void make(Capsule<Scalar, 3>& capsule) {
    capsule.b = axes().col(0) * length(0.2, 1);
    capsule.a = -capsule.b;
    capsule.radius = length(0.2, 0.6);
  }
  void make(Lozenge<Scalar, 3>& lozenge) {
    const Matrix<Scalar, 3> axes = this->axes();
    lozenge.edges = {axes.col(0) * length(0.4, 2), axes.col(1) * length(0.4, 2)};
    lozenge.origin = -(lozenge.edges[0] + lozenge.edges[1]) / 2;
    lozenge.radius = length(0.2, 0.4);
  }
  void make(Kdop<Scalar, 3>& kdop) { kdop = fit::kdop_fit(PointSet<Scalar, 3>::make(points())->span(), 14).volume; }
  void make(ConvexHull<Scalar, 3>& hull) { hull = fit::quickhull(PointSet<Scalar, 3>::make(points())->span()).volume; }

  Point place(double spread) { return {length(-spread, spread), length(-spread, spread), length(-spread, spread)}; }

 private:
  static constexpr int kPoints = 24;

  Scalar length(double least, double most) { return static_cast<Scalar>(random_.between(least, most)); }
  Point extents() { return {length(0.2, 1), length(0.2, 1), length(0.2, 1)}; }
  Matrix<Scalar, 3> axes() {
    const Vector<double, 3> axis{random_.normal(), random_.normal(), random_.normal()};
    return turn(axis, random_.between(0, 6)).template cast<Scalar>();
  }
  std::vector<Point> points() {
    const Matrix<Scalar, 3> axes = this->axes();
    const Point half = extents();
    std::vector<Point> points;
    for (int i = 0; i < kPoints; ++i) points.push_back(axes * place(1).cwiseProduct(half));
    return points;
  }

  Random& random_;
};

template <class A, class B>
struct Pairs {
  std::vector<A> a;
  std::vector<B> b;
};

/// near: half of the pairs overlap by a tenth of the distance at which they touch, and half are as far apart, as a
/// broad phase leaves them. Else they lie in a scene, and most are apart.
template <class A, class B>
Pairs<A, B> pairs_of(bool near) {
  using Scalar = typename query::VolumeKind<A>::Scalar;
  Random random(7);
  Maker<Scalar> maker(random);
  Pairs<A, B> pairs;
  for (int i = 0; i < kPairs; ++i) {
    A a;
    B b;
    maker.make(a), maker.make(b);
    const Vector<Scalar, 3> place = maker.place(kSpread), other = maker.place(kSpread);
    if (!near) {
      pairs.a.push_back(moved<Scalar, 3>(a, other)), pairs.b.push_back(moved<Scalar, 3>(b, place));
      continue;
    }
    const Vector<Scalar, 3> way = place.normalized();
    double least = 0, most = 8;
    for (int halving = 0; halving < 20; ++halving) {
      const double middle = (least + most) / 2;
      (query::overlaps(a, moved<Scalar, 3>(b, way * static_cast<Scalar>(middle))) ? least : most) = middle;
    }
    pairs.a.push_back(a);
    pairs.b.push_back(
        moved<Scalar, 3>(b, way * static_cast<Scalar>(least * (random.below(2) == 0 ? kTouching : kApart))));
  }
  return pairs;
}

/// The share of pairs, of a million drawn anew, that rounded numbers leave open; none for tests that compare what is
/// stored.
template <class A, class B>
std::string left_open() {
  if constexpr (requires(const A& a, const B& b) { query::apart_filter(a, b); }) {
    using Scalar = typename query::VolumeKind<A>::Scalar;
    constexpr int kDrawn = 1'000'000;
    Random random(11);
    Maker<Scalar> maker(random);
    int open = 0;
    for (int i = 0; i < kDrawn; ++i) {
      A a;
      B b;
      maker.make(a), maker.make(b);
      open += query::apart_filter(a, moved<Scalar, 3>(b, maker.place(1.2))).has_value() ? 0 : 1;
    }
    return std::to_string(open) + " of a million";
  } else {
    return "none: exact";
  }
}

/// aim: 0 where none is stated.
void print_row(const std::string& name, bool single, const std::string& pairs, double share, const bench::Ratio& ratio,
               int count, double aim, const std::string& open = "") {
  std::printf("| %s | %s | %s | %.0f | %.2f | %.2f | %.2f to %.2f | ", name.c_str(), single ? "float" : "double",
              pairs.c_str(), share, ratio.base / count * 1e9, ratio.median, ratio.low, ratio.high);
  if (aim > 0) std::printf("%.1f | %s | %s |\n", aim, ratio.median <= aim ? "yes" : "NO", open.c_str());
  else std::printf("| | %s |\n", open.c_str());
}

/// One test beside its plain lines. plain: gives what the plain lines want of a volume, and tests two of those.
template <class A, class B, class PlainA, class PlainB>
void one_test(const char* name, double aim) {
  using Scalar = typename query::VolumeKind<A>::Scalar;
  for (const bool near : {true, false}) {
    const Pairs<A, B> pairs = pairs_of<A, B>(near);
    std::vector<PlainA> plain_a(pairs.a.begin(), pairs.a.end());
    std::vector<PlainB> plain_b(pairs.b.begin(), pairs.b.end());
    int found = 0, plainly = 0;
    const auto ratio = bench::ratio(
        [&] {
          for (int again = 0; again < 20; ++again) {
            int count = 0;
            for (int i = 0; i < kPairs; ++i) {
              count += query::overlaps(pairs.a[i], pairs.b[i]);
              bench::one_by_one(count);
            }
            bench::keep(found = count);
          }
        },
        [&] {
          for (int again = 0; again < 20; ++again) {
            int count = 0;
            for (int i = 0; i < kPairs; ++i) {
              count += bench::plain_overlap(plain_a[i], plain_b[i]);
              bench::one_by_one(count);
            }
            bench::keep(plainly = count);
          }
        },
        kRounds);
    if (found != plainly) std::printf("(%d overlap, %d by the plain lines)\n", found, plainly);
    print_row(name, sizeof(Scalar) == 4, near ? "near" : "scene", 100.0 * found / kPairs, ratio, kPairs * 20, aim,
              near ? left_open<A, B>() : "");
  }
}

/// Hulls that move a little from frame to frame: GJK that starts from the simplex where it ended, beside one that
/// begins anew each time. The time is that of the latter.
template <class Scalar>
void hulls() {
  constexpr int kBodies = 24, kFrames = 20;
  using Hull = ConvexHull<Scalar, 3>;
  struct Body {
    Hull hull;
    std::vector<Hull> other;  // in each frame
    query::KeptSimplex kept;
  };
  Random random(9);
  Maker<Scalar> maker(random);
  std::vector<Body> bodies(kBodies);
  int overlapping = 0;
  for (Body& body : bodies) {
    Hull other;
    maker.make(body.hull), maker.make(other);
    const Vector<Scalar, 3> place = maker.place(1), step = maker.place(0.02);
    for (int frame = 0; frame < kFrames; ++frame)
      body.other.push_back(moved<Scalar, 3>(other, Vector<Scalar, 3>(place + step * static_cast<Scalar>(frame))));
    overlapping += query::overlaps(body.hull, body.other.front()) ? 1 : 0;
  }
  const auto run = [&](bool keep) {
    int count = 0;
    for (Body& body : bodies)
      for (const Hull& other : body.other)
        count += query::gjk(body.hull, other, true, Ignore{}, keep ? &body.kept : nullptr)->overlap;
    bench::keep(count);
  };
  print_row("hull, hull: kept simplex / anew", sizeof(Scalar) == 4, "moving", 100.0 * overlapping / kBodies,
            bench::ratio([&] { run(true); }, [&] { run(false); }, kRounds), kBodies * kFrames, 0);
}

template <class Scalar>
void all_tests() {
  using namespace bench;
  one_test<Aabb<Scalar, 3>, Aabb<Scalar, 3>, PlainAabb<Scalar>, PlainAabb<Scalar>>("AABB, AABB", 1.2);
  one_test<Sphere<Scalar, 3>, Sphere<Scalar, 3>, PlainSphere<Scalar>, PlainSphere<Scalar>>("sphere, sphere", 1.5);
  one_test<Sphere<Scalar, 3>, Aabb<Scalar, 3>, PlainSphere<Scalar>, PlainAabb<Scalar>>("sphere, AABB", 1.5);
  one_test<Sphere<Scalar, 3>, Obb<Scalar, 3>, PlainSphere<Scalar>, PlainObb<Scalar>>("sphere, OBB", 1.5);
  one_test<Sphere<Scalar, 3>, Capsule<Scalar, 3>, PlainSphere<Scalar>, PlainCapsule<Scalar>>("sphere, capsule", 1.3);
  one_test<Capsule<Scalar, 3>, Capsule<Scalar, 3>, PlainCapsule<Scalar>, PlainCapsule<Scalar>>("capsule, capsule", 1.3);
  one_test<Sphere<Scalar, 3>, Lozenge<Scalar, 3>, PlainSphere<Scalar>, PlainLozenge<Scalar>>("sphere, lozenge", 1.3);
  one_test<Kdop<Scalar, 3>, Kdop<Scalar, 3>, PlainDop14<Scalar>, PlainDop14<Scalar>>("14-DOP, 14-DOP", 1.2);
  one_test<Obb<Scalar, 3>, Obb<Scalar, 3>, PlainObb<Scalar>, PlainObb<Scalar>>("OBB, OBB", 1.0);
  hulls<Scalar>();
}

// ---- frusta

/// A camera inside the field of volumes. near: the volumes lie nearer, and more of them are seen.
template <class Kind, class Plain>
void one_cull(const char* name, double aim) {
  using Scalar = typename query::VolumeKind<Kind>::Scalar;
  FrustumCamera<Scalar, 3> camera{.half_tangents = {Scalar(0.8), Scalar(0.5)}, .near = Scalar(0.5), .far = 80};
  camera.axes = turn(Vector<double, 3>(1, 2, -1), 0.7).template cast<Scalar>();
  const Frustum<Scalar, 3> frustum = *frustum_of_camera(camera);
  const query::Culler<Scalar, 3> culler(frustum);
  const bench::PlainFrustum<Scalar> plain_frustum(frustum);
  for (const double spread : {3.0, 60.0}) {
    Random random(5);
    Maker<Scalar> maker(random);
    std::vector<Kind> volumes(kPairs);
    for (Kind& volume : volumes) maker.make(volume), volume = moved<Scalar, 3>(volume, maker.place(spread));
    const std::vector<Plain> plain(volumes.begin(), volumes.end());
    int found = 0, plainly = 0;
    const auto ratio = bench::ratio(
        [&] {
          for (int again = 0; again < 20; ++again) {
            int count = 0;
            for (const Kind& volume : volumes) {
              count += static_cast<int>(culler(volume));
              bench::one_by_one(count);
            }
            bench::keep(found = count);
          }
        },
        [&] {
          for (int again = 0; again < 20; ++again) {
            int count = 0;
            for (const Plain& volume : plain) {
              count += bench::plain_cull(plain_frustum, volume);
              bench::one_by_one(count);
            }
            bench::keep(plainly = count);
          }
        },
        kRounds);
    if (found != plainly) std::printf("(%d, %d by the plain lines)\n", found, plainly);
    int outside = 0;
    for (const Kind& volume : volumes) outside += culler(volume) == query::Culling::kOutside;
    print_row(name, sizeof(Scalar) == 4, spread < 10 ? "near" : "scene", 100.0 * (kPairs - outside) / kPairs, ratio,
              kPairs * 20, aim);
  }
}

template <class Scalar>
void all_culls() {
  using namespace bench;
  one_cull<Sphere<Scalar, 3>, PlainSphere<Scalar>>("sphere, frustum", 1.3);
  one_cull<Aabb<Scalar, 3>, PlainAabb<Scalar>>("AABB, frustum", 1.3);
}

// ---- updates

/// One volume through many poses, as it follows a body.
template <class Kind, class Plain, class Update>
void one_update(const char* name, double aim, Update update) {
  using Scalar = typename query::VolumeKind<Kind>::Scalar;
  Random random(3);
  Maker<Scalar> maker(random);
  Kind volume;
  maker.make(volume);
  std::vector<Pose<Scalar, 3>> poses(kPairs);
  for (auto& pose : poses) {
    pose.rotation = turn(Vector<double, 3>(1, 2, 3), random.between(0, 6)).template cast<Scalar>();
    pose.translation = maker.place(kSpread);
  }
  const std::vector<bench::PlainPose<Scalar>> plain_poses(poses.begin(), poses.end());
  std::vector<Kind> moved(kPairs);
  const Plain plain(volume);
  std::vector<Plain> plainly(kPairs, plain);
  const auto ratio = bench::ratio(
      [&] {
        for (int again = 0; again < 20; ++again)
          for (int i = 0; i < kPairs; ++i) moved[i] = update(volume, poses[i]), bench::keep(moved[i]);
      },
      [&] {
        for (int again = 0; again < 20; ++again)
          for (int i = 0; i < kPairs; ++i)
            bench::plain_update(plain, plain_poses[i], plainly[i]), bench::keep(plainly[i]);
      },
      kRounds);
  print_row(name, sizeof(Scalar) == 4, "–", 0, ratio, kPairs * 20, aim);
}

template <class Scalar>
void all_updates() {
  using namespace bench;
  one_update<Sphere<Scalar, 3>, PlainSphere<Scalar>>(
      "sphere, R c + t", 1.5, [local = std::optional<Scalar>()](const auto& ball, const auto& pose) mutable {
        if (!local) local = fit::local_error(ball);
        return fit::update_sphere(ball, *local, pose).volume;
      });
  one_update<Obb<Scalar, 3>, PlainObb<Scalar>>(
      "OBB, R A and R c + t", 1.5, [local = std::optional<Scalar>()](const auto& box, const auto& pose) mutable {
        if (!local) local = fit::local_error(box);
        return fit::update_obb(box, *local, pose).volume;
      });
  one_update<Aabb<Scalar, 3>, PlainExtents<Scalar>>(
      "AABB of the rotated AABB, |R| h and R c + t", 1.5,
      [](const auto& box, const auto& pose) { return fit::update_rotated_box(box, pose).volume; });
}

/// The catalogue's own fit, beside one pass that takes the least and the greatest of each coordinate.
template <class Scalar>
void aabb_fit() {
  constexpr int kPoints = 10'000;
  Random random(2);
  Maker<Scalar> maker(random);
  std::vector<Vector<Scalar, 3>> points(kPoints);
  for (auto& point : points) point = maker.place(1);
  const auto set = *PointSet<Scalar, 3>::make(points);
  const auto ratio = bench::ratio([&] { bench::keep(fit::aabb_min_max(set.span())); },
                                  [&] {
                                    Vector<Scalar, 3> least = points.front(), most = least;
                                    for (const auto& p : points) least = least.cwiseMin(p), most = most.cwiseMax(p);
                                    bench::keep(least), bench::keep(most);
                                  },
                                  kRounds);
  print_row("fit of an AABB, one pass", sizeof(Scalar) == 4, "10,000 points", 0, ratio, kPoints, 0);
}

}  // namespace

int main() {
  std::puts(
      "| what | scalar | pairs | overlap, % | plain, ns | ours / plain | quartiles | at most | met | left to the whole "
      "test |");
  std::puts("|---|---|---|---:|---:|---:|---|---:|---|---|");
  all_tests<double>();
  all_tests<float>();
  all_culls<double>();
  all_culls<float>();
  all_updates<double>();
  all_updates<float>();
  aabb_fit<double>();
  aabb_fit<float>();
}
