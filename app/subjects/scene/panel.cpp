#include "app/subjects/scene/panel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/marks.hpp"
#include "app/subjects/scene/graph.hpp"
#include "app/subjects/scene/update_costs.hpp"
#include "app/widgets.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"

namespace snug::app {
namespace {

constexpr float kText = 14, kSmall = 13, kTiny = 12;
constexpr float kEffectRow = 26, kLeading = 16, kIndent = 20;
constexpr float kReason = 11, kReasonToFinger = 18;  // what an effect's reason adds to its row

const lesson::FrameTaken* taken(const lesson::Session& session) {
  if (session.player().step() == 0) return nullptr;
  return std::get_if<lesson::FrameTaken>(
      &lesson::scene_run(session.player().run(0)).entry(session.player().step() - 1).step.fact);
}

class ScenePanel {
 public:
  ScenePanel(const Look& look, ImVec2 at, float width)
      : look_(look), list_(ImGui::GetWindowDrawList()), x_(at.x), width_(width), top_(at.y), y_(at.y) {}

  [[nodiscard]] float height() const { return y_ - top_; }

  void gap() { y_ += look_.px(12); }

  void heading(std::string_view words) {
    text(list_, look_, Face::kSemiBold, 13, {x_, y_ + look_.px(5)}, look_->muted, words);
    y_ += look_.px(28);
  }

  /// Draws a stage of the funnel: its stroke as on the stage, its name, how many pairs it left, and a bar of their
  /// fraction of all pairs. hidden: it is still to be predicted.
  void stage(std::string_view name, double left, double all, bool hidden, Stroke stroke, Color color, bool sampled) {
    const float middle = y_ + look_.px(9);
    float x = x_;
    if (sampled) {
      line(list_, {x, middle}, {x + 26, middle}, stroke, color, stroke == Stroke::kSolid ? 3.0f : 2.0f);
      if (stroke == Stroke::kSolid) diamond(list_, {x + 13, middle}, 5, color, look_->panel);
      x += 36;
    }
    text(list_, look_, Face::kRegular, kText, {x, middle_of(middle, look_.px(kText))}, look_->ink, name);
    text_right(list_, look_, Face::kMonoBold, kSmall, {x_ + width_, middle_of(middle, look_.px(kSmall))}, look_->ink,
               hidden ? "—" : lesson::count_text(static_cast<std::int64_t>(left)));
    const float top = y_ + look_.px(22), thick = 8;
    list_->AddRectFilled({x_, top}, {x_ + width_, top + thick}, look_->track, 2);
    if (left > 0 && !hidden)
      list_->AddRectFilled({x_, top}, {x_ + std::max(2.0f, width_ * static_cast<float>(left / all)), top + thick},
                           color, 2);
    y_ += look_.px(40);
  }

  /// Draws a figure that is not a stage: the work of the first one.
  void figure(std::string_view name, const std::string& value) {
    const float middle = y_ + look_.px(9);
    text(list_, look_, Face::kRegular, kText, {x_, middle_of(middle, look_.px(kText))}, look_->muted, name);
    text_right(list_, look_, Face::kMono, kSmall, {x_ + width_, middle_of(middle, look_.px(kSmall))}, look_->ink,
               value);
    y_ += look_.px(28);
  }

  void funnel(const lesson::Session& session, const lesson::FrameTaken& frame) {
    heading("The funnel: how many pairs are left");
    const auto part = [&](std::string_view key, double left, Stroke stroke, Color color, bool sampled) {
      stage(lesson::scene_figure_title(key), left, frame.all_pairs, session.telling().is_hidden(key), stroke, color,
            sampled);
    };
    part("all_pairs", frame.all_pairs, Stroke::kSolid, look_->muted, false);
    std::string compared(lesson::scene_figure_title("compared"));
    if (const int axis = frame_of(session)->swept_along; axis >= 0) compared += std::string(" along ") + "xyz"[axis];
    figure(compared, session.telling().is_hidden("compared")
                         ? "—"
                         : lesson::count_text(static_cast<std::int64_t>(frame.compared)));
    part("after_broad", frame.after_broad, Stroke::kDotted, look_->previous, true);
    part("after_loose", frame.after_loose, Stroke::kDashed, look_->examined_text, true);
    part("touching", frame.touching, Stroke::kSolid, look_->support_text, true);
    y_ += look_.px(16);
  }

  void updates(const lesson::Session& session) { y_ += draw_update_costs(look_, session, {x_, y_}, width_); }

  void graph(const lesson::Session& session) {
    const ImVec2 size = graph_size(look_, session, width_);
    if (size.y == 0) return;
    heading("The graph of the effects");
    draw_graph(list_, look_, session, {x_, y_}, width_);
    y_ += size.y + look_.px(12);
  }

