// What an address needs to restore the current state of any subject (lesson::Rows): nothing, the changed rows, or all
// of them.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::web {

class SharedRows {
 public:
  /// Remembers the session's current state, if it comes from a source that an address can name: the lesson, a
  /// generator, a mesh, or the start of the task. Points from the user's file are ignored.
  void remember(const lesson::Session& session);
  void forget() { known_.clear(); }

  /// {how, moved: [[i, numbers …] …]} relative to the nearest known state; {rows: [[numbers …] …]} if none is near and
  /// there are few rows; {packed} if there are more (lesson/packed_rows.hpp); or {} if an address cannot hold them.
  /// how: "" for the situation's own, "clusters:200", "bunny", "task". slide: the sliders' values, if any has moved; a
  /// known state is near if they lead there.
  [[nodiscard]] emscripten::val describe(const lesson::Session& session) const;

 private:
  struct Known {
    std::string how;
    std::uint64_t seed;
    lesson::Snapshot state;
  };
  [[nodiscard]] static lesson::Rows rows_from(const Known& known, const lesson::Session& session);

  std::vector<Known> known_;
};

/// Replaces all rows; or some, each given after its index. Returns "" or why that is impossible.
[[nodiscard]] std::string take_rows(lesson::Session& session, const emscripten::val& rows);
[[nodiscard]] std::string take_packed(lesson::Session& session, const std::string& packed);
[[nodiscard]] std::string take_changes(lesson::Session& session, const emscripten::val& moved);

}  // namespace snug::web
