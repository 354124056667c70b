#include "desktop/animation.hpp"

#include <gif_lib.h>

#include <array>
#include <cmath>

namespace snug::desktop {

struct Animation::Encoder {
  std::string bytes;
  GifFileType* gif = nullptr;
  bool good = false;

  void check(int status) { good = good && status == GIF_OK; }
};

Animation::Animation(int width, int height, const std::string& note)
    : encoder_(std::make_unique<Encoder>()), width_(width), height_(height) {
  const auto write = [](GifFileType* gif, const GifByteType* bytes, int count) {
    static_cast<Encoder*>(gif->UserData)
        ->bytes.append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(count));
    return count;
  };
  int error = 0;
  Encoder& e = *encoder_;
  e.gif = EGifOpen(&e, write, &error);
  if (e.gif == nullptr) return;
  e.good = true;
  EGifSetGifVersion(e.gif, true);
  e.check(EGifPutScreenDesc(e.gif, width, height, 8, 0, nullptr));
  constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
  e.check(EGifPutExtensionLeader(e.gif, APPLICATION_EXT_FUNC_CODE));
  e.check(EGifPutExtensionBlock(e.gif, 11, "NETSCAPE2.0"));
  e.check(EGifPutExtensionBlock(e.gif, kForEver.size(), kForEver.data()));
  e.check(EGifPutExtensionTrailer(e.gif));
  if (!note.empty()) e.check(EGifPutComment(e.gif, note.c_str()));
}

Animation::~Animation() {
  int error = 0;
  if (encoder_->gif != nullptr) EGifCloseFile(encoder_->gif, &error);
}

bool Animation::add(const std::vector<unsigned char>& rgb, double seconds) {
  Encoder& e = *encoder_;
  if (!e.good) return false;
  const std::size_t count = rgb.size() / 3;
  std::array<std::vector<GifByteType>, 3> planes;
  for (std::size_t channel = 0; channel < 3; ++channel) {
    planes[channel].resize(count);
    for (std::size_t i = 0; i < count; ++i) planes[channel][i] = rgb[3 * i + channel];
  }
  int colors = 256;
  std::vector<GifByteType> pixels(count);
  ColorMapObject* const map = GifMakeMapObject(colors, nullptr);
  e.good = map != nullptr;
  if (!e.good) return false;
  e.check(GifQuantizeBuffer(static_cast<unsigned>(width_), static_cast<unsigned>(height_), &colors, planes[0].data(),
                            planes[1].data(), planes[2].data(), pixels.data(), map->Colors));
  GraphicsControlBlock control{};
  control.DisposalMode = DISPOSE_DO_NOT;
  control.DelayTime = static_cast<int>(std::lround(seconds * 100));
  control.TransparentColor = NO_TRANSPARENT_COLOR;
  std::array<GifByteType, 4> block{};
  EGifGCBToExtension(&control, block.data());
  e.check(EGifPutExtension(e.gif, GRAPHICS_EXT_FUNC_CODE, block.size(), block.data()));
  e.check(EGifPutImageDesc(e.gif, 0, 0, width_, height_, false, map));
  for (int y = 0; y < height_ && e.good; ++y)
    e.check(EGifPutLine(e.gif, pixels.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width_), width_));
  GifFreeMapObject(map);
  return e.good;
}

std::string Animation::finish() {
  int error = 0;
  if (encoder_->gif != nullptr) encoder_->check(EGifCloseFile(encoder_->gif, &error));
  encoder_->gif = nullptr;
  return encoder_->good ? encoder_->bytes : std::string();
}

}  // namespace snug::desktop
