#include "desktop/cli/sheet_page.hpp"

#include <algorithm>
#include <cstdio>

#include "desktop/cli/words.hpp"

namespace snug::desktop {
namespace {

constexpr double kLetter = 1.85;  // the width of one, of text of the usual size, mm

}  // namespace

std::string mm(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", value);
  return text.data();
}

void SheetPage::text(double x, double y, std::string_view words, double size, const char* more) {
  svg_ += "<text x=\"" + mm(x) + "\" y=\"" + mm(y) + "\" font-size=\"" + mm(size) + "\" " + more + '>' +
          xml_text(std::string(words)) + "</text>\n";
}

void SheetPage::line(double x1, double y1, double x2, double y2, const char* stroke) {
  svg_ += "<path d=\"M" + mm(x1) + ' ' + mm(y1) + 'L' + mm(x2) + ' ' + mm(y2) + "\" stroke=\"" + stroke +
          "\" stroke-width=\".2\"/>\n";
}

void SheetPage::polygon(const std::vector<std::array<double, 2>>& corners, bool dashed) {
  svg_ += "<path d=\"";
  for (std::size_t i = 0; i < corners.size(); ++i)
    svg_ += (i == 0 ? "M" : "L") + mm(corners[i][0]) + ' ' + mm(corners[i][1]);
  svg_ += std::string("Z\" fill=\"none\" stroke=\"#000\" stroke-width=\".35\"") +
          (dashed ? " stroke-dasharray=\"2 1\"" : "") + "/>\n";
}

void SheetPage::dot(double x, double y) { svg_ += "<circle cx=\"" + mm(x) + "\" cy=\"" + mm(y) + "\" r=\".8\"/>\n"; }

double SheetPage::choices(double x, double y, double width, std::span<const std::string> all) {
  constexpr double kSquare = 3.4, kGap = 6;
  double at = x;
  for (const std::string& choice : all) {
    const double own = kSquare + 2 + kLetter * static_cast<double>(letters_of(choice));
    if (at > x && at + own > x + width) at = x, y += kLine;
    polygon({{{at, y - kSquare + .4}, {at + kSquare, y - kSquare + .4}, {at + kSquare, y + .4}, {at, y + .4}}}, false);
    text(at + kSquare + 2, y, choice);
    at += own + kGap;
  }
  return y + kLine;
}

double SheetPage::paragraph(double x, double y, double width, std::string_view words, const char* more) {
  const auto most = static_cast<std::size_t>(width / kLetter);
  while (!words.empty()) {
    std::size_t end = words.size() <= most ? words.size() : words.rfind(' ', most);
    if (end == std::string_view::npos) end = std::min(words.find(' '), words.size());
    text(x, y, words.substr(0, end), 3.9, more);
    words.remove_prefix(std::min(end + 1, words.size()));
    y += kLine;
  }
  return y;
}

void SheetPage::put(const SheetPage& other, double x, double y, double scale) {
  svg_ += "<g transform=\"translate(" + mm(x) + ' ' + mm(y) + ") scale(" + mm(scale) + ")\">\n" + other.svg_ + "</g>\n";
}

std::string SheetPage::finished() const {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\" "
         "font-family=\"Inter, Helvetica, Arial, sans-serif\">\n<rect width=\"210\" height=\"297\" fill=\"#fff\"/>\n" +
         svg_ + "</svg>\n";
}

}  // namespace snug::desktop
