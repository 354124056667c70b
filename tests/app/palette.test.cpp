// Words and marks can be told from their ground, in every theme, by the measure of WCAG 2.
#include "app/palette.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

namespace snug::app {
namespace {

double luminance(Color color) {
  const auto linear = [&](int shift) {
    const double c = (color >> shift & 0xffu) / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(0) + 0.7152 * linear(8) + 0.0722 * linear(16);
}

double contrast(Color a, Color b) {
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace

TEST_CASE("the measure itself") {
  CHECK(contrast(rgb(0x000000), rgb(0xFFFFFF)) == doctest::Approx(21));
  CHECK(contrast(rgb(0x767676), rgb(0xFFFFFF)) == doctest::Approx(4.54).epsilon(0.01));
}

TEST_CASE("every theme: words 4.5 to 1, marks 3 to 1") {
  for (const Theme theme : {Theme::kLight, Theme::kDark, Theme::kHighContrast, Theme::kProjector}) {
    const Palette& p = palette_of(theme);
    CAPTURE(static_cast<int>(theme));
    for (const Color ground : {p.ground, p.panel})
      for (const Color words : {p.ink, p.muted, p.current_text, p.previous_text, p.support_text, p.examined_text,
                                p.optimum_text, p.wrong_text})
        CHECK(contrast(words, ground) >= 4.5);
    for (const Color words : {p.ink, p.muted, p.current_text, p.optimum_text, p.wrong_text})
      CHECK(contrast(words, p.raised) >= 4.5);
    CHECK(contrast(p.ink, p.lit) >= 4.5);
    CHECK(contrast(p.on_current, p.current) >= 4.5);
    for (const Color mark : {p.current, p.previous, p.support, p.examined, p.optimum, p.wrong, p.point})
      CHECK(contrast(mark, p.ground) >= 3);
  }
}

}  // namespace snug::app
