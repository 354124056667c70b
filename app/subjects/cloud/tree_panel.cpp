#include "app/subjects/cloud/tree_panel.hpp"

#include <algorithm>
#include <string>

#include "app/marks.hpp"
#include "fit/sphere/welzl_recursive.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

using lesson::CallTree;
using lesson::TreeCall;

/// A wide tree's calls stand too close for a mark each.
constexpr int kMostMarked = 60;

class TreePanel {
 public:
  TreePanel(const Look& look, const lesson::Session& session, const CallTree& whole, const CallTree& now, ImVec2 at,
            float width)
      : look_(look), session_(session), whole_(whole), now_(now), list_(ImGui::GetWindowDrawList()), x_(at.x),
        width_(width), top_(at.y), y_(at.y) {}

  [[nodiscard]] float height() const { return y_ - top_; }

  void heading(std::string_view words) {
    text(list_, look_, Face::kSemiBold, 13, {x_, y_ + look_.px(5)}, look_->muted, words);
    y_ += look_.px(28);
  }

  /// Each call under the one that made it. Every call has its place from the beginning, so that none moves when the
  /// tree grows.
  void tree() {
    columns_ = columns_of(whole_);
    const bool marked = whole_.deepest <= kMostMarked && whole_.calls.size() <= 4 * kMostMarked;
    for (std::size_t i = now_.calls.size(); i-- > 0;) draw_branch(i);
    if (marked)
      for (std::size_t i = 0; i < now_.calls.size(); ++i) draw_call(i);
    else if (!now_.open.empty()) draw_call(static_cast<std::size_t>(now_.open.back()));
    y_ += look_.px(kTreeHeight) + look_.px(16);
  }

