#include "desktop/cli/command.hpp"
#include "desktop/cli/json.hpp"
#include "fit/catalogue.hpp"

namespace snug::desktop {
namespace {

CommandResult run_algorithms() {
  Printed printed;
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    Json dims = Json::array();
    for (const int dim : {2, 3})
      if (fit::takes(algorithm, dim)) dims.push_back(dim);
    printed.text += line_of({{"volume", algorithm.volume},
                             {"algorithm", algorithm.name},
                             {"dims", dims},
                             {"exact", algorithm.exact},
                             {"source", algorithm.source},
                             {"title", algorithm.title},
                             {"naive", algorithm.naive}});
  }
  return printed;
}

}  // namespace

void add_algorithms(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("algorithms", "List every volume and algorithm that fit knows");
  command.footer(
      "JSON Lines: {\"volume\",\"algorithm\",\"dims\":[..],\"exact\":bool,\"source\",\"title\",\"naive\":bool};\n"
      "exact says whether the algorithm guarantees the smallest volume of its kind, naive whether it is as\n"
      "textbooks print it: rounding may cost it all of its digits, or leave points outside.");
  command.callback([&commands] { commands.chosen = run_algorithms; });
}

}  // namespace snug::desktop
