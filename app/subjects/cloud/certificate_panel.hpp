// The certificate of a finished sphere, line by line, with its exact numbers.
#pragma once

#include "app/look.hpp"
#include "app/subjects/cloud/shown.hpp"

namespace snug::app {

/// Draws it beside the stage, while no question hides the result, and returns its height. pointed: becomes the point
/// whose row the pointer is on; kNoIndex for none.
float draw_certificate_panel(const Look& look, const lesson::Session& session, const CloudShown& shown, ImVec2 at,
                             float width, Index& pointed);

}  // namespace snug::app
