#include "app/panel_charts.hpp"

#include <algorithm>

#include "app/marks.hpp"
#include "app/widgets.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

constexpr float kScaleWords = 12, kCurvesHeight = 84, kBarTitle = 14, kBarLeading = 18, kBarFigure = 13;

}  // namespace

std::vector<PanelBar> bars_of_methods(const lesson::Session& session, std::string_view key) {
  std::vector<PanelBar> bars;
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method& method = *lesson::find_method(session.lesson(), name);
    PanelBar one{lesson::title_in(session.lesson(), method),
                 {},
                 &method == session.player().method(0),
                 &method == session.player().method(1)};
    if (lesson::may_tell_result(session.conversation(), method, key))
      for (const lesson::Figure& figure : session.player().result(method))
        if (figure.key == key && figure.known) one.value = figure.value;
    bars.push_back(std::move(one));
  }
  return bars;
}

PanelCharts::PanelCharts(const Look& look, ImVec2 at, float width)
    : look_(look), list_(ImGui::GetWindowDrawList()), x_(at.x), width_(width), top_(at.y), y_(at.y) {}

void PanelCharts::heading(std::string_view words) {
  text(list_, look_, Face::kSemiBold, 13, {x_, y_ + look_.px(5)}, look_->muted, words);
  y_ += look_.px(28);
}

void PanelCharts::curves(std::string_view title, std::span<const PanelCurve> curves, double most,
                         const std::string& most_text, const std::array<std::string, 2>& ends) {
  heading(title);
  const float bottom = y_ + look_.px(kCurvesHeight);
  const float room = measure(look_, Face::kMono, kScaleWords, most_text).x + 10;
  const float left = x_ + room, wide = width_ - room;
  text_right(list_, look_, Face::kMono, kScaleWords, {left - 8, y_ - look_.px(2)}, look_->muted, most_text);
  text_right(list_, look_, Face::kMono, kScaleWords, {left - 8, bottom - look_.px(12)}, look_->muted, "0");
  rule(list_, left, y_, wide, look_->line);
  rule(list_, left, bottom, wide, look_->muted);
  for (const PanelCurve& one : curves) curve(one, {left, y_}, {wide, bottom - y_}, most);
  text(list_, look_, Face::kRegular, kScaleWords, {left, bottom + look_.px(5)}, look_->muted, ends[0]);
  text_right(list_, look_, Face::kRegular, kScaleWords, {x_ + width_, bottom + look_.px(5)}, look_->muted, ends[1]);
  y_ = bottom + look_.px(44);
}

void PanelCharts::bars(std::string_view title, std::span<const PanelBar> bars) {
  heading(title);
  double most = 1;
  for (const PanelBar& one : bars) most = std::max(most, one.value.value_or(0));
  for (const PanelBar& one : bars) bar(one, most);
  y_ += look_.px(16);
}

void PanelCharts::curve(const PanelCurve& one, ImVec2 at, ImVec2 size, double most) {
  std::vector<ImVec2> places;
  for (const ImVec2 place : one.places)
    places.push_back({at.x + size.x * place.x, at.y + size.y * (1 - place.y / static_cast<float>(most))});
  const Color color = one.chosen ? look_->current : look_->previous;
  path(list_, places, false, one.chosen ? Stroke::kSolid : Stroke::kDashed, color, 2);
  if (one.dot && *one.dot < places.size()) disc(list_, places[*one.dot], 4, color);
}

void PanelCharts::bar(const PanelBar& one, double most) {
  const std::string value = one.value ? lesson::count_text(static_cast<std::int64_t>(*one.value)) : "—";
  text_right(list_, look_, one.chosen ? Face::kMonoBold : Face::kMono, kBarFigure, {x_ + width_, y_},
             one.chosen ? look_->current_text : look_->ink, value);
  const Face face = one.chosen || one.compared ? Face::kSemiBold : Face::kRegular;
  const float room = width_ - measure(look_, Face::kMonoBold, kBarFigure, value).x - 10;
  for (const std::string_view line : lines_of(look_, face, kBarTitle, one.title, room)) {
    text(list_, look_, face, kBarTitle, {x_, y_}, look_->ink, line);
    y_ += look_.px(kBarLeading);
  }
  const float top = y_ + look_.px(2), thick = 6, least = 2;
  list_->AddRectFilled({x_, top}, {x_ + width_, top + thick}, look_->track, thick / 2);
  if (one.value.value_or(0) > 0)
    list_->AddRectFilled({x_, top}, {x_ + std::max(least, width_ * static_cast<float>(*one.value / most)), top + thick},
                         one.chosen ? look_->current : look_->previous, thick / 2);
  y_ += look_.px(16);
}

}  // namespace snug::app
