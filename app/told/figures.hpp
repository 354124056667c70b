// The figures of the run, and what the panels beside the stage tell.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"
#include "app/told/cover.hpp"
#include "app/told/words.hpp"

namespace snug::app::told {

struct ShownFigure {
  std::string key, name, text;
  SNUG_FIELDS(key, name, text);
};

struct ProseFigure {
  std::string text;
  std::string_view says;
  bool known = false;
  SNUG_FIELDS(text, says, known);
};

struct Figures {
  ByName<double> readout;
  List<ShownFigure> figures;
  ByName<ProseFigure> prose_figures;  // those of the lesson's texts
  SNUG_FIELDS(readout, figures, prose_figures);
};

/// What a panel tells beyond the figures.
struct Panel {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::string says;
  std::optional<CoverButton> button;
  SNUG_FIELDS(title, head, rows, says, button);
};

struct Panels {
  List<Panel> panels;
  SNUG_FIELDS(panels);
};

struct Rival {
  std::string name, title;
  std::optional<double> size, excess;
  SNUG_FIELDS(name, title, size, excess);
};

/// The algorithms that run, and the pseudocode of the first.
struct Algorithms {
  std::string algorithm;
  std::optional<std::string> beside;
  std::string_view code_title;
  std::vector<std::string_view> code;
  int line = 0;
  List<Rival> rivals;
  SNUG_FIELDS(algorithm, beside, code_title, code, line, rivals);
};

[[nodiscard]] Figures figures_of(const lesson::Session& session);
[[nodiscard]] Panels panels_of(const App& app);
[[nodiscard]] Algorithms algorithms_of(const lesson::Session& session);

}  // namespace snug::app::told
