#include "app/inspector.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

/// Writes from top to bottom within a column.
class Column {
 public:
  Column(const Look& look, const Rect& rect)
      : look_(look), list_(ImGui::GetWindowDrawList()), x_(rect.x + 24), width_(rect.width - 48),
        y_(rect.y + 24 - ImGui::GetScrollY()) {}

  void heading(std::string_view words) {
    constexpr float kSize = 13, kLeading = 18;
    for (const std::string_view line : lines_of(look_, Face::kSemiBold, kSize, words, width_)) {
      text(list_, look_, Face::kSemiBold, kSize, {x_, y_ + look_.px(5)}, look_->muted, line);
      y_ += look_.px(kLeading);
    }
    y_ += look_.px(24 - kLeading);
  }

  /// Draws a figure. A name too long for its row is wrapped, never cut.
  void figure(const lesson::Figure& figure) {
    const float row = look_.px(30), size = 14, small = 13, leading = 18;
    const float value = measure(look_, Face::kMonoBold, small, figure.text).x;
    const auto lines = lines_of(look_, Face::kRegular, size, figure.name, width_ - value - 6);
    float y = y_ + row / 2;
    text_right(list_, look_, Face::kMonoBold, small, {x_ + width_, middle_of(y, look_.px(small))}, look_->ink,
               figure.text);
    for (const std::string_view line : lines) {
      text(list_, look_, Face::kRegular, size, {x_, middle_of(y, look_.px(size))}, look_->ink, line);
      y += look_.px(leading);
    }
    y_ += row + look_.px(leading) * static_cast<float>(lines.size() - 1);
    rule(list_, x_, y_ - 1, width_, look_->line);
  }

  void rival(const std::string& title, const lesson::Rival& rival, double widest, bool chosen, bool beside,
             bool hidden) {
    const float size = 14, small = 13;
    const std::string value = hidden                    ? "—"
                              : chosen || !rival.excess ? lesson::number_text(rival.size)
                                                        : lesson::percent_text(*rival.excess);
    const Color bar = chosen ? look_->current : look_->previous;
    text_right(list_, look_, chosen ? Face::kMonoBold : Face::kMono, small, {x_ + width_, y_ + look_.px(4)},
               chosen ? look_->current_text : look_->muted, value);
    const float room = width_ - measure(look_, Face::kMonoBold, small, value).x - 10;
    const Face face = chosen || beside ? Face::kSemiBold : Face::kRegular;
    const auto lines = lines_of(look_, face, size, title, room);
    for (std::size_t i = 0; i < lines.size(); ++i, y_ += i < lines.size() ? look_.px(18) : 0)
      text(list_, look_, face, size, {x_, y_ + look_.px(3)}, look_->ink, lines[i]);
    const float top = y_ + look_.px(24), height = 6;
    const float share = widest > 0 ? static_cast<float>(rival.size / widest) : 1.0f;
    list_->AddRectFilled({x_, top}, {x_ + width_, top + height}, look_->track, height / 2);
    if (!hidden) list_->AddRectFilled({x_, top}, {x_ + width_ * share, top + height}, bar, height / 2);
    y_ += look_.px(40);
  }

  void proof(const lesson::Proof& proof) {
    const float size = 14, indent = 22, leading = 20;
    const float middle = y_ + look_.px(14);
    if (proof.holds) tick(list_, {x_ + 6, middle}, 5, look_->optimum, 2);
    else if (proof.claimed) cross(list_, {x_ + 6, middle}, 4, look_->wrong, 2);
    else list_->AddLine({x_ + 2, middle}, {x_ + 10, middle}, look_->muted, 2);
    const float height =
        paragraph(list_, look_, Face::kRegular, size, leading, {x_ + indent, y_ + look_.px(4)}, width_ - indent,
                  proof.holds     ? look_->ink
                  : proof.claimed ? look_->wrong_text
                                  : look_->muted,
                  proof.text);
    y_ += height + look_.px(8);
  }

