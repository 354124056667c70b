#include <algorithm>
#include <array>
#include <cmath>

#include "lesson/subjects/cloud/by_hand.hpp"
#include "lesson/subjects/cloud/calipers_turn.hpp"
#include "lesson/subjects/cloud/call_tree.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/subjects/cloud/covariance_digits.hpp"
#include "lesson/subjects/cloud/edge_pairs.hpp"
#include "lesson/subjects/cloud/hull_growth.hpp"
#include "lesson/subjects/cloud/passes.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

constexpr std::array<std::string_view, kOperations> kOperationTitles{
    "Points touched",    "Distance tests", "Comparisons", "Dot products", "Square roots", "",
    "Orientation tests", "Exact decisions"};

std::string things_text(std::int64_t n, std::string_view one, std::string_view many) {
  return lesson::count_text(n) + " " + std::string(n == 1 ? one : many);
}

/// Collects the figures at one step of a run.
class FitBoard {
 public:
  FitBoard(const View& view, const FitRun& run, const Reference& reference)
      : view_(view), run_(run), reference_(reference), trace_(run.trace()),
        entry_(view.step > 0 ? &trace_[view.step - 1] : nullptr) {}

  std::vector<Figure> figures() {
    volume();
    seen();
    best();
    hull();
    slabs();
    turned();
    searched();
    calls();
    if (entry_ != nullptr) spread(entry_->step.fact);
    image();
    operations();
    return std::move(figures_);
  }

 private:
  void add(std::string_view name, std::string key, std::string text, double value, std::string_view unit) {
    figures_.push_back({std::string(name), std::move(key), std::move(text), value, std::string(unit)});
  }
  void length(std::string_view name, std::string key, double value, int digits = 4) {
    add(name, std::move(key), number_text(value, digits) + " units", value, "units");
  }
  void of_all(std::string_view name, std::string key, Index count) {
    add(name, std::move(key), count_text(count) + " of " + count_text(fit::count_of(run_.points())), count, "points");
  }

  void volume() {
    if (entry_ == nullptr || !entry_->step.has_volume) return;
    const bool ball = ball_of(entry_->step) != nullptr;
    if (ball) radius(fit::size_of(entry_->step.volume, run_.dim()));
    const double measure = fit::measure_of(entry_->step.volume, run_.dim());
    if (!ball || reference_.by_measure) this->measure(measure);
    const double own = reference_.by_measure ? measure : fit::size_of(entry_->step.volume, run_.dim());
    const Index outside = run_.outside_at(view_.step - 1);
    if (const auto over = excess_of(own, reference_.size)) excess(*over, outside == 0);
    of_all("Points outside", "outside", outside);
    const auto holding = static_cast<int>(run_.support(view_.step).size());
    // Before the end there may be no support set yet: a dash is shown then.
    add(run_.exact() ? "Support set" : "Found on the boundary", "support",
        holding > 0 ? things_text(holding, "point", "points") : "—", holding, "points");
    figures_.back().known = holding > 0;
  }

  [[nodiscard]] std::string so_far() const { return view_.step == static_cast<int>(trace_.size()) ? "" : " so far"; }
  void radius(double value) { length("Radius" + so_far(), "radius", value, digits_beside_best(value)); }
  void measure(double value) {
    const bool plane = run_.dim() == 2;
    const std::string unit = plane ? "units²" : "units³";
    add((plane ? "Area" : "Volume") + so_far(), "measure", number_text(value) + " " + unit, value, unit);
  }

  void excess(double excess, bool holds_all) {
    const std::string text = reference_.by_measure ? looseness_text(excess) : percent_text(excess);
    add("Excess over " + reference_.name, "excess", holds_all ? text : "—", holds_all ? 100 * excess : 0, "%");
    figures_.back().known = holds_all;
  }

  /// How far the pass over the points has come. Points that Welzl's recursion visits again do not count.
  void seen() {
    if (entry_ == nullptr) return;
    int seen = 0;
    bool passes = false;
    for (int i = view_.step; i-- > 0;) {
      const auto& fact = trace_[i].step.fact;
      if (const auto* shrunk = std::get_if<BallShrunk<double, 3>>(&fact)) {
        add("Pass", "pass", std::to_string(shrunk->pass), shrunk->pass, "");
        break;
      }
      const auto* examined = std::get_if<PointExamined>(&fact);
      passes = passes || examined != nullptr;
      if (examined != nullptr && examined->depth == 0) ++seen;
    }
    if (passes) of_all("Points seen", "seen", seen);
    const auto* examined = std::get_if<PointExamined>(&entry_->step.fact);
    const Sphere3* ball = ball_of(entry_->step);
    if (examined != nullptr && examined->outside && ball != nullptr)
      length("Outside by", "outside_by", examined->distance - ball->radius);
    if (const auto* grown = std::get_if<BallGrown<double, 3>>(&entry_->step.fact); grown != nullptr && ball != nullptr)
      growth(*grown, ball->radius);
  }

