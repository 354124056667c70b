// A lecturer's demo: an ordered list of states of lessons, each with its notes, its slide, and the hash of its trace.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/file_place.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

/// What may be shown beside the stage.
inline constexpr std::array<std::string_view, 4> kDemoParts{"caption", "prose", "numbers", "code"};
/// What a press may reveal besides: the steps to the end, played; the answer to the question that stands open.
inline constexpr std::string_view kRevealSteps = "steps", kRevealAnswer = "answer";

/// The words for a reveal: "the numbers".
[[nodiscard]] std::string_view revealed_text(std::string_view reveal);

/// A state, in the words of the page's address.
struct DemoState {
  std::string lesson;                 // its id
  std::string situation;              // empty: the lesson's own
  std::string algorithm;              // empty: the lesson's first
  std::optional<std::string> beside;  // "" for none; no value: the lesson's own
  std::string scalar;                 // "float" or "double"; empty: the situation's own
  std::optional<std::uint64_t> seed;
  std::string from;  // "bunny", "clusters:200", "task:2"; empty: the situation's own points
  std::vector<double> sliders;
  std::vector<double> camera;  // as app::App::hand_view has it; empty: as the lesson has it
  Rows rows, moved;            // all rows, which many have packed (packed_rows.hpp); some, each after its index
  int step = 0;                // or Standpoint::kLastStep
  std::vector<std::string> shows, reveal;
  std::string slide, notes;           // of the lecture; what is said
  std::optional<std::uint64_t> hash;  // none: not written yet

  FilePlace place;                                             // its header's
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

/// Why a state cannot be shown, and which of its keys is at fault.
struct DemoFault {
  std::string key;
  InputError error;
};
using MeshOf = std::function<tl::expected<io::PointFile, InputError>(const std::string&)>;
/// Brings a session of the state's lesson, just opened, to that state, as the page does with an address.
[[nodiscard]] tl::expected<void, DemoFault> take_state(const DemoState& state, Session& session, const MeshOf& mesh);

/// Passes all questions of this run that are still open, and comes back: what plays then stops nowhere.
void pass_questions(Session& session);

/// The file with each state's hash written, the others' lines as they are. hashes: one for each state.
[[nodiscard]] std::string with_hashes(std::string_view toml, const Demo& demo,
                                      const std::vector<std::uint64_t>& hashes);

}  // namespace snug::lesson