  void proofs(std::string_view title, const std::vector<lesson::Proof>& proofs) {
    if (proofs.empty()) return;
    heading(title);
    for (const lesson::Proof& proof : proofs) this->proof(proof);
    gap(look_.px(12));
  }

  void panels(lesson::Session& session, const SubjectView& view) {
    const float height = view.draw_panels(look_, session, {x_, y_}, width_);
    if (height > 0) y_ += height + look_.px(28);
  }

  void gap(float height) { y_ += height; }
  /// How far it went.
  [[nodiscard]] float height(const Rect& rect) const { return y_ + ImGui::GetScrollY() - rect.y; }
  /// Tells ImGui how far it went, so that it can scroll.
  void finish() const {
    ImGui::SetCursorScreenPos({x_, y_ + 12});
    ImGui::Dummy({1, 1});
  }

 private:
  const Look& look_;
  ImDrawList* list_;
  float x_, width_, y_;
};

/// The figures by which two methods are compared. The last row is of naive methods and those beside them.
constexpr std::array<std::string_view, 16> kCompared{
    "radius",   "measure",       "excess",     "corners", "verdict",    "slack",   "over_hull", "cost",
    "compared", "outside_count", "worst_ulps", "dents",   "wrong_rows", "far_off", "digits",    "widened_ulps"};

/// Whether another method stands beside the main one, and not the same once more.
bool has_another_beside(const lesson::Session& session) {
  return session.player().method(1) != nullptr && session.player().method(1) != session.player().method(0);
}

}  // namespace

std::vector<lesson::Figure> figures_beside(const lesson::Session& session) {
  if (!has_another_beside(session)) return {};
  const std::string step =
      std::to_string(session.player().step_of(1)) + " of " + std::to_string(session.player().run(1).steps());
  std::string word(session.lesson().subject->step_word);
  word.front() = static_cast<char>(word.front() - 'a' + 'A');
  std::vector<lesson::Figure> figures{{word, "step", step, static_cast<double>(session.player().step_of(1)), ""}};
  for (lesson::Figure& figure : session.telling().figures(1))
    if (std::find(kCompared.begin(), kCompared.end(), figure.key) != kCompared.end())
      figures.push_back(std::move(figure));
  return figures;
}

float draw_inspector(const Look& look, lesson::Session& session, const SubjectView& view, const Rect& rect) {
  Column column(look, rect);
  if (const auto figures = session.telling().figures(); !figures.empty()) {
    column.heading(view.figures_are(session));
    for (const lesson::Figure& figure : figures)
      if (!view.in_panels(figure)) column.figure(figure);
    column.gap(look.px(28));
  }

  column.panels(session, view);
  const float own = column.height(rect);

  if (has_another_beside(session)) {
    column.heading("Compared: " + lesson::title_in(session.lesson(), *session.player().method(1)));
    for (const lesson::Figure& figure : figures_beside(session)) column.figure(figure);
    column.gap(look.px(28));
  }

  if (session.player().rivals().size() > 1) {
    column.heading(lesson::kComparedWord);
    double widest = 0;
    for (const auto& rival : session.player().rivals()) widest = std::max(widest, rival.size);
    for (const auto& rival : session.player().rivals()) {
      const bool chosen = rival.method == session.player().method(0);
      column.rival(lesson::title_in(session.lesson(), *rival.method), rival, widest * 1.08, chosen,
                   rival.method == session.player().method(1), session.telling().hides_result(*rival.method));
    }
    column.gap(look.px(20));
  }

  const bool at_end = session.player().step() == session.player().steps();
  column.proofs(at_end ? "Proof" : "Proof so far", session.player().proofs());
  if (has_another_beside(session))
    column.proofs((at_end ? "Proof: " : "Proof so far: ") +
                      lesson::title_in(session.lesson(), *session.player().method(1)),
                  session.player().proofs(1));
  column.finish();
  fade_foot(ImGui::GetWindowDrawList(), rect, look->panel);
  return own;
}

}  // namespace snug::app
