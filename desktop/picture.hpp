// A frame drawn off the screen, as a PNG file.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"

namespace snug::desktop {

/// A framebuffer of its own, so that what is drawn does not depend on a window being in front.
class OffScreen {
 public:
  OffScreen(int width, int height);
  ~OffScreen();
  OffScreen(const OffScreen&) = delete;
  OffScreen& operator=(const OffScreen&) = delete;
  [[nodiscard]] bool complete() const { return complete_; }
  void bind() const;
  /// The pixels as PNG bytes; empty where they could not be encoded.
  [[nodiscard]] std::string png() const;

 private:
  int width_, height_;
  bool complete_ = false;
  std::uint32_t drawn_ = 0, color_ = 0, depth_ = 0, resolved_ = 0, resolved_color_ = 0;
};

/// A PNG file's picture as a texture; 0 where it is none.
[[nodiscard]] std::uint32_t texture_of_png(const std::string& png);

}  // namespace snug::desktop
