// Draws what is over the stage: the sentence, two buttons, the axis cross. Labels keep clear of
// it.
#include <algorithm>

#include "app/stage.hpp"
#include "app/widgets.hpp"
#include "geometry/sort.hpp"

namespace snug::app {
namespace {

void keep_free(Obstacles& obstacles, const Rect& rect) {
  obstacles.taken.push_back({rect.x - 4, rect.y - 4, rect.width + 8, rect.height + 8});
}

constexpr float kSentenceSize = 15, kSentenceLeading = 22, kBelowPill = 12;

/// Where a page's sentence stands over the stage, if it has two lines.
Rect sentence_of_page(const Look& look, const Rect& stage) {
  constexpr float kMargin = 24;
  const float height = look.px(72);
  return {stage.x + kMargin, stage.y + stage.height - height, stage.width - 2 * kMargin, height};
}

/// As few lines as fit, about equally long: the last word does not stand alone.
std::vector<std::string_view> balanced_lines(const Look& look, std::string_view sentence, float widest) {
  constexpr int kHalvings = 6;
  const auto within = [&](float width) { return lines_of(look, Face::kRegular, kSentenceSize, sentence, width); };
  const std::size_t fewest = within(widest).size();
  float narrow = widest / static_cast<float>(std::max<std::size_t>(fewest, 1)), wide = widest;
  for (int i = 0; i < kHalvings && fewest > 1; ++i) {
    const float middle = (narrow + wide) / 2;
    (within(middle).size() > fewest ? narrow : wide) = middle;
  }
  return within(wide);
}

/// A sentence in lines, and the pill that it stands on.
struct Pill {
  std::vector<std::string_view> lines;
  Rect rect;

