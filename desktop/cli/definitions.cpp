#include "desktop/cli/definitions.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "fit/catalogue.hpp"

namespace snug::desktop {
namespace {

bool is_called(const CLI::Option& option, std::string_view name) {
  const auto& names = option.get_lnames();
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool names_algorithms(const CLI::Option& option) {
  return is_called(option, "algorithm") || is_called(option, "algorithms");
}

/// What follows an option that every command reads in the same way.
std::vector<std::string> catalogued(const CLI::Option& option) {
  std::set<std::string> found;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (is_called(option, "volume")) found.emplace(algorithm.volume);
    else if (names_algorithms(option)) found.emplace(algorithm.name);
  return {found.begin(), found.end()};
}

void add_commands(const Defined& command, std::vector<Defined>& all) {
  all.push_back(command);
  for (const CLI::App* sub : subcommands_of(*command.app))
    add_commands({command.call + ' ' + sub->get_name(), sub}, all);
}

}  // namespace

std::vector<const CLI::App*> subcommands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* sub) { return !sub->get_group().empty(); });
}

std::vector<Defined> all_commands(const CLI::App& snug) {
  std::vector<Defined> all;
  add_commands({snug.get_name(), &snug}, all);
  return all;
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // of one that is checked "TEXT:{double,float}"
  const auto begin = type.find('{'), end = type.rfind('}');
  if (begin == std::string::npos || end == std::string::npos) return catalogued(option);
  std::vector<std::string> values;
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  for (std::string value; std::getline(list, value, ',');) values.push_back(value);
  return values;
}

bool is_of_volume(const Defined& command, const CLI::Option& option) {
  return names_algorithms(option) && command.app->get_option_no_throw("--volume") != nullptr;
}

std::vector<std::pair<std::string, std::vector<std::string>>> algorithms_by_volume() {
  std::vector<std::pair<std::string, std::vector<std::string>>> found;
  std::set<std::string> all;
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    if (found.empty() || found.back().first != algorithm.volume) found.emplace_back(algorithm.volume, 0);
    found.back().second.emplace_back(algorithm.name);
    all.emplace(algorithm.name);
  }
  found.emplace_back("*", std::vector<std::string>(all.begin(), all.end()));
  return found;
}

std::string ids_of(const Defined& command, const CLI::Option& option) {
  // The completions name an option as the help does.
  const std::string name = option.nonpositional() ? names_of(option).back() : option.get_name();
  if (name == "LESSON" || name == "--lesson") return "lessons";
  if (name == "--case") return "cases";
  if (name == "--trials") return "claims";
  if (name == "SET") return "sets exercises";
  if (name == "WHAT") return "packages";
  if (name == "ID" && command.call.starts_with("snug exercise ")) return "exercises";
  if (name == "FILE" && command.call.starts_with("snug demo ")) return "demos";
  if (name == "NAME" && command.call.starts_with("snug lab ")) return "labs";
  return {};
}

std::string ids_in_place(const Defined& command) {
  for (const CLI::Option* option :
       command.app->get_options([](const CLI::Option* one) { return !one->nonpositional(); }))
    if (std::string ids = ids_of(command, *option); !ids.empty()) return ids;
  return {};
}

std::string help_of(const Defined& command) {
  return command.app->get_formatter()->make_help(command.app, command.call, CLI::AppFormatMode::Normal);
}

}  // namespace snug::desktop
