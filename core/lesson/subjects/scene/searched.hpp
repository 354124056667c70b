// What a search for pairs compared in a frame: it is run again on the same boxes, the frame's AABBs with the room that
// the scene gave them, with an eye on each comparison.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "hierarchy/broad_phase/broad_phase.hpp"
#include "lesson/subjects/scene/scene_frames.hpp"
#include "lesson/subjects/scene/scene_set.hpp"

namespace snug::lesson {

/// The search of a method, or of the scene's own broad phase if the method is none. None if nothing searches, or if
/// bodies move by their velocities: then the search widens the AABBs by how far they may move, which no frame keeps.
[[nodiscard]] std::optional<hierarchy::PairSearch> search_shown(const SceneSet& set, std::string_view method);

/// Each pair of bodies whose AABBs the search compared in the frame.
[[nodiscard]] std::vector<BodyPair> pairs_compared(const SceneFrame& frame, hierarchy::PairSearch search);

/// The bodies that one was compared with, rising.
[[nodiscard]] std::vector<Index> compared_with(std::span<const BodyPair> compared, Index body);

/// The bodies that were compared with the most others, rising; none if there was no comparison.
[[nodiscard]] std::vector<Index> most_compared(std::span<const BodyPair> compared, std::size_t bodies);

/// The active list of a sweep when it comes to a body: those that begin before it and have not ended, in the sweep's
/// order.
[[nodiscard]] std::vector<Index> active_list(const SceneFrame& frame, Index body);

}  // namespace snug::lesson