  /// The lengths of Ritter's formula.
  void growth(const BallGrown<double, 3>& grown, double radius) {
    const double dist = (point_of(run_.points(), grown.point) - grown.before.center).norm();
    length("Old radius", "old_radius", grown.before.radius);
    length("Distance dist", "dist", dist);
    if (dist > 0)
      add("Factor k", "k", number_text((radius - grown.before.radius) / dist), (radius - grown.before.radius) / dist,
          "");
  }

  /// The number of digits with which a radius differs from the one that it is compared with.
  [[nodiscard]] int digits_beside_best(double radius) const {
    const auto before = best_before(trace_, view_.step), best = best_so_far(trace_, view_.step);
    return before ? digits_apart(radius, *before) : best ? digits_apart(radius, *best) : 4;
  }

  void best() {
    if (view_.step == static_cast<int>(trace_.size()) || entry_ == nullptr) return;
    if (const auto best = best_so_far(trace_, view_.step)) {
      const int digits = digits_beside_best(fit::size_of(entry_->step.volume, run_.dim()));
      if (const auto before = best_before(trace_, view_.step))
        length("Best before this pass", "best_before", *before, digits);
      return length("Best so far", "best", *best, digits);
    }
    int tried = 0;
    for (int i = view_.step; i-- > 0;)
      if (std::holds_alternative<CandidateTried<double, 3>>(trace_[i].step.fact)) ++tried;
    const std::string one = ball_word(run_.dim()), many = one + "s";
    if (tried > 0) add("Candidates tried", "candidates", things_text(tried, one, many), tried, many);
  }

  /// How far Quickhull has come: the same rows at every step.
  void hull() {
    const auto* result = std::get_if<ConvexHull<double, 3>>(&run_.recording().result.volume);
    if (result == nullptr || !run_.axes_by_hand().empty()) return;
    const auto grown = growing_hull(trace_, view_.step);
    const bool done = view_.step == static_cast<int>(trace_.size());
    const auto number = [&](std::string_view name, std::string key, std::size_t n, std::string_view unit) {
      add(name, std::move(key), count_text(static_cast<std::int64_t>(n)), static_cast<double>(n), unit);
    };
    const std::size_t vertices = done ? result->vertices.size() : grown ? grown->vertices().size() : 0;
    const std::size_t facets = done ? result->facets.size() : grown ? static_cast<std::size_t>(grown->alive()) : 0;
    number("Vertices" + so_far(), "vertices", vertices, "vertices");
    number((run_.dim() == 2 ? "Edges" : "Facets") + so_far(), "facets", facets, run_.dim() == 2 ? "edges" : "facets");
    if (!grown) return;
    number("Still outside", "still_outside", done ? 0 : grown->still_outside(), "points");
    number("Dropped", "dropped", grown->dropped.size(), "points");
    number("Farthest points chosen", "rounds", grown->rounds, "points");
    if (run_.dim() == 2) return;
    number("Facets that the eye sees", "seen_facets", grown->seen.size(), "facets");
    if (grown->seen.empty()) figures_.back().text = "—", figures_.back().known = false;  // an eye sees one at least
  }

  /// The slabs that were found so far in directions set by hand, and what it takes to store them.
  void slabs() {
    if (run_.axes_by_hand().empty()) return;
    const auto is_slab = [](const auto& entry) { return std::holds_alternative<SlabFound>(entry.step.fact); };
    const auto found = std::count_if(trace_.begin(), trace_.begin() + view_.step, is_slab);
    constexpr int kBytes = 2 * sizeof(float);
    add("Slabs" + so_far(), "slabs", things_text(found, "slab", "slabs"), static_cast<double>(found), "slabs");
    add("Stored as float", "bytes", things_text(kBytes * found, "byte", "bytes"), static_cast<double>(kBytes * found),
        "bytes");
  }

  /// The rectangles around a projection in space.
  void turned() {
    const auto turn = calipers_turn(trace_, view_.step);
    if (turn.empty()) return;
    const auto area = [&](std::string_view name, std::string key, double value) {
      add(name, std::move(key), number_text(value) + " units²", value, "units²");
    };
    if (std::holds_alternative<CalipersTurned<double, 3>>(entry_->step.fact))
      area("Rectangle on this edge", "rectangle", turn.back()->area);
    area("Smallest of this projection", "rectangle_least", turn.back()->least);
  }

  /// How far the exact search among pairs of edges has come.
  void searched() {
    const EdgePairs pairs = edge_pairs(trace_, view_.step);
    if (pairs.all == 0) return;
    const auto number = [&](std::string_view name, std::string key, std::int64_t n, std::string_view unit) {
      add(name, std::move(key), count_text(n), static_cast<double>(n), unit);
    };
    add("Pairs of edges left", "pairs_left", count_text(pairs.left) + " of " + count_text(pairs.all),
        static_cast<double>(pairs.left), "pairs");
    number("Ruled out at once", "pairs_ruled_out", pairs.ruled_out, "pairs");
    number("Halvings", "halvings", pairs.halvings, "halvings");
  }

