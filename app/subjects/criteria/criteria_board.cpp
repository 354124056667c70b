#include "app/subjects/criteria/criteria_board.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <utility>

#include "app/brush.hpp"
#include "app/widgets.hpp"
#include "geometry/sort.hpp"
#include "lesson/figures.hpp"
#include "measure/sample.hpp"

namespace snug::app {
namespace {

using lesson::CriteriaSubject;
using lesson::CriteriaTable;
using lesson::CriteriaTableKind;

constexpr Index kMostFitted = 5'000;  // points around which all volumes are fitted within a frame or two
/// The length of a batch that any browser's clock can measure, and the longest runs that do not delay a frame, ns.
constexpr double kShortestBatch = 10e6, kLongestBatch = 15e6, kLongestFit = 24e6, kLongestWatchedFit = 28e6;
constexpr int kBatches = 9;
constexpr float kOrbitPixels = 32;  // that one press of a key turns the pictures by
constexpr std::array<std::string_view, 2> kCriteriaFormats{"csv", "json"};

constexpr std::array<std::string_view, 3> kTableNames{"criteria", "total", "ranks"};
constexpr std::array<std::string_view, 3> kTableWords{"Criteria", "Total cost", "Ranks"};
constexpr std::array<std::string_view, 3> kTableTitles{"The criteria, measured here, and T, the total cost",
                                                       "Where the total cost T goes, with the sliders as they are",
                                                       "Ranks, 1 for the best, beside the textbooks' order"};

const CriteriaSubject& criteria(const lesson::Session& session) { return *lesson::criteria_of(session); }

/// The volume whose algorithm the session shows; -1 if it takes no part.
int chosen_in(const lesson::Session& session) {
  const auto& volumes = criteria(session).around().volumes;
  const auto found = std::find_if(volumes.begin(), volumes.end(),
                                  [&](const auto& volume) { return volume.method == session.player().method(0); });
  return found == volumes.end() ? -1 : static_cast<int>(found - volumes.begin());
}

std::string points_words(Index n) { return lesson::count_text(n) + (n == 1 ? " point" : " points"); }

/// The rows in the order of a column; those without a figure come last.
std::vector<std::size_t> order_by(const CriteriaTable& table, int column) {
  std::vector<std::size_t> order(table.names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (column < 1) return order;
  const auto key = [&](std::size_t row) { return table.cells[row][column - 1].key.value_or(HUGE_VAL); };
  sort_stably(order, [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  return order;
}

/// Whether nothing in the column is better than that cell.
bool is_best(const CriteriaTable& table, std::size_t row, std::size_t column) {
  const std::optional<double> own = table.cells[row][column].key;
  return own && std::none_of(table.cells.begin(), table.cells.end(),
                             [&](const auto& other) { return other[column].key && *other[column].key < *own; });
}

}  // namespace

CriteriaBoard::CriteriaBoard(const Platform& platform) {
  if (platform.clock == nullptr) return;
  clock_ = platform.clock;
  here_ = platform.here;
  here_.clock_resolution_ns = cost::resolution_of(clock_);
  options_.timing = {.repeats = kBatches,
                     .batch = cost::batch_length(here_.clock_resolution_ns, kShortestBatch, kLongestBatch)};
  options_.limits = {.longest = kLongestFit, .longest_watched = kLongestWatchedFit};
}

std::vector<SmallPicture> CriteriaBoard::pictures(const lesson::Session& session) const {
  const CriteriaSubject& subject = criteria(session);
  const std::vector<int> ranks = session.conversation().to_predict() == nullptr
                                     ? subject.ranks(lesson::Criterion::kTotal, subject.load_now())
                                     : std::vector<int>{};
  const int chosen = chosen_in(session);
  std::vector<SmallPicture> pictures;
  for (const lesson::FittedVolume& volume : subject.around().volumes) {
    const auto i = pictures.size();
    pictures.push_back({.volume = &volume.volume,
                        .id = lesson::name_in(session.lesson(), *volume.method),
                        .name = std::string(lesson::short_title(*volume.method)),
                        .figure = volume.over_hull ? lesson::decimal_text(*volume.over_hull, 2) + "×" : "flat",
                        .chosen = static_cast<int>(i) == chosen,
                        .best = !ranks.empty() && ranks[i] == 0});
  }
  return pictures;
}

void CriteriaBoard::draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) {
  ImDrawList* const list = ImGui::GetWindowDrawList();
  const float below = look.foot > 0 ? 4 : room_for_sentence(look, rect, caption(session), with_sentence);
  const auto [free, taken] = cover_room(look, rect, below);  // of the page's buttons and the sentence
  const Rect room{free.x + 12, free.y + 4, free.width - 24 - taken, free.height - 4};
  std::vector<ImVec2> places;
  const std::vector<SmallPicture> all = pictures(session);
  const PictureHands hands =
      draw_small_pictures(list, look, room, criteria(session).around().points, all, gaze_, places);
  handles_.clear();
  for (std::size_t i = 0; i < places.size(); ++i) handles_.push_back({all[i].id, places[i].x, places[i].y});
  Obstacles none;
  if (with_sentence) draw_sentence(list, look, none, rect, caption(session));
  if (hands.turned_x != 0 || hands.turned_y != 0) gaze_ = turned(gaze_, hands.turned_x, hands.turned_y), ++version_;
  if (hands.clicked >= 0) static_cast<void>(pick(session, hands.clicked));
}

std::string CriteriaBoard::caption(const lesson::Session& session) const {
  if (session.conversation().asked() != nullptr)
    return "Predict first, then measure. Drag a picture: all of them turn.";
  if (running()) return "Measuring all volumes: test, looseness, build, update, bytes, false positives.";
  const int chosen = chosen_in(session);
  if (chosen < 0) return "Select a picture.";
  if (session.conversation().to_predict() != nullptr && criteria(session).is_measured())
    return std::string(kPressMeasure);
  return lesson::defence_text(criteria(session), chosen);
}

void CriteriaBoard::start(const lesson::Session& session) {
  measured_ = session.stage().subject().clone();
  const auto& subject = static_cast<const CriteriaSubject&>(*measured_);
  options_.fit.seed = session.stage().subject().origin().seed;
  rows_.clear();
  provenance_ = here_;
  provenance_.points = session.stage().subject().origin().source, provenance_.scalar = "double";
  provenance_.dim = session.stage().subject().dim(),
  provenance_.seed = static_cast<std::int64_t>(session.stage().subject().origin().seed);
  run_ = std::make_unique<cost::CriteriaRun>(*measured_->points(), lesson::algorithms_of(subject.around()),
                                             subject.own_load().still(), options_, clock_);
  ++version_;
}

/// Whatever stands on the stage now, and wherever the sliders do: what was measured stays known of its points.
void CriteriaBoard::finish(lesson::Session& session) {
  rows_ = run_->rows();
  run_.reset();
  ++version_;
  if (rows_.empty()) return;
  static_cast<CriteriaSubject&>(*measured_).measured(*measured_->points(), rows_);
  session.inform<CriteriaSubject>([](CriteriaSubject&) {});
}

void CriteriaBoard::work(lesson::Session& session, double budget) {
  load_ = criteria(session).load_now();
  if (!running()) return;
  cost::advance(*run_, clock_, budget);
  if (run_->done()) finish(session);
}

bool CriteriaBoard::pick(lesson::Session& session, std::size_t volume) {
  const auto& volumes = criteria(session).around().volumes;
  if (volume >= volumes.size()) return false;
  ++version_;
  return session.player().choose(0, lesson::name_in(session.lesson(), *volumes[volume].method)).has_value();
}

bool CriteriaBoard::pick_next(lesson::Session& session, int by) {
  const int count = static_cast<int>(criteria(session).around().volumes.size());
  return count > 0 && pick(session, (chosen_in(session) + by + count) % count);
}

bool CriteriaBoard::sort_by(std::string_view column) {
  int& sorted = sorted_[static_cast<std::size_t>(kind_)];
  int wanted = 0;
  const auto [end, error] = std::from_chars(column.data(), column.data() + column.size(), wanted);
  if (error != std::errc() || end != column.data() + column.size() || wanted < 0 || wanted > 7) return false;
  sorted = wanted == 0 || sorted == wanted ? -1 : wanted;
  ++version_;
  return true;
}

bool CriteriaBoard::command(lesson::Session& session, std::string_view name) {
  const auto after = [&](std::string_view start) -> std::optional<std::string_view> {
    return name.starts_with(start) ? std::optional(name.substr(start.size())) : std::nullopt;
  };
  if (const auto column = after("sort:")) return sort_by(*column);
  if (const auto volume = after("pick:")) {
    for (std::size_t i = 0; i < criteria(session).around().volumes.size(); ++i)
      if (std::to_string(i) == *volume) return pick(session, i);
    return false;
  }
  const auto kind = static_cast<std::size_t>(kind_);
  if (name == "show_other") return kind_ = static_cast<CriteriaTableKind>((kind + 1) % 3), ++version_, true;
  if (const auto table = after("show_")) {
    const auto* const found = std::find(kTableNames.begin(), kTableNames.end(), *table);
    if (found == kTableNames.end()) return false;
    return kind_ = static_cast<CriteriaTableKind>(found - kTableNames.begin()), ++version_, true;
  }
  if (name == "toggle_pictures") return show(!shown_), true;
  if (name == "measure") {
    if (running() || !clock_ || session.conversation().asked() != nullptr) return false;
    return session.conversation().to_predict() != nullptr ? session.conversation().ask_predictions() : start(session),
           true;
  }
  if (name == "stop_measuring") {
    if (!running()) return false;
    return run_->stop(), finish(session), true;
  }
  if (!shown_) return false;
  if (name == "next_volume" || name == "previous_volume") return pick_next(session, name == "next_volume" ? 1 : -1);
  if (name == "orbit_left") gaze_ = turned(gaze_, -kOrbitPixels, 0);
  else if (name == "orbit_right") gaze_ = turned(gaze_, kOrbitPixels, 0);
  else if (name == "orbit_up") gaze_ = turned(gaze_, 0, -kOrbitPixels);
  else if (name == "orbit_down") gaze_ = turned(gaze_, 0, kOrbitPixels);
  else return false;
  return ++version_, true;
}

std::string_view CriteriaBoard::command_of_key(std::string_view key) const {
  if (key == "c" || key == "C") return "toggle_pictures";
  if (key == "m" || key == "M") return "measure";
  if (key == "v" || key == "V") return "show_other";
  if (!shown_) return {};
  return key == "ArrowRight" ? "next_volume" : key == "ArrowLeft" ? "previous_volume" : std::string_view();
}

std::vector<CoverButton> CriteriaBoard::choices(const lesson::Session& session) const {
  std::vector<CoverButton> buttons;
  for (std::size_t i = 0; i < kTableNames.size(); ++i)
    buttons.push_back({"show_" + std::string(kTableNames[i]), std::string(kTableWords[i]),
                       i == static_cast<std::size_t>(kind_), session.conversation().to_predict() == nullptr});
  return buttons;
}

std::array<CoverButton, 2> CriteriaBoard::work_buttons(const lesson::Session& session) const {
  return {CoverButton{"measure", "Measure", false,
                      !running() && session.conversation().asked() == nullptr && clock_ != nullptr},
          CoverButton{"stop_measuring", "Stop", false, running()}};
}

std::string CriteriaBoard::status(const lesson::Session& session) const {
  if (session.conversation().asked() != nullptr)
    return "Answer the question first: the table would give the answer away.";
  if (session.conversation().to_predict() != nullptr) return std::string(kPressMeasure);
  const std::string points = points_words(session.stage().subject().size());
  if (running()) return "Measuring, on " + points_words(measured_->size()) + ".";
  if (criteria(session).is_measured()) return "Measured here, on " + points + ".";
  return "Now press Measure: " + points + ".";
}

WordTable CriteriaBoard::table(const lesson::Session& session) const {
  const CriteriaSubject& subject = criteria(session);
  const auto kind = static_cast<std::size_t>(kind_);
  WordTable words{.head = {}, .rows = {}, .title = std::string(kTableTitles[kind])};
  if (session.conversation().to_predict() != nullptr || !subject.is_measured()) return words;
  const CriteriaTable table = lesson::criteria_table(subject, kind_);
  words.head = table.head;
  words.sorted = sorted_[kind];
  for (std::size_t i = 0; i < table.head.size(); ++i) words.sorts.push_back("sort:" + std::to_string(i));
  const int chosen = chosen_in(session);
  for (const std::size_t row : order_by(table, words.sorted)) {
    if (static_cast<int>(row) == chosen) words.picked = static_cast<int>(words.rows.size());
    words.picks.push_back("pick:" + std::to_string(row));
    std::vector<std::string>& cells = words.rows.emplace_back(1, table.names[row]);
    std::vector<bool>& best = words.best.emplace_back(1, false);
    for (std::size_t i = 0; i < table.cells[row].size(); ++i)
      cells.push_back(table.cells[row][i].text), best.push_back(is_best(table, row, i));
  }
  return words;
}

bool CriteriaBoard::decided(const lesson::Session& session) const { return criteria(session).is_measured(); }

std::span<const std::string_view> CriteriaBoard::formats() const { return kCriteriaFormats; }

std::string CriteriaBoard::file(std::string_view format) const {
  if (rows_.empty()) return {};
  const std::vector<cost::WhichRow> table = cost::which_rows(rows_, load_);
  const std::span<const cost::WhichRow> all(table);
  return format == "csv" ? cost::csv_of(provenance_, all) : cost::json_of(provenance_, all);
}

std::optional<tl::expected<void, InputError>> CriteriaBoard::lay_over(lesson::Session&, std::string_view text,
                                                                      std::string_view name) {
  if (!text.starts_with("# snug table: ")) return std::nullopt;
  return tl::unexpected(InputError{.what = "this is a table; it takes a file of points", .file = std::string(name)});
}

tl::expected<void, InputError> CriteriaBoard::load(lesson::Session& session, const io::PointFile& file,
                                                   std::string_view name) {
  if (file.points.size() <= static_cast<std::size_t>(kMostFitted)) return session.stage().load(file, name);
  auto set = io::to_point_set(file, name, 0, false);
  if (!set) return tl::unexpected(std::move(set.error()));
  const AnyPointSet some = cost::sample(*set, kMostFitted, session.stage().subject().origin().seed);
  io::PointFile part{.dim = file.dim, .points = {}, .triangles = {}};
  for (Index i = 0; i < kMostFitted; ++i) part.points.push_back(fit::point_of(some, i));
  return session.stage().load(part, name);
}

std::unique_ptr<Cover> criteria_cover(const Platform& platform) { return std::make_unique<CriteriaBoard>(platform); }

}  // namespace snug::app
