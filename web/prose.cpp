#include "web/prose.hpp"

#include <array>

#include "web/values.hpp"

namespace snug::web {
namespace {

using emscripten::val;
using lesson::Stretch;

val link_object(const lesson::Link& link) {
  constexpr std::array<const char*, 6> kKinds{"lesson", "mesh", "algorithm", "step", "mark", "situation"};
  val object = val::object();
  object.set("kind", kKinds[static_cast<std::size_t>(link.kind)]);
  object.set("target", link.target);
  return object;
}

val stretch_object(const Stretch& stretch) {
  val piece = val::object();
  piece.set("text", stretch.text);
  if (stretch.strong) piece.set("strong", true);
  if (stretch.emphasis) piece.set("emphasis", true);
  if (stretch.code) piece.set("code", true);
  if (stretch.script != Stretch::Script::kNone)
    piece.set("script", stretch.script == Stretch::Script::kLow ? "sub" : "sup");
  if (!stretch.tex.empty()) piece.set("tex", stretch.tex);
  if (stretch.link) piece.set("link", link_object(*stretch.link));
  if (stretch.figure) piece.set("figure", name_of(*stretch.figure));
  if (stretch.sentence >= 0) piece.set("sentence", stretch.sentence);
  return piece;
}

}  // namespace

val stretch_array(const lesson::Paragraph& paragraph) { return array_of(paragraph, stretch_object); }

val prompt_array(std::string_view text) {
  std::vector<lesson::ProseFault> ignored;  // the lesson's reader has told them
  return stretch_array(lesson::paragraph_of(text, ignored));
}

val block_object(const lesson::Block& block) {
  constexpr std::array<const char*, 4> kKinds{"paragraph", "bullets", "numbers", "table"};
  val object = val::object();
  object.set("kind", kKinds[static_cast<std::size_t>(block.kind)]);
  object.set("rows", array_of(block.rows,
                              [](const std::vector<lesson::Paragraph>& row) { return array_of(row, stretch_array); }));
  object.set("right", array_of(block.right, [](bool right) { return val(right); }));
  return object;
}

val prose_figures_object(const lesson::Session& session) {
  lesson::ProseFigures figures(session.conversation());
  val object = val::object();
  for (const lesson::RunFigure& figure : session.lesson().figures) {
    const lesson::FigureNow& now = figures.of(figure);
    val one = val::object();
    one.set("text", now.text);
    one.set("says", text(now.says));
    one.set("known", now.says != lesson::kFigureUnknown);
    object.set(name_of(figure), one);
  }
  return object;
}

}  // namespace snug::web
