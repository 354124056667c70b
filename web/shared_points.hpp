// What an address must say so that the points come out as they stand: nothing, the points that were moved, or all.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::web {

class SharedPoints {
 public:
  /// The session's points as they stand are what `how` and the seed lead to. how: "" for the lesson's own.
  void remember(const lesson::Session& session, std::string how);
  void forget() { known_.clear(); }

  /// {how, seed, moved: [[i, x, y(, z)] …]} against the nearest of the known sets, {points: [[x, y(, z)] …]} where none
  /// is near and there are few, or {} where an address cannot hold them.
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
