#include "app/subjects/scene/update_costs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"

namespace snug::app {
namespace {

constexpr float kAxisWords = 12, kFramesHeight = 84, kUpdateName = 14, kUpdateLeading = 18, kUpdateFigure = 13;
constexpr double kLeastLooseness = 1;  // %, the smallest end of the scale: less is mostly rounding

/// A figure of a slot after a step; 0 before the first.
double figure_after(const lesson::Session& session, int slot, int step, std::string_view key) {
  if (step == 0) return 0;
  const auto& fact = lesson::scene_run(session.run(slot)).trace()[step - 1].step.fact;
  const double value = lesson::figure_of(*std::get_if<lesson::FrameTaken>(&fact), key);
  return std::isfinite(value) ? value : 0;
}

/// The figures of an update at the end of its run, beside those of others.
struct UpdateCost {
  std::string title;
  std::optional<double> points;  // none while it is still to be predicted
  bool chosen = false, compared = false;
};

std::vector<UpdateCost> costs_of_all(const lesson::Session& session) {
  std::vector<UpdateCost> costs;
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method& method = *lesson::find_method(session.lesson(), name);
    UpdateCost one{
        lesson::title_in(session.lesson(), method), {}, &method == session.method(0), &method == session.method(1)};
    if (lesson::may_tell_result(session, method, "cost"))
      for (const lesson::Figure& figure : session.result(method))
        if (figure.key == "cost" && figure.known) one.points = figure.value;
    costs.push_back(std::move(one));
  }
  return costs;
}

class UpdateCharts {
 public:
  UpdateCharts(const Look& look, const lesson::Session& session, ImVec2 at, float width)
      : look_(look), session_(session), list_(ImGui::GetWindowDrawList()), x_(at.x), width_(width), top_(at.y),
        y_(at.y) {}

  [[nodiscard]] float height() const { return y_ - top_; }

  /// Draws a figure of each frame so far, over the whole run; slot 1's is dashed.
  void frame_by_frame(std::string_view title, std::string_view key, double least) {
    if (session_.is_hidden(key)) return;
    heading(std::string(title) + ", frame by frame");
    const double most = std::max(least, most_of(key));
    const std::string most_words = lesson::scene_figure_text(key, most);
    const float bottom = y_ + look_.px(kFramesHeight);
    const float room = measure(look_, Face::kMono, kAxisWords, most_words).x + 10;
    const float left = x_ + room, wide = width_ - room;
    text_right(list_, look_, Face::kMono, kAxisWords, {left - 8, y_ - look_.px(2)}, look_->muted, most_words);
    text_right(list_, look_, Face::kMono, kAxisWords, {left - 8, bottom - look_.px(12)}, look_->muted, "0");
    rule(list_, left, y_, wide, look_->line);
    rule(list_, left, bottom, wide, look_->muted);
    for (const int slot : {1, 0})
      if (session_.method(slot) != nullptr) curve(slot, key, {left, y_}, {wide, bottom - y_}, most);
    text(list_, look_, Face::kRegular, kAxisWords, {left, bottom + look_.px(5)}, look_->muted, "frame 1");
    text_right(list_, look_, Face::kRegular, kAxisWords, {x_ + width_, bottom + look_.px(5)}, look_->muted,
               std::to_string(session_.steps()));
    y_ = bottom + look_.px(44);
  }

  /// Draws a bar for each update of the lesson: the points that it examines in the last frame.
  void all_updates() {
    const std::vector<UpdateCost> costs = costs_of_all(session_);
    if (costs.size() < 2) return;
    heading("Points examined in frame " + std::to_string(session_.steps()));
    double most = 1;
    for (const UpdateCost& one : costs) most = std::max(most, one.points.value_or(0));
    for (const UpdateCost& one : costs) bar(one, most);
    y_ += look_.px(16);
  }

 private:
  void heading(std::string_view words) {
    text(list_, look_, Face::kSemiBold, 13, {x_, y_ + look_.px(5)}, look_->muted, words);
    y_ += look_.px(28);
  }

  [[nodiscard]] double most_of(std::string_view key) const {
    double most = 0;
    for (const int slot : {0, 1})
      for (int step = 1; session_.method(slot) != nullptr && step <= session_.step_of(slot); ++step)
        most = std::max(most, scaled(slot, step, key));
    return most;
  }

  /// As its text is written: looseness in per cent.
  [[nodiscard]] double scaled(int slot, int step, std::string_view key) const {
    return figure_after(session_, slot, step, key) * (key == "slack" ? 100 : 1);
  }

  void curve(int slot, std::string_view key, ImVec2 at, ImVec2 size, double most) {
    std::vector<ImVec2> places;
    const auto steps = static_cast<float>(session_.run(slot).steps());
    for (int step = 1; step <= session_.step_of(slot); ++step)
      places.push_back({at.x + size.x * static_cast<float>(step) / steps,
                        at.y + size.y * static_cast<float>(1 - scaled(slot, step, key) / most)});
    const Color color = slot == 0 ? look_->current : look_->previous;
    path(list_, places, false, slot == 0 ? Stroke::kSolid : Stroke::kDashed, color, 2);
    if (slot == 0 && !places.empty()) disc(list_, places.back(), 4, color);
  }

  void bar(const UpdateCost& one, double most) {
    const std::string value = one.points ? lesson::count_text(static_cast<std::int64_t>(*one.points)) : "—";
    text_right(list_, look_, one.chosen ? Face::kMonoBold : Face::kMono, kUpdateFigure, {x_ + width_, y_},
               one.chosen ? look_->current_text : look_->ink, value);
    const Face face = one.chosen || one.compared ? Face::kSemiBold : Face::kRegular;
    const float room = width_ - measure(look_, Face::kMonoBold, kUpdateFigure, value).x - 10;
    for (const std::string_view line : lines_of(look_, face, kUpdateName, one.title, room)) {
      text(list_, look_, face, kUpdateName, {x_, y_}, look_->ink, line);
      y_ += look_.px(kUpdateLeading);
    }
    const float top = y_ + look_.px(2), thick = 6, least = 2;
    list_->AddRectFilled({x_, top}, {x_ + width_, top + thick}, look_->track, thick / 2);
    if (one.points.value_or(0) > 0)
      list_->AddRectFilled({x_, top},
                           {x_ + std::max(least, width_ * static_cast<float>(*one.points / most)), top + thick},
                           one.chosen ? look_->current : look_->previous, thick / 2);
    y_ += look_.px(16);
  }

  const Look& look_;
  const lesson::Session& session_;
  ImDrawList* list_;
  float x_, width_, top_, y_;
};

}  // namespace

float draw_update_costs(const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  UpdateCharts charts(look, session, at, width);
  charts.frame_by_frame("Looseness", "slack", kLeastLooseness);
  charts.frame_by_frame("Points examined", "cost", 1);
  charts.all_updates();
  return charts.height();
}

}  // namespace snug::app
