// "Stored as": how a volume on the stage is stored, live. Each representation with its struct's members and their
// numbers, its bytes, and what each operation costs in it; a member that is pointed at is drawn on the stage.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fit/any_step.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

inline constexpr std::string_view kStoredWord = "Stored as";

/// A member of a struct, or one entry of a member that is an array.
struct StoredMember {
  std::string declared;         // "Point min", "float r[0]"
  std::vector<double> numbers;  // as they are now
  std::string text;             // the same, as a student reads them
  /// What it is on the stage: lines through these points; a single point is a place.
  std::vector<std::vector<Point3>> lines = {};
  std::string mark = {};  // by which it is lit (App::light)
};

/// What an operation takes in a representation.
struct StoredOperation {
  std::string name;    // "move"
  std::string says;    // "2 additions"
  bool least = false;  // whether no other representation of the volume takes less; false where there is no other
};

/// One representation of a volume.
struct StoredForm {
  std::string name;  // "min-max"
  std::vector<StoredMember> members;
  std::vector<StoredOperation> operations;  // test, move, turn, grow
  [[nodiscard]] int numbers() const;
  /// "16 bytes in float, 32 in double"
  [[nodiscard]] std::string bytes() const;
};

struct StoredVolume {
  std::string name;   // "A"
  std::string title;  // "A: axis-aligned box"
  std::vector<StoredForm> forms;
};

/// The representations of a volume; none of a kind that has none in stored_forms.cpp. In 2-D its z is 0.
[[nodiscard]] std::vector<StoredForm> stored_forms(const fit::Volume3& volume, int dim);

/// What a student calls it: "AABB", "8-DOP", "lozenge".
[[nodiscard]] std::string stored_title(const fit::Volume3& volume, int dim);

/// The volumes whose representations the lesson shows, each with a mark for each of its members; none if it asks for
/// none. Every subject that stores volumes has its own in the list of subjects.cpp.
[[nodiscard]] std::vector<StoredVolume> stored_of(const Session& session);

/// What a member's mark lights: its lines. None for any other mark, or while a question is answered on the stage.
[[nodiscard]] std::vector<std::vector<Point3>> stored_lines(const Session& session, std::string_view mark);

/// Adds what may be stored on a subject's stage; one for each such subject.
using StoredOn = std::vector<StoredVolume> (*)(const Session& session);
[[nodiscard]] std::span<const StoredOn> stored_on_subjects();

}  // namespace snug::lesson
