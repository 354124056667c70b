#include "app/subjects/cloud/call_panel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/cloud/waiting_calls.hpp"

namespace snug::app {
namespace {

using lesson::WaitingCall;
using lesson::WelzlState;

/// A note of always one line, so that what is below does not move.
std::string list_note(const lesson::Session& session, const WelzlState& state) {
  const auto place = [](int at) { return std::to_string(at + 1); };
  if (state.moved != kNoIndex && state.moved_from == 0)
    return session.stage().subject().name_of(state.moved) + " is at the front.";
  if (state.moved != kNoIndex)
    return session.stage().subject().name_of(state.moved) + " moved to the front from place " +
           place(state.moved_from) + ".";
  if (state.calls.empty()) return "All points have been tested.";
  if (state.calls.back().at == kNoIndex)
    return state.calls.size() == 1 ? "The points are in random order." : "The call begins at the front.";
  const auto at = std::find(state.list.begin(), state.list.end(), state.calls.back().at) - state.list.begin();
  return session.stage().subject().name_of(state.calls.back().at) + " is tested, at place " +
         place(static_cast<int>(at)) + ".";
}

class CallPanel {
 public:
  CallPanel(const Look& look, const lesson::Session& session, const WelzlState& state, ImVec2 at, float width)
      : look_(look), session_(session), state_(state), list_(ImGui::GetWindowDrawList()), x_(at.x), width_(width),
        top_(at.y), y_(at.y), support_(session.player().support(0)) {}

  [[nodiscard]] float height() const { return y_ - top_; }

  void heading(std::string_view words) {
    text(list_, look_, Face::kSemiBold, kHeading, {x_, y_ + look_.px(5)}, look_->muted, words);
    y_ += look_.px(28);
  }

  /// Draws the points in the list's order, line by line. The running call's part of the list lies on a band.
  void cells() {
    const int size = static_cast<int>(state_.list.size());
    const int end = state_.calls.empty() ? 0 : state_.calls.back().length;
    const int at = state_.calls.empty() ? 0 : std::min(state_.calls.back().done, std::max(end - 1, 0));
    const std::vector<int> places = shown_places(size, at, kMostCells);
    float widest = 0;
    for (const int place : places)
      if (place != kListGap) widest = std::max(widest, measure(look_, Face::kMonoBold, kSize, name(place)).x);
    const float least = widest + 8;
    const int in_row = std::max(1, static_cast<int>((width_ + kGap) / (least + kGap)));
    const float cell = (width_ + kGap) / static_cast<float>(in_row) - kGap, high = look_.px(kCell);
    int column = 0;
    for (const int place : places) {
      if (column == in_row) column = 0, y_ += high + kGap;
      const Rect rect{x_ + static_cast<float>(column++) * (cell + kGap), y_, cell, high};
      if (place == kListGap) text_middle(list_, look_, Face::kMono, kSize, middle(rect), look_->muted, "…");
      else draw_cell(rect, place, end);
    }
    y_ += high + look_.px(8);
  }

  /// Draws the calls, the outermost first, each indented by its depth. There is room for as many as there can be.
  void calls() {
    const int most = session_.stage().subject().dim() + 2, running = static_cast<int>(state_.calls.size()) - 1;
    for (int depth = 0; depth < most; ++depth) {
      const float left = x_ + static_cast<float>(depth) * kIndent;
      const Rect rect{left, y_, x_ + width_ - left, look_.px(kRow) - kGap};
      if (depth <= running) draw_call(rect, state_.calls[depth], depth == running);
      else list_->AddRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look_->line, kCorner, 0, 1);
      y_ += look_.px(kRow);
    }
  }

  void note(const std::string& words) {
    y_ += paragraph(list_, look_, Face::kRegular, kSize, 18, {x_, y_}, width_, look_->muted, words) + look_.px(8);
  }

 private:
  static constexpr float kHeading = 13, kSize = 12, kCell = 24, kRow = 26, kIndent = 12, kCorner = 4, kGap = 3,
                         kPadding = 8;
  static constexpr int kMostCells = 28;

  [[nodiscard]] std::string name(int place) const { return session_.stage().subject().name_of(state_.list[place]); }
  [[nodiscard]] ImVec2 middle(const Rect& rect) const {
    return {rect.x + rect.width / 2, middle_of(rect.y + rect.height / 2, look_.px(kSize))};
  }
  [[nodiscard]] bool waited_at(Index point) const {
    for (std::size_t i = 0; i + 1 < state_.calls.size(); ++i)
      if (state_.calls[i].at == point) return true;
    return false;
  }

