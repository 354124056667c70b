// A program for Node that checks lessons and reads TOML, for the page's build and the preview. The page's own program
// has no checks.
// usage: read FILE.toml...                       prints the tables of each: {FILE: {tables} or {mistake}}
//        check LESSON.toml MESHES LESSONS IDEAS  prints what is wrong with it: {heading, lines: [{text, warning}]}
//        demos FILE.toml...                      prints the demo of each: {FILE: {id, title, lecture, states} or
//        {mistake}}
// MESHES: a folder. LESSONS, IDEAS: the ids of those beside it, with commas between.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/check_beside.hpp"
#include "check/check_lesson.hpp"
#include "check/draft_text.hpp"
#include "lesson/demo.hpp"
#include "lesson/toml_file.hpp"
#include "number/fnv.hpp"

namespace {

using namespace snug;
using Json = nlohmann::ordered_json;

std::optional<std::string> bytes_of(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) return std::nullopt;
  std::string bytes;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) bytes.append(buffer, n);
  return bytes;
}

Json json_of(const toml::node& node) {
  if (const toml::table* table = node.as_table()) {
    Json object = Json::object();
    for (const auto& [key, value] : *table) object[std::string(key.str())] = json_of(value);
    return object;
  }
  if (const toml::array* array = node.as_array()) {
    Json list = Json::array();
    for (const toml::node& value : *array) list.push_back(json_of(value));
    return list;
  }
  if (const auto text = node.value_exact<std::string>()) return *text;
  if (const auto whole = node.value_exact<std::int64_t>()) return *whole;
  if (const auto flag = node.value_exact<bool>()) return *flag;
  if (const auto number = node.value_exact<double>()) return *number;
  return nullptr;  // a date, of which no file has any
}

Json tables_of(const std::string& path) {
  const auto text = bytes_of(path);
  if (!text) return {{"mistake", path + ": cannot be opened"}};
  lesson::Complaints complaints(path);
  if (const auto toml = lesson::parse_file(*text, "a file", complaints)) return {{"tables", json_of(*toml)}};
  return {{"mistake", complaints.first()->error().message()}};
}

std::vector<std::string> parts_of(std::string_view list) {
  std::vector<std::string> parts;
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(','), list.size());
    parts.emplace_back(list.substr(0, end));
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return parts;
}

std::optional<io::PointFile> mesh_of(const lesson::Draft& draft, const std::string& meshes) {
  if (!draft.lesson || draft.lesson->points.mesh.empty()) return std::nullopt;
  const auto bytes = bytes_of(meshes + '/' + draft.lesson->points.mesh + ".ply");
  auto mesh = io::read_points(bytes.value_or(""), draft.lesson->points.mesh + ".ply");
  if (!mesh) return std::nullopt;
  return *std::move(mesh);
}

Json wrong_with(const std::string& path, const std::string& meshes, const check::Beside& beside) {
  const std::string name = path.substr(path.rfind('/') + 1), text = bytes_of(path).value_or("");
  lesson::Draft draft = check::checked_draft(text, name);
  std::optional<io::PointFile> mesh = mesh_of(draft, meshes);
  if (mesh) draft = check::checked_draft(text, name, &*mesh);
  check::check_names_beside(draft, name, beside);
  check::check_played(draft, name, std::move(mesh));
  const check::DraftText says = check::text_of(draft, name);
  Json lines = Json::array();
  for (const check::DraftText::Line& line : says.lines)
    lines.push_back({{"text", line.text}, {"warning", line.warning}});
  return {{"heading", says.heading}, {"lines", std::move(lines)}};
}

Json demo_of(const std::string& path) {
  const auto text = bytes_of(path);
  if (!text) return {{"mistake", path + ": cannot be opened"}};
  const lesson::DemoDraft draft = lesson::read_demo(*text, path);
  if (!draft.mistakes.empty()) return {{"mistake", draft.mistakes.front().error().message()}};
  Json states = Json::array();
  for (const lesson::DemoState& state : draft.demo.states)
    states.push_back({{"address", lesson::address_of(state)},
                      {"shows", state.shows},
                      {"reveal", state.reveal},
                      {"slide", state.slide},
                      {"notes", state.notes},
                      {"hash", state.hash ? hex_of(*state.hash) : ""}});
  return {{"id", draft.demo.id},
          {"title", draft.demo.title},
          {"lecture", draft.demo.lecture},
          {"states", std::move(states)}};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  Json answer = Json::object();
  if (words.size() > 1 && (words[0] == "read" || words[0] == "demos"))
    for (std::size_t i = 1; i < words.size(); ++i)
      answer[words[i]] = words[0] == "read" ? tables_of(words[i]) : demo_of(words[i]);
  else if (words.size() == 5 && words[0] == "check")
    answer = wrong_with(words[1], words[2], {parts_of(words[3]), parts_of(words[4])});
  else return 2;
  std::puts(answer.dump().c_str());
}
