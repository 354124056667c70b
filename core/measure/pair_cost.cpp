#include "measure/pair_cost.hpp"

#include <array>
#include <string_view>

#include "fit/catalogue.hpp"
#include "geometry/convert.hpp"
#include "geometry/random.hpp"
#include "query/overlaps_any.hpp"

namespace snug::cost {
namespace {

constexpr int kBodies = 24, kPoints = 12;
constexpr double kApart = 1.7;  // how far second bodies lie at most, in each coordinate: about half of them overlap

/// The algorithm that wraps a body in each kind, in kVolumeNames' order.
constexpr std::array<std::string_view, kVolumeNames.size()> kFitters{"ritter", "min_max", "pca",      "pca",
                                                                     "pca",    "",        "quickhull"};

template <int Dim>
struct Bodies {
  /// First and second bodies of each kind, in turn.
  std::array<std::vector<Volume<double, Dim>>, kVolumeNames.size()> of_kind;

  explicit Bodies(std::uint64_t seed) {
    Random random(seed);
    for (int body = 0; body < 2 * kBodies; ++body) {
      Vector<double, Dim> center = Vector<double, Dim>::Zero();
      for (int i = 0; i < Dim && body % 2 == 1; ++i) center[i] = random.between(-kApart, kApart);
      std::vector<Vector<double, Dim>> points(kPoints, center);
      for (auto& point : points)
        for (int i = 0; i < Dim; ++i) point[i] += random.between(-1, 1) / (i + 1);
      wrap(*PointSet<double, Dim>::make(std::move(points)));
    }
  }

  [[nodiscard]] int apart(std::size_t a, std::size_t b, bool by_gjk) const {
    Ignore observe;
    int apart = 0;
    for (std::size_t i = 0; i + 1 < of_kind[a].size(); i += 2) {
      const auto &first = of_kind[a][i], &second = of_kind[b][i + 1];
      const bool overlap = by_gjk ? query::any_pair::by_gjk<double, Dim>(first, second, observe).overlap
                                  : query::overlaps<double, Dim>(first, second);
      apart += overlap ? 0 : 1;
    }
    return apart;
  }

 private:
  void wrap(const AnyPointSet& points) {
    for (std::size_t kind = 0; kind < of_kind.size(); ++kind) {
      const std::string_view name = kVolumeNames[kind] == "kdop" ? (Dim == 2 ? "k8" : "k14") : kFitters[kind];
      const fit::Volume3 volume = fit::find_algorithm(kVolumeNames[kind], name)->fit(points, {}).volume;
      of_kind[kind].push_back(
          std::visit([](const auto& own) { return Volume<double, Dim>(converted<double, Dim>(own)); }, volume));
    }
  }
};

template <int Dim>
auto tests_of(std::uint64_t seed) {
  return [bodies = std::make_shared<const Bodies<Dim>>(seed)](std::size_t a, std::size_t b, bool by_gjk) {
    return bodies->apart(a, b, by_gjk);
  };
}

}  // namespace

PairCostRun::PairCostRun(int dim, std::uint64_t seed, const TimingOptions& timing, Clock clock)
    : timing_(timing), clock_(std::move(clock)) {
  if (dim == 2) test_ = tests_of<2>(seed);
  else test_ = tests_of<3>(seed);
}

Timing PairCostRun::of_one_test() const {
  Timing time = watch_->timing();
  time.median /= kBodies, time.min /= kBodies;
  return time;
}

void PairCostRun::step() {
  if (done()) return;
  if (watch_ == nullptr)
    watch_ = std::make_unique<Stopwatch>([this] { static_cast<void>(test_(a_, b_, by_gjk_)); }, timing_);
  watch_->step(clock_);
  if (!watch_->done()) return;
  (by_gjk_ ? row_.gjk : row_.time) = of_one_test();
  watch_.reset();
  if (!by_gjk_ && query::kPairTests[a_][b_] != query::PairTest::kGjk) return static_cast<void>(by_gjk_ = true);
  if (!by_gjk_) row_.gjk = row_.time;
  row_.a = a_, row_.b = b_;
  row_.apart = static_cast<double>(test_(a_, b_, false)) / kBodies;
  rows_.push_back(row_);
  by_gjk_ = false;
  if (++b_ == kVolumeNames.size()) b_ = ++a_;
}

}  // namespace snug::cost
