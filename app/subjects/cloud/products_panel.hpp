// The table of the products that a covariance is the sum of, beside the stage.
#pragma once

#include "app/look.hpp"
#include "lesson/session.hpp"

namespace snug::app {

/// Draws it if the run adds products, in 2-D. Returns its height; 0 if there is none.
float draw_products_panel(const Look& look, const lesson::Session& session, ImVec2 at, float width);

}  // namespace snug::app
