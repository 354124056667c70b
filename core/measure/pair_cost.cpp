#include "measure/pair_cost.hpp"

#include <array>
#include <memory>
#include <string_view>
#include <utility>

#include "fit/catalogue.hpp"
#include "geometry/convert.hpp"
#include "geometry/random.hpp"
#include "query/overlap/overlaps_any.hpp"

namespace snug::cost {
namespace {

constexpr int kBodies = 96, kPoints = 12;
/// How far second bodies lie at most, in each coordinate: near, about half of them overlap.
constexpr double kNear = 1.7, kScene = 6;

/// The algorithm that wraps a body in each kind, in kVolumeNames' order.
constexpr std::array<std::string_view, kVolumeNames.size()> kFitters{"ritter", "min_max", "pca",      "pca",
                                                                     "pca",    "",        "quickhull"};

/// First and second bodies of each kind.
template <int Dim>
struct Bodies {
  using Kinds = std::array<std::vector<Volume<double, Dim>>, kVolumeNames.size()>;
  Kinds first, second;

  Bodies(double spread, std::uint64_t seed) {
    Random random(seed);
    for (int body = 0; body < 2 * kBodies; ++body) {
      Vector<double, Dim> center = Vector<double, Dim>::Zero();
      for (int i = 0; i < Dim && body % 2 == 1; ++i) center[i] = random.between(-spread, spread);
      std::vector<Vector<double, Dim>> points(kPoints, center);
      for (auto& point : points)
        for (int i = 0; i < Dim; ++i) point[i] += random.between(-1, 1) / (i + 1);
      wrap(*PointSet<double, Dim>::make(std::move(points)), body % 2 == 0 ? first : second);
    }
  }

 private:
  static void wrap(const AnyPointSet& points, Kinds& kinds) {
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      const std::string_view name = kVolumeNames[kind] == "kdop" ? (Dim == 2 ? "k8" : "k14") : kFitters[kind];
      const fit::Volume3 volume = fit::find_algorithm(kVolumeNames[kind], name)->fit(points, {}).volume;
      kinds[kind].push_back(
          std::visit([](const auto& own) { return Volume<double, Dim>(converted<double, Dim>(own)); }, volume));
    }
  }
};

template <int Dim>
using AnyOf = std::vector<Volume<double, Dim>>;

template <class Kind, int Dim>
std::vector<Kind> of_kind(const AnyOf<Dim>& volumes) {
  std::vector<Kind> own;
  for (const auto& volume : volumes) own.push_back(*std::get_if<Kind>(&volume));
  return own;
}

/// Tests each pair, and counts those that are apart.
template <class A, class B, class Overlap>
std::function<int()> work_of(std::vector<A> a, std::vector<B> b, Overlap overlap) {
  return [a = std::move(a), b = std::move(b), overlap] {
    int apart = 0;
    for (std::size_t i = 0; i < a.size(); ++i) apart += overlap(a[i], b[i]) ? 0 : 1;
    return apart;
  };
}

/// GJK goes by the variant of all kinds: that costs it next to nothing, and is compiled once.
template <int Dim>
std::function<int()> gjk_work(const AnyOf<Dim>& first, const AnyOf<Dim>& second) {
  return work_of(first, second, [](const auto& a, const auto& b) {
    Ignore ignore;
    return query::any_pair::by_gjk<double, Dim>(a, b, ignore, true).overlap;
  });
}

/// The pair's own test.
template <int Dim>
std::function<int()> own_work(const AnyOf<Dim>& first, const AnyOf<Dim>& second) {
  return std::visit(
      [&]<class A, class B>(const A&, const B&) -> std::function<int()> {
        if constexpr (query::VolumeKind<A>::kIndex > query::VolumeKind<B>::kIndex) return {};  // no pair of the table
        else if constexpr (query::kPairTest<A, B> == query::PairTest::kGjk) return gjk_work<Dim>(first, second);
        else
          return work_of(of_kind<A, Dim>(first), of_kind<B, Dim>(second),
                         [](const A& a, const B& b) { return query::overlaps(a, b); });
      },
      first.front(), second.front());
}

template <int Dim, class Works>
auto works_of(std::uint64_t seed) {
  const auto near = std::make_shared<const Bodies<Dim>>(kNear, seed);
  const auto scene = std::make_shared<const Bodies<Dim>>(kScene, seed);
  return [near, scene](std::size_t a, std::size_t b) {
    return Works{own_work<Dim>(near->first[a], near->second[b]), own_work<Dim>(scene->first[a], scene->second[b]),
                 gjk_work<Dim>(near->first[a], near->second[b])};
  };
}

}  // namespace

PairCostRun::PairCostRun(int dim, std::uint64_t seed, const TimingOptions& timing, Clock clock)
    : rounds_(timing, std::move(clock)) {
  if (dim == 2) works_of_ = works_of<2, Works>(seed);
  else works_of_ = works_of<3, Works>(seed);
}

void PairCostRun::start() {
  if (piece_ == 0 && !started_) works_ = works_of_(a_, b_);
  const std::array pieces{std::pair(&works_.near, &PairCost::time), std::pair(&works_.scene, &PairCost::scene),
                          std::pair(&works_.gjk, &PairCost::gjk)};
  const auto [work, timing] = pieces[static_cast<std::size_t>(piece_)];
  if (!std::exchange(started_, true)) {
    rounds_.add([work = *work] { static_cast<void>(work()); });
    timed_.push_back({rows_.size(), timing});
  }
  if (!rounds_.start_last()) return;
  started_ = false;
  const bool has_own = query::kPairTests[a_][b_] != query::PairTest::kGjk;
  if (++piece_ < (has_own ? 3 : 2)) return;
  piece_ = 0;
  rows_.push_back({.a = a_, .b = b_, .apart = static_cast<double>(works_.near()) / kBodies});
  if (++b_ == kVolumeNames.size()) b_ = ++a_;
  take_times();
}

void PairCostRun::take_times() {
  for (std::size_t i = 0; i < timed_.size(); ++i) rows_[timed_[i].row].*timed_[i].timing = rounds_.timing(i, kBodies);
  for (PairCost& row : rows_)
    if (query::kPairTests[row.a][row.b] == query::PairTest::kGjk) row.gjk = row.time;
}

void PairCostRun::step() {
  if (done()) return;
  if (rows_.size() < kPairs) return start();
  const int before = rounds_.round();
  rounds_.step();
  if (rounds_.round() != before || rounds_.done()) take_times();
}

}  // namespace snug::cost
