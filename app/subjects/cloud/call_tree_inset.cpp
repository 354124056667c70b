// The tree of calls and the meter of the stack, in a corner of the stage.
#include <algorithm>
#include <numeric>
#include <string>

#include "app/marks.hpp"
#include "app/subjects/cloud/call_tree_view.hpp"
#include "fit/sphere/welzl_recursive.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

using lesson::CallTree;
using lesson::TreeCall;

constexpr float kPad = 12, kNameSize = 12, kMeter = 6;
constexpr float kNarrow = 560, kNarrowTree = 56;  // a narrow stage, and how high the tree is there, pixels

/// A large tree's calls stand too close for a mark each.
constexpr std::size_t kMostMarked = 200;
constexpr int kDeepestMarked = 40;

class TreeInset {
 public:
  TreeInset(Brush& brush, const CallTree& whole, const CallTree& now, const Rect& panel)
      : brush_(brush), p_(brush.p), whole_(whole), now_(now), panel_(panel), columns_(columns_of(whole)) {}

  static float head(const Look& look) { return look.px(24); }
  static float foot(const Look& look) { return look.px(20) + kMeter + kPad; }

  void draw() {
    const ImVec2 low{panel_.x, panel_.y}, high{panel_.x + panel_.width, panel_.y + panel_.height};
    brush_.panel(panel_);
    text(brush_.list, brush_.look, Face::kSemiBold, kNameSize, {low.x + kPad, low.y + brush_.look.px(6)}, p_.muted,
         "Calls");
    if (now_.calls.empty()) {
      const ImVec2 middle{panel_.x + panel_.width / 2,
                          panel_.y + (panel_.height + head(brush_.look) - foot(brush_.look)) / 2};
      text_middle(brush_.list, brush_.look, Face::kRegular, kNameSize,
                  {middle.x, middle_of(middle.y, brush_.look.px(kNameSize))}, p_.muted, "none yet");
    }
    draw_branches();
    const bool marked = whole_.calls.size() <= kMostMarked && whole_.deepest <= kDeepestMarked;
    for (std::size_t i = 0; i < now_.calls.size(); ++i)
      if (marked || runs(i)) draw_call(i);
    draw_meter();
  }

 private:
  [[nodiscard]] bool narrow() const { return panel_.width < 180; }
  [[nodiscard]] bool runs(std::size_t i) const { return !now_.open.empty() && now_.open.back() == static_cast<int>(i); }

  [[nodiscard]] ImVec2 place(std::size_t i) const {
    const float top = panel_.y + head(brush_.look) + kPad, bottom = panel_.y + panel_.height - foot(brush_.look) - kPad;
    const float depths = static_cast<float>(std::max(1, whole_.deepest - 1));
    return {panel_.x + 2 * kPad + columns_[i] * (panel_.width - 4 * kPad),
            top + static_cast<float>(whole_.calls[i].depth - 1) / depths * (bottom - top)};
  }

  /// Calls that each made one call, and look alike, stand in a column: one line is enough for all of them.
  void draw_branches() {
    std::vector<int> made(whole_.calls.size(), 0);
    for (const TreeCall& call : whole_.calls)
      if (call.parent >= 0) ++made[call.parent];
    std::vector<std::size_t> bottom(now_.calls.size());  // of the column that begins at each call
    std::iota(bottom.begin(), bottom.end(), std::size_t{0});
    for (std::size_t i = bottom.size(); i-- > 0;) {  // a call stands after the one that made it
      const TreeCall& call = now_.calls[i];
      const std::size_t caller = std::max(call.parent, 0);
      const bool goes_on = call.parent >= 0 && made[caller] == 1 && call.open == now_.calls[caller].open;
      if (goes_on) {
        bottom[caller] = bottom[i];
        continue;
      }
      if (call.parent >= 0) draw_branch(place(caller), place(i), call);
      if (bottom[i] != i) draw_branch(place(i), place(bottom[i]), now_.calls[bottom[i]]);
    }
  }

  void draw_branch(ImVec2 from, ImVec2 to, const TreeCall& call) {
    const Color color = call.open ? p_.support : call.again ? p_.current : p_.muted;
    line(brush_.list, from, to, call.again ? Stroke::kDashed : Stroke::kSolid,
         call.open ? color : with_alpha(color, 0.6f), brush_.stroke(call.open ? 1.0f : 0.5f));
  }

