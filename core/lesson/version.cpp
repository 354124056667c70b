#include "lesson/version.hpp"

#include "lesson/figures.hpp"

namespace snug::lesson {
namespace {

FilePlace place_of(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  return file_place(node != nullptr ? *node : static_cast<const toml::node&>(table));
}

void tell_question(const toml::table& table, Complaints& complaints) {
  if (table.contains("own_points"))
    return complaints.add(place_of(table, "own_points"), "\"own_points\" is gone: write holds = \"here\"");
  if (table["asks"].value_or(std::string_view()) == "choice")
    complaints.add(place_of(table, "answer"),
                   "a choice now says when its answer is true: add holds = \"always\", or holds = \"here\" if a drag "
                   "can make it false");
}

/// Says how a key of [task] is written as a requirement.
void tell_requirement(const toml::table& task, std::string_view key, const std::string& written,
                      Complaints& complaints) {
  if (task.contains(key))
    complaints.add(place_of(task, key), '"' + std::string(key) + "\" is gone: add a [[task.require]] with " + written);
}

void tell_task(const toml::table& task, Complaints& complaints) {
  complaints.add(file_place(task), "there can be several tasks now: write [[task]]");
  const auto percent = [&](std::string_view key) { return plain_number(100 * task[key].value_or(0.0)); };
  tell_requirement(task, "excess_at_least", "figure = \"excess\" and at_least = " + percent("excess_at_least"),
                   complaints);
  tell_requirement(task, "tighter_by", "figure = \"tighter\" and at_least = " + percent("tighter_by"), complaints);
  tell_requirement(task, "support_size",
                   "figure = \"support\", the exact algorithm, and equals = " +
                       std::to_string(task["support_size"].value_or(0)),
                   complaints);
  tell_requirement(task, "goals", "goal, in a [[task]] of its own for each", complaints);
  if (const toml::node* model = task.get("model"); model != nullptr && model->is_array_of_tables())
    complaints.add(file_place(*model), "each [[task]] has one model: write [task.model]");
}

}  // namespace

void tell_changes(const toml::table& toml, Complaints& complaints) {
  complaints.add(place_of(toml, "version"), "the file is of version 1: change what the other lines tell, if there are "
                                            "any, then write version = 2");
  if (const toml::array* questions = toml["question"].as_array())
    for (const toml::node& question : *questions)
      if (const toml::table* table = question.as_table()) tell_question(*table, complaints);
  if (const toml::table* task = toml["task"].as_table()) tell_task(*task, complaints);
}

}  // namespace snug::lesson
