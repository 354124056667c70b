// Draws a frame off the screen, as a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

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
  /// The pixels as PNG bytes; empty if they could not be encoded.
  [[nodiscard]] std::string png() const;

 private:
  int width_, height_;
  bool complete_ = false;
  std::uint32_t drawn_ = 0, color_ = 0, depth_ = 0, resolved_ = 0, resolved_color_ = 0;
};

/// A texture from a PNG file; 0 if it is not one.
[[nodiscard]] std::uint32_t texture_of_png(const std::string& png);

}  // namespace snug::desktop
