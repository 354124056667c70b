#include "app/timeline_map.hpp"

#include <algorithm>
#include <cmath>

namespace snug::app {

float TimelineMap::x_of(int step) const {
  return left + width * static_cast<float>(step) / static_cast<float>(std::max(steps, 1));
}

int TimelineMap::step_at(float x) const {
  const float share = std::clamp((x - left) / std::max(width, 1.0f), 0.0f, 1.0f);
  return static_cast<int>(std::lround(share * static_cast<float>(steps)));
}

bool is_open(const lesson::Session& session, const lesson::Asked& asked) {
  const auto& outcomes = session.log().outcomes();
  const auto own = std::find_if(outcomes.begin(), outcomes.end(),
                                [&](const lesson::Outcome& outcome) { return outcome.question == asked.question->id; });
  return own == outcomes.end() || own->passed;
}

namespace {

/// The step of the first question without an answer; the last step if there is none.
int first_open(const lesson::Session& session) {
  int gate = session.player().steps();
  for (const lesson::Asked& asked : session.conversation().questions())
    if (is_open(session, asked)) gate = std::min(gate, asked.step);
  return gate;
}

}  // namespace

bool count_known(const lesson::Exercise& exercise) { return exercise.least == exercise.most; }

std::optional<int> furthest_to_show(const lesson::Session& session, const lesson::Sitting* sitting) {
  if (sitting == nullptr || count_known(sitting->exercise()) || all_decided(session)) return std::nullopt;
  return std::max(session.player().step(), first_open(session));
}

std::vector<lesson::Mark> marks_to_show(const lesson::Session& session) {
  int known =
      session.player().previewing() ? 0 : session.player().step();  // up to here the trace was shown to the student
  known = std::max(known, first_open(session));
  std::vector<lesson::Mark> shown = session.player().marks();
  std::erase_if(
      shown, [&](const lesson::Mark& mark) { return mark.kind != lesson::Mark::Kind::kQuestion && mark.step > known; });
  return shown;
}

std::vector<lesson::Mark> marks_with_room(std::span<const lesson::Mark> marks, const TimelineMap& map, float apart) {
  using Kind = lesson::Mark::Kind;
  const auto always = [](const lesson::Mark& mark) {
    return mark.kind == Kind::kQuestion || mark.kind == Kind::kBest || mark.kind == Kind::kWrong;
  };
  std::vector<lesson::Mark> kept;
  std::vector<float> firm;
  for (const lesson::Mark& mark : marks)
    if (always(mark)) firm.push_back(map.x_of(mark.step));
  float before = -1e9f;
  for (const lesson::Mark& mark : marks) {
    if (always(mark)) {
      kept.push_back(mark);
      continue;
    }
    const float x = map.x_of(mark.step);
    const bool at_firm =
        std::any_of(firm.begin(), firm.end(), [&](float other) { return std::abs(other - x) < apart; });
    if (x - before < apart || at_firm) continue;
    before = x;
    kept.push_back(mark);
  }
  return kept;
}

std::vector<float> flag_places(std::span<const lesson::Mark> marks, const TimelineMap& map, float apart) {
  std::vector<float> places;
  for (const lesson::Mark& mark : marks) {
    if (mark.kind != lesson::Mark::Kind::kQuestion) continue;
    const float x = map.x_of(mark.step);
    places.push_back(places.empty() ? x : std::max(x, places.back() + apart));
  }
  float most = map.left + map.width;
  for (std::size_t i = places.size(); i-- > 0; most = places[i] - apart) places[i] = std::min(places[i], most);
  return places;
}

}  // namespace snug::app
