// snug lesson facts: what an author would otherwise compute by hand.
#include <algorithm>
#include <map>
#include <string>

#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/ask.hpp"
#include "lesson/play.hpp"
#include "lesson/subjects.hpp"

namespace snug::desktop {
namespace {

struct FactsOptions {
  std::string folder;
  std::string id;
  std::string algorithm;  // empty for all
};

Json figures_of(const lesson::Session& session) {
  Json json = Json::object();
  for (const lesson::Figure& figure : session.subject().figures(session.view()))
    if (figure.known) json[figure.key] = figure.value;
  return json;
}

/// What may be asked of a step: a question's "asks".
Json asks_of(const lesson::Session& session, int step) {
  Json asks = Json::array();
  if (!session.lesson().subject->asks_of_steps) return asks;
  for (const lesson::Asking& asking : session.run(0).askings(step)) asks.push_back(asking.name);
  for (const std::string_view name : lesson::general_askings(*session.lesson().subject))
    if (!name.starts_with("point") || !session.run(0).handles(step).empty()) asks.push_back(name);
  return asks;
}

Json names_of_handles(const lesson::Session& session, int step) {
  Json names = Json::array();
  for (const Index handle : session.run(0).handles(step)) names.push_back(session.name_of(handle));
  return names;
}

/// The steps of the algorithm that stands, a line each; figures are those after the step.
std::string steps_of(lesson::Session& session, const std::string& algorithm) {
  std::string text;
  std::map<std::string_view, int> seen;
  for (int i = 0; i < session.steps(); ++i) {
    session.jump(i + 1);
    const std::string_view fact = session.run(0).fact(i);
    const bool counts = session.run(0).counts(i);
    if (counts) ++seen[fact];
    text += line_of({{"algorithm", algorithm},
                     {"step", i + 1},
                     {"fact", fact},
                     {"nth", counts ? Json(seen[fact]) : Json()},
                     {"handles", names_of_handles(session, i)},
                     {"asks", asks_of(session, i)},
                     {"sentence", session.run(0).sentence(i, {})},
                     {"figures", figures_of(session)}});
  }
  return text;
}

Json result_of(const lesson::Session& session, const std::string& algorithm) {
  Json json{{"algorithm", algorithm}, {"steps", session.steps()}};
  for (const lesson::Rival& rival : session.rivals()) {
    if (rival.method != session.method(0)) continue;
    json["size"] = rival.size;
    json["excess"] = rival.excess ? Json(*rival.excess) : Json();
  }
  json["figures"] = figures_of(session);
  return json;
}

CommandResult run_facts(const FactsOptions& options) {
  const auto file = find_lesson(options.folder, options.id, lesson::Checked::kAsWritten);
  if (!file) return bad_input(file.error());
  auto session = open_lesson(*file);
  if (!session) return bad_input(session.error());
  const auto names = lesson::playable(*session);
  if (!options.algorithm.empty() && std::find(names.begin(), names.end(), options.algorithm) == names.end())
    return bad_input("the lesson does not offer the algorithm " + options.algorithm);
  Printed printed;
  for (const std::string& name : names) {
    if (!options.algorithm.empty() && name != options.algorithm) continue;
    if (const auto chosen = session->choose(0, name); !chosen) return bad_input(chosen.error());
    printed.text += steps_of(*session, name);
    printed.text += line_of(result_of(*session, name));
  }
  return printed;
}

}  // namespace

void add_lesson_facts(Commands& commands, CLI::App& group) {
  CLI::App& facts = *group.add_subcommand("facts", "Print what a lesson's algorithms do and come to");
  facts.footer(
      "What an author would otherwise work out by hand. JSON Lines: for each algorithm a line for each step (in a\n"
      "scene, each frame):\n"
      "{\"algorithm\",\"step\",\"fact\",\"nth\",\"handles\",\"asks\",\"sentence\",\"figures\"}, then one of its "
      "result:\n"
      "{\"algorithm\",\"steps\",\"size\",\"excess\",\"figures\"}. \"fact\" and \"nth\" are what a question's "
      "\"before\" and\n"
      "\"nth\" name (null where a recursion's inner call is not counted), \"asks\" what it can be asked. \"size\" is "
      "a\n"
      "sphere's radius, of others the area or volume; \"excess\" is over the smallest, 0.1 for 10 %.");
  const auto options = add_command<FactsOptions>(commands, facts, run_facts);
  facts.add_option("--algorithm", options->algorithm, "Only this one of the lesson's");
  add_lesson_options(facts, options->folder, options->id);
}

}  // namespace snug::desktop
