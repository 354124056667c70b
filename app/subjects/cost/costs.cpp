#include "app/subjects/cost/costs.hpp"

#include <algorithm>
#include <utility>

#include "app/brush.hpp"
#include "app/subjects/cost/captions.hpp"
#include "app/subjects/cost/charts.hpp"
#include "app/widgets.hpp"
#include "geometry/generate.hpp"
#include "measure/growth.hpp"
#include "measure/sample.hpp"
#include "measure/turn_run.hpp"

namespace snug::app {
namespace {

/// More points than this every frame would be late for; the chart needs no more of them on the stage.
constexpr Index kMostShown = 5'000;
/// A batch that any browser's clock can tell, and the longest runs that leave a frame its time, ns; the watched one is
/// done once or twice.
constexpr double kLeastBatch = 10e6, kMostBatch = 15e6, kLongest = 24e6, kLongestWatched = 28e6;
constexpr double kLongestLoaded = 0.3e9;  // what a click may take, ns
constexpr int kRepeats = 9;
/// A line has many points: each has fewer batches, and where those are long, three.
constexpr int kRepeatsOnLine = 5;
constexpr double kEnoughOnLine = 1e9;
/// How far growth is followed; a set of fewer points than the least says little of it, and others stand in.
constexpr Index kMostGrown = 1'000'000, kFewestGrown = 10'000;
constexpr std::string_view kStandIn = "cube";
constexpr int kFrames = 72;  // of a turn

using AccuracySheet = CostSheetOf<cost::CostRun, cost::CostRow>;
using GrowthSheet = CostSheetOf<cost::GrowthRun, cost::GrowthRow>;
using TurnSheet = CostSheetOf<cost::TurnRun, cost::TurnRow>;

bool same(const AnyPointSet& a, const AnyPointSet& b) {
  const Index n = fit::size_of(a);
  if (a.index() != b.index() || n != fit::size_of(b)) return false;
  for (Index i = 0; i < n; ++i)
    if (fit::point_of(a, i) != fit::point_of(b, i)) return false;
  return true;
}

std::vector<const fit::Algorithm*> algorithms_of(const lesson::Session& session) {
  std::vector<const fit::Algorithm*> algorithms;
  for (const std::string& name : session.lesson().algorithms)
    algorithms.push_back(fit::find_algorithm(session.lesson().volume, name));
  return algorithms;
}

/// The kind that the session's points are of, if they are of one.
std::string generated_kind(const lesson::Session& session) {
  const auto kinds = generator_kinds();
  return std::find(kinds.begin(), kinds.end(), session.source()) != kinds.end() ? session.source() : std::string();
}

/// Whether there are predictions that wait for the measurement.
bool awaits_measuring(const lesson::Session& session) {
  const auto& outcomes = session.outcomes();
  return std::any_of(outcomes.begin(), outcomes.end(), [](const lesson::Outcome& outcome) { return outcome.pending; });
}

std::optional<CostView> view_named(std::string_view name) {
  for (std::size_t i = 0; i < kCostViewNames.size(); ++i)
    if (kCostViewNames[i] == name) return static_cast<CostView>(i);
  return std::nullopt;
}

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kKeys{{{"ArrowRight", "chart_next"},
                                                                              {"ArrowDown", "chart_down"},
                                                                              {"ArrowLeft", "chart_previous"},
                                                                              {"ArrowUp", "chart_up"},
                                                                              {"Enter", "chart_load"}}};

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

const CostTable& Costs::table() const { return static_cast<const AccuracySheet&>(of(CostView::kAccuracy)).table; }
const GrowthTable& Costs::growth() const { return static_cast<const GrowthSheet&>(of(CostView::kGrowth)).table; }
const TurnTable& Costs::turn() const { return static_cast<const TurnSheet&>(of(CostView::kTurn)).table; }

tl::expected<void, InputError> Costs::load(lesson::Session& session, const io::PointFile& file, std::string_view name) {
  const auto n = static_cast<Index>(file.points.size());
  if (n <= kMostShown) return session.load(file, name);
  if (file.points.size() > kMostMeasured)
    return tl::unexpected(InputError{
        .what = "there are " + chart_figure(ChartUnit::kCount, static_cast<double>(file.points.size())) +
                " points, and costs are measured on at most " + chart_figure(ChartUnit::kCount, kMostMeasured),
        .file = std::string(name)});
  auto set = io::to_point_set(file, name, 0, false);
  if (!set) return tl::unexpected(std::move(set.error()));
  const AnyPointSet some = cost::sample(*set, kMostShown, session.seed());
  io::PointFile shown{.dim = file.dim, .points = {}, .triangles = {}};
  for (Index i = 0; i < kMostShown; ++i) shown.points.push_back(fit::point_of(some, i));
  if (auto loaded = session.load(shown, name); !loaded) return loaded;
  whole_ = *std::move(set);
  some_ = session.points();
  return {};
}

bool Costs::may_see(const lesson::Session& session, CostView view) const {
  return view == CostView::kAccuracy || session.asked() == nullptr;
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
  return whole_ && same(*some_, session.points()) ? fit::size_of(*whole_) : session.size();
}

void Costs::start(const lesson::Session& session) {
  at_start_ = session.points();
  subject_ = whole_ && same(*some_, *at_start_) && view_ != CostView::kTurn ? *whole_ : *at_start_;
  options_.fit.seed = session.seed();
  cost::Provenance about = here_;
  about.points = session.source(), about.scalar = "double", about.dim = session.dim();
  about.seed = static_cast<std::int64_t>(session.seed());
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

/// Generated points can be as many as one likes; a mesh or a file has only its own.
void Costs::start_growth(const lesson::Session& session, cost::Provenance about) {
  std::string kind = generated_kind(session);
  if (kind.empty() && fit::size_of(*subject_) < kFewestGrown) kind = kStandIn;
  const Index most = kind.empty() ? std::min(kMostGrown, fit::size_of(*subject_)) : kMostGrown;
  const auto points = kind.empty() ? std::make_shared<cost::PointStock>(*subject_, session.seed())
                                   : std::make_shared<cost::PointStock>(kind, session.dim(), false, session.seed());
  if (!kind.empty()) about.points = kind + ":" + std::to_string(most);
  std::vector<cost::Workload> loads;
  for (const fit::Algorithm* algorithm : algorithms_of(session))
    loads.push_back(cost::workload_of(*algorithm, session.dim(), most, points, options_.fit));
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

/// What is ready goes onto the chart.
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

/// Whole results alone are told to the session, if its points are still those.
void Costs::finish(lesson::Session& session) {
  const CostView done = *std::exchange(at_work_, std::nullopt);
  of(done).stop();
  take_rows();
  const bool whole = done == CostView::kAccuracy && table().rows.size() == session.lesson().algorithms.size();
  if (whole && same(*at_start_, session.points())) session.measured(table().rows);
}

bool Costs::command(lesson::Session& session, std::string_view name) {
  constexpr std::string_view kShow = "show_";
  if (name == "show_other") return look_at(session, static_cast<CostView>((static_cast<int>(view_) + 1) % kCostViews));
  if (name.substr(0, kShow.size()) == kShow) {
    const auto view = view_named(name.substr(kShow.size()));
    return view && look_at(session, *view);
  }
  refused_.clear();
  if (name == "measure") {
    if (running() || !clock_ || session.asked() != nullptr) return false;
    start(session);
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

std::optional<ChartHit> Costs::focused() const {
  for (std::size_t i = 0; i < chart_.series.size(); ++i) {
    const ChartSeries& series = chart_.series[i];
    if (focus_row_ >= 0 && series.row == focus_row_ && !series.points.empty())
      return ChartHit{i, std::min(focus_point_, series.points.size() - 1)};
  }
  return std::nullopt;
}

/// The chart's points in the order of the keys: by rising time, along a line and on along the next, or from line to
/// line.
std::vector<ChartHit> Costs::stops(bool to_line) const {
  std::vector<ChartHit> stops;
  const auto x_of = [&](const ChartHit& hit) { return chart_.series[hit.series].points[hit.point].x; };
  for (std::size_t i = 0; i < chart_.series.size(); ++i) {
    const ChartSeries& series = chart_.series[i];
    if (series.row < 0 || series.points.empty()) continue;
    const std::size_t last = series.points.size() - 1, only = std::min(focus_point_, last);
    for (std::size_t k = to_line ? only : 0; k <= (to_line ? only : last); ++k) {
      const ChartHit hit{i, k};
      stops.insert(series.line ? stops.end()
                               : std::find_if(stops.begin(), stops.end(),
                                              [&](const ChartHit& other) { return x_of(other) > x_of(hit); }),
                   hit);
    }
  }
  return stops;
}

/// Round and round.
void Costs::move_focus(int by, bool to_line) {
  const std::vector<ChartHit> order = stops(to_line);
  if (order.empty()) return;
  const auto now = focused();
  const auto n = static_cast<int>(order.size());
  const auto found = std::find_if(order.begin(), order.end(), [&](const ChartHit& hit) {
    return now && hit.series == now->series && hit.point == now->point;
  });
  const int at = found == order.end() ? (by > 0 ? 0 : n - 1) : (static_cast<int>(found - order.begin()) + by + n) % n;
  const ChartHit& to = order[at];
  focus_row_ = chart_.series[to.series].row;
  focus_point_ = to.point;
  ++version_;
}

bool Costs::load_algorithm(lesson::Session& session) {
  if (focus_row_ < 0 || view_ != CostView::kAccuracy) return false;
  const cost::CostRow& row = table().rows[focus_row_];
  ++version_;
  if (row.whole_ns && row.points < session.size() && *row.whole_ns > kLongestLoaded) {
    refused_ = algorithm_title(row.volume, row.algorithm) + " would take about " +
               chart_figure(ChartUnit::kTime, *row.whole_ns) +
               " on all points. It was measured on fewer of them, and is not loaded.";
    return false;
  }
  if (!session.choose(0, row.algorithm)) return false;
  session.jump(session.steps());
  shown_ = false;
  return true;
}

std::string Costs::status(const lesson::Session& session) const {
  if (session.asked() != nullptr) return std::string(kPredictFirst);
  const bool growth = view_ == CostView::kGrowth;
  const std::string points = chart_figure(ChartUnit::kCount, size(session)) + " points";
  const std::string on = sheet().about().points.substr(0, sheet().about().points.find(':'));
  std::string says;
  if (running() && *at_work_ == view_) says = "Measuring " + (growth ? on : points) + ".";
  else if (sheet().rows() > 0) says = std::to_string(count()) + " measured, on " + on + ".";
  else says = "Now press Measure: " + (growth ? "10 points and more." : points + ".");
  if (const cost::Provenance* then = sheet().then()) says += " Hollow: " + then->points + ", an earlier result.";
  return says;
}

int Costs::count() const {
  const std::size_t n = view_ == CostView::kGrowth ? lines_of(growth().rows).size()
                        : view_ == CostView::kTurn ? lines_of(turn().rows).size()
                                                   : table().rows.size();
  return static_cast<int>(n);
}

std::string Costs::caption(const lesson::Session& session) const {
  if (!refused_.empty()) return refused_;
  if (running() && *at_work_ != view_) return "Another chart is being measured: this one waits for it.";
  if (running()) {
    const int begun = count() + (view_ == CostView::kAccuracy ? 1 : 0);  // a line grows while it is measured
    const auto all = view_ == CostView::kTurn ? 0 : session.lesson().algorithms.size();
    return measuring_caption(std::max(0, begun - 1), static_cast<int>(all));
  }
  const bool any = sheet().rows() > 0;
  if (focus_row_ >= 0 && any) {
    if (view_ == CostView::kGrowth) return growth_caption(growth(), focus_row_, focus_point_);
    if (view_ == CostView::kTurn) return turn_caption(turn(), focus_row_, focus_point_);
    return accuracy_caption(table().rows[focus_row_]);
  }
  if (session.asked() != nullptr) return "Predict first, then measure.";
  if (!any && view_ == CostView::kAccuracy && awaits_measuring(session))
    return "Your predictions are in: now press Measure.";
  if (!any) return "Nothing is measured yet: press Measure.";
  if (view_ == CostView::kGrowth) return growth_caption(growth(), longest_growing_);
  return view_ == CostView::kTurn ? turn_caption(turn()) : accuracy_caption(table());
}

void Costs::draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->ground);
  // The buttons stand above it, the sentence below.
  const float above = look.fingers ? 60 : look.px(44), below = rect.width >= 560 ? look.px(76) : 4;
  const Rect room{rect.x, rect.y + above, rect.width, rect.height - above - below};
  const Touch touch = touch_area("chart", room);
  places_.clear();
  const auto hit = draw_chart(list, look, room, chart_, focused(), &places_);
  Obstacles none;
  if (with_sentence) draw_sentence(list, look, none, rect, caption(session));
  if (!touch.clicked || !hit || chart_.series[hit->series].row < 0) return;
  focus_row_ = chart_.series[hit->series].row;
  focus_point_ = hit->point;
  refused_.clear();
  ++version_;
  static_cast<void>(load_algorithm(session));
}

std::string_view Costs::command_of_key(std::string_view key) const {
  if (key == "c" || key == "C") return "toggle_chart";
  if (key == "m" || key == "M") return "measure";
  if (key == "v" || key == "V") return "show_other";
  const auto found = std::find_if(kKeys.begin(), kKeys.end(), [&](const auto& row) { return row.first == key; });
  return shown_ && found != kKeys.end() ? found->second : std::string_view();
}

std::vector<Handle> Costs::handles() const {
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < places_.size() && i < chart_.series.size(); ++i) {
    const int row = chart_.series[i].row;
    if (row < 0) continue;
    if (view_ == CostView::kAccuracy) handles.push_back({table().rows[row].algorithm, places_[i].x, places_[i].y});
    else if (view_ == CostView::kGrowth)
      handles.push_back({lines_of(growth().rows)[row][0].algorithm, places_[i].x, places_[i].y});
    else handles.push_back({chart_.series[i].name, places_[i].x, places_[i].y});
  }
  return handles;
}

std::unique_ptr<Cover> cost_cover(const Platform& platform) { return std::make_unique<Costs>(platform); }

Costs* costs_of(App& app) { return app.subject() == kCostSubject ? static_cast<Costs*>(app.cover()) : nullptr; }

}  // namespace snug::app