  Pill(const Look& look, const Rect& stage, std::string_view sentence) {
    constexpr float kMargin = 24, kPad = 20;
    const float widest = std::min(stage.width - 2 * kMargin, look.px(620));
    lines = balanced_lines(look, sentence, widest - 2 * kPad);
    float words = 0;
    for (const std::string_view line : lines)
      words = std::max(words, measure(look, Face::kRegular, kSentenceSize, line).x);
    const float width = words + 2 * kPad + 4,
                height = look.px(kSentenceLeading) * static_cast<float>(lines.size()) + 18;
    rect = {stage.x + (stage.width - width) / 2, stage.y + stage.height - height - kBelowPill, width, height};
  }
};

}  // namespace

float room_for_sentence(const Look& look, const Rect& stage, std::string_view sentence, bool in_canvas) {
  constexpr float kWide = 560, kBare = 4;
  const float room = stage.width >= kWide ? look.px(76) : kBare;
  return in_canvas ? std::max(room, Pill(look, stage, sentence).rect.height + 2 * kBelowPill) : room;
}

Rect draw_sentence(ImDrawList* list, const Look& look, Obstacles& obstacles, const Rect& stage,
                   std::string_view sentence) {
  if (sentence.empty()) return {};
  const Palette& p = *look.palette;
  const Pill pill(look, stage, sentence);
  const Rect& rect = pill.rect;
  const float corner = std::min(rect.height / 2, 20.0f);
  list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, p.panel, corner);
  list->AddRect({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, p.line, corner, 0, 1);
  float y = rect.y + 9 + (look.px(kSentenceLeading) - look.px(kSentenceSize)) / 2;
  for (const std::string_view line : pill.lines) {
    text_middle(list, look, Face::kRegular, kSentenceSize, {rect.x + rect.width / 2, y}, p.ink, line);
    y += look.px(kSentenceLeading);
  }
  keep_free(obstacles, rect);
  return rect;
}

void Stage::draw_tools(Brush& brush, Settings& settings, float y, float height) {
  const Look& look = brush.look;
  float right = brush.rect.x + brush.rect.width - 12;
  const Rect fit{right - height, y, height, height};
  if (button(brush.list, look,
             {.id = "Show everything", .rect = fit, .icon = Icon::kFit, .kind = ButtonKind::kOutlined}))
    reset_view(brush.session);
  right -= height + 8;

  // A cover's button takes its place.
  if (!view_->optimum_button().empty() && !brush.session.telling().predicting() && look.tools_right == 0)
    draw_toggle(brush, settings, right, y, height);
  if (LocalFrame* const frame = view_->local_frame(brush.session)) {
    const std::string id(frame->button());
    const float width = measure(look, Face::kSemiBold, 13, id).x + look.px(28);
    const Rect rect{right - width, y, width, height};
    if (button(brush.list, look,
               {.id = id.c_str(),
                .rect = rect,
                .words = id,
                .kind = frame->is_shown() ? ButtonKind::kChosen : ButtonKind::kOutlined,
                .size = 13})) {
      frame->show(!frame->is_shown());
      reset_view(brush.session);
    }
    keep_free(brush.canvas.obstacles, rect);
  }
  keep_free(brush.canvas.obstacles, fit);
  if (look.tools_right > 0) keep_free(brush.canvas.obstacles, {right - look.tools_right, y, look.tools_right, height});
}

void Stage::draw_notes(Brush& brush, Settings& settings) {
  const Look& look = brush.look;
  const float height = look.fingers ? 44.0f : look.px(32);
  const float y = brush.rect.y + 12;
  if (settings.tools) draw_tools(brush, settings, y, height);

  // The page's undo and redo buttons are in the other corner.
  const float tools = look.tools;
  const bool column = is_low(brush.rect);  // the page's two stand one above the other
  if (tools > 0) keep_free(brush.canvas.obstacles, {brush.rect.x, brush.rect.y, tools, (column ? 2 : 1) * height + 16});

  const ImVec2 corner =
      column ? ImVec2{brush.rect.x + tools + 12, y} : ImVec2{brush.rect.x + 12, y + (tools > 0 ? height + 10 : 0)};
  const Rect inset = inset_ = view_->draw_inset(brush, corner);
  if (inset.width > 0) keep_free(brush.canvas.obstacles, inset);
  draw_close_up(brush, settings.tools || tools > 0 ? y + height + 10 : y);
  if (close_up_) keep_free(brush.canvas.obstacles, close_up_->panel);
  Rect sentence;
  if (look.foot > 0)
    keep_free(brush.canvas.obstacles,
              {brush.rect.x, brush.rect.y + brush.rect.height - look.foot, brush.rect.width, look.foot});
  else if (settings.prose_in_canvas)
    sentence = draw_sentence(brush.list, look, brush.canvas.obstacles, brush.rect, brush.session.telling().caption());
  else if (is_wide(brush.rect)) keep_free(brush.canvas.obstacles, sentence_of_page(look, brush.rect));
  if (camera_.dim() == 3) draw_axis_cross(brush, inset, sentence);
}

/// Draws the button that shows the smallest volume before the end.
void Stage::draw_toggle(Brush& brush, Settings& settings, float right, float y, float height) {
  const Palette& p = brush.p;
  const Look& look = brush.look;
  const std::string words(view_->optimum_button());
  const float width = measure(look, Face::kSemiBold, 13, words).x + look.px(52);
  const Rect toggle{right - width, y, width, height};
  const bool on = settings.show_optimum;
  if (button(brush.list, look,
             {.id = words.c_str(), .rect = toggle, .kind = on ? ButtonKind::kChosen : ButtonKind::kOutlined}))
    settings.show_optimum = !on;
  const float middle = y + height / 2;
  line(brush.list, {toggle.x + look.px(12), middle}, {toggle.x + look.px(36), middle}, Stroke::kDashed, p.optimum, 2);
  text(brush.list, look, Face::kSemiBold, 13, {toggle.x + look.px(42), middle_of(middle, look.px(13))}, p.ink, words);
  keep_free(brush.canvas.obstacles, toggle);
}

/// Draws the axis cross; the axis in use is thicker.
void Stage::draw_axis_cross(Brush& brush, const Rect& inset, const Rect& sentence) const {
  constexpr float kLength = 22, kReach = 36;
  // Above the room for the sentence, in the corner that is free, or else beside the second picture.
  const float low = camera_.free_bottom();
  ImVec2 origin{inset.x + inset.width + kReach, low - kReach - 8};  // nearer to the sentence's middle
  const auto around = [](ImVec2 at) { return Rect{at.x - kReach, at.y - kReach, 2 * kReach, 2 * kReach}; };
  for (const float x : {brush.rect.x + brush.rect.width - 44, brush.rect.x + 44})
    if (const ImVec2 corner{x, low - 30};
        !overlap(inset, around(corner)) && !(close_up_ && overlap(close_up_->panel, around(corner))))
      origin = corner;
  if (overlap(sentence, {origin.x - kReach, origin.y - kReach, 2 * kReach, 2 * kReach}))
    origin.y = sentence.y - kReach;  // a narrow stage breaks it into more lines than there is room for
  std::array<int, 3> order{0, 1, 2};
  sort_stably(order, [&](int a, int b) { return camera_.forward()[a] > camera_.forward()[b]; });
  const int in_use = view_->axis_in_use(brush.session);
  for (const int axis : order) {
    const bool used = axis == in_use;
    const Color color = used ? brush.p.current_text : brush.p.muted;
    const float dx = static_cast<float>(camera_.right()[axis]) * kLength,
                dy = -static_cast<float>(camera_.up()[axis]) * kLength;
    brush.list->AddLine(origin, {origin.x + dx, origin.y + dy}, color, used ? 4.0f : 1.5f);
    const ImVec2 end{origin.x + dx * 1.5f, origin.y + dy * 1.5f};
    const float size = brush.look.px(12);
    const bool towards = dx * dx + dy * dy < 0.06f * kLength * kLength;  // its label would cover the origin
    if (!towards)
      text_middle(brush.list, brush.look, Face::kSemiBold, 12, {end.x, end.y - size / 2}, color,
                  std::string_view("xyz").substr(axis, 1));
  }
  keep_free(brush.canvas.obstacles, {origin.x - kReach, origin.y - kReach, 2 * kReach, 2 * kReach});
}

}  // namespace snug::app
