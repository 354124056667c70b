#include "lesson/check_texts.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_place.hpp"

namespace snug::lesson {
namespace {

/// The keys of questions and tasks whose texts have markup.
constexpr std::array<std::string_view, 5> kPromptKeys{"prompt", "prompt_here", "because", "because_here", "hint"};

/// A figure in a text of the file.
struct PlacedFigure {
  RunFigure figure;
  FilePlace place;
  std::string_view key;   // of the text
  std::string algorithm;  // in whose run the text is read; empty: in any
  std::string situation;  // the same
};

/// The tables of that name: one, or a list of them.
std::vector<const toml::table*> tables_named(const toml::table& toml, std::string_view name) {
  std::vector<const toml::table*> tables;
  if (const toml::table* one = toml[name].as_table()) tables.push_back(one);
  if (const toml::array* many = toml[name].as_array())
    for (const toml::node& each : *many)
      if (const toml::table* one = each.as_table()) tables.push_back(one);
  return tables;
}

std::vector<PlacedFigure> figures_in(const toml::table& toml, const Lesson& lesson) {
  std::vector<PlacedFigure> figures;
  const auto sections = tables_named(toml, "section");
  for (std::size_t i = 0; i < std::min(sections.size(), lesson.sections.size()); ++i)
    for (const Stretch* stretch : stretches_of(lesson.sections[i]))
      if (stretch->figure)
        figures.push_back({*stretch->figure, place_in_text(*sections[i], "text", stretch->at), "text",
                           lesson.sections[i].algorithm, lesson.sections[i].situation});
  for (const PlacedText& text : prompts_of(toml)) {
    std::vector<ProseFault> told;
    const std::string_view situation = text.situation().empty() ? kOwnSituation : text.situation();
    for (const Stretch& stretch : paragraph_of(text_of(*text.table, text.key), told)) {
      if (!stretch.figure) continue;
      figures.push_back({*stretch.figure, place_in_text(*text.table, text.key, stretch.at), text.name(),
                         std::string(text.algorithm()), std::string(situation)});
    }
  }
  return figures;
}

/// The lesson's name of an algorithm that it offers; empty if it does not.
std::string offered(const std::string& name, const Lesson& lesson) {
  const Method* method = find_method(lesson, name);
  const std::string own = method != nullptr ? name_in(lesson, *method) : std::string();
  return is_among(lesson.algorithms, own) ? own : std::string();
}

bool is_among_figures(const std::vector<RunFigure>& figures, const RunFigure& one) {
  return std::find(figures.begin(), figures.end(), one) != figures.end();
}

void add_keys(std::vector<std::string>& keys, const std::string& algorithm, const Lesson& lesson, const Subject& own,
              const Run& run, int step) {
  const View view{{Slot{find_method(lesson, algorithm), &run}, Slot{}}, 0, step};
  for (Figure& figure : own.figures(view))
    if (!is_among(keys, figure.key)) keys.push_back(std::move(figure.key));
}

}  // namespace

const OpenSituation* find_open(std::span<const OpenSituation> situations, std::string_view name) {
  for (const OpenSituation& one : situations)
    if (one.name == (name.empty() ? kOwnSituation : name)) return &one;
  return nullptr;
}

std::string_view PlacedText::situation() const { return text_of(*of, "situation"); }
std::string_view PlacedText::algorithm() const { return text_of(*of, "algorithm"); }

std::vector<PlacedText> prompts_of(const toml::table& toml) {
  std::vector<PlacedText> texts;
  for (const std::string_view name : {"question", "task"})
    for (const toml::table* table : tables_named(toml, name))
      for (const std::string_view key : kPromptKeys)
        if (!text_of(*table, key).empty()) texts.push_back({table, key, table});
  for (const toml::table* question : tables_named(toml, "question"))
    if (const toml::table* wrong = (*question)["wrong"].as_table())
      for (const auto& [key, text] : *wrong)
        if (text.is_string()) texts.push_back({wrong, key.str(), question});
  return texts;
}

void read_texts(const toml::table& toml, Lesson& lesson, Complaints& complaints) {
  for (const PlacedText& text : prompts_of(toml)) {
    std::vector<ProseFault> faults;
    static_cast<void>(paragraph_of(text_of(*text.table, text.key), faults));
    for (const ProseFault& fault : faults)
      complaints.add(place_in_text(*text.table, text.key, fault.at),
                     '"' + std::string(text.name()) + "\" " + fault.what);
  }
  for (PlacedFigure& placed : figures_in(toml, lesson)) {
    const std::string& algorithm = placed.figure.algorithm;
    if (!algorithm.empty() && !lesson.algorithms.empty() && offered(algorithm, lesson).empty())
      complaints.add(placed.place, '"' + std::string(placed.key) + "\" shows a figure of an algorithm that " +
                                       none_of_text(algorithm, lesson.algorithms));
    else if (!is_among_figures(lesson.figures, placed.figure)) lesson.figures.push_back(std::move(placed.figure));
  }
}

std::string lack_of(const RunFigure& figure, const std::string& algorithm, const Lesson& lesson, const Subject& own,
                    const RunOf& run_of) {
  std::vector<std::string> keys, among{algorithm};
  if (!figure.algorithm.empty()) among = {offered(figure.algorithm, lesson)};
  else if (offered(algorithm, lesson).empty()) among = lesson.algorithms;
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

namespace {

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

}  // namespace snug::lesson
