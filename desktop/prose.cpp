#include "desktop/prose.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/marks.hpp"

namespace snug::desktop {
namespace {

using app::Face;
using lesson::Link;
using lesson::Paragraph;
using lesson::Stretch;

constexpr float kMonoSize = 0.875f, kRaised = 0.36f;
constexpr float kSlant = 0.2f;  // how far emphasised words lean: the typeface has no italics
constexpr float kIndent = 20, kBetweenItems = 4, kBetweenColumns = 16, kAroundCells = 6;
constexpr Writing kCellWriting{14, 20}, kHeadWriting{13, 20, Face::kSemiBold};

struct Word {
  std::string_view text;
  const Stretch* stretch;
  bool space_before;
};

/// A word where it stands; at: the top left of its line's box, as if it were as large as the others.
struct Placed {
  Word word;
  ImVec2 at;
  float width;
};

/// The words of a paragraph in lines, the first of which begins at 0, 0.
struct Lines {
  std::vector<Placed> words;
  float width = 0, height = 0;
};

bool is_untold(const Word& word) { return word.stretch->figure && word.text == lesson::kHiddenFigure; }
bool is_mono(const Word& word) { return word.stretch->code || (word.stretch->figure && !is_untold(word)); }

Face face_of(const Word& word, const Writing& writing) {
  const bool bold = word.stretch->strong || writing.face == Face::kSemiBold;
  if (is_mono(word)) return bold ? Face::kMonoBold : Face::kMono;
  return bold ? Face::kSemiBold : writing.face;
}

float size_of(const Word& word, const Writing& writing) {
  const float size = is_mono(word) ? writing.size * kMonoSize : writing.size;
  return word.stretch->script == Stretch::Script::kNone ? size : size * app::kScriptSize;
}

/// How far below the top of the line's box a word begins, so that all stand on one baseline.
float drop_of(const Word& word, const Writing& writing) {
  const float down = app::kBaseline * (writing.size - size_of(word, writing));
  if (word.stretch->script == Stretch::Script::kHigh) return down - kRaised * writing.size;
  return word.stretch->script == Stretch::Script::kLow ? down + app::kLowered * writing.size : down;
}

std::vector<Word> words_of(const Paragraph& paragraph, lesson::ProseFigures& figures) {
  std::vector<Word> words;
  bool space = false;
  for (const Stretch& stretch : paragraph) {
    if (!figures.tells(paragraph, stretch)) continue;
    const std::string_view text = stretch.figure ? figures.of(*stretch.figure).text : stretch.text;
    for (std::size_t begin = 0; begin < text.size();) {
      if (text[begin] == ' ') {
        space = true;
        ++begin;
        continue;
      }
      const std::size_t end = std::min(text.find(' ', begin), text.size());
      words.push_back({text.substr(begin, end - begin), &stretch, space});
      space = false;
      begin = end;
    }
  }
  return words;
}

/// From left to right, line by line. Words without a space between them, as a term and the comma behind it, stay on one
/// line.
Lines lay_out(const app::Look& look, const std::vector<Word>& words, const Writing& writing, float width) {
  const float space = app::measure(look, writing.face, writing.size, " ").x, step = look.px(writing.leading);
  const float inset = (step - look.px(writing.size)) / 2;
  const auto width_of = [&](const Word& word) {
    return app::measure(look, face_of(word, writing), size_of(word, writing), word.text).x;
  };
  Lines lines;
  float x = 0, y = 0;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t end = i + 1;
    while (end < words.size() && !words[end].space_before) ++end;
    float run = 0;
    for (std::size_t k = i; k < end; ++k) run += width_of(words[k]);
    if (x > 0 && x + space + run > width) x = 0, y += step;
    else if (x > 0) x += space;
    for (; i < end; ++i) {
      lines.words.push_back({words[i], {x, y + inset}, width_of(words[i])});
      x += lines.words.back().width;
    }
    lines.width = std::max(lines.width, x);
  }
  lines.height = words.empty() ? 0 : y + step;
  return lines;
}

/// The width of the longest piece that is not broken.
float narrowest(const app::Look& look, const std::vector<Word>& words, const Writing& writing) {
  return lay_out(look, words, writing, 0).width;
}

/// Moves each line to the right end of the width.
void align_right(Lines& lines, float width) {
  for (std::size_t i = 0; i < lines.words.size();) {
    std::size_t end = i + 1;
    while (end < lines.words.size() && lines.words[end].at.y == lines.words[i].at.y) ++end;
    const float by = width - lines.words[end - 1].at.x - lines.words[end - 1].width;
    for (; i < end; ++i) lines.words[i].at.x += by;
  }
}

/// What the words of a link or of code cover, line by line.
std::vector<app::Rect> grounds_of(std::span<const Placed> words, float size) {
  std::vector<app::Rect> grounds;
  for (const Placed& word : words) {
    if (grounds.empty() || word.at.y > grounds.back().y + 4)
      grounds.push_back({word.at.x - 2, word.at.y - 3, 0, size + 7});
    grounds.back().width = word.at.x + word.width + 2 - grounds.back().x;
  }
  return grounds;
}

void fill(ImDrawList* list, const app::Rect& rect, app::Color color) {
  list->AddRectFilled({rect.x, rect.y}, {rect.x + rect.width, rect.y + rect.height}, color, 3);
}

void underline(ImDrawList* list, float x, float y, float width, app::Color color, bool dotted) {
  if (!dotted) return app::rule(list, x, y, width, color);
  for (float at = 0; at < width; at += 4) list->AddRectFilled({x + at, y}, {x + at + 2, y + 1.5f}, color);
}

/// A link answers the pointer on each of its lines, and is one place of the keyboard.
void draw_link(const app::Look& look, ImDrawList* list, std::span<const Placed> words, std::size_t number, bool lit,
               float size, ProseTouch& touch) {
  const Link& link = *words.front().word.stretch->link;
  const auto lines = grounds_of(words, size);
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
    if (mark && (lit || hovered)) fill(list, line, look->lit);
    underline(list, line.x + 2, line.y + size + 5, line.width - 4, look->current, mark);
  }
}