  /// The open calls as blocks that lie on one another, the first one lowest.
  void stack() {
    const int rows = std::min(kMostRows, whole_.deepest), open = static_cast<int>(now_.open.size());
    const std::vector<int> shown = rows_shown(open, rows);
    for (int row = 0; row < rows; ++row) {
      const int from_top = rows - 1 - row;
      const Rect rect{x_, y_, width_, look_.px(kRow) - 3};
      if (from_top >= static_cast<int>(shown.size()))
        list_->AddRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look_->line, kCorner, 0, 1);
      else draw_block(rect, shown[static_cast<std::size_t>(from_top)], open);
      y_ += look_.px(kRow);
    }
  }

  void meter() {
    const auto open = static_cast<std::int64_t>(now_.open.size());
    const int depth = now_.stopped_at > 0 ? now_.stopped_at : static_cast<int>(open);
    const float high = 8, full = static_cast<float>(fit::kWelzlDepthLimit);
    const auto across = [&](int calls) { return width_ * std::min(1.0f, static_cast<float>(calls) / full); };
    list_->AddRectFilled({x_, y_}, {x_ + width_, y_ + high}, look_->track, high / 2);
    list_->AddRectFilled({x_, y_}, {x_ + std::max(high, across(depth)), y_ + high},
                         now_.stopped_at > 0 ? look_->wrong : look_->current, high / 2);
    const float tick = x_ + across(now_.deepest);
    list_->AddLine({tick, y_ - 3}, {tick, y_ + high + 3}, look_->support, 2);
    y_ += high + look_.px(8);
    const std::string words = lesson::count_text(depth) + " of " + lesson::count_text(fit::kWelzlDepthLimit) +
                              " calls, at most " + lesson::count_text(now_.deepest) + " so far";
    y_ += paragraph(list_, look_, Face::kRegular, kSize, 18, {x_, y_}, width_, look_->muted,
                    now_.stopped_at > 0 ? words + ": the recursion is stopped here." : words + ".") +
          look_.px(8);
  }

 private:
  static constexpr float kTreeHeight = 190, kRow = 26, kCorner = 4, kSize = 12, kMargin = 8;
  static constexpr int kMostRows = 8, kGap = -1;

  [[nodiscard]] ImVec2 place(std::size_t i) const {
    const float depths = static_cast<float>(std::max(1, whole_.deepest - 1));
    return {x_ + kMargin + columns_[i] * (width_ - 2 * kMargin),
            y_ + kMargin + static_cast<float>(whole_.calls[i].depth - 1) / depths * look_.px(kTreeHeight)};
  }

  void draw_branch(std::size_t i) {
    const TreeCall& call = now_.calls[i];
    if (call.parent < 0) return;
    const Color color = call.open ? look_->support : call.again ? look_->current : look_->muted;
    line(list_, place(static_cast<std::size_t>(call.parent)), place(i), call.again ? Stroke::kDashed : Stroke::kSolid,
         call.open ? color : with_alpha(color, 0.6f), call.open ? 2 : 1);
  }

  void draw_call(std::size_t i) {
    const TreeCall& call = now_.calls[i];
    const ImVec2 at = place(i);
    const bool runs = !now_.open.empty() && now_.open.back() == static_cast<int>(i);
    if (runs) disc(list_, at, 6 * look_->mark, look_->examined);
    else if (call.open) diamond(list_, at, 6 * look_->mark, look_->support, look_->panel);
    else disc(list_, at, 3 * look_->mark, look_->muted);
    if (!call.open || call.point == kNoIndex) return;
    const std::string name = session_.name_of(call.point);
    const float wide = measure(look_, Face::kMonoBold, kSize, name).x;
    const bool left = at.x + 10 + wide > x_ + width_;
    text(list_, look_, Face::kMonoBold, kSize, {left ? at.x - 10 - wide : at.x + 10, middle_of(at.y, look_.px(kSize))},
         runs ? look_->examined_text : look_->support_text, name);
  }

  /// Which open calls have a row, the outermost first: all, or the first and the last ones about a gap.
  [[nodiscard]] static std::vector<int> rows_shown(int open, int rows) {
    std::vector<int> shown;
    const int first = open <= rows ? open : rows / 2;
    for (int i = 0; i < first; ++i) shown.push_back(i);
    if (open <= rows) return shown;
    shown.push_back(kGap);
    for (int i = open - (rows - first - 1); i < open; ++i) shown.push_back(i);
    return shown;
  }

  void draw_block(const Rect& rect, int row, int open) {
    const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
    const float baseline = middle_of(rect.y + rect.height / 2, look_.px(kSize));
    if (row == kGap) {
      text_middle(list_, look_, Face::kRegular, kSize, {rect.x + rect.width / 2, baseline}, look_->muted,
                  "… and more calls that wait …");
      return;
    }
    const TreeCall& call = now_.calls[static_cast<std::size_t>(now_.open[static_cast<std::size_t>(row)])];
    const bool runs = row == open - 1;
    if (runs) list_->AddRectFilled(low, high, look_->lit, kCorner);
    else list_->AddRect(low, high, look_->support, kCorner, 0, 1.5f * look_->mark);
    const std::string right = runs ? (call.decided ? "calls again" : "runs") : call.decided ? "2nd call" : "1st call";
    text_right(list_, look_, Face::kRegular, kSize, {high.x - 8, baseline}, look_->muted, right);
    const float room = rect.width - 16 - measure(look_, Face::kRegular, kSize, right).x - 8;
    std::string words = session_.name_of(call.point) + " removed";
    for (const Index i : call.boundary) words += (i == call.boundary[0] ? " · fixed " : " ") + session_.name_of(i);
    text(list_, look_, Face::kMono, kSize, {low.x + 8, baseline}, look_->ink,
         shortened(look_, Face::kMono, kSize, words, room));
  }

  const Look& look_;
  const lesson::Session& session_;
  const CallTree& whole_;
  const CallTree& now_;
  ImDrawList* list_;
  float x_, width_, top_, y_;
  std::vector<float> columns_;
};

}  // namespace

std::vector<float> columns_of(const CallTree& tree) {
  const std::size_t n = tree.calls.size();
  struct Span {
    float first = -1, last = -1;
  };
  std::vector<Span> below(n);
  std::vector<float> columns(n, 0.5f);
  std::vector<bool> calls(n, false);
  for (const TreeCall& call : tree.calls)
    if (call.parent >= 0) calls[static_cast<std::size_t>(call.parent)] = true;
  float leaves = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (!calls[i]) below[i] = {leaves, leaves}, leaves += 1;
  for (std::size_t i = n; i-- > 0;) {  // calls stand after their callers
    columns[i] = leaves > 1 ? (below[i].first + below[i].last) / 2 / (leaves - 1) : 0.5f;
    if (tree.calls[i].parent < 0) continue;
    Span& caller = below[static_cast<std::size_t>(tree.calls[i].parent)];
    const float own = (below[i].first + below[i].last) / 2;
    if (caller.last < 0) caller.last = own;
    caller.first = own;
  }
  return columns;
}

float draw_tree_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  const lesson::FitTrace trace = lesson::fit_run(session.run(0)).trace();
  if (!lesson::has_calls(trace)) return 0;
  const CallTree whole = lesson::call_tree(trace, static_cast<int>(trace.size()));
  const CallTree now = lesson::call_tree(trace, session.step());
  TreePanel panel(look, session, whole, now, at, width);
  panel.heading("The calls, as a tree");
  panel.tree();
  panel.heading("The stack, the first call at the bottom");
  panel.stack();
  panel.meter();
  return panel.height();
}

}  // namespace snug::app
