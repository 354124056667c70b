// What a sheet on paper is drawn with: text, lines and squares in SVG, in millimetres.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace snug::desktop {

// A4.
inline constexpr double kPageWidth = 210, kPageHeight = 297, kMargin = 20;
inline constexpr double kLine = 5.2;  // from one line of text to the next

/// "12.34"
[[nodiscard]] std::string mm(double value);

class SheetPage {
 public:
  void text(double x, double y, std::string_view words, double size = 3.9, const char* more = "");
  void line(double x1, double y1, double x2, double y2, const char* stroke = "#777");
  void polygon(const std::vector<std::array<double, 2>>& corners, bool dashed);
  void dot(double x, double y);
  /// A square beside each choice, to be marked or numbered. Returns where the next line would be.
  double choices(double x, double y, double width, std::span<const std::string> all);
  /// Breaks words into lines. Returns where the next line would be.
  double paragraph(double x, double y, double width, std::string_view words, const char* more = "");
  /// What another page has, moved and then scaled.
  void put(const SheetPage& other, double x, double y, double scale);
  [[nodiscard]] std::string finished() const;

 private:
  std::string svg_;
};

}  // namespace snug::desktop
