#include "app/subjects/cost/costs.hpp"

#include <algorithm>
#include <utility>

#include "app/subjects/cost/charts.hpp"
#include "geometry/generate.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/cost/cost.hpp"
#include "measure/growth.hpp"
#include "measure/sample.hpp"
#include "measure/turn_run.hpp"

namespace snug::app {
namespace {

/// With more points on the stage, every frame would be late; the chart needs no more.
constexpr Index kMostShown = 5'000;
/// The length of a batch that any browser's clock can measure, and the longest runs that do not delay a frame, ns; the
/// run with an observer is done only once or twice.
constexpr double kLeastBatch = 10e6, kMostBatch = 15e6, kLongest = 24e6, kLongestWatched = 28e6;
constexpr int kRepeats = 9;
/// A line has many points, so each gets fewer batches, and only three if those are long.
constexpr int kRepeatsOnLine = 5;
constexpr double kEnoughOnLine = 1e9;
/// The most points for growth; a set with fewer than the least says little, and generated points replace it.
constexpr Index kMostGrown = 1'000'000, kFewestGrown = 10'000;
constexpr std::string_view kStandIn = "cube";
constexpr int kFrames = 72;  // of a full turn

using AccuracySheet = CostSheetOf<cost::CostRun, cost::CostRow>;
using GrowthSheet = CostSheetOf<cost::GrowthRun, cost::GrowthRow>;
using TurnSheet = CostSheetOf<cost::TurnRun, cost::TurnRow>;

bool same(const AnyPointSet& a, const AnyPointSet& b) {
  const Index n = fit::count_of(a);
  if (a.index() != b.index() || n != fit::count_of(b)) return false;
  for (Index i = 0; i < n; ++i)
    if (fit::point_of(a, i) != fit::point_of(b, i)) return false;
  return true;
}

std::vector<const fit::Algorithm*> algorithms_of(const lesson::Session& session) {
  std::vector<const fit::Algorithm*> algorithms;
  for (const std::string& name : session.lesson().algorithms)
    if (const lesson::Method* method = lesson::find_method(session.lesson(), name))
      algorithms.push_back(fit::find_algorithm(method->volume, method->name));
  return algorithms;
}

/// The generator of the session's points, if they have one.
std::string generated_kind(const lesson::Session& session) {
  const auto kinds = generator_kinds();
  return std::find(kinds.begin(), kinds.end(), session.stage().subject().origin().source) != kinds.end()
             ? session.stage().subject().origin().source
             : std::string();
}

}  // namespace

Costs::Costs(const Platform& platform)
    : longest_growing_(platform.longest_run), sheets_{std::make_unique<AccuracySheet>(cost_chart),
                                                      std::make_unique<GrowthSheet>(growth_chart),
                                                      std::make_unique<TurnSheet>(turn_chart)} {
  take_rows();
  if (platform.clock == nullptr) return;
  clock_ = platform.clock;
  here_ = platform.here;
  here_.clock_resolution_ns = cost::resolution_of(clock_);
  options_.timing = {.repeats = kRepeats,
                     .batch = cost::batch_length(here_.clock_resolution_ns, kLeastBatch, kMostBatch)};
  options_.limits = {.longest = kLongest, .longest_watched = kLongestWatched};
}
Costs::~Costs() = default;

const CostTable& Costs::accuracy() const { return static_cast<const AccuracySheet&>(of(CostView::kAccuracy)).table; }
const GrowthTable& Costs::growth() const { return static_cast<const GrowthSheet&>(of(CostView::kGrowth)).table; }
const TurnTable& Costs::turn() const { return static_cast<const TurnSheet&>(of(CostView::kTurn)).table; }

tl::expected<void, InputError> Costs::load(lesson::Session& session, const io::PointFile& file, std::string_view name) {
  const auto n = static_cast<Index>(file.points.size());
  if (n <= kMostShown) return session.stage().load(file, name);
  if (file.points.size() > kMostMeasured)
    return tl::unexpected(InputError{
        .what = "there are " + chart_figure(ChartUnit::kCount, static_cast<double>(file.points.size())) +
                " points, and costs are measured on at most " + chart_figure(ChartUnit::kCount, kMostMeasured),
        .file = std::string(name)});
  auto set = io::to_point_set(file, name, 0, false);
  if (!set) return tl::unexpected(std::move(set.error()));
  const AnyPointSet some = cost::sample(*set, kMostShown, session.stage().subject().origin().seed);
  io::PointFile shown{.dim = file.dim, .points = {}, .triangles = {}};
  for (Index i = 0; i < kMostShown; ++i) shown.points.push_back(fit::point_of(some, i));
  if (auto loaded = session.stage().load(shown, name); !loaded) return loaded;
  whole_ = *std::move(set);
  some_ = some;
  return {};
}

bool Costs::may_see(const lesson::Session& session, CostView view) const {
  return view == CostView::kAccuracy || session.conversation().to_predict() == nullptr;
}

bool Costs::look_at(const lesson::Session& session, CostView view) {
  if (!may_see(session, view)) return false;
  refused_.clear();
  view_ = view;
  focus_row_ = -1;
  take_rows();
  show(true);
  return true;
}

template <class Row>
bool Costs::lay_over(const lesson::Session& session, cost::Table<Row> then) {
  constexpr bool growth = std::is_same_v<Row, cost::GrowthRow>, turn = std::is_same_v<Row, cost::TurnRow>;
  const CostView view = growth ? CostView::kGrowth : turn ? CostView::kTurn : CostView::kAccuracy;
  if (!may_see(session, view)) return false;
  using Sheet = std::conditional_t<growth, GrowthSheet, std::conditional_t<turn, TurnSheet, AccuracySheet>>;
  static_cast<Sheet&>(of(view)).lay_over(std::move(then));
  return look_at(session, view);
}
template bool Costs::lay_over(const lesson::Session&, CostTable);
template bool Costs::lay_over(const lesson::Session&, GrowthTable);
template bool Costs::lay_over(const lesson::Session&, TurnTable);

Index Costs::size(const lesson::Session& session) const {
  return whole_ && same(*some_, *session.stage().subject().points()) ? fit::count_of(*whole_)
                                                                     : session.stage().subject().size();
}

std::string Costs::not_for_these(const lesson::Session& session) const {
  if (view_ == CostView::kTurn) return {};
  const int dim = session.stage().subject().dim();
  for (const fit::Algorithm* algorithm : algorithms_of(session))
    if (!fit::takes(*algorithm, dim))
      return algorithm_title(algorithm->volume, algorithm->name) + " takes points with " +
             (dim == 2 ? "three" : "two") + " coordinates, and these have " + (dim == 2 ? "two." : "three.");
  return {};
}

void Costs::start(const lesson::Session& session) {
  const AnyPointSet& points = *session.stage().subject().points();
  at_start_[static_cast<std::size_t>(view_)] = points;
  subject_ = whole_ && same(*some_, points) && view_ != CostView::kTurn ? *whole_ : points;
  options_.fit.seed = session.stage().subject().origin().seed;
  cost::Provenance about = here_;
  about.points = session.stage().subject().origin().source, about.scalar = "double",
  about.dim = session.stage().subject().dim();
  about.seed = static_cast<std::int64_t>(session.stage().subject().origin().seed);
  if (view_ == CostView::kAccuracy) start_accuracy(session, std::move(about));
  else if (view_ == CostView::kGrowth) start_growth(session, std::move(about));
  else start_turn(std::move(about));
  at_work_ = view_;
  focus_row_ = -1;
  take_rows();
  show(true);
}

void Costs::start_accuracy(const lesson::Session& session, cost::Provenance about) {
  static_cast<AccuracySheet&>(of(CostView::kAccuracy))
      .start(std::make_unique<cost::CostRun>(*subject_, algorithms_of(session), options_, clock_), std::move(about));
}

/// Starts the growth measurement. Generated points come in any number; a mesh or a file has only its own.
void Costs::start_growth(const lesson::Session& session, cost::Provenance about) {
  std::string kind = generated_kind(session);
  if (kind.empty() && fit::count_of(*subject_) < kFewestGrown) kind = kStandIn;
  const Index most = kind.empty() ? std::min(kMostGrown, fit::count_of(*subject_)) : kMostGrown;
  const auto points = kind.empty()
                          ? std::make_shared<cost::PointStock>(*subject_, session.stage().subject().origin().seed)
                          : std::make_shared<cost::PointStock>(kind, session.stage().subject().dim(), false,
                                                               session.stage().subject().origin().seed);
  if (!kind.empty()) about.points = kind + ":" + std::to_string(most);
  std::vector<cost::Workload> loads;
  for (const fit::Algorithm* algorithm : algorithms_of(session))
    loads.push_back(cost::workload_of(*algorithm, session.stage().subject().dim(), most, points, options_.fit));
  cost::TimingOptions timing = options_.timing;
  timing.repeats = kRepeatsOnLine, timing.enough = kEnoughOnLine;
  static_cast<GrowthSheet&>(of(CostView::kGrowth))
      .start(std::make_unique<cost::GrowthRun>(std::move(loads), timing, longest_growing_, clock_), std::move(about));
}

void Costs::start_turn(cost::Provenance about) {
  std::vector<const fit::UpdateStrategy*> strategies;
  for (const fit::UpdateStrategy& strategy : fit::update_strategies())
    if (about.dim == 2 ? strategy.plane : strategy.space) strategies.push_back(&strategy);
  cost::TimingOptions timing = options_.timing;
  timing.repeats = kRepeatsOnLine;
  static_cast<TurnSheet&>(of(CostView::kTurn))
      .start(std::make_unique<cost::TurnRun>(*subject_, std::move(strategies), kFrames, timing, clock_),
             std::move(about));
}

/// Puts the finished rows onto the chart.
void Costs::take_rows() {
  chart_ = sheet().chart();
  places_.clear();
  ++version_;
}

void Costs::work(lesson::Session& session, double budget) {
  if (!running()) return;
  CostSheet& sheet = of(*at_work_);
  const bool more = sheet.work(clock_, budget);
  if (more && view_ == *at_work_) take_rows();
  if (sheet.done()) finish(session);
}

bool Costs::started_on_these(const lesson::Session& session, CostView view) const {
  const auto& then = at_start_[static_cast<std::size_t>(view)];
  return then && same(*then, *session.stage().subject().points());
}

/// Reports a complete result to the session, if its points are still the same.
void Costs::finish(lesson::Session& session) {
  const CostView done = *std::exchange(at_work_, std::nullopt);
  of(done).stop();
  take_rows();
  const bool whole = done == CostView::kAccuracy && accuracy().rows.size() == session.lesson().algorithms.size();
  if (!whole || !started_on_these(session, done)) return;
  session.inform<lesson::CostSubject>([&](lesson::CostSubject& chart) { chart.measured(accuracy().rows); });
}

bool Costs::command(lesson::Session& session, std::string_view name) {
  constexpr std::string_view kShow = "show_";
  if (name == "show_other") return look_at(session, static_cast<CostView>((static_cast<int>(view_) + 1) % kCostViews));
  if (name.substr(0, kShow.size()) == kShow) {
    const auto* const found = std::find(kCostViewNames.begin(), kCostViewNames.end(), name.substr(kShow.size()));
    return found != kCostViewNames.end() && look_at(session, static_cast<CostView>(found - kCostViewNames.begin()));
  }
  refused_.clear();
  if (name == "measure") {
    if (running() || !clock_ || session.conversation().asked() != nullptr) return false;
    refused_ = not_for_these(session);
    if (!refused_.empty()) return true;
    if (session.conversation().to_predict() != nullptr) session.conversation().ask_predictions();
    else start(session);
  } else if (name == "stop_measuring") {
    if (!running()) return false;
    finish(session);
  } else if (name == "toggle_chart") {
    show(!shown_);
  } else if (name == "chart_next" || name == "chart_previous") {
    move_focus(name == "chart_next" ? 1 : -1, false);
  } else if (name == "chart_down" || name == "chart_up") {
    move_focus(name == "chart_down" ? 1 : -1, true);
  } else if (name == "chart_load") {
    return load_algorithm(session);
  } else {
    return false;
  }
  return true;
}

std::unique_ptr<Cover> cost_cover(const Platform& platform) { return std::make_unique<Costs>(platform); }

}  // namespace snug::app
