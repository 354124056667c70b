#include "app/chart_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "app/chart_pen.hpp"
#include "app/svg_text.hpp"

namespace snug::app {
namespace {

/// From the top of a line's box to the baseline, of the em.
constexpr float kBaseline = 0.83f;

/// A colour, and the one that takes its place on a dark ground.
struct Ink {
  Color light = kNoColor, dark = kNoColor;
  friend bool operator<(const Ink& a, const Ink& b) { return std::pair(a.light, a.dark) < std::pair(b.light, b.dark); }
};

/// An element: "<path", its colours, the rest: " d=..."; what it contains, and whether it is closed by a tag.
struct Element {
  std::string tag;
  Ink fill, line;
  std::string rest, inside;
};

/// Writes the elements of a chart. Drawn a second time, it takes the colours of the other palette.
class SvgPen final : public ChartPen {
 public:
  void line(ImVec2 a, ImVec2 b, Color color, float width) override {
    add("line", kNoColor, color,
        " x1=\"" + px_text(a.x) + "\" y1=\"" + px_text(a.y) + "\" x2=\"" + px_text(b.x) + "\" y2=\"" + px_text(b.y) +
            "\" stroke-width=\"" + px_text(width) + '"');
  }
  void path(std::span<const ImVec2> points, Stroke stroke, Color color, float width) override {
    add("path", kNoColor, color,
        " d=\"" + way(points) + "\" stroke-width=\"" + px_text(width) + '"' + dashes(stroke, width));
  }
  void polygon(std::span<const ImVec2> corners, Color fill, Color color, float width) override {
    add("path", fill, color, " d=\"" + way(corners) + "Z\" stroke-width=\"" + px_text(width) + '"');
  }
  void disc(ImVec2 center, float radius, Color fill, Color color, float width) override {
    add("circle", fill, color,
        " cx=\"" + px_text(center.x) + "\" cy=\"" + px_text(center.y) + "\" r=\"" + px_text(radius) +
            "\" stroke-width=\"" + px_text(width) + '"');
  }
  void box(const Rect& rect, Color fill, Color color) override {
    add("rect", fill, color, place_of(rect) + (color == kNoColor ? "" : " rx=\"8\" stroke-width=\"1\""));
  }
  void words(const Look& look, Face face, float size, ImVec2 at, Color color, std::string_view words) override {
    put_words(look, face, size, at, color, kNoColor, words);
  }
  void halo_words(const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
                  std::string_view words) override {
    put_words(look, face, size, at, color, halo, words);
  }
  void clip(const Rect* within) override {
    if (within == nullptr) return clip_.clear();
    const std::string id = "within" + std::to_string(++clips_);
    add("clipPath", kNoColor, kNoColor, " id=\"" + id + '"', "<rect" + place_of(*within) + "/>");
    clip_ = " clip-path=\"url(#" + id + ")\"";
  }
  [[nodiscard]] std::optional<ImVec2> pointer() const override { return std::nullopt; }

  /// What is drawn from now on is the same again, on the dark ground.
  void begin_dark() { dark_ = true, at_ = 0, clips_ = 0; }
  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }

 private:
  void add(std::string tag, Color fill, Color line, std::string rest, std::string inside = {}) {
    if (!dark_) {
      elements_.push_back({std::move(tag), {fill, fill}, {line, line}, std::move(rest) + clip_, std::move(inside)});
    } else if (at_ < elements_.size()) {
      elements_[at_].fill.dark = fill, elements_[at_].line.dark = line;
    }
    ++at_;
  }
  void put_words(const Look& look, Face face, float size, ImVec2 at, Color color, Color halo, std::string_view words) {
    if (words.empty()) return;
    const bool mono = face == Face::kMono || face == Face::kMonoBold, bold = face == Face::kSemiBold;
    std::string rest = " x=\"" + px_text(at.x) + "\" y=\"" + px_text(at.y + kBaseline * look.px(size)) +
                       "\" font-size=\"" + px_text(look.px(size)) + "\" textLength=\"" +
                       px_text(measure(look, face, size, words).x) + "\" lengthAdjust=\"spacingAndGlyphs\"";
    if (mono) rest += " class=\"mono\"";
    if (bold || face == Face::kMonoBold) rest += " font-weight=\"600\"";
    if (halo != kNoColor) rest += " stroke-width=\"4\" stroke-linejoin=\"round\" paint-order=\"stroke\"";
    add("text", color, halo, std::move(rest), escaped(words));
  }
  static std::string place_of(const Rect& rect) {
    return " x=\"" + px_text(rect.x) + "\" y=\"" + px_text(rect.y) + "\" width=\"" + px_text(rect.width) +
           "\" height=\"" + px_text(rect.height) + '"';
  }
  static std::string way(std::span<const ImVec2> points) {
    std::string text;
    for (const ImVec2& point : points) text += (text.empty() ? 'M' : 'L') + px_text(point.x) + ' ' + px_text(point.y);
    return text;
  }
  /// The patterns of app/marks.cpp.
  static std::string dashes(Stroke stroke, float width) {
    const float scale = std::max(1.0f, width / 2);
    const auto pattern = [&](float on, float off) {
      return " stroke-dasharray=\"" + px_text(on * scale) + ' ' + px_text(off * scale) + '"';
    };
    switch (stroke) {
      case Stroke::kDotted: return pattern(0.01f, 6.5f) + " stroke-linecap=\"round\"";
      case Stroke::kDashed: return pattern(8, 5);
      case Stroke::kLongDashed: return pattern(22, 7);
      case Stroke::kSolid: break;
    }
    return {};
  }

