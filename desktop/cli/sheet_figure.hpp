// The picture of an instance on paper: in the plane on squared paper, in space in projection.
#pragma once

#include <array>
#include <string>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

#include "desktop/cli/sheet_page.hpp"
#include "geometry/input_error.hpp"
#include "lesson/session.hpp"

namespace snug::desktop {

using Outline = std::vector<lesson::Point3>;

/// Outlines, of which the dashed ones are a frustum's or a run's, edges in space, and named points and sides.
struct SheetFigure {
  int dim = 2;
  std::vector<Outline> solid, dashed;
  std::vector<std::array<lesson::Point3, 2>> edges;
  std::vector<std::pair<std::string, lesson::Point3>> points, sides;
};

/// Errors: there is nothing on the stage that can be drawn.
[[nodiscard]] tl::expected<SheetFigure, InputError> figure_of(const lesson::Session& session);

/// room: how high it may be. around: how much wider the squared paper is than what stands on it, 1 for as wide.
void draw(SheetPage& page, const SheetFigure& figure, double top, double room, double around = 1);

/// The numbers of what is drawn, a text for each thing: "P0 (0.12, −0.44)".
[[nodiscard]] std::vector<std::string> numbers_of(const lesson::Session& session);

/// Texts side by side, in columns of one width. Returns where the next line would be.
double columns(SheetPage& page, double y, const std::vector<std::string>& texts);

}  // namespace snug::desktop
