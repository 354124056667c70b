// libFuzzer: what an address may ask of a lesson: any rows of numbers on its stage, any places of its sliders, any
// step, seed and algorithm. All of it is taken or refused with a sentence, and the lesson plays on.
#include <array>
#include <fstream>
#include <limits>
#include <sstream>

#include "fuzz/bytes.hpp"
#include "lesson/place.hpp"
#include "lesson/subjects.hpp"

namespace {

using namespace snug;
using fuzz::require;

/// One lesson a subject; fuzz.sh runs in the project's folder.
const std::vector<lesson::Lesson>& lessons() {
  static const std::vector<lesson::Lesson> read = [] {
    std::vector<lesson::Lesson> all;
    for (const char* name :
         {"sphere-ritter", "aabb", "swept-overlap", "obb-axes", "frustum-3d", "bvh-build", "scene-broad"}) {
      std::ifstream file("lessons/" + std::string(name) + ".toml");
      std::stringstream text;
      text << file.rdbuf();
      auto draft = lesson::read_draft(text.str(), name);
      if (draft.lesson && draft.mistakes.empty()) all.push_back(*std::move(draft.lesson));
    }
    require(all.size() == 7);
    return all;
  }();
  return read;
}

double any_number(fuzz::Bytes& bytes) {
  constexpr std::array kOdd{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e300,
                            -0.0, 5e-324};
  return bytes.below(16) == 0 ? kOdd[bytes.below(kOdd.size())] : bytes.number<double>();
}

void edit(lesson::Session& session, fuzz::Bytes& bytes) {
  lesson::Rows rows = session.stage().subject().rows();
  for (unsigned edits = bytes.below(4); edits > 0; --edits) {
    if (rows.empty() || bytes.below(8) == 0) {
      rows.emplace_back();
      continue;
    }
    auto& row = rows[bytes.byte() % rows.size()];
    if (row.empty() || bytes.below(8) == 0) row.push_back(any_number(bytes));
    else row[bytes.byte() % row.size()] = any_number(bytes);
  }
  const lesson::Rows before = session.stage().subject().rows();
  if (const auto done = session.stage().set_rows(rows); !done) {
    require(!done.error().message().empty());
    require(session.stage().subject().rows() == before);  // as if it had not been asked
  }
}

/// A few keys, each with a text of the letters that values are made of.
std::string any_address(fuzz::Bytes& bytes) {
  constexpr std::string_view kLetters = "0123456789,;:.-e%&#=?abcdeknort";
  std::string address = "?";
  for (unsigned keys = 1 + bytes.below(3); keys > 0; --keys) {
    address += std::string(lesson::kPlaceKeys[bytes.below(lesson::kPlaceKeys.size())].in_address) + '=';
    for (unsigned letters = bytes.below(16); letters > 0; --letters) address += kLetters[bytes.below(kLetters.size())];
    address += '&';
  }
  return address;
}

/// What is read of any address is gone to or refused with a sentence; and the address of what stands leads back to it.
void follow(lesson::Session& session, const std::string& address) {
  const lesson::MeshOf none = [](const std::string&) -> tl::expected<io::PointFile, InputError> {
    return tl::unexpected(InputError{.what = "no mesh"});
  };
  const lesson::PlaceRead read = lesson::read_place(address);
  for (lesson::WayTo way(read.place, none); !way.done();)
    if (const auto gone = way.go_on(session); !gone) require(!gone.error().error.message().empty());
  const lesson::Place here = lesson::NamedStages().place_of(session);
  if (lesson::fits_address(here)) require(lesson::read_place(lesson::address_of(here)).place == here);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  auto session = lesson::Session::open(lessons()[bytes.byte() % lessons().size()]);
  require(session.has_value());
  for (int turn = 0; turn < 3; ++turn) {
    edit(*session, bytes);
    if (bytes.below(4) == 0) session->stage().scatter(bytes.byte());
    if (bytes.below(4) == 0) session->stage().undo();
    session->jump(static_cast<int>(bytes.byte()) * session->player().steps() / 255);
    require(session->player().step() >= 0 && session->player().step() <= session->player().steps());
    require(session->telling().caption().find("nan") == std::string::npos);
  }
  follow(*session, any_address(bytes));
  return 0;
}