  void draw_cell(const Rect& rect, int place, int end) {
    const Index point = state_.list[place];
    const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
    const bool supports = std::find(support_.begin(), support_.end(), point) != support_.end();
    const bool at_hand = !state_.calls.empty() && state_.calls.back().at == point;
    const bool tested = !state_.calls.empty() && place < state_.calls.back().done;
    if (place < end) list_->AddRectFilled(low, high, look_->raised, kCorner);
    if (point == state_.moved) list_->AddRectFilled(low, high, with_alpha(look_->support, 0.2f), kCorner);
    if (waited_at(point)) list_->AddRect(low, high, look_->support, kCorner, 0, 1.5f * look_->mark);
    if (at_hand) list_->AddRect(low, high, look_->examined, kCorner, 0, 2 * look_->mark);
    const Color ink = at_hand    ? look_->examined_text
                      : supports ? look_->support_text
                      : tested   ? look_->ink
                                 : look_->muted;
    text_middle(list_, look_, at_hand || supports ? Face::kMonoBold : Face::kMono, kSize, middle(rect), ink,
                name(place));
  }

  void draw_call(const Rect& rect, const WaitingCall& call, bool running) {
    const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
    if (running) list_->AddRectFilled(low, high, look_->lit, kCorner);
    else list_->AddRect(low, high, look_->support, kCorner, 0, 1.5f * look_->mark);
    const float baseline = middle_of(rect.y + rect.height / 2, look_.px(kSize)), room = rect.width - 2 * kPadding;
    const std::string fixed = names(call.boundary);
    const Face face = call.boundary.size() == 0 ? Face::kRegular : Face::kMonoBold;
    text(list_, look_, face, kSize, {low.x + kPadding, baseline},
         call.boundary.size() == 0 ? look_->muted : look_->support_text, shortened(look_, face, kSize, fixed, room));
    // The fixed points matter more: where they leave no room, the other side says less.
    const float left = room - kPadding - measure(look_, face, kSize, fixed).x;
    for (const std::string& state : states(call, running)) {
      if (measure(look_, Face::kRegular, kSize, state).x > left) continue;
      text_right(list_, look_, Face::kRegular, kSize, {high.x - kPadding, baseline},
                 running ? look_->ink : look_->muted, state);
      break;
    }
  }

  [[nodiscard]] std::string names(const fit::Support& points) const {
    std::string names;
    for (const Index i : points) names += (names.empty() ? "" : " ") + session_.stage().subject().name_of(i);
    return names.empty() ? "none fixed" : names;
  }

  /// What a call is doing, in words from long to short.
  [[nodiscard]] std::vector<std::string> states(const WaitingCall& call, bool running) const {
    if (!running)
      return {"waits at " + session_.stage().subject().name_of(call.at),
              "at " + session_.stage().subject().name_of(call.at)};
    const std::string count = std::to_string(call.done) + " of " + std::to_string(call.length);
    return {count + (call.length == 1 ? " point" : " points"), count};
  }

  const Look& look_;
  const lesson::Session& session_;
  const WelzlState& state_;
  ImDrawList* list_;
  float x_, width_, top_, y_;
  std::vector<Index> support_;
};

}  // namespace

std::vector<int> shown_places(int size, int at, int most) {
  std::vector<int> places;
  const auto add = [&](int from, int to) {
    for (int place = std::max(from, 0); place < std::min(to, size); ++place) places.push_back(place);
  };
  if (size <= most) return add(0, size), places;
  const int around = (most - 2) / 2, front = most - 2 - around;
  if (at < front - 1) {
    add(0, most - 1), places.push_back(kListGap);
    return places;
  }
  const int from = std::clamp(at - around / 2, front, size - around);
  add(0, front);
  if (from > front) places.push_back(kListGap);
  add(from, from + around);
  if (from + around < size) places.push_back(kListGap);
  return places;
}

float draw_call_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  const WelzlState state =
      lesson::welzl_state(lesson::fit_run(session.player().run(0)).trace(), session.player().step());
  if (state.list.empty()) return 0;
  CallPanel panel(look, session, state, at, width);
  panel.heading("The list, front first");
  panel.cells();
  panel.note(list_note(session, state));
  panel.heading("Calls, and what each has fixed");
  panel.calls();
  return panel.height();
}

}  // namespace snug::app
