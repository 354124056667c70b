// What effects keep where their declaration does not say.
#pragma once

namespace snug::scene::limits {

/// How many places a trail keeps where its length is not declared.
inline constexpr int kTrailPlaces = 60;

}  // namespace snug::scene::limits
