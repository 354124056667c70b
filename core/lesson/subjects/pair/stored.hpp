// How the volumes of a pair are stored.
#pragma once

#include "lesson/stored.hpp"

namespace snug::lesson {

/// Those that [volumes] asks for with "stored".
[[nodiscard]] std::vector<StoredVolume> stored_volumes(const Session& session);

}  // namespace snug::lesson
