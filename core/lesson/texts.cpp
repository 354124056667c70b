#include "lesson/texts.hpp"

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

/// The tables of that name: one, or a list of them.
std::vector<const toml::table*> tables_named(const toml::table& toml, std::string_view name) {
  std::vector<const toml::table*> tables;
  if (const toml::table* one = toml[name].as_table()) tables.push_back(one);
  if (const toml::array* many = toml[name].as_array())
    for (const toml::node& each : *many)
      if (const toml::table* one = each.as_table()) tables.push_back(one);
  return tables;
}

}  // namespace

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

bool is_among_figures(const std::vector<RunFigure>& figures, const RunFigure& one) {
  return std::find(figures.begin(), figures.end(), one) != figures.end();
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
    if (!algorithm.empty() && !lesson.algorithms.empty() && offered(lesson, algorithm).empty())
      complaints.add(placed.place, '"' + std::string(placed.key) + "\" shows a figure of an algorithm that " +
                                       none_of_text(algorithm, lesson.algorithms));
    else if (!is_among_figures(lesson.figures, placed.figure)) lesson.figures.push_back(std::move(placed.figure));
  }
}

}  // namespace snug::lesson
