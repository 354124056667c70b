// A lecturer's demo: an ordered list of states of lessons, each with its notes, its slide, and the hash of its trace.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "lesson/file_place.hpp"
#include "lesson/place.hpp"

namespace snug::lesson {

/// What may be shown beside the stage.
inline constexpr std::array<std::string_view, 4> kDemoParts{"caption", "prose", "numbers", "code"};
/// What a press may reveal besides: the steps to the end, played; the answer to the question that stands open.
inline constexpr std::string_view kRevealSteps = "steps", kRevealAnswer = "answer";

/// The words for a reveal: "the numbers".
[[nodiscard]] std::string_view revealed_text(std::string_view reveal);

/// A state: a place, and what is shown and said there.
struct DemoState : Place {
  std::vector<std::string> shows, reveal;
  std::string slide, notes;           // of the lecture; what is said
  std::optional<std::uint64_t> hash;  // none: not written yet

  FilePlace place;                                             // its header's
  bool in_braces = false;                                      // it has no lines of its own
  std::vector<std::pair<std::string, FilePlace>> places = {};  // those of its keys
  [[nodiscard]] FilePlace place_of(std::string_view key) const;
};

struct Demo {
  std::string id, title, lecture;
  std::vector<DemoState> states;
};

/// What was read; of no use if there are mistakes.
struct DemoDraft {
  Demo demo;
  std::vector<FileError> mistakes;
};
[[nodiscard]] DemoDraft read_demo(std::string_view toml, std::string_view name);

/// Passes all questions of this run that are still open, and comes back: what plays then stops nowhere.
void pass_questions(Session& session);

/// A place as a [[state]] of a demo's file, to which its notes are written by hand. title: of the lesson; hash: of its
/// trace.
[[nodiscard]] std::string state_text(const Place& place, std::string_view title, std::uint64_t hash);

/// The file with each state's hash written, and all else as it is. hashes: one for each state. Errors: a state in
/// braces, or written otherwise so that its hash cannot be found.
[[nodiscard]] tl::expected<std::string, FileError> with_hashes(std::string_view toml, const Demo& demo,
                                                               const std::vector<std::uint64_t>& hashes);

}  // namespace snug::lesson
