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

/// Writes one word; what leads somewhere answers the pointer. after: how far that goes on behind the word.
void draw_word(const Column& column, const Word& word, ImVec2 at, float width, float after, bool lit,
               std::size_t number, ProseTouch& touch) {
  const app::Look& look = column.look();
  const float size = look.px(kSize);
  app::Color color = look->ink;
  if (const std::optional<Link>& link = word.stretch->link) {
    const app::Rect rect{at.x - 2, at.y - 3, width + after + 4, size + 7};
    touch.links.push_back({&*link, rect});
    const std::string id = "word " + std::to_string(number) + std::string(word.text);
    const app::Touch touched = app::touch_area(id.c_str(), rect);
    if (touched.hovered || touched.held) touch.hovered = &*link, ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (touched.clicked) touch.clicked = &*link;
    const bool mark = link->kind == Link::Kind::kMark;
    if (mark && (lit || touched.hovered))
      column.list()->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, look->lit, 3);
    if (!mark) color = look->current_text;
    underline(column.list(), at.x, at.y + size + 2, width + after, look->current, mark);
  }
  app::text(column.list(), look, face_of(word), kSize, at, color, word.text);
}

/// A formula that is a paragraph of its own, in the middle of the column; false where it is too long for a line.
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
  const app::Look& look = column.look();
  const float space = app::measure(look, Face::kRegular, kSize, " ").x;
  const float inset = (look.px(kLeading) - look.px(kSize)) / 2;
  const auto width_of = [&](const Word& word) { return app::measure(look, face_of(word), kSize, word.text).x; };
  // Words without a space between them, as a term and the comma behind it, stay on one line.
  const std::vector<Word> words = words_of(paragraph);
  ProseTouch touch;
  float x = 0;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t end = i + 1;
    while (end < words.size() && !words[end].space_before) ++end;
    float run = 0;
    for (std::size_t k = i; k < end; ++k) run += width_of(words[k]);
    if (x > 0 && x + space + run > column.width()) x = 0, column.gap(look.px(kLeading));
    else if (x > 0) x += space;
    for (; i < end; ++i) {
      const std::optional<Link>& link = words[i].stretch->link;
      const bool is_lit = link && std::find(lit.begin(), lit.end(), link->target) != lit.end();
      const bool goes_on = i + 1 < words.size() && words[i + 1].stretch == words[i].stretch &&
                           x + width_of(words[i]) + space + width_of(words[i + 1]) <= column.width();
      draw_word(column, words[i], {column.x() + x, column.y() + inset}, width_of(words[i]), goes_on ? space : 0, is_lit,
                i, touch);
      x += width_of(words[i]);
    }
  }
  if (!words.empty()) column.gap(look.px(kLeading));
  return touch;
}

}  // namespace snug::desktop
