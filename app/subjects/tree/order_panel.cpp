// Steering a ray by hand: where it meets both children of a node, the student chooses which one comes next.
#include "app/subjects/tree/draw.hpp"
#include "app/subjects/tree/hand_buttons.hpp"

namespace snug::app {
namespace {

/// Keeps the choices that were needed, and adds one or takes the last one back.
void steer(lesson::Session& session, std::optional<Index> choice) {
  const std::size_t needed = lesson::tree_run(session.player().run(0)).result().chosen;
  const std::size_t row = lesson::as<lesson::TreeSubject>(session.stage().subject())->stage().row_of_order();
  lesson::Rows rows = session.stage().subject().rows();
  std::vector<double>& order = rows[row];
  order.resize(needed + (choice ? 1 : 0));  // the first number is how many there are
  if (choice) order.push_back(*choice);
  order.front() = static_cast<double>(order.size() - 1);
  static_cast<void>(session.stage().set_rows(rows));
  session.last();
}

}  // namespace

float draw_order_panel(const Look& look, lesson::Session& session, const TreeShown& shown, ImVec2 at, float width) {
  const lesson::TreeRun& run = *shown.run;
  const Index node = run.undecided();
  text(ImGui::GetWindowDrawList(), look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted,
       node == kNoIndex ? "Your order is complete" : "Which child comes next?");
  HandButtons buttons{look, ImGui::GetWindowDrawList(), {at.x, at.y + look.px(kHandHead)}, width};
  if (node != kNoIndex)
    for (const Index side : {0, 1}) {
      const std::string name = run.name_of(shown.forest(), shown.forest().at(node).children[side]);
      if (!buttons.press(name, "Take " + name + " next", ButtonKind::kOutlined)) continue;
      const float high = buttons.height();
      steer(session, side);
      return high;  // what is shown is another run now
    }
  buttons.next_row();
  const float high = buttons.height();
  if (buttons.press("Take the last one back", "Take the last choice back", ButtonKind::kPlain, run.result().chosen > 0))
    steer(session, std::nullopt);
  return high;
}

}  // namespace snug::app
