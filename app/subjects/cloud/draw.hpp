// What a fitter's step draws; for this folder only.
#pragma once

#include "app/point_marks.hpp"
#include "app/subjects/cloud/shown.hpp"

namespace snug::app {

void draw_cloud(Brush& brush, const CloudShown& shown);
void mark_cloud(Brush& brush, const CloudShown& shown);
void name_cloud(PointNames& names, const CloudShown& shown);

/// Draws the slab of a k-DOP with its direction; marks and names the points on its planes.
void draw_slab(Brush& brush, const CloudShown& shown);
void mark_slab(Brush& brush, const CloudShown& shown);
void name_slab(PointNames& names, const CloudShown& shown);
/// Draws the hull of a box fitter, the edges of it that a box was built on, and the projection behind a rectangle.
void draw_box_fit(Brush& brush, const CloudShown& shown);
/// Draws Quickhull's hull so far, and what the step does with it; fades the points that it dropped.
void draw_growing_hull(Brush& brush, const CloudShown& shown);
/// Draws the lengths of Ritter's formula, where the step lets a sphere grow.
void draw_growth(Brush& brush, const CloudShown& shown);
/// In 2-D, draws a product as the rectangle between a point and the mean or the origin.
void draw_products(Brush& brush, const CloudShown& shown);
/// Draws mean, covariance and axes.
void draw_spread(Brush& brush, const CloudShown& shown);
/// Draws the first diameter; along the main axis, with the projections that determined it.
void draw_axis_ends(Brush& brush, const CloudShown& shown);

}  // namespace snug::app
