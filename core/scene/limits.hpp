// Defaults of effects.
#pragma once

namespace snug::scene::limits {

/// How many places a trail keeps if its length is not declared.
inline constexpr int kTrailPlaces = 60;

}  // namespace snug::scene::limits
