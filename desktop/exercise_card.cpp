#include "desktop/exercise_card.hpp"

#include "app/marks.hpp"
#include "lesson/figures.hpp"

namespace snug::desktop {

using app::Face;

std::pair<std::string, std::string> decision_place(const lesson::Sitting& sitting, const lesson::Session& session) {
  const bool tells = sitting.exercise().told_at_once || sitting.finished(session);
  // How many there are would tell where a test ends.
  const bool same = sitting.exercise().least == sitting.exercise().most;
  return {"Decision " + std::to_string(sitting.at(session) + 1) + (same ? " of " + std::to_string(sitting.of()) : ""),
          tells ? "mark " + lesson::plain_number(sitting.mark(session)) : "told at the end"};
}

void draw_before(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  if (!sitting.exercise().told_at_once || session.outcomes().empty() || session.tried() != nullptr) return;
  const lesson::Outcome& last = session.outcomes().back();
  if (!last.right) return;
  const app::Look& look = column.look();
  app::tick(column.list(), {column.x() + 6, column.y() + look.px(10)}, 5, look->optimum, 2);
  Column beside(look, column.x() + 20, column.y(), column.width() - 20);
  beside.words(last.says, Face::kRegular, 14, look->muted);
  column.gap(beside.y() - column.y() + 6);
}

void draw_rule(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  const std::string says = sitting.rule_says(session);
  if (says.empty()) return;
  const app::Look& look = column.look();
  column.gap(6);
  Column beside(look, column.x() + 12, column.y(), column.width() - 12);
  beside.words(says, Face::kRegular, 14, look->ink);
  column.list()->AddRectFilled({column.x(), column.y()}, {column.x() + 3, beside.y()}, look->wrong);
  column.gap(beside.y() - column.y());
}

void draw_hints(Column& column, const lesson::Sitting& sitting, const lesson::Session& session) {
  draw_rule(column, sitting, session);
  for (const std::string& hint : sitting.hints(session)) {
    column.gap(6);
    column.words("Hint: " + hint, Face::kRegular, 14);
  }
}

std::string hint_words(double price) {
  if (price == 0) return {};
  return price == 1 ? "Hint for the whole mark" : "Hint for " + lesson::plain_number(price) + " of the mark";
}

std::string mark_words(const lesson::Marked& marked) {
  const std::string mark = lesson::plain_number(marked.mark);
  if (marked.hints == 0) return mark;
  return mark + (marked.hints == 1 ? ", 1 hint" : ", " + std::to_string(marked.hints) + " hints");
}

}  // namespace snug::desktop
