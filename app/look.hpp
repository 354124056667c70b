// The current look: palette, fonts and sizes; and text on a draw list. Everything that is drawn uses it.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "app/palette.hpp"

namespace snug::app {

enum class Face { kRegular, kSemiBold, kMono, kMonoBold };

/// Words that were drawn, and where. low and high: the box that the letters fill; clip: the visible rectangle
/// there.
struct DrawnWords {
  std::string words;
  ImVec2 low, high, clip_low, clip_high;
  const ImDrawList* list = nullptr;  // on which they stand, after so many of its indices
  int after = 0;
  Face face = Face::kRegular;
  float size = 0;             // of the em, page pixels
  ImVec2 at = {};             // as in text
  Color color = 0, halo = 0;  // halo: 0 for none
};

struct Look {
  const Palette* palette = &kLight;
  std::array<ImFont*, 4> fonts{};
  float text_scale = 1;
  float least = 0;  // as in Settings
  bool fingers = false;
  bool still = false;     // reduced motion
  float tools = 0;        // as in Layout
  float foot = 0;         // as in Layout
  float tools_right = 0;  // how wide the front end's own button is, beside the stage's in its other top corner
  std::vector<DrawnWords>* drawn = nullptr;  // receives all words of the frame, for tests and pictures
  bool words_apart = false;                  // whether they are not drawn then

  [[nodiscard]] ImFont* font(Face face) const { return fonts[static_cast<std::size_t>(face)]; }
  /// A size of words in page pixels, from its size at scale 1; and the size at which they are drawn.
  [[nodiscard]] float px(float size) const { return size * text_scale; }
  [[nodiscard]] float drawn_px(float size) const { return px(size) < least ? least : px(size); }
  /// How large a subscript is drawn beside words of this size.
  [[nodiscard]] float script(float size) const;
  const Palette* operator->() const { return palette; }
};

// Parts of the em. A line's baseline is kBaseline below the top of its box, in both typefaces; a subscript or a
// superscript is kScriptSize as large, if that is not too low to be read, and its baseline is kLowered lower or kRaised
// higher.
inline constexpr float kBaseline = 0.864f, kScriptSize = 0.75f, kLowered = 0.14f, kRaised = 0.33f;

enum class Script : std::uint8_t { kNone, kLowered, kRaised };

/// Letters that stand at one height.
struct Letters {
  std::string_view text;
  Script script = Script::kNone;
  bool operator==(const Letters&) const = default;
};
/// "r_A = 2" has three pieces: r, a lowered A, and the rest. All that measures or draws words goes by them. A single
/// letter or sign and at most three lowered ones are such a name, "a_min" and "∑_i", and nothing else: "min_max" and
/// "x_axis" are words as they stand. One capital letter is raised after a caret: "p^T".
[[nodiscard]] std::vector<Letters> with_scripts(std::string_view words);

/// What ImGui calls the size of a font whose em is of this size at text scale 1.
[[nodiscard]] float font_size(const Look& look, Face face, float size);

// size: at text scale 1; the look's scale is applied in here.
[[nodiscard]] ImVec2 measure(const Look& look, Face face, float size, std::string_view text);
/// at: the top left of the line box, which is as high as the size.
void text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, std::string_view words);
void text_right(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color,
                std::string_view words);
void text_middle(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color,
                 std::string_view words);
/// The same for words with a halo, which are noted where they are not drawn.
void note_text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
               std::string_view words);
/// The part of the words that fits, with an ellipsis if some does not.
[[nodiscard]] std::string shortened(const Look& look, Face face, float size, std::string_view words, float width);
/// The lines of a text at a width. Words longer than a line are broken.
[[nodiscard]] std::vector<std::string_view> lines_of(const Look& look, Face face, float size, std::string_view words,
                                                     float width);
/// Draws lines and returns their height. leading: at text scale 1.
float paragraph(ImDrawList* list, const Look& look, Face face, float size, float leading, ImVec2 at, float width,
                Color color, std::string_view words);

/// The top of a line box of this size whose words are centred at y.
[[nodiscard]] inline float middle_of(float y, float size) { return y - size / 2; }

/// ImGui's own colours and measures, for the few of its widgets that are used (text fields, scroll bars, popups).
void apply_style(const Look& look);

}  // namespace snug::app
