#include "lesson/exercise/sets.hpp"

#include <algorithm>

#include "lesson/names.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {

tl::expected<std::vector<ExerciseSet>, InputError> read_sets(std::string_view text, std::string_view name,
                                                             std::span<const std::string> ids) {
  Complaints complaints(name);
  std::vector<ExerciseSet> sets;
  if (const auto toml = parse_file(text, "the sets", complaints)) {
    TomlTable table(*toml, "the file of sets", complaints);
    if (table.integer("version", 1, 1) != 1) table.wrong("version", "must be 1");
    for (const toml::table* one : table.tables("set")) {
      TomlTable own(*one, "[[set]]", complaints);
      ExerciseSet set;
      set.id = own.text("id");
      set.title = own.text("title");
      set.lecture = own.text("lecture");
      set.exercises = read_names(own, "exercises", 1, std::vector<std::string>(ids.begin(), ids.end()));
      if (std::any_of(sets.begin(), sets.end(), [&](const ExerciseSet& other) { return other.id == set.id; }))
        own.wrong("id", "is that of another set: " + set.id);
      own.refuse_others();
      sets.push_back(std::move(set));
    }
    table.refuse_others();
  }
  if (const FileError* first = complaints.first()) return tl::unexpected(first->error());
  return sets;
}

}  // namespace snug::lesson
