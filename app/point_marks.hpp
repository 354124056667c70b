// The marks on points and other handles that subjects share, and the names beside them.
#pragma once

#include <string>
#include <vector>

#include "app/brush.hpp"

namespace snug::app {

/// The distance from the middle of the mark to its edge, pixels.
inline constexpr float kDiamond = 7.5f, kRing = 11;

/// Draws a diamond that labels keep clear of: the point was chosen, or supports the volume.
void mark_point(Brush& brush, Index i);
/// Marks the points that support the volume.
void draw_support(Brush& brush, const Shown& shown);
/// Marks the points that the step is about.
void draw_spoken_of(Brush& brush, const Shown& shown);
/// Marks the examined point. marked: whether it already has a diamond.
void draw_examined(Brush& brush, const Shown& shown, bool marked);

[[nodiscard]] bool among(const std::vector<Index>& points, Index i);

/// Names beside handles, away from the middle of the picture. Each handle is named once, as first requested.
class PointNames {
 public:
  PointNames(Brush& brush, const Point3& middle);
  void name(Index i, std::string words, Color color, Face face, float gap, float size = 14, bool optional = false);
  /// Names a handle that the step is about.
  void plain(Index i);
  /// The same of several, unless they are so many that their names would hide what they name.
  void plain(const std::vector<Index>& all);
  /// Names a handle that stands among many marks, which would show through a halo.
  void on_plate(Index i);
  /// Leaves out a handle that is named elsewhere.
  void skip(Index i) { named_[i] = true; }

  Brush& brush;

 private:
  std::vector<bool> named_;
  ImVec2 middle_;
};

}  // namespace snug::app
