// Where one stands in a lesson, as a state of a demo and as the page's address.
#pragma once

#include <string>

#include "lesson/demo.hpp"

namespace snug::lesson {

/// The keys that describe a place in a lesson: their names in a demo's file and in the page's address, in the order in
/// which both write them, so that both make the same code of a state.
struct PlaceKey {
  std::string_view in_file, in_address;
  bool is_number = false;
};
inline constexpr std::array<PlaceKey, 13> kPlaceKeys{{{"lesson", "lesson"},
                                                      {"step", "step", true},
                                                      {"seed", "seed", true},
                                                      {"situation", "situation"},
                                                      {"algorithm", "a"},
                                                      {"compare", "b"},
                                                      {"scalar", "scalar"},
                                                      {"from", "from"},
                                                      {"sliders", "slide"},
                                                      {"moved", "moved"},
                                                      {"rows", "rows"},
                                                      {"packed", "packed"},
                                                      {"camera", "camera"}}};

/// How an address names what the stage was filled from, apart from the seed: "" for the situation's own,
/// "clusters:200", "bunny", "task"; none if it cannot, as for the points of a file.
[[nodiscard]] std::optional<std::string> source_words(const Session& session);

/// An address writes up to this many rows as decimals, and packs more. In full precision they take about 4000
/// characters, which every browser and server accepts.
inline constexpr std::size_t kMostPlainRows = 64;

/// The state that brings a session of the lesson to where this one stands. Errors: those of opening the lesson's
/// points.
[[nodiscard]] tl::expected<DemoState, InputError> state_now(const Session& session, const MeshOf& mesh);
/// "?lesson=ID&step=3&seed=7". Packed rows stand after a #, because servers refuse long addresses and are not sent that
/// part.
[[nodiscard]] std::string address_of(const DemoState& state);
/// The state as a [[state]] of a demo's file, to which its notes are written by hand. title: of the lesson; hash: of
/// its trace.
[[nodiscard]] std::string state_text(const DemoState& state, std::string_view title, std::uint64_t hash);

}  // namespace snug::lesson
