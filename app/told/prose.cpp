#include "app/told/prose.hpp"

#include <array>

#include "lesson/prose.hpp"

namespace snug::app::told {
namespace {

constexpr std::array<std::string_view, 6> kLinks{"lesson", "mesh", "algorithm", "step", "mark", "situation"};
constexpr std::array<std::string_view, 3> kScripts{"", "sub", "sup"};
constexpr std::array<std::string_view, 4> kBlocks{"paragraph", "bullets", "numbers", "table"};

Stretch stretch_of(const lesson::Stretch& own) {
  Stretch told{.text = own.text, .strong = own.strong, .emphasis = own.emphasis, .code = own.code, .tex = own.tex};
  told.script = Word<"sub", "sup">(kScripts[static_cast<std::size_t>(own.script)]);
  if (own.link) told.link = std::optional(Link{kLinks[static_cast<std::size_t>(own.link->kind)], own.link->target});
  if (own.figure) told.figure = name_of(*own.figure);
  if (own.sentence >= 0) told.sentence = std::optional(own.sentence);
  return told;
}

}  // namespace

Paragraph paragraph_of(const lesson::Paragraph& own) {
  Paragraph told;
  for (const lesson::Stretch& stretch : own) told.push_back(stretch_of(stretch));
  return told;
}

Paragraph prompt_of(std::string_view text) {
  std::vector<lesson::ProseFault> ignored;  // the lesson's reader has told them
  return paragraph_of(lesson::paragraph_of(text, ignored));
}

Block block_of(const lesson::Block& own) {
  Block told{.kind = kBlocks[static_cast<std::size_t>(own.kind)], .right = own.right};
  for (const std::vector<lesson::Paragraph>& row : own.rows) {
    auto& cells = told.rows.emplace_back();
    for (const lesson::Paragraph& cell : row) cells.push_back(paragraph_of(cell));
  }
  return told;
}

}  // namespace snug::app::told
