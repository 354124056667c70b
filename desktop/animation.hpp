// Frames as an animated GIF, which every program for slides plays by itself; WebM is not played by all of them.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace snug::desktop {

class Animation {
 public:
  /// note: what is written into the file as its comment.
  Animation(int width, int height, const std::string& note);
  ~Animation();
  Animation(const Animation&) = delete;
  Animation& operator=(const Animation&) = delete;

  /// rgb: three bytes a pixel, from the top. Each frame has the 256 colours that suit it best. Returns false if it
  /// could not be encoded.
  bool add(const std::vector<unsigned char>& rgb, double seconds);
  /// The file's bytes; empty if it could not be encoded.
  [[nodiscard]] std::string finish();

 private:
  struct Encoder;
  std::unique_ptr<Encoder> encoder_;
  int width_, height_;
};

}  // namespace snug::desktop
