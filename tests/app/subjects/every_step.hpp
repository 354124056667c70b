// Lessons of two boxes, or of a box and a frustum, at every step.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "../course_lessons.hpp"
#include "lesson/boxes.hpp"
#include "lesson/session.hpp"

namespace snug::app {

inline lesson::Session lesson_session(const std::string& id, bool asks) {
  return *lesson::Session::open(course_lesson(id, asks));
}

/// "—" where there is none.
inline std::string figure(const lesson::Session& session, std::string_view key) {
  for (const lesson::Figure& figure : session.telling().figures())
    if (figure.key == key) return figure.text;
  return "—";
}

/// Lessons with every method, on the boxes as they stand, scattered, and thrown into each other.
template <class Check>
void at_every_step(const char* id, Check check) {
  for (int seed = 0; seed < 6; ++seed) {
    lesson::Session session = lesson_session(id, false);
    if (seed > 0) session.stage().scatter(static_cast<std::uint64_t>(seed));
    if (seed == 5) {
      lesson::BoxPair pair = boxes_of(session.stage().subject());
      pair.boxes[0].center = pair.boxes[1].center;
      REQUIRE(set_boxes(session, pair).has_value());
    }
    for (const std::string& method : session.lesson().algorithms) {
      CAPTURE(id);
      CAPTURE(seed);
      CAPTURE(method);
      REQUIRE(session.player().choose(0, method).has_value());
      for (int step = 0; step <= session.player().steps(); ++step) {
        session.jump(step);
        CAPTURE(step);
        CAPTURE(session.telling().caption());
        check(session);
      }
    }
  }
}

}  // namespace snug::app
