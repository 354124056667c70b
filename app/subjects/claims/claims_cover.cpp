#include "app/subjects/claims/claims_cover.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "app/brush.hpp"
#include "app/chart_pen.hpp"
#include "app/subjects/claims/trial_chart.hpp"
#include "app/widgets.hpp"
#include "lesson/subjects/claims/claims.hpp"
#include "measure/cost_run.hpp"

namespace snug::app {
namespace {

constexpr std::array<std::string_view, 2> kTableFormats{"csv", "json"};
constexpr std::string_view kShowClaim = "show_";
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kChartKeys{{{"ArrowRight", "chart_next"},
                                                                                   {"ArrowDown", "chart_down"},
                                                                                   {"ArrowLeft", "chart_previous"},
                                                                                   {"ArrowUp", "chart_up"},
                                                                                   {"Enter", "chart_load"}}};

std::string claim_verdict(const cost::TrialTally& tally) {
  const std::string_view verdict = tally.verdict();
  return verdict == "holds" ? "holds" : verdict == "typical" ? "holds typically" : "false on half or more";
}

/// "in a cube, cloud 17: 1.216"
std::string cloud_words(const cost::TrialRow& row) {
  return std::string(kind_title(row.kind)) + ", cloud " + std::to_string(row.seed) + ": " +
         chart_figure(ChartUnit::kRatio, row.value);
}

bool predictions_wait(const lesson::Session& session) {
  const auto& outcomes = session.log().outcomes();
  return std::any_of(outcomes.begin(), outcomes.end(), [](const lesson::Outcome& outcome) { return outcome.pending; });
}

}  // namespace

ClaimsCover::ClaimsCover(const Platform& platform) : clock_(platform.clock), here_(platform.here) {
  here_.points = std::to_string(cost::kTrialSeeds) + " clouds of each kind";
  here_.scalar = "double", here_.dim = 3;
  take_rows();
}

/// Puts the finished clouds onto the chart. The worst of those on which the claim does not hold has the focus.
void ClaimsCover::take_rows() {
  chart_ = trial_chart(claim(), rows_);
  focus_.reset();
  places_.clear();
  ++version_;
  const cost::TrialTally tally = cost::tally_trials(claim().name, rows_);
  if (run_ != nullptr || !tally.worst) return;
  for (std::size_t i = 0; i < chart_.series.size(); ++i)
    if (cost::trial_kinds()[chart_.series[i].row] == tally.worst->kind)
      focus_ = ChartHit{i, chart_.series[i].points.size() - 1};
}

void ClaimsCover::follow(const lesson::Session& session) {
  const lesson::Outcome* const told = session.conversation().outcome();
  const lesson::Asked* const now = session.conversation().asked() != nullptr ? session.conversation().asked()
                                   : told != nullptr                         ? session.conversation().question_of(*told)
                                                                             : nullptr;
  const std::string id = now != nullptr ? now->question->id : "";
  if (id == followed_) return;
  followed_ = id;
  const cost::Claim* const claim = now != nullptr ? cost::find_trial(now->question->figure) : nullptr;
  if (claim == nullptr) return;
  claim_ = claim;
  take_rows();
}

void ClaimsCover::look_at(const cost::Claim& claim) {
  claim_ = &claim;
  take_rows();
  show(true);
}

const cost::TrialRow* ClaimsCover::focused() const {
  if (!focus_) return nullptr;
  return trials_of_line(claim(), rows_, chart_.series[focus_->series].row)[focus_->point];
}

/// line, point: by how many to move; the ends wrap around.
void ClaimsCover::move_focus(int line, int point) {
  if (chart_.series.empty()) return;
  const auto wrapped = [](std::size_t at, int by, std::size_t n) {
    return (static_cast<int>(at) + by + static_cast<int>(n)) % static_cast<int>(n);
  };
  ChartHit to = focus_.value_or(ChartHit{});
  to.series = wrapped(to.series, line, chart_.series.size());
  const std::size_t points = chart_.series[to.series].points.size();
  to.point = wrapped(std::min(to.point, points - 1), point, points);
  focus_ = to;
  ++version_;
}

/// Puts the cloud that has the focus on the stage, with what shows the claim, at its end.
bool ClaimsCover::put_on_stage(lesson::Session& session) {
  const cost::TrialRow* row = focused();
  if (row == nullptr) return false;
  const auto seed = static_cast<std::uint64_t>(row->seed);
  const lesson::AtOnce at_once(session.stage());
  if (!session.stage().set_generator(row->kind, row->points, 3, seed)) return false;
  if (!session.player().choose(0, lesson::shown_by(session.lesson(), claim()))) return false;
  session.jump(session.player().steps());
  show(false);
  return true;
}

bool ClaimsCover::command(lesson::Session& session, std::string_view name) {
  follow(session);
  const std::vector<const cost::Claim*>& all = cost::tried_claims();
  if (name == "show_other") {
    const auto next = std::find(all.begin(), all.end(), claim_) + 1;
    return look_at(next != all.end() ? **next : *all.front()), true;
  }
  if (name.starts_with(kShowClaim)) {
    const cost::Claim* found = cost::find_trial(name.substr(kShowClaim.size()));
    if (found != nullptr) look_at(*found);
    return found != nullptr;
  }
  if (name == "measure") {
    if (running() || !clock_ || session.conversation().asked() != nullptr) return false;
    if (session.conversation().to_predict() != nullptr) return session.conversation().ask_predictions(), true;
    run_ = std::make_unique<cost::TrialRun>(all);
    rows_.clear();
    claim_ = all.front();
    take_rows();
    show(true);
  } else if (name == "stop_measuring") {
    if (!running()) return false;
    finish(session);
  } else if (name == "toggle_chart") {
    show(!shown_);
  } else if (name == "chart_next" || name == "chart_previous") {
    move_focus(0, name == "chart_next" ? 1 : -1);
  } else if (name == "chart_down" || name == "chart_up") {
    move_focus(name == "chart_down" ? 1 : -1, 0);
  } else {
    return name == "chart_load" && !running() && put_on_stage(session);
  }
  return true;
}

std::string_view ClaimsCover::command_of_key(std::string_view key) const {
  if (key == "c" || key == "C") return "toggle_chart";
  if (key == "m" || key == "M") return "measure";
  if (key == "v" || key == "V") return "show_other";
  const auto* const found =
      std::find_if(kChartKeys.begin(), kChartKeys.end(), [&](const auto& row) { return row.first == key; });
  return shown_ && found != kChartKeys.end() ? found->second : std::string_view();
}

tl::expected<void, InputError> ClaimsCover::load(lesson::Session& session, const io::PointFile& file,
                                                 std::string_view name) {
  return session.stage().load(file, name);
}

void ClaimsCover::work(lesson::Session& session, double budget) {
  follow(session);
  if (!running()) return;
  const std::size_t before = run_->rows().size();
  cost::advance(*run_, clock_, budget);
  if (run_->done()) return finish(session);
  if (run_->rows().size() == before) return;
  rows_ = run_->rows();
  take_rows();
}

/// Ends the run. What came of all clouds decides the predictions; of some of them, nothing.
void ClaimsCover::finish(lesson::Session& session) {
  rows_ = run_->rows();
  const bool whole = rows_.size() == cost::tried_claims().size() * cost::trial_kinds().size() * cost::kTrialSeeds;
  run_.reset();
  take_rows();
  if (whole) session.inform<lesson::ClaimsSubject>([&](lesson::ClaimsSubject& claims) { claims.tried(rows_); });
}

// ---- the controls

std::vector<CoverButton> ClaimsCover::choices(const lesson::Session&) const {
  std::vector<CoverButton> buttons;
  for (const cost::Claim* one : cost::tried_claims())
    buttons.push_back({std::string(kShowClaim).append(one->name), std::string(one->title), one == claim_, true});
  return buttons;
}

std::array<CoverButton, 2> ClaimsCover::work_buttons(const lesson::Session& session) const {
  return {CoverButton{"measure", "Measure", false, !running() && session.conversation().asked() == nullptr},
          CoverButton{"stop_measuring", "Stop", false, running()}};
}

std::string ClaimsCover::status(const lesson::Session& session) const {
  if (session.conversation().asked() != nullptr)
    return "Answer the questions first: the charts would give the answers away.";
  if (session.conversation().to_predict() != nullptr) return std::string(kPressMeasure);
  const std::string all = std::to_string(cost::tried_claims().size()) + " claims, " +
                          std::to_string(cost::trial_kinds().size() * cost::kTrialSeeds) + " clouds each";
  if (running()) return "Trying " + all + ".";
  return rows_.empty() ? "Now press Measure: " + all + "." : "Tried: " + all + ".";
}

std::string ClaimsCover::caption(const lesson::Session& session) const {
  const cost::TrialTally tally = cost::tally_trials(claim().name, rows_);
  if (session.conversation().asked() != nullptr) return "Predict first, then measure.";
  if (session.conversation().to_predict() != nullptr) return std::string(kPressMeasure);
  if (running()) return "Measuring: " + std::to_string(static_cast<int>(100 * progress())) + " % of the clouds.";
  if (tally.clouds == 0 && predictions_wait(session)) return "Your predictions are in: now press Measure.";
  if (tally.clouds == 0) return "Nothing has been measured yet: press Measure.";
  // At most two lines: the legend stands above them.
  std::string says = "The claim " + claim_verdict(tally) + ", on " + lesson::tally_text(tally) + ".";
  if (tally.verdict() == "false") says = "The claim holds on " + lesson::tally_text(tally) + ".";
  if (const cost::TrialRow* row = focused()) says += " Marked: " + cloud_words(*row) + ". Enter or a click shows it.";
  return says;
}

WordTable ClaimsCover::table(const lesson::Session&) const {
  WordTable table{{"Claim", "Verdict", "Holds on", "Worst cloud"}, {}};
  for (const cost::Claim* one : cost::tried_claims()) {
    const cost::TrialTally tally = cost::tally_trials(one->name, rows_);
    if (tally.clouds == 0) continue;
    table.rows.push_back({std::string(one->says), claim_verdict(tally), lesson::tally_text(tally),
                          tally.worst ? cloud_words(*tally.worst) : "none"});
  }
  return table;
}

bool ClaimsCover::decided(const lesson::Session& session) const {
  const auto* claims = lesson::as<lesson::ClaimsSubject>(session.stage().subject());
  return claims != nullptr && !claims->trials().empty();
}

std::span<const std::string_view> ClaimsCover::formats() const { return kTableFormats; }

std::string ClaimsCover::file_name() const { return "snug-claims"; }

std::string ClaimsCover::file(std::string_view format) const {
  if (rows_.empty()) return {};
  const std::span<const cost::TrialRow> rows(rows_);
  return format == "csv" ? cost::csv_of(here_, rows) : cost::json_of(here_, rows);
}

// ---- on the stage

void ClaimsCover::draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) {
  follow(session);
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float below = room_for_sentence(look, rect, caption(session), with_sentence);
  const auto [room, taken] = cover_room(look, rect, below);
  const Touch touch = pointer_area("claim", room);
  places_.clear();
  ScreenPen pen(list);
  const auto hit = draw_chart(pen, look, room, chart_, focus_, &places_, taken);
  Obstacles none;
  if (with_sentence) draw_sentence(list, look, none, rect, caption(session));
  if (!touch.clicked || !hit) return;
  focus_ = hit;
  ++version_;
  if (!running()) static_cast<void>(put_on_stage(session));
}

std::vector<Handle> ClaimsCover::handles() const {
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < places_.size() && i < chart_.series.size(); ++i)
    handles.push_back({std::string(cost::trial_kinds()[chart_.series[i].row]), places_[i].x, places_[i].y});
  return handles;
}

std::unique_ptr<Cover> claims_cover(const Platform& platform) { return std::make_unique<ClaimsCover>(platform); }

}  // namespace snug::app
