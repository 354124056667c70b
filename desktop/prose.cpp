#include "desktop/prose.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace snug::desktop {
namespace {

using app::Face;
using lesson::Link;

constexpr float kSize = 15, kLeading = 24;

struct Word {
  std::string_view text;
  const lesson::Stretch* stretch;
  bool space_before;
};

std::vector<Word> words_of(const lesson::Paragraph& paragraph) {
  std::vector<Word> words;
  bool space = false;
  for (const lesson::Stretch& stretch : paragraph) {
    std::size_t begin = 0;
    const std::string_view text = stretch.text;
    while (begin < text.size()) {
      if (text[begin] == ' ' || text[begin] == '\n') {
        space = true;
        ++begin;
        continue;
      }
      const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
      words.push_back({text.substr(begin, end - begin), &stretch, space});
      space = false;
      begin = end;
    }
  }
  return words;
}

Face face_of(const Word& word) { return word.stretch->strong ? Face::kSemiBold : Face::kRegular; }

void underline(ImDrawList* list, float x, float y, float width, app::Color color, bool dotted) {
  if (!dotted) return app::rule(list, x, y, width, color);
  for (float at = 0; at < width; at += 4) list->AddRectFilled({x + at, y}, {x + at + 2, y + 1.5f}, color);
}

/// A word where it stands.
struct Placed {
  Word word;
  ImVec2 at;
  float width;
};

/// From left to right, line by line. Words without a space between them, as a term and the comma behind it, stay on one
/// line.
std::vector<Placed> place(Column& column, const std::vector<Word>& words) {
  const app::Look& look = column.look();
  const float space = app::measure(look, Face::kRegular, kSize, " ").x;
  const float inset = (look.px(kLeading) - look.px(kSize)) / 2;
  const auto width_of = [&](const Word& word) { return app::measure(look, face_of(word), kSize, word.text).x; };
  std::vector<Placed> placed;
  float x = 0;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t end = i + 1;
    while (end < words.size() && !words[end].space_before) ++end;
    float run = 0;
    for (std::size_t k = i; k < end; ++k) run += width_of(words[k]);
    if (x > 0 && x + space + run > column.width()) x = 0, column.gap(look.px(kLeading));
    else if (x > 0) x += space;
    for (; i < end; ++i) {
      placed.push_back({words[i], {column.x() + x, column.y() + inset}, width_of(words[i])});
      x += placed.back().width;
    }
  }
  if (!words.empty()) column.gap(look.px(kLeading));
  return placed;
}

/// What the words of a link cover, line by line.
std::vector<app::Rect> lines_of(std::span<const Placed> words, float size) {
  std::vector<app::Rect> lines;
  for (const Placed& word : words) {
    if (lines.empty() || word.at.y > lines.back().y + 4) lines.push_back({word.at.x - 2, word.at.y - 3, 0, size + 7});
    lines.back().width = word.at.x + word.width + 2 - lines.back().x;
  }
  return lines;
}

/// A link answers the pointer on each of its lines, and is one place of the keyboard.
void draw_link(const Column& column, std::span<const Placed> words, std::size_t number, bool lit, ProseTouch& touch) {
  const app::Look& look = column.look();
  const Link& link = *words.front().word.stretch->link;
  const float size = look.px(kSize);
  const auto lines = lines_of(words, size);
  bool hovered = false;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string id = "link " + std::to_string(number) + " " + std::to_string(i);
    const app::Touch touched = app::pointer_area(id.c_str(), lines[i]);
    hovered = hovered || touched.hovered || touched.held;
    if (touched.clicked) touch.clicked = &link;
    touch.links.push_back({&link, lines[i]});
  }
  if (hovered) touch.hovered = &link, ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (app::Focus* const focus = app::Focus::current()) {
    const app::Rect& line = lines.front();
    const auto here = focus->offer({.id = ImGui::GetID(("link " + std::to_string(number)).c_str()),
                                    .low = {line.x, line.y},
                                    .high = {line.x + line.width, line.y + line.height},
                                    .name = words.front().word.stretch->text});
    for (std::size_t i = 1; here.focused && i < lines.size(); ++i)
      focus->draw_ring({lines[i].x, lines[i].y}, {lines[i].x + lines[i].width, lines[i].y + lines[i].height});
    if (here.focused) touch.focused = &link, hovered = true;
    if (here.pressed) touch.clicked = &link;
  }
  const bool mark = link.kind == Link::Kind::kMark;
  for (const app::Rect& line : lines) {
    if (mark && (lit || hovered))
      column.list()->AddRectFilled({line.x, line.y}, {line.x + line.width, line.y + line.height}, look->lit, 3);
    underline(column.list(), line.x + 2, line.y + size + 5, line.width - 4, look->current, mark);
  }
}

/// Writes a formula that is a paragraph by itself, centred in the column. Returns false if it is too long for a line.
bool draw_displayed(Column& column, const lesson::Paragraph& paragraph) {
  if (paragraph.size() != 1 || paragraph.front().tex.empty()) return false;
  const app::Look& look = column.look();
  const float width = app::measure(look, Face::kRegular, kSize, paragraph.front().text).x;
  if (width > column.width()) return false;
  app::text(column.list(), look, Face::kRegular, kSize,
            {column.x() + (column.width() - width) / 2, column.y() + (look.px(kLeading) - look.px(kSize)) / 2},
            look->ink, paragraph.front().text);
  column.gap(look.px(kLeading));
  return true;
}

}  // namespace

ProseTouch draw_prose(Column& column, const lesson::Paragraph& paragraph, std::span<const std::string_view> lit) {
  if (draw_displayed(column, paragraph)) return {};
  const std::vector<Placed> placed = place(column, words_of(paragraph));
  ProseTouch touch;
  for (std::size_t i = 0; i < placed.size();) {
    std::size_t end = i + 1;
    while (end < placed.size() && placed[end].word.stretch == placed[i].word.stretch) ++end;
    if (const std::optional<Link>& link = placed[i].word.stretch->link) {
      const bool is_lit = std::find(lit.begin(), lit.end(), link->target) != lit.end();
      draw_link(column, std::span(placed).subspan(i, end - i), i, is_lit, touch);
    }
    i = end;
  }
  for (const auto& [word, at, width] : placed) {
    const std::optional<Link>& link = word.stretch->link;
    const app::Look& look = column.look();
    app::text(column.list(), look, face_of(word), kSize, at,
              link && link->kind != Link::Kind::kMark ? look->current_text : look->ink, word.text);
  }
  return touch;
}

}  // namespace snug::desktop
