// The chart on the stage: which point has the focus, what its caption says, and how the keys move.
#include <algorithm>
#include <utility>

#include "app/brush.hpp"
#include "app/chart_pen.hpp"
#include "app/subjects/cost/captions.hpp"
#include "app/subjects/cost/charts.hpp"
#include "app/subjects/cost/costs.hpp"
#include "app/widgets.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

constexpr double kLongestLoaded = 0.3e9;  // how long a click may take, ns

constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kKeys{{{"ArrowRight", "chart_next"},
                                                                              {"ArrowDown", "chart_down"},
                                                                              {"ArrowLeft", "chart_previous"},
                                                                              {"ArrowUp", "chart_up"},
                                                                              {"Enter", "chart_load"}}};

/// Whether predictions wait for the measurement.
bool awaits_measuring(const lesson::Session& session) {
  const auto& outcomes = session.log().outcomes();
  return std::any_of(outcomes.begin(), outcomes.end(), [](const lesson::Outcome& outcome) { return outcome.pending; });
}

}  // namespace

std::optional<ChartHit> Costs::focused() const {
  for (std::size_t i = 0; i < chart_.series.size(); ++i) {
    const ChartSeries& series = chart_.series[i];
    if (focus_row_ >= 0 && series.row == focus_row_ && !series.points.empty())
      return ChartHit{i, std::min(focus_point_, series.points.size() - 1)};
  }
  return std::nullopt;
}

/// The chart's points in the order in which keys visit them: by rising time; along one line and then the next; or from
/// line to line.
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

/// Moves the focus, and wraps around at the ends.
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
  const cost::CostRow& row = accuracy().rows[focus_row_];
  ++version_;
  if (row.whole_ns && row.points < session.stage().subject().size() && *row.whole_ns > kLongestLoaded) {
    refused_ = algorithm_title(row.volume, row.algorithm) + " would take about " +
               chart_figure(ChartUnit::kTime, *row.whole_ns) +
               " on all points. It was measured on fewer, and is not loaded.";
    return false;
  }
  const std::string name = lesson::is_mixed(session.lesson()) ? row.volume + '/' + row.algorithm : row.algorithm;
  const lesson::Method* method = lesson::find_method(session.lesson(), name);
  if (method == nullptr || !session.player().choose(0, lesson::name_in(session.lesson(), *method))) return false;
  session.jump(session.player().steps());
  shown_ = false;
  return true;
}

std::string Costs::status(const lesson::Session& session) const {
  if (session.conversation().asked() != nullptr) return std::string(kPredictFirst);
  if (session.conversation().to_predict() != nullptr) return std::string(kPressMeasure);
  const bool growth = view_ == CostView::kGrowth;
  const std::string points = chart_figure(ChartUnit::kCount, size(session)) + " points";
  const std::string on = sheet().about().points.substr(0, sheet().about().points.find(':'));
  std::string says;
  if (running() && *at_work_ == view_) says = "Measuring " + (growth ? "10 points and more." : points + ".");
  else if (sheet().rows() > 0) says = std::to_string(count()) + " measured. Points: " + on + ".";
  else says = "Now press Measure: " + (growth ? "10 points and more." : points + ".");
  if (sheet().rows() > 0 && !growth && !started_on_these(session, view_)) says += " The points have changed since.";
  if (const cost::Provenance* then = sheet().then()) says += " Hollow marks: " + then->points + ", an earlier result.";
  return says;
}

int Costs::count() const {
  const std::size_t n = view_ == CostView::kGrowth ? lines_of(growth().rows).size()
                        : view_ == CostView::kTurn ? lines_of(turn().rows).size()
                                                   : accuracy().rows.size();
  return static_cast<int>(n);
}

std::string Costs::caption(const lesson::Session& session) const {
  if (!refused_.empty()) return refused_;
  if (running() && *at_work_ != view_) return "Another chart is being measured: this one waits for it.";
  if (running()) {
    const int done = count() - (view_ == CostView::kAccuracy ? 0 : 1);  // a line is shown while it is measured
    const auto all = view_ == CostView::kTurn ? 0 : session.lesson().algorithms.size();
    return measuring_caption(std::max(0, done), static_cast<int>(all));
  }
  const bool any = sheet().rows() > 0;
  if (focus_row_ >= 0 && any) {
    if (view_ == CostView::kGrowth) return growth_caption(growth(), focus_row_, focus_point_);
    if (view_ == CostView::kTurn) return turn_caption(turn(), focus_row_, focus_point_);
    return accuracy_caption(accuracy(), accuracy().rows[focus_row_]);
  }
  if (session.conversation().asked() != nullptr) return "Predict first, then measure.";
  if (session.conversation().to_predict() != nullptr) return std::string(kPressMeasure);
  if (!any && view_ == CostView::kAccuracy && awaits_measuring(session))
    return "Your predictions are in: now press Measure.";
  if (!any) return "Nothing has been measured yet: press Measure.";
  if (view_ == CostView::kGrowth) return growth_caption(growth(), longest_growing_);
  return view_ == CostView::kTurn ? turn_caption(turn()) : accuracy_caption(accuracy());
}

void Costs::draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float below = room_for_sentence(look, rect, caption(session), with_sentence);
  const auto [room, taken] = cover_room(look, rect, below);
  const Touch touch = pointer_area("chart", room);
  places_.clear();
  ScreenPen pen(list);
  const auto hit = draw_chart(pen, look, room, chart_, focused(), &places_, taken);
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
    if (view_ == CostView::kAccuracy) handles.push_back({accuracy().rows[row].algorithm, places_[i].x, places_[i].y});
    else if (view_ == CostView::kGrowth)
      handles.push_back({lines_of(growth().rows)[row][0].algorithm, places_[i].x, places_[i].y});
    else handles.push_back({chart_.series[i].name, places_[i].x, places_[i].y});
  }
  return handles;
}

}  // namespace snug::app
