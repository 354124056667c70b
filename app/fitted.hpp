// Draws the fitted volume and those that it is compared with, in every subject.
#pragma once

#include "app/brush.hpp"

namespace snug::app {

/// Draws the current volume; a ball with its centre and radius.
void draw_fitted(Brush& brush, const Shown& shown);
/// Draws the other algorithm's volume and the smallest one.
void draw_compared(Brush& brush, const Shown& shown);

}  // namespace snug::app
