// snug lesson facts: what an author would otherwise compute by hand.
#include <algorithm>
#include <map>
#include <string>

#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/ask.hpp"
#include "lesson/playable.hpp"
#include "lesson/situations.hpp"
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
  for (const lesson::Figure& figure : session.stage().subject().figures(session.player().view()))
    if (figure.known) json[figure.key] = figure.value;
  return json;
}

/// What may be asked of a step: a question's "asks".
Json asks_of(const lesson::Session& session, int step) {
  Json asks = Json::array();
  if (session.lesson().subject->experiment != nullptr) return asks;
  for (const lesson::QuestionKind& kind : session.player().run(0).question_kinds(step)) asks.push_back(kind.name);
  for (const std::string_view name : lesson::general_question_kinds(*session.lesson().subject))
    if (!name.starts_with("point") || !session.player().run(0).handles(step).empty()) asks.push_back(name);
  return asks;
}

Json names_of_handles(const lesson::Session& session, int step) {
  Json names = Json::array();
  for (const Index handle : session.player().run(0).handles(step))
    names.push_back(session.stage().subject().name_of(handle));
  return names;
}

/// A line's beginning: which run it is of.
Json begun_with(const lesson::Session& session, const std::string& algorithm) {
  Json line{{"algorithm", algorithm}};
  if (!session.lesson().situations.empty()) line["situation"] = session.stage().situation();
  return line;
}

/// The steps of the algorithm that stands, a line each; figures are those after the step.
std::string steps_of(lesson::Session& session, const std::string& algorithm) {
  std::string text;
  std::map<std::string_view, int> seen;
  for (int i = 0; i < session.player().steps(); ++i) {
    session.jump(i + 1);
    const std::string_view fact = session.player().run(0).fact(i);
    const bool counts = session.player().run(0).counts(i);
    if (counts) ++seen[fact];
    Json line = begun_with(session, algorithm);
    line["step"] = i + 1;
    line["fact"] = fact;
    line["nth"] = counts ? Json(seen[fact]) : Json();
    line["handles"] = names_of_handles(session, i);
    line["asks"] = asks_of(session, i);
    line["sentence"] = session.player().run(0).sentence(i, {});
    line["figures"] = figures_of(session);
    text += line_of(line);
  }
  return text;
}

Json result_of(const lesson::Session& session, const std::string& algorithm) {
  Json json = begun_with(session, algorithm);
  json["steps"] = session.player().steps();
  for (const lesson::Rival& rival : session.player().rivals()) {
    if (rival.method != session.player().method(0)) continue;
    json["size"] = rival.size;
    json["excess"] = rival.excess ? Json(*rival.excess) : Json();
  }
  json["figures"] = figures_of(session);
  return json;
}

/// The facts of the situation that stands.
tl::expected<std::string, InputError> facts_here(lesson::Session& session, const std::string& algorithm) {
  const auto names = lesson::playable(session);
  if (!algorithm.empty() && std::find(names.begin(), names.end(), algorithm) == names.end())
    return tl::unexpected(InputError{.what = "the lesson does not offer the algorithm " + algorithm});
  std::string text;
  for (const std::string& name : names) {
    if (!algorithm.empty() && name != algorithm) continue;
    if (const auto chosen = session.player().choose(0, name); !chosen) return tl::unexpected(chosen.error());
    text += steps_of(session, name);
    text += line_of(result_of(session, name));
  }
  return text;
}

CommandResult run_facts(const FactsOptions& options) {
  const auto file = find_lesson(options.folder, options.id, Read::kAsWritten);
  if (!file) return bad_input(file.error());
  auto session = open_lesson(*file);
  if (!session) return bad_input(session.error());
  Printed printed;
  for (const std::string_view situation : lesson::situation_names(file->lesson)) {
    if (const auto shown = session->stage().show_situation(situation); !shown) return bad_input(shown.error());
    const auto facts = facts_here(*session, options.algorithm);
    if (!facts) return bad_input(facts.error());
    printed.text += *facts;
  }
  return printed;
}

}  // namespace

void add_lesson_facts(Commands& commands, CLI::App& group) {
  CLI::App& facts = *group.add_subcommand("facts", "Print every step of a lesson's algorithms, and the results");
  facts.footer(
      "What an author would otherwise work out by hand. JSON Lines: for each algorithm a line for each step (in a\n"
      "scene, each frame):\n"
      "{\"algorithm\",\"step\",\"fact\",\"nth\",\"handles\",\"asks\",\"sentence\",\"figures\"}, then one of its "
      "result:\n"
      "{\"algorithm\",\"steps\",\"size\",\"excess\",\"figures\"}. \"fact\" and \"nth\" are what a question's "
      "\"before\" and\n"
      "\"nth\" name (null where a recursion's inner call is not counted), \"asks\" what it can be asked. \"size\" is "
      "a\n"
      "sphere's radius, of others the area or volume; \"excess\" is over the lesson's \"reference\", 0.1 for\n"
      "10 %, and null where nothing is compared.\n"
      "If the lesson has several situations, each line has its \"situation\".");
  const auto options = add_command<FactsOptions>(commands, facts, run_facts);
  facts.add_option("--algorithm", options->algorithm, "Only this one of the lesson's");
  add_lesson_options(facts, options->folder, options->id);
}

}  // namespace snug::desktop
