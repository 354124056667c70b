// The colours and the weights of marks, by theme: one meaning, one colour, everywhere.
#pragma once

#include <cstdint>

#include "app/app.hpp"

namespace snug::app {

/// Red in the lowest byte, alpha in the highest.
using Color = std::uint32_t;

/// hex: 0xRRGGBB.
constexpr Color rgb(std::uint32_t hex) {
  return 0xff000000u | (hex & 0xffu) << 16 | (hex & 0xff00u) | (hex >> 16 & 0xffu);
}

constexpr Color with_alpha(Color color, float alpha) {
  return (color & 0x00ffffffu) | static_cast<Color>(alpha * 255.0f + 0.5f) << 24;
}

struct Palette {
  // Grounds.
  Color ground;  // the stage
  Color panel;
  Color raised;  // buttons and cards on a panel
  Color lit;     // the pseudocode line that is lit
  Color track;   // the track of a bar or slider
  // Ink.
  Color ink;
  Color muted;
  Color line;  // one-pixel rules
  Color grid;
  Color point;
  Color surface;  // meshes, before the light
  // Meanings.
  Color current;   // the current volume
  Color previous;  // the previous volume, or a rival's
  Color support;   // touching, chosen
  Color examined;  // being examined, outside
  Color optimum;   // proof, right
  Color wrong;     // wrong, separated, culled
  // The same for words: marks need a contrast of 3:1, words need 4.5:1.
  Color current_text;
  Color previous_text;
  Color support_text;
  Color examined_text;
  Color optimum_text;
  Color wrong_text;
  Color on_current;  // words on a button filled with current
  // Weights.
  float stroke;  // width of a volume's outline, pixels
  float mark;    // scale of diamonds, rings and crosses
  float text;    // scale of all words
  float fill;    // alpha of the current volume
};

inline constexpr Palette kLight{.ground = rgb(0xFAF8F3),
                                .panel = rgb(0xFFFFFF),
                                .raised = rgb(0xEDF2FA),
                                .lit = rgb(0xFFF0C7),
                                .track = rgb(0xE3DED3),
                                .ink = rgb(0x1B2230),
                                .muted = rgb(0x5F6878),
                                .line = rgb(0xE3DED3),
                                .grid = rgb(0xEFEBE1),
                                .point = rgb(0x3F4652),
                                .surface = rgb(0xD9D3C6),
                                .current = rgb(0x0A5FBF),
                                .previous = rgb(0x5F6878),
                                .support = rgb(0xC8430A),
                                .examined = rgb(0xB37400),
                                .optimum = rgb(0x007A5A),
                                .wrong = rgb(0xA3265C),
                                .current_text = rgb(0x0A5FBF),
                                .previous_text = rgb(0x5F6878),
                                .support_text = rgb(0xC0400A),
                                .examined_text = rgb(0x8A5900),
                                .optimum_text = rgb(0x007A5A),
                                .wrong_text = rgb(0xA3265C),
                                .on_current = rgb(0xFFFFFF),
                                .stroke = 2.25f,
                                .mark = 1,
                                .text = 1,
                                .fill = 0.09f};

inline constexpr Palette kDark{.ground = rgb(0x10141B),
                               .panel = rgb(0x171D27),
                               .raised = rgb(0x1F2835),
                               .lit = rgb(0x3A3015),
                               .track = rgb(0x2A3342),
                               .ink = rgb(0xE9EDF4),
                               .muted = rgb(0x9AA6B8),
                               .line = rgb(0x2A3342),
                               .grid = rgb(0x1B222D),
                               .point = rgb(0xC3C9D3),
                               .surface = rgb(0x7C8593),
                               .current = rgb(0x6FB1FF),
                               .previous = rgb(0x9AA6B8),
                               .support = rgb(0xFF8A4C),
                               .examined = rgb(0xF2C14E),
                               .optimum = rgb(0x4CD0A5),
                               .wrong = rgb(0xF07AAE),
                               .current_text = rgb(0x6FB1FF),
                               .previous_text = rgb(0x9AA6B8),
                               .support_text = rgb(0xFF8A4C),
                               .examined_text = rgb(0xF2C14E),
                               .optimum_text = rgb(0x4CD0A5),
                               .wrong_text = rgb(0xF07AAE),
                               .on_current = rgb(0x10141B),
                               .stroke = 2.25f,
                               .mark = 1,
                               .text = 1,
                               .fill = 0.09f};

inline constexpr Palette kHighContrast{.ground = rgb(0x000000),
                                       .panel = rgb(0x000000),
                                       .raised = rgb(0x1E1E1E),
                                       .lit = rgb(0x4A4000),
                                       .track = rgb(0x6A6A6A),
                                       .ink = rgb(0xFFFFFF),
                                       .muted = rgb(0xE0E0E0),
                                       .line = rgb(0xA8A8A8),
                                       .grid = rgb(0x262626),
                                       .point = rgb(0xFFFFFF),
                                       .surface = rgb(0x9A9A9A),
                                       .current = rgb(0x7CC0FF),
                                       .previous = rgb(0xFFFFFF),
                                       .support = rgb(0xFF9A5C),
                                       .examined = rgb(0xFFD84A),
                                       .optimum = rgb(0x4FF0B8),
                                       .wrong = rgb(0xFF8EC2),
                                       .current_text = rgb(0x7CC0FF),
                                       .previous_text = rgb(0xFFFFFF),
                                       .support_text = rgb(0xFF9A5C),
                                       .examined_text = rgb(0xFFD84A),
                                       .optimum_text = rgb(0x4FF0B8),
                                       .wrong_text = rgb(0xFF8EC2),
                                       .on_current = rgb(0x000000),
                                       .stroke = 3.5f,
                                       .mark = 1.3f,
                                       .text = 1,
                                       .fill = 0.14f};

inline constexpr Palette kProjector{.ground = rgb(0xFFFFFF),
                                    .panel = rgb(0xFFFFFF),
                                    .raised = rgb(0xE6EEF9),
                                    .lit = rgb(0xFFE9A8),
                                    .track = rgb(0xD3CFC5),
                                    .ink = rgb(0x0A0F18),
                                    .muted = rgb(0x454E5E),
                                    .line = rgb(0xC9C4B8),
                                    .grid = rgb(0xECE9E2),
                                    .point = rgb(0x20262F),
                                    .surface = rgb(0xCFC9BC),
                                    .current = rgb(0x00489C),
                                    .previous = rgb(0x454E5E),
                                    .support = rgb(0xB03200),
                                    .examined = rgb(0x8A5900),
                                    .optimum = rgb(0x006147),
                                    .wrong = rgb(0x8A1248),
                                    .current_text = rgb(0x00489C),
                                    .previous_text = rgb(0x454E5E),
                                    .support_text = rgb(0xB03200),
                                    .examined_text = rgb(0x7A4E00),
                                    .optimum_text = rgb(0x006147),
                                    .wrong_text = rgb(0x8A1248),
                                    .on_current = rgb(0xFFFFFF),
                                    .stroke = 3.5f,
                                    .mark = 1.3f,
                                    .text = 1.2f,
                                    .fill = 0.12f};

constexpr const Palette& palette_of(Theme theme) {
  switch (theme) {
    case Theme::kDark: return kDark;
    case Theme::kHighContrast: return kHighContrast;
    case Theme::kProjector: return kProjector;
    case Theme::kLight: break;
  }
  return kLight;
}

}  // namespace snug::app