/// Lets what was drawn since then lean to the right above the baseline.
void slant(ImDrawList* list, int since, float baseline) {
  for (int i = since; i < list->VtxBuffer.Size; ++i)
    list->VtxBuffer[i].pos.x += kSlant * (baseline - list->VtxBuffer[i].pos.y);
}

void draw_word(const app::Look& look, ImDrawList* list, const Placed& placed, const Writing& writing) {
  const Word& word = placed.word;
  const Stretch& stretch = *word.stretch;
  const app::Color ink = writing.color != 0 ? writing.color : look->ink;
  const bool acts = stretch.link && stretch.link->kind != Link::Kind::kMark;
  const int since = list->VtxBuffer.Size;
  app::text(list, look, face_of(word, writing), size_of(word, writing),
            {placed.at.x, placed.at.y + look.px(drop_of(word, writing))},
            acts              ? look->current_text
            : is_untold(word) ? look->muted
                              : ink,
            word.text);
  if (stretch.emphasis) slant(list, since, placed.at.y + look.px(app::kBaseline * writing.size));
}

/// Draws lines from a place on.
ProseTouch draw_lines(const Column& column, Lines lines, ImVec2 from, const Writing& writing,
                      std::span<const std::string_view> lit) {
  const app::Look& look = column.look();
  for (Placed& placed : lines.words) placed.at.x += from.x, placed.at.y += from.y;
  const std::span<const Placed> words = lines.words;
  ProseTouch touch;
  for (std::size_t i = 0; i < words.size();) {
    std::size_t end = i + 1;
    while (end < words.size() && words[end].word.stretch == words[i].word.stretch) ++end;
    const Stretch& stretch = *words[i].word.stretch;
    if (stretch.link) {
      const bool is_lit = std::find(lit.begin(), lit.end(), stretch.link->target) != lit.end();
      draw_link(look, column.list(), words.subspan(i, end - i), i, is_lit, look.px(writing.size), touch);
    }
    if (stretch.code)
      for (const app::Rect& ground : grounds_of(words.subspan(i, end - i), look.px(writing.size) - 1))
        fill(column.list(), ground, writing.ground != 0 ? writing.ground : look->raised);
    if (stretch.figure) touch.figures.emplace_back(words[i].word.text);
    i = end;
  }
  for (const Placed& placed : words) draw_word(look, column.list(), placed, writing);
  return touch;
}

/// Writes a formula that is a paragraph by itself, centred in the column. Returns false if it is too long for a line.
bool draw_displayed(Column& column, const Paragraph& paragraph) {
  if (paragraph.size() != 1 || paragraph.front().tex.empty()) return false;
  const app::Look& look = column.look();
  const Writing writing;
  const float width = app::measure(look, Face::kRegular, writing.size, paragraph.front().text).x;
  if (width > column.width()) return false;
  app::text(
      column.list(), look, Face::kRegular, writing.size,
      {column.x() + (column.width() - width) / 2, column.y() + (look.px(writing.leading) - look.px(writing.size)) / 2},
      look->ink, paragraph.front().text);
  column.gap(look.px(writing.leading));
  return true;
}

ProseTouch draw_paragraph(Column& column, const Paragraph& paragraph, lesson::ProseFigures& figures,
                          const Writing& writing, std::span<const std::string_view> lit) {
  const Lines lines = lay_out(column.look(), words_of(paragraph, figures), writing, column.width());
  ProseTouch touch = draw_lines(column, lines, {column.x(), column.y()}, writing, lit);
  column.gap(lines.height);
  return touch;
}

