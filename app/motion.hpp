// How a volume moves from one step to the next.
#pragma once

#include <optional>

#include "fit/any_step.hpp"

namespace snug::app {

/// Animates a volume from one step's to the next one's.
class Motion {
 public:
  /// The volume to draw. jump: go there at once.
  [[nodiscard]] std::optional<fit::Volume3> at(const std::optional<fit::Volume3>& target, bool jump, double now);
  [[nodiscard]] bool moving() const { return moving_; }

 private:
  std::optional<fit::Volume3> from_, to_, drawn_;
  double since_ = 0;
  bool moving_ = false;
};

}  // namespace snug::app
