// What an address must say so that the points come out as they stand: nothing, the points that were moved, or all.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::web {

class SharedPoints {
 public:
  /// The session's points as they stand come from somewhere that an address can name: the lesson, a generator, a mesh,
  /// the start of the task. Points of the user's own file do not, and are passed over.
  void remember(const lesson::Session& session);
  void forget() { known_.clear(); }

  /// {how, moved: [[i, x, y(, z)] …]} against the nearest of the known sets, {points: [[x, y(, z)] …]} where none is
  /// near and there are few, or {} where an address cannot hold them. how: "" for the lesson's own, "clusters:200",
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
