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

/// Calls see(table, key) for each text of a question or task, and what it says to wrong answers.
void each_prompt(const toml::table& toml, auto see) {
  for (const std::string_view name : {"question", "task"})
    for (const toml::table* table : tables_named(toml, name))
      for (const std::string_view key : kPromptKeys)
        if (!text_of(*table, key).empty()) see(*table, key);
  for (const toml::table* question : tables_named(toml, "question"))
    if (const toml::table* wrong = (*question)["wrong"].as_table())
      for (const auto& [key, text] : *wrong)
        if (text.is_string()) see(*wrong, key.str());
}

std::vector<PlacedFigure> figures_in(const toml::table& toml, const Lesson& lesson) {
  std::vector<PlacedFigure> figures;
  const auto add = [&](const toml::table& table, std::string_view key, const Stretch& stretch, std::string algorithm) {
    if (stretch.figure)
      figures.push_back({*stretch.figure, place_in_text(table, key, stretch.at), key, std::move(algorithm)});
  };
  const auto sections = tables_named(toml, "section");
  for (std::size_t i = 0; i < std::min(sections.size(), lesson.sections.size()); ++i)
    for (const Stretch* stretch : stretches_of(lesson.sections[i]))
      add(*sections[i], "text", *stretch, lesson.sections[i].algorithm);
  each_prompt(toml, [&](const toml::table& table, std::string_view key) {
    std::vector<ProseFault> told;
    for (const Stretch& stretch : paragraph_of(text_of(table, key), told))
      add(table, key, stretch, std::string(text_of(table, "algorithm")));
  });
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

void read_texts(const toml::table& toml, Lesson& lesson, Complaints& complaints) {
  each_prompt(toml, [&](const toml::table& table, std::string_view key) {
    std::vector<ProseFault> faults;
    static_cast<void>(paragraph_of(text_of(table, key), faults));
    for (const ProseFault& fault : faults)
      complaints.add(place_in_text(table, key, fault.at), '"' + std::string(key) + "\" " + fault.what);
  });
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

void check_figures(const Lesson& lesson, const toml::table& toml, const Subject& own, const RunOf& run_of,
                   Complaints& complaints) {
  for (const PlacedFigure& placed : figures_in(toml, lesson)) {
    if (!is_among_figures(lesson.figures, placed.figure)) continue;  // its algorithm is not there, which was told
    const std::string lack = lack_of(placed.figure, placed.algorithm, lesson, own, run_of);
    const std::string of = placed.figure.algorithm.empty() ? "" : " of " + placed.figure.algorithm + " at its end";
    if (!lack.empty())
      complaints.add(placed.place, '"' + std::string(placed.key) + "\" shows a figure" + of + " that " + lack);
  }
}

}  // namespace snug::lesson
