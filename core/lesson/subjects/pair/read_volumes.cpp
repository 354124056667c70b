#include "lesson/subjects/pair/read_volumes.hpp"

#include <algorithm>

#include "lesson/beside.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"

namespace snug::lesson {
namespace {

/// Reads whether cylinders stand beside the capsules.
bool read_cylinders(TomlTable& table, int dim) {
  if (!table.has("beside")) return table.allow("beside"), false;
  if (table.text("beside") != "cylinders") table.wrong("beside", "must be \"cylinders\"");
  else if (dim != 3) table.wrong("beside", "is for capsules in space");
  return true;
}

/// Reads which of the two volumes are shown as they are stored.
std::array<bool, 2> read_stored(TomlTable& table) {
  constexpr std::array<std::string_view, 2> kSides{"a", "b"};
  const std::vector<std::string> names = read_names(table, "stored", 0, kSides);
  return {is_among(names, kSides[0]), is_among(names, kSides[1])};
}

}  // namespace

void read_volumes(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto tables = std::make_shared<VolumeTables>();
  TomlTable own(*table.table("volumes"), "[volumes]", complaints);
  tables->in_float = read_scalar(own);
  tables->line = own.place().line;
  const int dim = tables->pair.dim = lesson.points.dim = static_cast<int>(own.integer_or("dim", 2, 3, 2));
  tables->stored = read_stored(own);
  tables->pair.any = own.flag_or("any", false);
  tables->pair.cylinders = read_cylinders(own, dim);
  const std::size_t before = complaints.count();
  double reach = 0;
  for (const std::size_t side : {0, 1}) {
    const char* key = side == 0 ? "a" : "b";
    HeldVolume& held = tables->pair.held[side];
    held.dim = dim;
    if (const toml::table* volume = own.table(key); volume != nullptr)
      held = read_held_volume(*volume, std::string("[volumes] ") + key, dim, complaints);
    else own.lack(key, std::string("[volumes] lacks the volume \"") + key + '"');
    if (complaints.count() > before) continue;
    for (const Handle& handle : handles_of(held))
      reach = std::max(reach, (at_handle(held, handle) - at_handle(held, {})).norm());
  }
  for (HeldVolume& held : tables->pair.held) held.knob = 0.3 * reach;
  if (complaints.count() == before && own.has("a") && own.has("b") &&
      tables->pair.held[0].volume.index() > tables->pair.held[1].volume.index())
    own.wrong("a", "must be of the kind that comes first: " + one_of(kVolumeNames));
  const auto is_capsule = [](const HeldVolume& held) {
    return std::holds_alternative<Capsule<double, 3>>(held.volume);
  };
  if (complaints.count() == before && tables->pair.cylinders &&
      !std::all_of(tables->pair.held.begin(), tables->pair.held.end(), is_capsule))
    own.wrong("beside", "is for two capsules");
  own.refuse_others();
  lesson.tables = std::move(tables);
}

Rows read_volume_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  const toml::table* model = task.table("model");
  if (model == nullptr) return task.lack("model", "the task lacks [task.model]"), Rows();
  TomlTable own(*model, "[task.model]", complaints);
  VolumePair pair{.dim = lesson.points.dim, .any = static_cast<const VolumeTables&>(*lesson.tables).pair.any};
  for (const std::size_t side : {0, 1}) {
    const char* key = side == 0 ? "a" : "b";
    pair.held[side].dim = pair.dim;
    if (const toml::table* volume = own.table(key); volume != nullptr)
      pair.held[side] = read_held_volume(*volume, std::string("[task.model] ") + key, pair.dim, complaints);
    else own.lack(key, std::string("[task.model] lacks the volume \"") + key + '"');
  }
  own.refuse_others();
  return rows_of(pair);
}

void check_volume_tests(const Lesson& lesson, const Subject& own, Complaints& complaints) {
  const VolumePair& pair = as<VolumesSubject>(own)->pair();
  if (pair.any) return;  // other volumes take the others
  const std::vector<std::string_view> tests = tests_of(pair);
  for (const std::string& algorithm : lesson.algorithms)
    if (!is_among(tests, algorithm))
      complaints.add(static_cast<const VolumeTables&>(*lesson.tables).line,
                     "the test of these two volumes is " + one_of(tests) + ", not " + algorithm);
}

}  // namespace snug::lesson
