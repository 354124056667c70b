// Building a tree by hand: two nodes without a parent are chosen, one after the other, and merged.
#include <algorithm>

#include "app/subjects/tree/draw.hpp"
#include "app/widgets.hpp"

namespace snug::app {
namespace {

constexpr float kHandRow = 32, kHandGap = 6;

/// Buttons from left to right, and then in the next row.
struct HandButtons {
  const Look& look;
  ImDrawList* list;
  ImVec2 at;
  float width;
  float x = 0, y = 0;

  bool press(const std::string& words, const std::string& name, ButtonKind kind, bool enabled = true) {
    const float wide = std::min(measure(look, Face::kSemiBold, 13, words).x + look.px(18), width);
    const float high = look.fingers ? 44.0f : look.px(kHandRow);
    if (x > 0 && x + wide > width) x = 0, y += high + kHandGap;
    const Rect rect{at.x + x, at.y + y, wide, high};
    x += wide + kHandGap;
    return button(list, look,
                  {.id = name.c_str(), .rect = rect, .words = words, .kind = kind, .enabled = enabled, .size = 13});
  }
  void next_row() {
    if (x > 0) y += (look.fingers ? 44.0f : look.px(kHandRow)) + kHandGap;
    x = 0;
  }
};

void merge(lesson::Session& session, Index first, Index second) {
  lesson::Rows rows = session.subject().rows();
  rows.back().front() += 1;
  rows.back().push_back(first), rows.back().push_back(second);
  static_cast<void>(session.set_rows(rows));
  session.last();
}

void take_back(lesson::Session& session) {
  lesson::Rows rows = session.subject().rows();
  rows.back().front() -= 1;
  rows.back().resize(rows.back().size() - 2);
  static_cast<void>(session.set_rows(rows));
  session.last();
}

}  // namespace

float draw_hand_panel(const Look& look, lesson::Session& session, const TreeShown& shown, ImVec2 at, float width,
                      Index& first) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const lesson::Forest& forest = shown.run->forest(shown.run->steps());  // after all mergers, whatever step is shown
  const std::vector<Index>& roots = forest.roots;
  if (std::find(roots.begin(), roots.end(), first) == roots.end()) first = kNoIndex;
  text(list, look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted,
       roots.size() == 1 ? "The tree is finished" : "Merge two nodes");
  HandButtons buttons{look, list, {at.x, at.y + look.px(26)}, width};
  for (const Index root : roots) {
    const std::string name = shown.run->name_of(forest, root);
    const bool chosen = root == first;
    if (roots.size() == 1 ||
        !buttons.press(name, "Merge " + name, chosen ? ButtonKind::kChosen : ButtonKind::kOutlined))
      continue;
    if (first == kNoIndex || chosen) {
      first = chosen ? kNoIndex : root;
      continue;
    }
    merge(session, std::exchange(first, kNoIndex), root);
    return buttons.y + look.px(26 + kHandRow);  // what is shown is another run now
  }
  buttons.next_row();
  const bool any = session.subject().rows().back().size() > 1;
  if (buttons.press("Take the last one back", "Take the last merger back", ButtonKind::kPlain, any)) take_back(session);
  return buttons.y + look.px(26 + kHandRow);
}

}  // namespace snug::app