  void draw_call(std::size_t i) {
    const TreeCall& call = now_.calls[i];
    const ImVec2 at = place(i);
    const float size = (narrow() ? 3.0f : 5.0f) * p_.mark;
    if (runs(i)) disc(brush_.list, at, size, p_.examined);
    else if (call.open) diamond(brush_.list, at, size, p_.support, p_.panel);
    else disc(brush_.list, at, size / 2, p_.muted);
    if (!call.open || call.point == kNoIndex || (narrow() && !runs(i))) return;
    const std::string name = brush_.session.stage().subject().name_of(call.point);
    const float wide = measure(brush_.look, Face::kMonoBold, kNameSize, name).x;
    const bool left = at.x + 9 + wide > panel_.x + panel_.width - 4;
    text(brush_.list, brush_.look, Face::kMonoBold, kNameSize,
         {left ? at.x - 9 - wide : at.x + 9, middle_of(at.y, brush_.look.px(kNameSize))},
         runs(i) ? p_.examined_text : p_.support_text, name);
  }

  /// How much of the stack is used, up to the depth at which the recursion is stopped; a stroke: the most so far.
  void draw_meter() {
    const int open = now_.stopped_at > 0 ? now_.stopped_at : static_cast<int>(now_.open.size());
    const float x = panel_.x + kPad, y = panel_.y + panel_.height - kPad - kMeter, width = panel_.width - 2 * kPad;
    const auto across = [&](int calls) {
      return width * std::min(1.0f, static_cast<float>(calls) / static_cast<float>(fit::kWelzlDepthLimit));
    };
    brush_.list->AddRectFilled({x, y}, {x + width, y + kMeter}, p_.track, kMeter / 2);
    if (open > 0)
      brush_.list->AddRectFilled({x, y}, {x + std::max(kMeter, across(open)), y + kMeter},
                                 now_.stopped_at > 0 ? p_.wrong : p_.current, kMeter / 2);
    const float tick = x + across(now_.deepest);
    if (now_.deepest > 0) brush_.list->AddLine({tick, y - 3}, {tick, y + kMeter + 3}, p_.support, 2);
    const std::string limit = lesson::count_text(fit::kWelzlDepthLimit);
    const std::string words = now_.stopped_at > 0 ? "stopped at " + limit
                              : narrow()          ? lesson::count_text(open) + " of " + limit
                                                  : "Stack: " + lesson::count_text(open) + " of " + limit + " calls";
    text(brush_.list, brush_.look, Face::kRegular, kNameSize, {x, y - brush_.look.px(18)},
         now_.stopped_at > 0 ? p_.wrong_text : p_.ink, words);
  }

  Brush& brush_;
  const Palette& p_;
  const CallTree& whole_;
  const CallTree& now_;
  const Rect panel_;
  std::vector<float> columns_;
};

}  // namespace

std::vector<float> columns_of(const CallTree& tree) {
  const std::size_t n = tree.calls.size();
  std::vector<bool> calls(n, false);
  for (const TreeCall& call : tree.calls)
    if (call.parent >= 0) calls[call.parent] = true;
  std::vector<float> first(n, -1), last(n, -1);  // of the columns below each call
  float leaves = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (!calls[i]) first[i] = last[i] = leaves++;
  std::vector<float> columns(n, 0.5f);
  for (std::size_t i = n; i-- > 0;) {  // a call stands after the one that made it
    const float own = (first[i] + last[i]) / 2;
    if (leaves > 1) columns[i] = own / (leaves - 1);
    if (tree.calls[i].parent < 0) continue;
    const std::size_t caller = tree.calls[i].parent;
    if (last[caller] < 0) last[caller] = own;
    first[caller] = own;
  }
  return columns;
}

Rect draw_call_tree(Brush& brush, ImVec2 at) {
  if (!shows_calls(brush.session)) return {};
  const lesson::FitTrace trace = lesson::fit_run(brush.session.player().run(0)).trace();
  const CallTree whole = lesson::call_tree(trace, static_cast<int>(trace.size()));
  const CallTree now = lesson::call_tree(trace, brush.session.player().step());
  const Look& look = brush.look;
  const bool narrow = brush.rect.width < kNarrow;
  const float width = narrow ? 110.0f : look.px(brush.rect.width < 900 ? 200 : 280);
  const Rect panel{at.x, at.y, width,
                   (narrow ? kNarrowTree : width * 0.8f) + TreeInset::head(look) + TreeInset::foot(look)};
  if (panel.y + panel.height > brush.canvas.camera.free_bottom()) return {};
  TreeInset(brush, whole, now, panel).draw();
  return panel;
}

}  // namespace snug::app
