// The stage's side of a prose that speaks to it: a lit mark asks for a frame and lets go of it, and the handle in hand
// tells which of the prose's marks it belongs to.
#include <doctest/doctest.h>

#include <algorithm>

#include "app/look.hpp"
#include "bench.hpp"

namespace snug::app {
namespace {

/// Ritter's pair is P0 and P1; the prose links to it, to what supports the circle and to P2.
lesson::Lesson with_marks() {
  lesson::Lesson lesson;
  lesson.id = "test";
  lesson.points.list = {{-2, 0, 0}, {2, 0, 0}, {0, 1.6, 0}, {0, -1.6, 0}, {0.2, 0.1, 0}};
  lesson.algorithms = {"ritter"};
  lesson::Section section;
  for (const char* mark : {"pair_chosen", "P2"})
    section.blocks.push_back(
        {.rows = {{lesson::Paragraph{{.text = "words", .link = lesson::Link{lesson::Link::Kind::kMark, mark}}}}}});
  lesson.sections = {section};
  return lesson;
}

bool are_drawn(const std::vector<DrawnWords>& drawn, std::string_view words) {
  return std::any_of(drawn.begin(), drawn.end(), [&](const DrawnWords& one) { return one.words == words; });
}

}  // namespace

TEST_CASE("a handle under the pointer belongs to the marks that the prose links to") {
  Bench bench(with_marks());
  bench.session().jump(2);
  bench.frames(3);
  CHECK(bench.app.marks_in_hand().empty());
  const auto marks_over = [&](const char* name) {
    const Handle at = bench.handle(name);
    bench.move(at.x, at.y);
    return bench.app.marks_in_hand();
  };
  CHECK(marks_over("P0") == std::vector<std::string_view>{"pair_chosen"});
  CHECK(marks_over("P2") == std::vector<std::string_view>{"P2"});
  CHECK(marks_over("P4").empty());
}

TEST_CASE("a mark that is lit asks for a frame, and so does one that goes out") {
  Bench bench(with_marks());
  bench.session().jump(2);
  bench.frames(3);
  const auto asks = [&] { return bench.app.wants_frame(0); };
  REQUIRE_FALSE(asks());
  bench.app.light("pair_chosen");
  CHECK(asks());
  bench.frames(2);
  CHECK_FALSE(asks());
  bench.app.light("pair_chosen");  // as it is already
  CHECK_FALSE(asks());
  bench.app.light("");
  CHECK(asks());
}

TEST_CASE("a lit handle bears its name, even among so many that none has room for its own") {
  lesson::Lesson many = with_marks();
  many.points = {.dim = 2, .generate = "gaussian", .count = 120};
  Bench bench(std::move(many));
  std::vector<DrawnWords> drawn;
  bench.app.note_words(&drawn);
  bench.frames(2);
  CHECK_FALSE(are_drawn(drawn, "P2"));
  drawn.clear();
  bench.app.light("P2");
  bench.frames(1);
  CHECK(are_drawn(drawn, "P2"));
  bench.app.note_words(nullptr);
}

}  // namespace snug::app