  /// How deep the recursion is.
  void calls() {
    if (!has_calls(trace_)) return;
    const CallTree tree = call_tree(trace_, view_.step);
    const auto open = static_cast<std::int64_t>(tree.open.size()), made = static_cast<std::int64_t>(tree.calls.size());
    add("Calls open", "depth", count_text(open), static_cast<double>(open), "calls");
    add("Deepest so far", "deepest", things_text(tree.deepest, "call", "calls"), tree.deepest, "calls");
    add("Kept on the stack", "stack_bytes", things_text(tree.bytes, "byte", "bytes"), static_cast<double>(tree.bytes),
        "bytes");
    add("Calls made", "calls", count_text(made), static_cast<double>(made), "calls");
  }

  void spread(const Step3::Fact& fact) {
    if (const auto* mean = std::get_if<MeanFound<double, 3>>(&fact)) middle(mean->mean);
    if (const auto* covariance = covariance_at()) {
      if (std::holds_alternative<CovarianceFound<double, 3>>(fact)) middle(covariance->mean);
      entries("C", "covariance_", covariance->covariance);
      if (sums()) digits(*covariance);
    }
    if (const auto* products = std::get_if<ProductsAdded<double, 3>>(&fact)) entries("Sum of", "sum_", products->sum);
    const auto* axes = std::get_if<AxesFound<double, 3>>(&fact);
    if (axes == nullptr) return;
    for (int i = 1; i <= run_.dim(); ++i) {
      const double variance = axes->variances[3 - i];
      const std::string n = std::to_string(i);
      add("Variance along v" + n, "variance_" + n, number_text(variance) + " units²", variance, "units²");
      length("Standard deviation along v" + n, "deviation_" + n, std::sqrt(std::max(variance, 0.0)));
    }
  }
  /// The entries of a symmetric matrix: "C x y", "Sum of x y".
  void entries(const std::string& word, const std::string& key, const Matrix<double, 3>& matrix) {
    constexpr std::string_view kNames = "xyz";
    for (int row = 0; row < run_.dim(); ++row)
      for (int column = row; column < run_.dim(); ++column) {
        const std::string pair{kNames[row], kNames[column]};
        add(word + " " + pair[0] + " " + pair[1], key + pair, number_text(matrix(row, column)) + " units²",
            matrix(row, column), "units²");
      }
  }
  /// That of this step; where its sums are the run's subject, the one found before as well.
  [[nodiscard]] const CovarianceFound<double, 3>* covariance_at() const {
    const int oldest = sums() ? 0 : view_.step - 1;
    for (int i = view_.step; i-- > oldest;)
      if (const auto* found = std::get_if<CovarianceFound<double, 3>>(&trace_[i].step.fact)) return found;
    return nullptr;
  }
  /// Products are added before there is a volume, so a long trace is not read to its end.
  [[nodiscard]] bool sums() const {
    const auto decides = [](const auto& entry) {
      return entry.step.has_volume || std::holds_alternative<ProductsAdded<double, 3>>(entry.step.fact);
    };
    const auto found = std::find_if(trace_.begin(), trace_.end(), decides);
    return found != trace_.end() && !found->step.has_volume;
  }
  void digits(const CovarianceFound<double, 3>& found) {
    const int right = digits_right(found.covariance, run_.points());
    add("Correct digits", "digits", std::to_string(right), right, "digits");
  }
  /// How far a direction set by hand is from being an eigenvector.
  void image() {
    if (view_.method().name != kEigenByHand) return;
    const auto seen = image_after(run_.recording(), view_.step);
    if (!seen) return;
    add("Angle between v and C v", "image_angle", number_text(seen->degrees) + "°", seen->degrees, "degrees");
    const double along = seen->direction.dot(seen->image);
    add("Variance along v", "image_variance", number_text(along) + " units²", along, "units²");
  }
  void middle(const Vector<double, 3>& mean) {
    for (int i = 0; i < run_.dim(); ++i)
      length(std::string("Mean ") + "xyz"[i], std::string("mean_") + "xyz"[i], mean[i]);
  }

  /// Lists the operations that the algorithm uses at all, so that the rows stay the same from step to step.
  void operations() {
    for (std::size_t i = 0; i < kOperations; ++i) {
      if (run_.recording().counts[i] == 0) continue;
      const std::int64_t n = entry_ != nullptr ? entry_->counts[i] : 0;
      const bool balls = i == static_cast<std::size_t>(Operation::kBallSolves);
      const std::string balls_title = run_.dim() == 2 ? "Circumcircles" : "Circumspheres";
      add(balls ? balls_title : kOperationTitles[i], std::string(kOperationNames[i]), count_text(n),
          static_cast<double>(n), "");
    }
  }

  const View& view_;
  const FitRun& run_;
  const Reference& reference_;
  FitTrace trace_;
  const Recorder<Step3>::Entry* entry_;
  std::vector<Figure> figures_;
};

}  // namespace

std::vector<Figure> fit_figures(const View& view, const FitRun& run, const Reference& reference) {
  return FitBoard(view, run, reference).figures();
}

}  // namespace snug::lesson
