// The volume that is fitted, and those that it is compared with: what subjects draw alike.
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// The volume as it stands; a ball with its centre and radius.
void draw_fitted(Brush& brush, const Shown& shown);
/// The other algorithm's volume and the smallest.
void draw_compared(Brush& brush, const Shown& shown);

}  // namespace snug::app
