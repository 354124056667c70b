// Building a tree by hand: two nodes without a parent are chosen, one after the other, and merged.
#include <algorithm>

#include "app/subjects/tree/draw.hpp"
#include "app/subjects/tree/hand_buttons.hpp"

namespace snug::app {
namespace {

std::size_t row_of_mergers(const lesson::Session& session) {
  return lesson::as<lesson::TreeSubject>(session.stage().subject())->stage().row_of_mergers();
}

void merge(lesson::Session& session, Index first, Index second) {
  lesson::Rows rows = session.stage().subject().rows();
  std::vector<double>& mergers = rows[row_of_mergers(session)];
  mergers.front() += 1;
  mergers.push_back(first), mergers.push_back(second);
  static_cast<void>(session.stage().set_rows(rows));
  session.last();
}

void take_back(lesson::Session& session) {
  lesson::Rows rows = session.stage().subject().rows();
  std::vector<double>& mergers = rows[row_of_mergers(session)];
  mergers.front() -= 1;
  mergers.resize(mergers.size() - 2);
  static_cast<void>(session.stage().set_rows(rows));
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
  HandButtons buttons{look, list, {at.x, at.y + look.px(kHandHead)}, width};
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
    return buttons.height();  // what is shown is another run now
  }
  buttons.next_row();
  const bool any = session.stage().subject().rows()[row_of_mergers(session)].size() > 1;
  if (buttons.press("Take the last one back", "Take the last merger back", ButtonKind::kPlain, any)) take_back(session);
  return buttons.height();
}

}  // namespace snug::app
