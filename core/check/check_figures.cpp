#include "check/check_figures.hpp"

#include <vector>

#include "lesson/names.hpp"
#include "lesson/subjects.hpp"

namespace snug::check {
namespace {

void add_keys(std::vector<std::string>& keys, const std::string& algorithm, const Lesson& lesson, const Subject& own,
              const Run& run, int step) {
  const View view{{Slot{find_method(lesson, algorithm), &run}, Slot{}}, 0, step};
  for (Figure& figure : own.figures(view))
    if (!is_among(keys, figure.key)) keys.push_back(std::move(figure.key));
}

/// Why there is no such figure: "is none of radius or excess: exces; did you mean excess?"; empty if there is one.
/// algorithm: in whose run it is shown, if it names none itself; empty: in that of any.
std::string lack_of(const RunFigure& figure, const std::string& algorithm, const Lesson& lesson, const Subject& own,
                    const RunOf& run_of) {
  std::vector<std::string> keys, among{algorithm};
  if (!figure.algorithm.empty()) among = {offered(lesson, figure.algorithm)};
  else if (offered(lesson, algorithm).empty()) among = lesson.algorithms;
  bool all_known = true;
  for (const std::string& name : among) {
    const Run* run = run_of(name);
    all_known = all_known && run != nullptr;
    if (run == nullptr) continue;
    const int first = figure.algorithm.empty() ? 0 : run->steps();
    for (int step = run->steps(); step >= first && !is_among(keys, figure.key); --step)
      add_keys(keys, name, lesson, own, *run, step);
  }
  if (is_among(keys, figure.key) || !all_known) return {};
  return keys.empty() ? "is not there: it has none" : none_of_text(figure.key, keys);
}

/// Why no situation that the text is about has the figure; empty if one has.
std::string lack_in(const PlacedFigure& placed, const Lesson& lesson, std::span<const OpenSituation> situations) {
  std::string lack;
  for (const OpenSituation& there : situations) {
    if (!placed.situation.empty() && there.name != placed.situation) continue;
    std::string here = lack_of(placed.figure, placed.algorithm, lesson, *there.own, there.run_of);
    if (here.empty()) return {};
    if (lack.empty()) lack = std::move(here);
  }
  return lack;
}

}  // namespace

const OpenSituation* find_open(std::span<const OpenSituation> situations, std::string_view name) {
  for (const OpenSituation& one : situations)
    if (one.name == (name.empty() ? kOwnSituation : name)) return &one;
  return nullptr;
}

void check_figures(const Lesson& lesson, const toml::table& toml, std::span<const OpenSituation> situations,
                   Complaints& complaints) {
  for (const PlacedFigure& placed : figures_in(toml, lesson)) {
    if (!is_among_figures(lesson.figures, placed.figure)) continue;  // its algorithm is not there, which was told
    const std::string lack = lack_in(placed, lesson, situations);
    const std::string of = placed.figure.algorithm.empty() ? "" : " of " + placed.figure.algorithm + " at its end";
    if (!lack.empty())
      complaints.add(placed.place, '"' + std::string(placed.key) + "\" shows a figure" + of + " that " + lack);
  }
}

}  // namespace snug::check