ProseTouch draw_list(Column& column, const lesson::Block& block, lesson::ProseFigures& figures,
                     std::span<const std::string_view> lit) {
  const app::Look& look = column.look();
  const Writing writing;
  const float indent = look.px(kIndent), inset = look.px(writing.leading - writing.size) / 2;
  ProseTouch touch;
  for (std::size_t i = 0; i < block.rows.size(); ++i) {
    if (i > 0) column.gap(look.px(kBetweenItems));
    if (block.kind == lesson::Block::Kind::kBullets)
      column.list()->AddCircleFilled({column.x() + indent / 2, column.y() + look.px(writing.leading) / 2},
                                     look.px(2.5f), look->muted);
    else
      app::text_right(column.list(), look, Face::kRegular, writing.size,
                      {column.x() + indent - look.px(4), column.y() + inset}, look->muted, std::to_string(i + 1) + ".");
    Column beside(look, column.x() + indent, column.y(), column.width() - indent);
    ImGui::PushID(static_cast<int>(i));
    touch.add(draw_paragraph(beside, block.rows[i].front(), figures, writing, lit));
    ImGui::PopID();
    column.gap(beside.y() - column.y());
  }
  return touch;
}

/// A table whose columns are as wide as what they say, or as little narrower as the column asks for.
class Table {
 public:
  Table(const Column& column, const lesson::Block& block, lesson::ProseFigures& figures)
      : look_(column.look()), block_(block) {
    const std::size_t columns = block.rows.front().size();
    const float gap = look_.px(kBetweenColumns);
    std::vector<float> least(columns), wanted(columns);
    for (std::size_t r = 0; r < block.rows.size(); ++r)
      for (std::size_t c = 0; c < columns; ++c) {
        cells_.push_back(words_of(block.rows[r][c], figures));
        least[c] = std::max(least[c], narrowest(look_, cells_.back(), writing(r)));
        wanted[c] = std::max(wanted[c], lay_out(look_, cells_.back(), writing(r), kUnbroken).width);
      }
    float all = gap * static_cast<float>(columns - 1), must = all;
    for (std::size_t c = 0; c < columns; ++c) all += wanted[c], must += least[c];
    const float share = all <= column.width() ? 1 : std::max(0.0f, (column.width() - must) / (all - must));
    for (std::size_t c = 0; c < columns; ++c) {
      widths_.push_back(std::ceil(least[c] + share * (wanted[c] - least[c])));
      width_ += widths_.back() + (c > 0 ? gap : 0);
    }
  }

  ProseTouch draw(Column& column, std::span<const std::string_view> lit) const {
    ProseTouch touch;
    for (std::size_t r = 0; r < block_.rows.size(); ++r) {
      float height = 0, x = column.x();
      for (std::size_t c = 0; c < widths_.size(); ++c, x += look_.px(kBetweenColumns)) {
        Lines lines = lay_out(look_, cells_[r * widths_.size() + c], writing(r), widths_[c]);
        if (block_.right[c]) align_right(lines, widths_[c]);
        height = std::max(height, lines.height);
        ImGui::PushID(static_cast<int>(r * widths_.size() + c));
        const Writing own{writing(r).size, writing(r).leading, writing(r).face, r == 0 ? look_->muted : look_->ink};
        touch.add(draw_lines(column, std::move(lines), {x, column.y() + look_.px(kAroundCells)}, own, lit));
        ImGui::PopID();
        x += widths_[c];
      }
      column.gap(height + 2 * look_.px(kAroundCells));
      app::rule(column.list(), column.x(), column.y() - 1, width_, look_->line);
    }
    return touch;
  }

 private:
  static constexpr float kUnbroken = std::numeric_limits<float>::max();
  static const Writing& writing(std::size_t row) { return row == 0 ? kHeadWriting : kCellWriting; }

  const app::Look& look_;
  const lesson::Block& block_;
  std::vector<std::vector<Word>> cells_;  // row by row
  std::vector<float> widths_;
  float width_ = 0;
};

}  // namespace

void ProseTouch::add(const ProseTouch& other) {
  if (other.hovered != nullptr) hovered = other.hovered;
  if (other.focused != nullptr) focused = other.focused;
  if (other.clicked != nullptr) clicked = other.clicked;
  links.insert(links.end(), other.links.begin(), other.links.end());
  figures.insert(figures.end(), other.figures.begin(), other.figures.end());
}

ProseTouch draw_block(Column& column, const lesson::Block& block, lesson::ProseFigures& figures,
                      std::span<const std::string_view> lit) {
  switch (block.kind) {
    case lesson::Block::Kind::kParagraph: break;
    case lesson::Block::Kind::kBullets:
    case lesson::Block::Kind::kNumbers: return draw_list(column, block, figures, lit);
    case lesson::Block::Kind::kTable: return Table(column, block, figures).draw(column, lit);
  }
  const Paragraph& paragraph = block.rows.front().front();
  if (draw_displayed(column, paragraph)) return {};
  return draw_paragraph(column, paragraph, figures, {}, lit);
}

void draw_prompt(Column& column, std::string_view text, lesson::ProseFigures& figures, const Writing& writing) {
  std::vector<lesson::ProseFault> ignored;  // the lesson's reader has told them
  draw_paragraph(column, lesson::paragraph_of(text, ignored), figures, writing, {});
}

}  // namespace snug::desktop
