// A lesson small enough to work out by hand, and how tests open it.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "check/check_lesson.hpp"
#include "lesson/session.hpp"

namespace snug::test {

/// Ritter's run: 0 extremes, 1 pair P0 and P1, 2 to 5 P0 to P3 inside, 6 P4 outside, 7 grown from radius 2 to 2.25,
/// 8 P5 inside, 9 checked, 10 finished. The smallest circle goes through P0, P1 and P4: radius 2.05.
inline constexpr std::string_view kSmallLesson = R"(version = 2
title = "Small"
summary = "A lesson for tests."
minutes = 3
covers = ["A lecture: a slide"]
seed = 5
algorithms = ["ritter", "welzl", "brute_force"]
meshes = ["bunny"]
generators = ["cube", "gaussian"]

[points]
dim = 2
list = [[-2, 0], [2, 0], [0, 1], [0, -1], [0, 2.5], [0.5, 0.2]]

[[section]]
title = "First"
text = """
A **term** stands here
over two lines.

Another paragraph.
"""

[[question]]
id = "pair"
algorithm = "ritter"
before = "pair_chosen"
asks = "axis"
prompt = "Which pair?"
because = "It is farther apart."

[[question]]
id = "growth"
algorithm = "ritter"
before = "ball_grown"
after = "pair_chosen"
asks = "point"
prompt = "Which point?"
because = "It lies outside."

[[question]]
id = "again"
algorithm = "ritter"
before = "radius_checked"
asks = "grows"
prompt = "Does it grow?"
because = "All are inside."

[[question]]
id = "number"
algorithm = "ritter"
before = "finished"
asks = "choice"
prompt = "How many passes?"
choices = ["one", "three"]
answer = "three"
holds = "here"
wrong = { one = "That one finds the extremes." }
because = "Extremes, growth, check."

[[task]]
prompt = "Make it fail."
algorithm = "ritter"
points = 4
hint = "Think."
model = [[-2, 0], [2, 0], [0, -1], [0, 2.5]]

[[task.require]]
figure = "excess"
at_least = 5
)";

/// Its first paragraph.
inline constexpr std::string_view kSmallText = "A **term** stands here\nover two lines.";

/// The small lesson with one stretch of it replaced.
inline std::string small_lesson_with(std::string_view from, std::string_view to) {
  std::string text(kSmallLesson);
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// The warnings of a lesson's text, without those of wrong answers that have no reason: the small lesson has few.
inline std::vector<lesson::FileError> warned(std::string_view text) {
  lesson::Draft draft = check::checked_draft(text, "small.toml");
  REQUIRE_MESSAGE(draft.mistakes.empty(), draft.mistakes.front().message());
  std::erase_if(draft.warnings, [](const auto& one) { return one.what.starts_with("\"wrong\" has no reason"); });
  return std::move(draft.warnings);
}
/// The same, a line each.
inline std::string warnings_of(const std::string& text) {
  std::string all;
  for (const lesson::FileError& warning : warned(text)) all += warning.message() + "\n";
  return all;
}

inline lesson::Session open(const std::string& text) {
  auto read = check::checked_lesson(text, "small.toml");
  REQUIRE_MESSAGE(read.has_value(), (read ? "" : read.error().message()));
  auto session = lesson::Session::open(*std::move(read));
  REQUIRE(session.has_value());
  return *std::move(session);
}

inline lesson::Session open_small() { return open(std::string(kSmallLesson)); }

inline lesson::Answer choice(int value) { return lesson::OneChoice{value}; }
inline lesson::Answer point(int value) { return lesson::OneHandle{value}; }

/// Answers everything that is asked with the model answer, to the end.
inline void play_to_end(lesson::Session& session) {
  for (int turns = 0; session.player().step() < session.player().steps() || session.conversation().asked() != nullptr;
       ++turns) {
    REQUIRE(turns < 10000);
    if (const auto* asked = session.conversation().asked())
      REQUIRE(session.conversation().give(lesson::model_answer(*asked, session.player().run(0))));
    else session.forward();
  }
}

}  // namespace snug::test
