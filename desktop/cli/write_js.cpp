#include "desktop/cli/write_js.hpp"

#include <sstream>

#include "desktop/cli/confined.hpp"
#include "desktop/cli/data_folder.hpp"
#include "desktop/cli/json.hpp"

namespace snug::desktop {

tl::expected<std::vector<JudgedJs>, std::string> judge_js(const write::Function& function,
                                                          const std::vector<std::string>& codes, std::uint64_t seed) {
  constexpr int kNoSuchProgram = 127;
  const auto folder = data_folder() / "assets" / "write";
  const std::vector<write::Case> cases = write::cases_of(function, seed);
  Json lines = Json::array();
  for (const write::Case& one : cases) {
    std::string line = write::json_lines(function, {one.input});
    line.pop_back();
    lines.push_back(std::move(line));
  }
  std::string asked;
  for (const std::string& code : codes)
    asked += line_of({{"code", code}, {"name", function.name}, {"gives", function.gives}, {"lines", lines}});
  // The engine inside confines the code; Node needs threads and files of its own.
  const Limits limits{.seconds = 60.0 * static_cast<double>(codes.size()), .bytes = 1LL << 30, .confined = false};
  const Ended ended =
      run_within(limits, {"node", (folder / "worker.js").string(), (folder / "quickjs.wasm").string()}, asked);
  if (ended.how == Ended::How::kDone && ended.status == kNoSuchProgram)
    return tl::unexpected(std::string("Node is not installed here, which runs JavaScript (nodejs)"));
  std::vector<JudgedJs> all;
  std::istringstream told(ended.out);
  while (all.size() < codes.size()) {
    std::string line, answers, error;
    std::getline(told, line);
    if (const Json ran = Json::parse(line, nullptr, false); ran.is_object() && ran.contains("answers")) {
      for (const Json& answer : ran["answers"]) answers += answer.get<std::string>() + '\n';
      if (ran["error"].is_object()) error = ran["error"].value("what", "");
    } else if (ended.how == Ended::How::kDone) {
      return tl::unexpected(std::string("the engine of the page did not start"));
    }
    all.push_back({write::judge(function, cases, write::read_answers(answers, cases.size())), error});
  }
  return all;
}

}  // namespace snug::desktop
