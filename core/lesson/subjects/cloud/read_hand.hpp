// What a lesson's file says about what is set by hand.
#pragma once

#include "lesson/subjects.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

/// The volumes that the lesson's students set by hand, each once.
[[nodiscard]] std::vector<std::string_view> volumes_by_hand(const Lesson& lesson);

/// Reads a task's "model", a list of points, and its "hand": "turn" of the box, in degrees, "segment" of the capsule,
/// "rectangle" of the lozenge, as a vertex and two edges, "axes" of the k-DOP. With a hand alone, the points are the
/// lesson's own.
[[nodiscard]] Rows read_cloud_model(TomlTable& task, const Lesson& lesson, Complaints& complaints);

}  // namespace snug::lesson
