// What a chart is drawn with: a pen for the screen, and one that writes SVG (app/chart_svg.hpp). The layout is the
// chart's own, so that both show the same.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "app/look.hpp"
#include "app/marks.hpp"

namespace snug::app {

/// No fill, or no line.
inline constexpr Color kNoColor = 0;

class ChartPen {
 public:
  ChartPen() = default;
  virtual ~ChartPen() = default;
  ChartPen(const ChartPen&) = delete;
  ChartPen& operator=(const ChartPen&) = delete;

  virtual void line(ImVec2 a, ImVec2 b, Color color, float width = 1) = 0;
  virtual void path(std::span<const ImVec2> points, Stroke stroke, Color color, float width) = 0;
  /// A convex one. fill, color: of its inside and its outline.
  virtual void polygon(std::span<const ImVec2> corners, Color fill, Color color, float width) = 0;
  virtual void disc(ImVec2 center, float radius, Color fill, Color color, float width) = 0;
  /// Its corners are rounded, and its line is one pixel wide.
  virtual void box(const Rect& rect, Color fill, Color color) = 0;
  /// at: as in app::text.
  virtual void words(const Look& look, Face face, float size, ImVec2 at, Color color, std::string_view words) = 0;
  virtual void halo_words(const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
                          std::string_view words) = 0;
  /// Until the next call, only what lies within is drawn; null: everything.
  virtual void clip(const Rect* within) = 0;
  /// Where a pointer is; none if nothing can be pointed at.
  [[nodiscard]] virtual std::optional<ImVec2> pointer() const = 0;
};

class ScreenPen final : public ChartPen {
 public:
  explicit ScreenPen(ImDrawList* list) : list_(list) {}
  void line(ImVec2 a, ImVec2 b, Color color, float width) override;
  void path(std::span<const ImVec2> points, Stroke stroke, Color color, float width) override;
  void polygon(std::span<const ImVec2> corners, Color fill, Color color, float width) override;
  void disc(ImVec2 center, float radius, Color fill, Color color, float width) override;
  void box(const Rect& rect, Color fill, Color color) override;
  void words(const Look& look, Face face, float size, ImVec2 at, Color color, std::string_view words) override;
  void halo_words(const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
                  std::string_view words) override;
  void clip(const Rect* within) override;
  [[nodiscard]] std::optional<ImVec2> pointer() const override { return ImGui::GetMousePos(); }

 private:
  ImDrawList* list_;
};

}  // namespace snug::app
