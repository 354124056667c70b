// The open calls as blocks that lie on one another, beside the stage.
#include <string>

#include "app/marks.hpp"
#include "app/subjects/cloud/call_tree_view.hpp"

namespace snug::app {
namespace {

using lesson::CallTree;
using lesson::TreeCall;

constexpr float kRow = 26, kCorner = 4, kSize = 12;
constexpr int kRows = 8, kGap = -1;  // as many for every run: how deep a run goes is asked

/// Which open calls have a row, the outermost first: all, or the first and the last ones about a gap.
std::vector<int> rows_shown(int open) {
  std::vector<int> shown;
  const int first = open <= kRows ? open : kRows / 2;
  for (int i = 0; i < first; ++i) shown.push_back(i);
  if (open <= kRows) return shown;
  shown.push_back(kGap);
  for (int i = open - (kRows - first - 1); i < open; ++i) shown.push_back(i);
  return shown;
}

void draw_block(const Look& look, const lesson::Session& session, const TreeCall* call, bool runs, const Rect& rect) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImVec2 low{rect.x, rect.y}, high{rect.x + rect.width, rect.y + rect.height};
  const float baseline = middle_of(rect.y + rect.height / 2, look.px(kSize));
  if (call == nullptr)
    return text_middle(list, look, Face::kRegular, kSize, {rect.x + rect.width / 2, baseline}, look->muted,
                       "… more calls that wait …");
  if (runs) list->AddRectFilled(low, high, look->lit, kCorner);
  else list->AddRect(low, high, look->support, kCorner, 0, 1.5f * look->mark);
  const std::string right = runs ? (call->decided ? "calls again" : "runs") : call->decided ? "2nd call" : "1st call";
  text_right(list, look, Face::kRegular, kSize, {high.x - 8, baseline}, look->muted, right);
  const float room = rect.width - 16 - measure(look, Face::kRegular, kSize, right).x - 8;
  std::string words = call->point == kNoIndex ? "stopped" : "u = " + session.stage().subject().name_of(call->point);
  for (const Index i : call->boundary)
    words += (i == call->boundary[0] ? " · " : " ") + session.stage().subject().name_of(i);
  text(list, look, Face::kMono, kSize, {low.x + 8, baseline}, look->ink,
       shortened(look, Face::kMono, kSize, words, room));
}

}  // namespace

bool shows_calls(const lesson::Session& session) {
  return lesson::has_calls(lesson::fit_run(session.player().run(0)).trace());
}

float draw_call_stack(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  if (!shows_calls(session)) return 0;
  const lesson::FitTrace trace = lesson::fit_run(session.player().run(0)).trace();
  const CallTree now = lesson::call_tree(trace, session.player().step());
  float y = at.y;
  text(ImGui::GetWindowDrawList(), look, Face::kSemiBold, 13, {at.x, y + look.px(5)}, look->muted,
       "The stack, the first call at the bottom");
  y += look.px(28);
  const int open = static_cast<int>(now.open.size());
  const std::vector<int> shown = rows_shown(open);
  for (int row = kRows; row-- > 0; y += look.px(kRow)) {
    const Rect rect{at.x, y, width, look.px(kRow) - 3};
    if (row >= static_cast<int>(shown.size())) {
      ImGui::GetWindowDrawList()->AddRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->line,
                                          kCorner, 0, 1);
      continue;
    }
    const int i = shown[row];
    const TreeCall* call = i == kGap ? nullptr : &now.calls[now.open[i]];
    draw_block(look, session, call, i == open - 1, rect);
  }
  return y - at.y;
}

}  // namespace snug::app
