// What an address needs to restore the current points: nothing, the moved points, or all of them.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::web {

class SharedPoints {
 public:
  /// Remembers the session's current points, if they come from a source that an address can name: the lesson, a
  /// generator, a mesh, or the start of the task. Points from the user's file are ignored.
  void remember(const lesson::Session& session);
  void forget() { known_.clear(); }

  /// {how, moved: [[i, x, y(, z)] …]} relative to the nearest known set; {points: [[x, y(, z)] …]} if no set is near
  /// and there are few points; or {} if an address cannot hold them. how: "" for the lesson's own, "clusters:200",
  /// "bunny", "task".
  [[nodiscard]] emscripten::val describe(const lesson::Session& session) const;

 private:
  struct Known {
    std::string how;
    std::uint64_t seed;
    int dim;
    std::vector<Vector<double, 3>> points;
  };
  std::vector<Known> known_;
};

}  // namespace snug::web
