// Draws a field of boxes and the frustum that flies over it; for this folder only.
#pragma once

#include <memory>
#include <optional>

#include "app/brush.hpp"
#include "app/panel_words.hpp"
#include "lesson/subjects/field/field.hpp"

namespace snug::app {

/// Thousands of boxes as marks, made anew when their answers, the colours or the stage's coordinates change.
class FieldMarks {
 public:
  /// Hands them to the graphics.
  void show(Brush& brush);

 private:
  void fill(const Brush& brush);
  std::shared_ptr<GlMarks> marks_;
  std::uint64_t revision_ = 0;
  const Palette* palette_ = nullptr;
  Frame frame_;
};

/// The vertices of the frustum as those of a box whose axes are right, up and back.
[[nodiscard]] std::optional<Polytope> frustum_solid(const lesson::FieldRecipe& recipe, const lesson::CameraPose& pose);

/// Draws the frustum of this frame and the frame before, the plane that is tested, and the tree's nodes.
void draw_field(Brush& brush);
/// Draws what the camera sees, in a corner of the stage, below a height. Returns the room that it takes.
[[nodiscard]] Rect draw_camera_image(Brush& brush, ImVec2 at);

/// What each method costs, measured one after the other while nothing moves, and a slow one over several frames: to
/// measure all of them would take longer than a frame.
class FieldCosts {
 public:
  struct Entry {
    const lesson::Method* method = nullptr;
    lesson::FieldMeasured measured;
    std::uint64_t stage = 0;  // the number of the stage that it was measured on
  };
  /// Goes on measuring, if the stage has not changed since the last frame.
  void measure(const lesson::Session& session);
  [[nodiscard]] bool working() const { return working_; }
  /// Null if it has never been measured.
  [[nodiscard]] const Entry* of(const lesson::Method& method) const;
  /// Whether it was measured on what stands there now.
  [[nodiscard]] bool is_of_now(const Entry& entry) const { return entry.stage == stage_; }

 private:
  void measure_next(const lesson::Session& session, const lesson::Method& method);

  std::vector<Entry> entries_;
  std::optional<lesson::FieldMeasuring> at_work_;
  const lesson::Method* measured_ = nullptr;  // by that
  std::uint64_t stage_ = 0;
  lesson::Rows rows_;  // of that stage, and its seed
  std::uint64_t seed_ = 0;
  bool working_ = false;
};

/// Draws a row for each method: the share of plane tests that it makes, and its time. What an open question asks is
/// hidden. Returns the height.
float draw_field_panel(const Look& look, const lesson::Session& session, const FieldCosts& costs, ImVec2 at,
                       float width);
/// The same in words.
[[nodiscard]] PanelWords field_in_words(const lesson::Session& session, const FieldCosts& costs);

}  // namespace snug::app
