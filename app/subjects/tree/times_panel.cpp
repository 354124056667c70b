// What building, refitting and rebuilding cost with many boxes, beside the stage.
#include <algorithm>
#include <array>
#include <string>

#include "app/subjects/tree/draw.hpp"
#include "app/widgets.hpp"
#include "lesson/figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

constexpr float kTimesHead = 24, kTimesRow = 22, kTimesWords = 12, kTimesGap = 12;
constexpr int kStillFrames = 12;

/// The ways that are timed: all that build; of those that move volumes, the one that refits AABBs and the one that
/// rebuilds.
std::vector<const lesson::Method*> timed_methods(const lesson::Session& session) {
  std::vector<const lesson::Method*> methods;
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method& method = *lesson::find_method(session.lesson(), name);
    const bool refits = method.name == "merge_aabb" || method.name == "rebuild";
    if ((method.volume == lesson::kTreeBuild && !method.by_hand) || (method.volume == lesson::kTreeUpdate && refits))
      methods.push_back(&method);
  }
  return methods;
}

/// "With 2,000 boxes"
std::string crowd_words() { return "With " + lesson::count_text(lesson::kCrowd) + " boxes"; }

std::string_view timed_title(const lesson::Method& method) {
  return method.name == "merge_aabb" ? "Refit" : method.name == "rebuild" ? "Rebuild" : method.title;
}

/// "0.042 ms", "12.3 ms"
std::string time_words(double ns) { return lesson::number_text(ns / 1e6, 2) + " ms"; }

/// The cost of a way's tree and its time, each empty before it is known.
std::array<std::string, 2> price_words(const TreeTimes::Entry* entry) {
  if (entry == nullptr) return {};
  return {lesson::number_text(entry->timed.cost, 3), entry->timed.ns ? time_words(*entry->timed.ns) : std::string()};
}

/// "Here a rebuild takes 12 times as long as a refit."
std::string ratio_words(const lesson::Session& session, const TreeTimes& times) {
  const TreeTimes::Entry *refit = nullptr, *rebuild = nullptr;
  for (const lesson::Method* method : timed_methods(session)) {
    if (method->name == "merge_aabb") refit = times.of(*method);
    if (method->name == "rebuild") rebuild = times.of(*method);
  }
  if (refit == nullptr || rebuild == nullptr || !refit->timed.ns || !rebuild->timed.ns || !(*refit->timed.ns > 0))
    return {};
  return "Here a rebuild takes " + lesson::number_text(*rebuild->timed.ns / *refit->timed.ns, 2) +
         " times as long as a refit.";
}

/// How wide the column of times is, with the gap before it: no wider than needed, for titles are long.
float time_column(const Look& look, const lesson::Session& session, const TreeTimes& times) {
  float width = measure(look, Face::kSemiBold, 12, "Time").x;
  for (const lesson::Method* method : timed_methods(session))
    if (const TreeTimes::Entry* entry = times.of(*method); entry != nullptr && entry->timed.ns)
      width = std::max(width, measure(look, Face::kMono, 12, time_words(*entry->timed.ns)).x);
  return width + look.px(kTimesGap);
}

std::string time_notes(const lesson::Session& session, const TreeTimes& times) {
  for (const lesson::Method* method : timed_methods(session))
    if (times.of(*method) == nullptr) return "Each way is timed at the end of its run.";
  return ratio_words(session, times);
}

}  // namespace

void TreeTimes::measure(const lesson::Session& session) {
  const auto& subject = *lesson::as<lesson::TreeSubject>(session.stage().subject());
  lesson::Rows rows = subject.rows();
  if (rows != rows_ || situation_ != subject.origin().situation)
    rows_ = std::move(rows), situation_ = subject.origin().situation, still_ = 0, ++stage_;
  working_ = false;
  const auto has_ended = [&](const lesson::Method* method) {
    return std::find(ended_.begin(), ended_.end(), method) != ended_.end();
  };
  if (!has_ended(session.player().method(0))) ended_.push_back(session.player().method(0));
  for (const lesson::Method* method : timed_methods(session)) {
    const auto own =
        std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.method == method; });
    if (!has_ended(method) || (own != entries_.end() && own->stage == stage_)) continue;
    working_ = true;
    if (++still_ < kStillFrames) return;
    const Entry entry{method, subject.timed(*method), stage_};
    if (own != entries_.end()) *own = entry;
    else entries_.push_back(entry);
    return;
  }
}

const TreeTimes::Entry* TreeTimes::of(const lesson::Method& method) const {
  for (const Entry& entry : entries_)
    if (entry.method == &method) return &entry;
  return nullptr;
}

bool shows_times(const lesson::Session& session) {
  const lesson::TreeRun& run = lesson::tree_run(session.player().run(0));
  const lesson::TreeStage& stage = lesson::as<lesson::TreeSubject>(session.stage().subject())->stage();
  return session.conversation().asked() == nullptr && session.player().step() == run.steps() && !run.is_query() &&
         run.pairing() == nullptr && run.is_whole() && (!run.is_update() || stage.has_moved()) &&
         timed_methods(session).size() > 1;
}

PanelWords times_in_words(const lesson::Session& session, const TreeTimes& times) {
  PanelWords words{{.head = {"", "Cost", "Time"}, .title = crowd_words()}, time_notes(session, times)};
  for (const lesson::Method* method : timed_methods(session)) {
    const TreeTimes::Entry* entry = times.of(*method);
    const auto [cost, time] = price_words(entry != nullptr && times.is_of_now(*entry) ? entry : nullptr);
    words.table.rows.push_back({std::string(timed_title(*method)), cost, time});
  }
  return words;
}

float draw_times_panel(const Look& look, const lesson::Session& session, const TreeTimes& times, ImVec2 at,
                       float width) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float small = look.px(12), row = look.px(kTimesRow), column = time_column(look, session, times);
  const float head = middle_of(at.y + look.px(11), small);
  text(list, look, Face::kSemiBold, 12, {at.x, head}, look->muted, crowd_words());
  text_right(list, look, Face::kSemiBold, 12, {at.x + width - column, head}, look->muted, "Cost");
  text_right(list, look, Face::kSemiBold, 12, {at.x + width, head}, look->muted, "Time");
  float y = at.y + look.px(kTimesHead);
  for (const lesson::Method* method : timed_methods(session)) {
    const float middle = y + row / 2;
    const Face face = method == session.player().method(0) ? Face::kSemiBold : Face::kRegular;
    text(list, look, face, kTimesWords, {at.x, middle_of(middle, look.px(kTimesWords))}, look->ink,
         timed_title(*method));
    const TreeTimes::Entry* entry = times.of(*method);
    const auto [cost, time] = price_words(entry);
    const Color color = entry != nullptr && times.is_of_now(*entry) ? look->ink : look->muted;
    text_right(list, look, Face::kMono, 12, {at.x + width - column, middle_of(middle, small)}, color, cost);
    text_right(list, look, Face::kMono, 12, {at.x + width, middle_of(middle, small)}, color, time);
    y += row;
  }
  const std::string words = time_notes(session, times);
  if (!words.empty()) y += paragraph(list, look, Face::kRegular, 12, 17, {at.x, y}, width, look->muted, words);
  return y - at.y;
}

}  // namespace snug::app
