#include "app/costs.hpp"

#include <algorithm>
#include <utility>

#include "app/cost_charts.hpp"
#include "app/stage_brush.hpp"
#include "app/widgets.hpp"
#include "measure/sample.hpp"

namespace snug::app {
namespace {

/// More points than this every frame would be late for; the chart needs no more of them on the stage.
constexpr Index kMostShown = 5'000;
/// A batch that any browser's clock can tell, and the longest runs that leave a frame its time, ns; the watched one is
/// done once or twice.
constexpr double kLeastBatch = 10e6, kMostBatch = 15e6, kLongest = 16e6, kLongestWatched = 24e6;
constexpr double kLongestLoaded = 0.3e9;  // what a click may take, ns
constexpr int kRepeats = 9;

bool same(const AnyPointSet& a, const AnyPointSet& b) {
  const Index n = fit::size_of(a);
  if (a.index() != b.index() || n != fit::size_of(b)) return false;
  for (Index i = 0; i < n; ++i)
    if (fit::point_of(a, i) != fit::point_of(b, i)) return false;
  return true;
}

std::string title_of(const cost::CostRow& row) {
  const fit::Algorithm* algorithm = fit::find_algorithm(row.volume, row.algorithm);
  return std::string(algorithm != nullptr ? algorithm->title : std::string_view(row.algorithm));
}

}  // namespace

Costs::Costs(const Platform& platform) {
  if (platform.clock == nullptr) return;
  clock_ = platform.clock;
  table_.provenance = platform.here;
  table_.provenance.clock_resolution_ns = cost::resolution_of(clock_);
  options_.timing = {.repeats = kRepeats,
                     .batch = cost::batch_length(table_.provenance.clock_resolution_ns, kLeastBatch, kMostBatch)};
  options_.limits = {.longest = kLongest, .longest_watched = kLongestWatched};
}

void Costs::open() {
  run_.reset();
  whole_.reset(), then_.reset();
  table_.rows.clear();
  focus_ = -1;
  show(false);  // the shape is what the predictions are of
  take_rows();
}

tl::expected<void, InputError> Costs::load(lesson::Session& session, const io::PointFile& file, std::string_view name) {
  const auto n = static_cast<Index>(file.points.size());
  if (n <= kMostShown) return session.load(file, name);
  if (file.points.size() > kMostMeasured)
    return tl::unexpected(InputError{.what = "there are " + chart_figure(ChartUnit::kCount, static_cast<double>(file.points.size())) +
                                             " points, and costs are measured on at most " +
                                             chart_figure(ChartUnit::kCount, kMostMeasured),
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

void Costs::lay_over(CostTable then) {
  then_ = std::move(then);
  take_rows();
  show(true);
}

Index Costs::size(const lesson::Session& session) const {
  return whole_ && same(*some_, session.points()) ? fit::size_of(*whole_) : session.size();
}

void Costs::start(const lesson::Session& session) {
  at_start_ = session.points();
  subject_ = whole_ && same(*some_, *at_start_) ? *whole_ : *at_start_;
  std::vector<const fit::Algorithm*> algorithms;
  for (const std::string& name : session.lesson().algorithms)
    algorithms.push_back(fit::find_algorithm(session.lesson().volume, name));
  options_.fit.seed = session.seed();
  cost::Provenance& about = table_.provenance;
  about.points = session.source(), about.scalar = "double", about.dim = session.dim();
  about.seed = static_cast<std::int64_t>(session.seed());
  table_.rows.clear();
  focus_ = -1;
  percent_ = 0;
  run_ = std::make_unique<cost::CostRun>(*subject_, std::move(algorithms), options_, clock_);
  take_rows();
  show(true);
}

/// What is ready goes onto the chart.
void Costs::take_rows() {
  if (run_ != nullptr) table_.rows = run_->rows();
  cost::mark_front(table_.rows);
  chart_ = cost_chart(table_, then());
  ++version_;
}

void Costs::work(lesson::Session& session, double budget) {
  if (run_ == nullptr) return;
  cost::advance(*run_, clock_, budget);
  const int percent = static_cast<int>(100 * run_->progress());
  if (std::exchange(percent_, percent) != percent) ++version_;
  if (run_->rows().size() != table_.rows.size()) take_rows();
  if (run_->done()) finish(session);
}

/// Whole results alone are told to the session, if its points are still those.
void Costs::finish(lesson::Session& session) {
  run_.reset();
  ++version_;
  if (table_.rows.size() == session.lesson().algorithms.size() && same(*at_start_, session.points())) session.measured(table_.rows);
}

bool Costs::command(lesson::Session& session, std::string_view name) {
  if (!session.lesson().measures) return false;
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
    move_focus(name == "chart_next" ? 1 : -1);
  } else if (name == "chart_load") {
    return load_algorithm(session);
  } else {
    return false;
  }
  return true;
}

/// From mark to mark by rising time, round and round.
void Costs::move_focus(int by) {
  std::vector<int> order;
  for (const ChartSeries& series : chart_.series)
    if (series.row >= 0) order.push_back(series.row);
  if (order.empty()) return;
  const auto time = [&](int row) { return table_.rows[static_cast<std::size_t>(row)].time.median; };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return time(a) < time(b); });
  const auto n = static_cast<int>(order.size());
  const auto found = std::find(order.begin(), order.end(), focus_);
  const int at = found == order.end() ? (by > 0 ? 0 : n - 1) : (static_cast<int>(found - order.begin()) + by + n) % n;
  focus_ = order[static_cast<std::size_t>(at)];
  ++version_;
}

bool Costs::load_algorithm(lesson::Session& session) {
  if (focus_ < 0) return false;
  const cost::CostRow& row = table_.rows[static_cast<std::size_t>(focus_)];
  ++version_;
  if (row.whole_ns && row.points < session.size() && *row.whole_ns > kLongestLoaded) {
    refused_ = title_of(row) + " would take about " + chart_figure(ChartUnit::kTime, *row.whole_ns) +
               " on all points: it was measured on fewer, and is not loaded.";
    return false;
  }
  if (!session.choose(0, row.algorithm)) return false;
  session.jump(session.steps());
  shown_ = false;
  return true;
}

std::string Costs::caption(const lesson::Session& session) const {
  if (!refused_.empty()) return refused_;
  const auto all = session.lesson().algorithms.size();
  if (running()) return "Measuring: " + std::to_string(table_.rows.size()) + " of " + std::to_string(all) + " algorithms are done.";
  if (focus_ >= 0) {
    const cost::CostRow& row = table_.rows[static_cast<std::size_t>(focus_)];
    std::string said = title_of(row) + ": " + chart_figure(ChartUnit::kTime, row.time.median);
    if (row.tightness) said += ", " + chart_figure(ChartUnit::kRatio, *row.tightness) + " times the smallest";
    else if (row.over_hull) said += ", " + chart_figure(ChartUnit::kRatio, *row.over_hull) + " times the hull";
    if (row.points < row.of) said += ", on " + std::to_string(row.points) + " of " + std::to_string(row.of) + " points";
    return said + (row.on_front ? "; on the front." : "; not on the front.");
  }
  if (session.asked() != nullptr) return "Predict first, then measure.";
  if (table_.rows.empty()) return "Nothing is measured yet: press Measure.";
  const auto front = std::count_if(table_.rows.begin(), table_.rows.end(), [](const cost::CostRow& row) { return row.on_front; });
  return std::to_string(front) + " of " + std::to_string(table_.rows.size()) + " lie on the front. Click a mark to load its box.";
}

void Costs::draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->ground);
  // The buttons stand above it, the sentence below.
  const float above = look.fingers ? 60 : look.px(44), below = rect.width >= 560 ? look.px(64) : 4;
  const Rect room{rect.x, rect.y + above, rect.width, rect.height - above - below};
  std::optional<ChartHit> focus;
  for (std::size_t i = 0; i < chart_.series.size(); ++i)
    if (focus_ >= 0 && chart_.series[i].row == focus_) focus = ChartHit{i, 0};
  const Touch touch = touch_area("chart", room);
  std::vector<ChartPlace> drawn;
  const auto hit = chart_.series.empty() ? std::nullopt : draw_chart(list, look, room, chart_, focus, &drawn);
  places_.assign(table_.rows.size(), std::nullopt);
  for (std::size_t i = 0; i < drawn.size(); ++i)
    if (chart_.series[i].row >= 0) places_[static_cast<std::size_t>(chart_.series[i].row)] = drawn[i];
  Obstacles none;
  if (with_sentence) draw_sentence(list, look, none, rect, caption(session));
  if (!touch.clicked || !hit || chart_.series[hit->series].row < 0) return;
  focus_ = chart_.series[hit->series].row;
  refused_.clear();
  static_cast<void>(load_algorithm(session));
}

std::vector<Handle> Costs::handles() const {
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (places_[i] && i < table_.rows.size()) handles.push_back({table_.rows[i].algorithm, places_[i]->x, places_[i]->y});
  return handles;
}

}  // namespace snug::app
