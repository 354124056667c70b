#include "measure/claims.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "measure/hard_cloud.hpp"
#include "measure/volume_cost.hpp"

namespace snug::cost {
namespace {

constexpr std::string_view kGeometry = "Data Structures & Algorithms for Geometry";
constexpr std::string_view kPhysics = "Physics based animation, Lecture 09";

/// Equal sizes differ by rounding.
constexpr double kSame = 1 + 1e-9;

const fit::Algorithm& algorithm_of(std::string_view volume, std::string_view name) {
  return *fit::find_algorithm(volume, name);
}
double size_by(std::string_view volume, std::string_view name, const AnyPointSet& points, std::uint64_t seed) {
  return fit::size_of(algorithm_of(volume, name).fit(points, {.seed = seed}).volume, 3);
}

// ---- size over the smallest

/// The size of what shows a counter-example, over the smallest.
double over_smallest(const Claim& claim, const AnyPointSet& points, std::uint64_t seed) {
  return 1 + excess_on(algorithm_of(claim.volume, claim.algorithm), points, seed);
}

// ---- the first sphere and the last

/// The radius of the first sphere of a growing pass, and of the last.
struct Grown {
  double first = 0, last = 0;
};

Grown grown_by(std::string_view algorithm, const AnyPointSet& points) {
  Grown grown;
  const auto see = [&](const fit::Step3& step, const OperationCounts&) {
    if (const fit::Sphere3* ball = fit::ball_of(step); ball != nullptr && grown.first == 0) grown.first = ball->radius;
  };
  grown.last = fit::size_of(algorithm_of("sphere", algorithm).watch(points, {}, see).result.volume, 3);
  return grown;
}

/// The radius that grew from the larger first sphere, over that from the smaller. The sphere through two points is
/// never larger than the smallest sphere of all: the larger is the better guess.
double better_start(const Claim&, const AnyPointSet& points, std::uint64_t) {
  const Grown ritter = grown_by("ritter", points), pca = grown_by("pca", points);
  const bool by_pca = pca.first > ritter.first;
  return by_pca ? pca.last / ritter.last : ritter.last / pca.last;
}

// ---- work

double work_by(std::string_view algorithm, const AnyPointSet& points, std::uint64_t seed) {
  const fit::Watched run = algorithm_of("sphere", algorithm).watch(points, {.seed = seed}, {});
  return static_cast<double>(std::accumulate(run.counts.begin(), run.counts.end(), std::int64_t{0}));
}

/// The first points of a cloud.
AnyPointSet first_of(const AnyPointSet& points, Index n) {
  std::vector<Vector<double, 3>> some;
  for (Index i = 0; i < n; ++i) some.push_back(fit::point_of(points, i));
  return *PointSet<double, 3>::make(std::move(some));
}

/// The work for each point over that for a tenth of the points.
double welzl_growth(const Claim&, const AnyPointSet& points, std::uint64_t seed) {
  constexpr Index kTimes = 10;
  const AnyPointSet few = first_of(points, fit::count_of(points) / kTimes);
  return work_by("welzl", points, seed) / work_by("welzl", few, seed) / static_cast<double>(kTimes);
}

/// How many times the work for half of the points.
double brute_growth(const Claim&, const AnyPointSet& points, std::uint64_t seed) {
  const AnyPointSet few = first_of(points, fit::count_of(points) / 2);
  return work_by("brute_force", points, seed) / work_by("brute_force", few, seed);
}

// ---- boxes, k-DOPs

double hull_over_points(const Claim&, const AnyPointSet& points, std::uint64_t seed) {
  return size_by("obb", "pca_hull", points, seed) / size_by("obb", "pca", points, seed);
}
double kdop_over_box(const Claim&, const AnyPointSet& points, std::uint64_t seed) {
  return size_by("kdop", "k14", points, seed) / size_by("obb", "exact", points, seed);
}

// ---- memory

/// The numbers of both in float: the same for every cloud.
double kdop_bytes_over_box(const Claim&, const AnyPointSet& points, std::uint64_t seed) {
  const auto bytes = [&](std::string_view volume, std::string_view name) {
    return static_cast<double>(bytes_of(algorithm_of(volume, name).fit(points, {.seed = seed}).volume, 3, true));
  };
  return bytes("kdop", "k14") / bytes("obb", "pca");
}

constexpr std::array kClaims{
    Claim{"four_points", kGeometry, "Brute-force", "The smallest sphere is one through four of the points",
          "Four points", "radius of the smallest sphere through four points, over the smallest of all", "no larger",
          kSame, "sphere", "brute_force_slide", 12, over_smallest},
    Claim{"better_start", kGeometry, "Ritter's Algorithm (cont.)",
          "The better the first sphere, the better the final one", "First sphere",
          "final radius from the better first sphere, over that from the worse", "no larger", kSame, "sphere", "pca",
          26, better_start},
    Claim{"brute_force_growth", kGeometry, "Sphere Creation", "Brute force takes O(n^5)", "Brute force",
          "operations for 16 points, over those for 8", "at most 2^5 = 32 times", 32, "sphere", "brute_force", 16,
          brute_growth},
    Claim{"welzl_growth", kGeometry, "Welzl's Algorithm (cont.)", "Welzl's algorithm runs in expected O(n)", "Welzl",
          "operations per point of 300, over those per point of 30", "no more", 1, "sphere", "welzl", 300,
          welzl_growth},
    Claim{"hull_helps", kGeometry, "PCA for OBB", "The hull makes the box of PCA smaller", "Hull",
          "volume of the box by PCA of the hull, over that by PCA of the points", "no larger", kSame, "obb", "pca_hull",
          40, hull_over_points},
    Claim{"ritter_ten_per_cent", kGeometry, "Ritter's Algorithm", "Ritter's sphere comes within 10 % of the smallest",
          "Ritter", "radius of Ritter’s sphere, over the smallest", "at most 10 % larger", 1.10, "sphere", "ritter", 26,
          over_smallest},
    Claim{"iterative_five_per_cent", kGeometry, "Sphere Creation",
          "The iterated sphere comes within 5 % of the smallest", "Iterated",
          "radius of the iterated sphere, over the smallest", "at most 5 % larger", 1.05, "sphere", "ritter_iterative",
          26, over_smallest},
    Claim{"brute_force_fifth_power", kGeometry, "Sphere Creation", "Trying every sphere takes O(n^5)"},
    Claim{"welzl_stack", kGeometry, "Welzl's Algorithm (cont.)", "Welzl's first recursion easily overflows the stack"},
    Claim{"kdop_storage", kPhysics, "k-DOP pros and cons", "A 14-DOP takes about as much storage as an oriented box"},
    Claim{"kdop_tighter", kPhysics, "k-DOP pros and cons", "A 14-DOP is likely to be tighter than an oriented box",
          "14-DOP", "volume of the 14-DOP, over that of the smallest box", "no larger", 1, "kdop", "k14", 40,
          kdop_over_box},
    Claim{"as_much_memory", kPhysics, "k-DOP pros and cons", "A 14-DOP takes about as much memory as an oriented box",
          "Memory", "bytes of the 14-DOP in float, over those of the box", "at most 10 % more", 1.10, "kdop", "k14", 40,
          kdop_bytes_over_box},
    Claim{"pca_not_optimal", kGeometry, "PCA for OBB",
          "PCA boxes are not the smallest; using the hull improves them but does not make them optimal"},
    Claim{"box_on_a_face", kGeometry, "OBB Creation", "The smallest box has a side flush with a face of the hull",
          "On a face", "volume of the best box on a face, over the smallest", "no larger", kSame, "obb", "face_aligned",
          26, over_smallest},
    Claim{"orourke_cube", kPhysics, "Computing an OBB", "O'Rourke's smallest box takes O(n^3)"},
};

}  // namespace

std::span<const Claim> claims() { return kClaims; }

const Claim* find_claim(std::string_view name) {
  const auto* const found =
      std::find_if(kClaims.begin(), kClaims.end(), [&](const Claim& c) { return c.name == name; });
  return found != kClaims.end() ? found : nullptr;
}

const std::vector<const Claim*>& tried_claims() {
  static const std::vector<const Claim*> tried = [] {
    std::vector<const Claim*> all;
    for (const Claim& claim : kClaims)
      if (claim.measure != nullptr) all.push_back(&claim);
    return all;
  }();
  return tried;
}

const Claim* find_trial(std::string_view name) {
  const Claim* const claim = find_claim(name);
  return claim != nullptr && claim->measure != nullptr ? claim : nullptr;
}

}  // namespace snug::cost
