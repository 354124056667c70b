// How the volume around a cloud is stored.
#pragma once

#include "lesson/stored.hpp"

namespace snug::lesson {

/// Whether it is shown how the volume is stored, and what its overlap test takes; a situation that says neither has the
/// lesson's own.
struct CloudTables final : Tables {
  bool stored = false, tested = false;
};

/// The volume at the current step, if the lesson asks for it with "stored". What the run has not found yet is a dash.
[[nodiscard]] std::vector<StoredVolume> stored_fit(const Session& session);

}  // namespace snug::lesson