  std::vector<Element> elements_;
  std::string clip_;  // the attribute of what is clipped
  int clips_ = 0;
  std::size_t at_ = 0;
  bool dark_ = false;
};

/// The classes of the colours that differ on a dark ground.
class Inks {
 public:
  /// The attributes of an element's colours.
  std::string attributes(const Element& element) {
    std::string classes, text;
    text += attribute("fill", element.fill, classes);
    text += attribute("stroke", element.line, classes);
    if (element.tag == "text" && element.rest.find("class=\"mono\"") != std::string::npos) classes += " mono";
    return text + (classes.empty() ? "" : " class=\"" + classes.substr(1) + '"');
  }
  [[nodiscard]] std::string rules() const {
    std::string text;
    for (const auto& [ink, index] : index_) {
      const std::string dark = hex(ink.dark);
      text += ".f" + std::to_string(index) + "{fill:" + dark + "}.s" + std::to_string(index) + "{stroke:" + dark + '}';
    }
    return text;
  }

 private:
  std::string attribute(const char* name, const Ink& ink, std::string& classes) {
    const bool fill = *name == 'f';
    if (ink.light == kNoColor) return fill ? " fill=\"none\"" : "";
    if (ink.light != ink.dark) {
      const auto index = index_.emplace(ink, static_cast<int>(index_.size())).first->second;
      classes += (fill ? " f" : " s") + std::to_string(index);
    }
    return " " + std::string(name) + "=\"" + hex(ink.light) + '"' +
           opacity_text(fill ? "fill-opacity" : "stroke-opacity", ink.light);
  }

  std::map<Ink, int> index_;
};

constexpr std::string_view kMonoClass = " class=\"mono\"";

std::string element_text(const Element& element, Inks& inks) {
  std::string rest = element.rest;
  if (const auto at = rest.find(kMonoClass); at != std::string::npos) rest.erase(at, kMonoClass.size());
  const std::string colors = element.tag == "clipPath" ? "" : inks.attributes(element);
  const std::string begin = '<' + element.tag + colors + rest;
  return element.inside.empty() ? begin + "/>\n" : begin + '>' + element.inside + "</" + element.tag + ">\n";
}

void draw_whole(SvgPen& pen, const Look& look, float width, float height, const Chart& chart, bool ground) {
  const Rect whole{0, 0, width, height};
  if (ground) pen.box(whole, look->ground, kNoColor);
  draw_chart(pen, look, whole, chart);
}

}  // namespace

std::string chart_svg(const Look& look, float width, float height, const Chart& chart, std::string_view address,
                      bool ground) {
  SvgPen pen;
  const bool either = look.palette == &kLight || look.palette == &kDark;
  Look own = look;
  own.drawn = nullptr;
  if (either) own.palette = &kLight;
  const float scale = picture_scale(width, height);
  draw_whole(pen, own, width / scale, height / scale, chart, ground);
  if (either) {
    own.palette = &kDark;
    pen.begin_dark();
    draw_whole(pen, own, width / scale, height / scale, chart, ground);
  }
  Inks inks;
  std::string body;
  for (const Element& element : pen.elements()) body += element_text(element, inks);
  const std::string size = px_text(width / scale) + ' ' + px_text(height / scale);
  std::string style = "text{font-family:Inter,\"Helvetica Neue\",Arial,sans-serif}"
                      ".mono{font-family:\"JetBrains Mono\",Menlo,Consolas,monospace}";
  if (either) style += "@media (prefers-color-scheme:dark){" + inks.rules() + '}';
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + px_text(width) + "\" height=\"" + px_text(height) +
         "\" viewBox=\"0 0 " + size + "\" role=\"img\" aria-labelledby=\"title note\">\n<title id=\"title\">" +
         escaped(chart.title) + "</title>\n<desc id=\"note\">" +
         escaped(chart.y.title + ", by " + chart.x.title + ". " + chart.note) + "</desc>\n" +
         (address.empty() ? "" : "<metadata>" + escaped(address) + "</metadata>\n") + "<style>" + style + "</style>\n" +
         body + "</svg>\n";
}

}  // namespace snug::app
