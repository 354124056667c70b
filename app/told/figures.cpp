#include "app/told/figures.hpp"

#include <utility>

#include "app/panel_words.hpp"
#include "lesson/code_told.hpp"
#include "lesson/prose.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app::told {

Figures figures_of(const lesson::Session& session) {
  Figures told;
  for (lesson::Figure& figure : session.telling().figures()) {
    if (figure.known) told.readout.emplace_back(figure.key, figure.value);
    told.figures.push_back({std::move(figure.key), std::move(figure.name), std::move(figure.text)});
  }
  lesson::ProseFigures figures(session.conversation());
  for (const lesson::RunFigure& figure : session.lesson().figures) {
    const lesson::FigureNow& now = figures.of(figure);
    told.prose_figures.push_back({name_of(figure), {now.text, now.says, now.says != lesson::kFigureUnknown}});
  }
  return told;
}

Panels panels_of(const App& app) {
  Panels told;
  for (PanelWords& panel : app.panel_words())
    told.panels.push_back({.title = std::move(panel.table.title),
                           .head = std::move(panel.table.head),
                           .rows = std::move(panel.table.rows),
                           .says = std::move(panel.says),
                           .button = std::move(panel.button)});
  return told;
}

Algorithms algorithms_of(const lesson::Session& session) {
  const lesson::Player& player = session.player();
  const lesson::Method& own = *player.method(0);
  const lesson::Method* beside = player.method(1);
  const auto name = [&](const lesson::Method& method) { return lesson::name_in(session.lesson(), method); };
  const lesson::CodeTold code = lesson::code_told(session);
  Algorithms told{.algorithm = name(own),
                  .code_title = own.title,
                  .code = {code.lines.begin(), code.lines.end()},
                  .line = code.lit};
  if (beside != nullptr) told.beside = name(*beside);
  for (const lesson::Rival& rival : player.rivals()) {
    Rival& row = told.rivals.emplace_back();
    row.name = name(*rival.method);
    row.title = lesson::title_in(session.lesson(), *rival.method);
    if (!session.telling().hides_result(*rival.method)) row.size = rival.size, row.excess = rival.excess;
  }
  return told;
}

}  // namespace snug::app::told
