// The close-up that a lesson's file may ask for: a part of the stage, magnified in one of its corners.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "app/brush.hpp"

namespace snug::app {

/// Where a place of a lesson's file is now: both ends of a gap, or the same point twice. None if there is no such
/// handle, or no gap.
[[nodiscard]] std::optional<std::array<Point3, 2>> ends_of(const lesson::StagePlace& place, const SubjectView& view,
                                                           const lesson::Session& session);

/// What it shows, and where; none if the lesson has none, if the gap is so wide that it needs none, or if the stage has
/// no room for it. top: below the stage's buttons; last: the panel of the last frame, which it keeps if no handle is
/// under it.
[[nodiscard]] std::optional<CloseUp> close_up_of(const Brush& brush, float top, const Rect& last);

/// Where a panel covers the fewest handles, none where there is no room. source: what it shows, on the screen;
/// may_shrink: to a smaller panel, or into the middle, if only that covers no handle.
[[nodiscard]] std::optional<Rect> free_place(const Brush& brush, ImVec2 source, float top, const Rect& last,
                                             bool may_shrink);

/// How much of a narrow stage is kept free above the picture, so that the close-up covers no handle; words: their
/// scale.
[[nodiscard]] float room_above(float words);

/// The part of the panel with the picture, below its title.
[[nodiscard]] Rect picture_of(const CloseUp& close_up, const Look& look);

/// The strip at the picture's foot in which its scale is written, and no label.
inline constexpr float kScaleHeight = 20;

/// Marks the place on the stage, and draws the panel with its title; then the picture's scale.
void draw_close_up_panel(const Brush& brush, const CloseUp& close_up);
void draw_close_up_scale(const Brush& brush, const CloseUp& close_up);

}  // namespace snug::app
