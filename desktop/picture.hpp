// Draws a frame off the screen, as a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"

namespace snug::desktop {

/// A separate framebuffer, so that the picture does not depend on the window being in front.
class OffScreen {
 public:
  OffScreen(int width, int height);
  ~OffScreen();
  OffScreen(const OffScreen&) = delete;
  OffScreen& operator=(const OffScreen&) = delete;
  [[nodiscard]] bool complete() const { return complete_; }
  void bind() const;
  /// The pixels as PNG bytes; empty if they could not be encoded. transparent: with their opacity.
  [[nodiscard]] std::string png(bool transparent = false) const;
  /// Three bytes a pixel, from the top; four with their opacity.
  [[nodiscard]] std::vector<unsigned char> pixels(int channels = 3) const;

 private:
  int width_, height_;
  bool complete_ = false;
  std::uint32_t drawn_ = 0, color_ = 0, depth_ = 0, resolved_ = 0, resolved_color_ = 0;
};

/// The file with a text: the address of what it shows, under "Source".
[[nodiscard]] std::string with_source(std::string png, const std::string& address);

/// A texture from a PNG file; 0 if it is not one.
[[nodiscard]] std::uint32_t texture_of_png(const std::string& png);

}  // namespace snug::desktop
