// Where somebody stands in a lesson, as one value with one text: the page's address. What is kept, a link, a demo's
// state and a picture's source are that text.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lesson/session.hpp"

namespace snug::lesson {

struct Place {
  static constexpr int kLastStep = -1;
  std::string lesson;                 // its id
  std::string situation;              // empty: the question's, or the lesson's own
  std::string algorithm;              // empty: the question's, or the lesson's first
  std::optional<std::string> beside;  // "" for none; no value: the lesson's own
  std::string scalar;                 // "float" or "double"; empty: the situation's own
  std::optional<std::uint64_t> seed;
  std::string from;  // "bunny", "clusters:200", "task:2"; empty: the situation's own points
  std::vector<double> sliders;
  std::vector<double> camera;  // as app::App::hand_view has it; empty: as the lesson has it
  Rows rows, moved;            // all rows, which many have packed (packed_rows.hpp); some, each after its index
  std::string file, draft;     // how the stage's text differs from the lesson's, and what was typed from that
                               // (text_change.hpp)
  std::optional<int> step;     // or kLastStep; not together with a question, which has its own
  std::string question;        // its id; empty for none
  bool answered = false;       // whether its model answer is given and its outcome shown, or else it is open

  /// Whether it names no more than a lesson.
  [[nodiscard]] bool is_bare() const;
};
/// Whether both have the same text.
[[nodiscard]] bool operator==(const Place& a, const Place& b);

/// The keys of a place: their names in a demo's file and in an address, in the order in which both write them, so that
/// both make the same code of a state.
struct PlaceKey {
  enum class Part : std::uint8_t {
    kLesson,
    kStep,
    kSeed,
    kSituation,
    kAlgorithm,
    kBeside,
    kScalar,
    kFrom,
    kSliders,
    kMoved,
    kRows,
    kPacked,
    kCamera,
    kFile,
    kDraft,
    kQuestion,
    kAnswered
  } part;
  std::string_view in_file, in_address;
  bool is_number = false;
};
inline constexpr std::array<PlaceKey, 17> kPlaceKeys{{{PlaceKey::Part::kLesson, "lesson", "lesson"},
                                                      {PlaceKey::Part::kStep, "step", "step", true},
                                                      {PlaceKey::Part::kSeed, "seed", "seed", true},
                                                      {PlaceKey::Part::kSituation, "situation", "situation"},
                                                      {PlaceKey::Part::kAlgorithm, "algorithm", "a"},
                                                      {PlaceKey::Part::kBeside, "compare", "b"},
                                                      {PlaceKey::Part::kScalar, "scalar", "scalar"},
                                                      {PlaceKey::Part::kFrom, "from", "from"},
                                                      {PlaceKey::Part::kSliders, "sliders", "slide"},
                                                      {PlaceKey::Part::kMoved, "moved", "moved"},
                                                      {PlaceKey::Part::kRows, "rows", "rows"},
                                                      {PlaceKey::Part::kPacked, "packed", "packed"},
                                                      {PlaceKey::Part::kCamera, "camera", "camera"},
                                                      {PlaceKey::Part::kFile, "file", "file"},
                                                      {PlaceKey::Part::kDraft, "draft", "draft"},
                                                      {PlaceKey::Part::kQuestion, "question", "question"},
                                                      {PlaceKey::Part::kAnswered, "answered", "answered"}}};

/// The value of a key as an address has it; empty for none.
[[nodiscard]] std::string text_of(const Place& place, PlaceKey::Part part);
/// Reads the value of a key. Returns what is wrong with it, as the end of a sentence that begins with the key's name;
/// empty for nothing.
[[nodiscard]] std::string read_text(Place& place, PlaceKey::Part part, const std::string& text);

/// An address writes up to this many rows as decimals, and packs more. In full precision they take about 4000
/// characters, which every browser and server accepts.
inline constexpr std::size_t kMostPlainRows = 64;
/// "?lesson=ID&step=3&seed=7". Packed rows stand after a #, because servers refuse long addresses and are not sent that
/// part.
[[nodiscard]] std::string address_of(const Place& place);
/// Whether an address has room for all of it. One that has not leaves out the rows.
[[nodiscard]] bool fits_address(const Place& place);
/// What an address says, with a sentence for each mistake in it, which is left out. Keys of others are passed over.
struct PlaceRead {
  Place place;
  std::vector<std::string> problems;
};
[[nodiscard]] PlaceRead read_place(std::string_view address);

/// Why a place cannot be shown, and which of its keys, by its name in a file, is at fault.
struct PlaceFault {
  std::string key;
  InputError error;
};
using MeshOf = std::function<tl::expected<io::PointFile, InputError>(const std::string&)>;

/// Brings a session of the place's lesson, just opened, to it part by part. A part may need a preparation
/// (Stage::preparing), which has to be done before the next.
class WayTo {
 public:
  WayTo(Place place, MeshOf mesh) : place_(std::move(place)), mesh_(std::move(mesh)) {}
  /// The mesh that is needed on it; empty for none.
  [[nodiscard]] std::string mesh_needed(const Lesson& lesson) const;
  [[nodiscard]] const Place& place() const { return place_; }
  [[nodiscard]] bool done() const;
  /// Goes the next part, and returns its key.
  tl::expected<std::string_view, PlaceFault> go_on(Session& session);

 private:
  Place place_;
  MeshOf mesh_;
  std::size_t next_ = 0;
};
/// The whole way at once, up to the first fault.
[[nodiscard]] tl::expected<void, PlaceFault> go_to(const Place& place, Session& session, const MeshOf& mesh);
/// From what stands on the stage to the place's situation, algorithm, and step or question. Errors: the lesson has no
/// such situation, algorithm or question; the run has no such step; the question does not come on what is on the stage.
[[nodiscard]] Done go_in_run(const Place& place, Session& session);

/// "clusters:200" in its parts. None if it is neither a name nor a name and a whole number from 1.
struct SourceWords {
  std::string_view name;
  std::optional<int> number;
};
[[nodiscard]] std::optional<SourceWords> source_in(std::string_view from);

/// How an address names what the stage was filled from, apart from the seed: "" for the situation's own,
/// "clusters:200", "bunny", "task"; none if it cannot, as for the points of a file.
[[nodiscard]] std::optional<std::string> source_words(const Session& session);

/// Stages that an address can name, as they were before they were edited: of the lesson, a generator, a mesh, or the
/// start of a task. A place is told from the one that is nearest.
class NamedStages {
 public:
  /// Remembers what stands on a session's stage, if it comes from such a source.
  void remember(const Session& session);
  void forget() { known_.clear(); }
  /// Without any, all rows of a stage that was edited are told.
  [[nodiscard]] Place place_of(const Session& session) const;

 private:
  struct Known {
    std::string from;
    std::uint64_t seed;
    Snapshot stage;
  };
  [[nodiscard]] static Rows rows_from(const Known& known, const Session& session);
  std::vector<Known> known_;
};

/// Where a session stands, told from the stage that its source gives. Errors: those of opening the lesson's points.
[[nodiscard]] tl::expected<Place, InputError> place_now(const Session& session, const MeshOf& mesh);

}  // namespace snug::lesson
