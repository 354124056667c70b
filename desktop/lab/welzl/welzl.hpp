// What you write: see welzl.cpp.
#pragma once

#include <snug/geometry/sphere.hpp>
#include <vector>

/// The smallest sphere that contains all points, of which there is at least one.
snug::Sphere<double, 3> smallest(std::vector<snug::Vector<double, 3>> points);