  void effects(lesson::Session& session) {
    const bool declares = lesson::set_of(session).graph;
    heading(declares ? "Effects that the scene calls for" : "What each effect has done so far");
    text(list_, look_, Face::kRegular, kTiny, {x_ + kIndent, y_}, look_->muted, "effect");
    constexpr std::array<const char*, 3> kHeads{"run", "skipped", "time, µs"};
    for (int i = 0; i < 3; ++i)
      text_right(list_, look_, Face::kRegular, kTiny, {right(i), y_}, look_->muted, kHeads[i]);
    y_ += look_.px(20);
    rule(list_, x_, y_ - 1, width_, look_->muted);
    int row = 0;
    const lesson::Switch* turned = nullptr;
    const std::vector<lesson::Switch> switches = session.player().switches();
    for (const lesson::Switch& one : switches) {
      ImGui::PushID(row++);
      const std::string name = lesson::effect_words(one.name);
      const auto lines = lines_of(look_, Face::kRegular, kSmall, name, room_for_name(one.run));
      const float reason = one.says.empty() ? 0 : look_.fingers ? kReasonToFinger : kReason;
      const float height = look_.px(kEffectRow + kLeading * static_cast<float>(lines.size() - 1) + reason);
      const bool enabled = session.player().can_toggle(one);
      const Touch touch = touch_area("effect", {x_ - 6, y_, width_ + 12, height}, name, enabled);
      ImGui::PopID();
      if (touch.clicked) turned = &one;
      if (touch.hovered) list_->AddRectFilled({x_ - 6, y_}, {x_ + width_ + 6, y_ + height - 1}, look_->raised, 4);
      effect(one, lines);
      if (!one.says.empty())
        text(list_, look_, Face::kRegular, kTiny, {x_ + kIndent, y_ + height - look_.px(kLeading)}, look_->muted,
             shortened(look_, Face::kRegular, kTiny, one.says, width_ - kIndent));
      y_ += height;
      rule(list_, x_, y_ - 1, width_, look_->line);
    }
    y_ += look_.px(8);
    y_ += paragraph(list_, look_, Face::kRegular, kTiny, kLeading, {x_, y_}, width_, look_->muted, note(session));
    if (turned != nullptr) session.player().toggle(*turned);
  }

 private:
  static std::string_view note(const lesson::Session& session) {
    if (!lesson::set_of(session).graph)
      return "The frames in which each effect ran, those in which it was skipped because nothing that it reads had "
             "changed, and the mean time of a run. Click an effect's checkbox to switch it off or on.";
    return session.player().step() == 0
               ? "Before the first frame, an effect's checkbox takes it out of the scene's declaration, or adds it."
               : "An effect's checkbox switches it off from this frame on. To change the declaration, go to frame 0. "
                 "Tap a body to make it hop.";
  }

  /// How wide an effect's name may be: up to the number of its runs.
  [[nodiscard]] float room_for_name(std::int64_t run) const {
    const float figure = measure(look_, Face::kMono, kTiny, std::to_string(run)).x;
    return right(0) - x_ - kIndent - figure - look_.px(6);
  }

  /// The right end of a column of figures.
  [[nodiscard]] float right(int column) const {
    constexpr std::array<float, 3> kShares{0.55f, 0.77f, 1};
    return x_ + width_ * kShares[column];
  }

  /// lines: those of its name, which is wrapped if it is too long for the row, and never cut.
  void effect(const lesson::Switch& one, const std::vector<std::string_view>& lines) {
    const float middle = y_ + look_.px(kEffectRow) / 2;
    const float box = 6;
    list_->AddRect({x_, middle - box}, {x_ + 2 * box, middle + box}, one.on ? look_->current : look_->muted, 3, 0,
                   1.5f);
    if (one.on && one.called) tick(list_, {x_ + box, middle}, 4, look_->current, 2);
    float y = middle_of(middle, look_.px(kSmall));
    for (const std::string_view line : lines) {
      text(list_, look_, Face::kRegular, kSmall, {x_ + kIndent, y}, one.on ? look_->ink : look_->muted, line);
      y += look_.px(kLeading);
    }
    const std::array<std::string, 3> figures{std::to_string(one.run), std::to_string(one.skipped),
                                             one.run == 0 || one.microseconds.empty() ? "—" : one.microseconds};
    for (int i = 0; i < 3; ++i)
      text_right(list_, look_, Face::kMono, kTiny, {right(i), middle_of(middle, look_.px(kTiny))}, look_->ink,
                 figures[i]);
  }

  const Look& look_;
  ImDrawList* list_;
  float x_, width_, top_, y_;
};

}  // namespace

float draw_scene_panel(const Look& look, lesson::Session& session, ImVec2 at, float width, bool with_graph) {
  ScenePanel panel(look, at, width);
  if (lesson::set_of(session).graph) {
    if (with_graph) panel.graph(session);
    panel.effects(session);
    panel.gap();
  }
  if (const lesson::FrameTaken* now = taken(session)) {
    if (now->all_pairs > 0) panel.funnel(session, *now);
    else if (session.player().volume(0) != nullptr) panel.updates(session);
  }
  if (!lesson::set_of(session).graph) panel.effects(session);
  return panel.height();
}

}  // namespace snug::app
