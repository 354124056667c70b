// Points in any number, to measure how a time grows with it.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "geometry/generate.hpp"
#include "geometry/point_set.hpp"

namespace snug::cost {

/// A set of each size is made once and kept. A million points take longer than a page may delay a frame, so they are
/// made piece by piece.
class PointStock {
 public:
  /// Points of a kind (geometry/generate.hpp). kind: a known one.
  PointStock(std::string kind, int dim, bool single, std::uint64_t seed);
  /// Samples of a set, which outlives them.
  PointStock(const AnyPointSet& points, std::uint64_t seed);

  /// Does one piece of the work. Returns whether there are n points now.
  bool make(Index n);
  /// The set of n points; makes what is missing.
  [[nodiscard]] const AnyPointSet& of(Index n);

 private:
  using Points = std::variant<std::vector<Vector<double, 2>>, std::vector<Vector<double, 3>>,
                              std::vector<Vector<float, 2>>, std::vector<Vector<float, 3>>>;  // as AnyPointSet
  [[nodiscard]] const AnyPointSet* find(Index n) const;
  void begin(Index n);

  const AnyPointSet* whole_ = nullptr;  // the set that samples are taken from
  std::function<PointStream(Index n)> open_;
  Points none_;  // empty, of the wanted scalar and dimension
  std::map<Index, AnyPointSet> kept_;
  Index making_ = 0;  // the size of the set under construction
  PointStream next_;
  Points made_;
};

}  // namespace snug::cost
