// Points in any number, for who wants to know how a time grows with it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "geometry/generate.hpp"
#include "geometry/point_set.hpp"

namespace snug::cost {

/// Each number of points is made once and kept. A million of them take longer than a page may keep a frame waiting:
/// they are made piece by piece.
class PointStock {
 public:
  /// Points of a kind (geometry/generate.hpp). kind: a known one.
  PointStock(std::string kind, int dim, bool single, std::uint64_t seed);
  /// Samples of a set, which outlives them.
  PointStock(const AnyPointSet& points, std::uint64_t seed);

  /// One piece of the work; whether there are n points now.
  bool make(Index n);
  /// Makes what is not there yet.
  [[nodiscard]] const AnyPointSet& of(Index n);

 private:
  using Points = std::variant<std::vector<Vector<double, 2>>, std::vector<Vector<double, 3>>,
                              std::vector<Vector<float, 2>>, std::vector<Vector<float, 3>>>;  // as AnyPointSet
  [[nodiscard]] const AnyPointSet* find(Index n) const;
  void begin(Index n);

  const AnyPointSet* whole_ = nullptr;  // that samples are taken of
  std::function<PointStream(Index n)> open_;
  Points none_;  // of the scalar and dimension that are wanted
  std::map<Index, AnyPointSet> kept_;
  Index making_ = 0;  // how many the points in the making are to become
  PointStream next_;
  Points made_;
};

}  // namespace snug::cost
