// FCL's rectangle-swept spheres, behind a few functions: its headers want compiler flags of their own.
#pragma once

#include <memory>
#include <vector>

#include "geometry/lozenge.hpp"

namespace snug::bench {

class FclRss {
 public:
  /// Converted once, outside what is timed.
  explicit FclRss(const std::vector<Lozenge<double, 3>>& lozenges);
  ~FclRss();

  /// How many of the pairs 0 and 1, 2 and 3, ... overlap.
  [[nodiscard]] int overlapping_pairs() const;

 private:
  struct All;
  std::unique_ptr<All> all_;
};

}  // namespace snug::bench
