// What you write: see ritter.cpp.
#pragma once

#include <snug/geometry/sphere.hpp>

/// Ritter's growing step. Returns the sphere as it is if it contains the point; else the smallest sphere that contains
/// both the sphere and the point. The radius may be 0.
snug::Sphere<double, 3> grow(const snug::Sphere<double, 3>& sphere, const snug::Vector<double, 3>& point);
