// What stands on the stage, and what edits it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/app.hpp"
#include "app/told/words.hpp"

namespace snug::app::told {

using Scalar = Word<"float", "double">;
[[nodiscard]] inline Scalar scalar_of(bool in_float) { return std::string_view(in_float ? "float" : "double"); }

struct NumberRow {
  std::string_view words, unit;
  double turn = 0;
  std::vector<std::string_view> names;
  std::vector<double> values;
  SNUG_FIELDS(words, unit, turn, names, values);
};

/// See lesson::NumberGroup.
struct NumberGroup {
  std::string_view heading, name;
  List<NumberRow> rows;
  SNUG_FIELDS(heading, name, rows);
};

/// The points, or whatever the subject has. coordinates: two or three.
struct Points {
  List<NumberGroup> numbers;
  std::string_view tools_word, tools_title;
  int size = 0, dim = 2;
  bool edited = false;
  std::string source;
  std::uint64_t seed = 0;
  std::optional<Scalar> scalar;  // none where the lesson offers no choice
  bool can_undo = false, can_redo = false;
  std::optional<Index> selected;
  std::optional<std::string> selected_name;
  std::optional<std::vector<double>> coordinates;
  SNUG_FIELDS(numbers, tools_word, tools_title, size, dim, edited, source, seed, scalar, can_undo, can_redo, selected,
              selected_name, coordinates);
};

struct ShownSlider {
  std::size_t number = 0;
  std::string title;
  double value = 0;
  std::string text;
  int place = 0, places = 1;
  SNUG_FIELDS(number, title, value, text, place, places);
};

struct StoredMember {
  std::string declared, text, mark;
  SNUG_FIELDS(declared, text, mark);
};
struct StoredOperation {
  std::string name, says;
  bool least = false;
  SNUG_FIELDS(name, says, least);
};
struct StoredForm {
  std::string name, bytes;
  List<StoredMember> members;
  List<StoredOperation> operations;
  SNUG_FIELDS(name, bytes, members, operations);
};
/// How a volume on the stage is stored.
struct StoredVolume {
  std::string title;
  List<StoredForm> forms;
  SNUG_FIELDS(title, forms);
};

/// The text that the stage is made from.
struct StageFile {
  std::string own, runs, typed, heading;
  std::vector<std::string> mistakes;
  SNUG_FIELDS(own, runs, typed, heading, mistakes);
};

/// What can be switched off in a scene.
struct Effect {
  std::string effect;
  bool on = false;
  std::int64_t constructed = 0, run = 0, skipped = 0;
  std::string microseconds;
  bool called = false;
  std::string says;
  SNUG_FIELDS(effect, on, constructed, run, skipped, microseconds, called, says);
};

/// What only some stages have.
struct Parts {
  std::optional<std::string> situation;  // none if the lesson has but one
  List<ShownSlider> sliders;
  List<StoredVolume> stored;
  std::optional<StageFile> file;
  List<Effect> effects;
  SNUG_FIELDS(situation, sliders, stored, file, effects);
};

[[nodiscard]] Points points_of(const App& app, const lesson::Session& session);
[[nodiscard]] Parts parts_of(const lesson::Session& session);
/// A place of the scene, as [x, y] or [x, y, z].
[[nodiscard]] std::vector<double> coordinates_of(const Vector<double, 3>& place, int dim);

}  // namespace snug::app::told
