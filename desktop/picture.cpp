#include "desktop/picture.hpp"

#include <png.h>
#include <snug_gl.h>
#include <zlib.h>

#include <algorithm>
#include <vector>

namespace snug::desktop {

OffScreen::OffScreen(int width, int height) : width_(width), height_(height) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const GLsizei samples = std::min(most, 4);
  const auto attach = [&](std::uint32_t& buffer, GLenum format, GLenum place, GLsizei count) {
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, format, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
  };
  glGenFramebuffers(1, &resolved_);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
  attach(resolved_color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, 0);
  complete_ = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glGenFramebuffers(1, &drawn_);
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  attach(color_, GL_RGBA8, GL_COLOR_ATTACHMENT0, samples);
  attach(depth_, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, samples);
  complete_ = complete_ && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

OffScreen::~OffScreen() {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  for (const GLuint buffer : {color_, depth_, resolved_color_}) glDeleteRenderbuffers(1, &buffer);
  for (const GLuint buffer : {drawn_, resolved_}) glDeleteFramebuffers(1, &buffer);
}

void OffScreen::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, drawn_); }

std::vector<unsigned char> OffScreen::pixels(int channels) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
  const std::size_t row = static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels);
  std::vector<unsigned char> upwards(row * static_cast<std::size_t>(height_)), pixels(upwards.size());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, channels == 4 ? GL_RGBA : GL_RGB, GL_UNSIGNED_BYTE, upwards.data());
  for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y)  // OpenGL's first row is the bottom one
    std::copy_n(upwards.begin() + static_cast<std::ptrdiff_t>((static_cast<std::size_t>(height_) - 1 - y) * row), row,
                pixels.begin() + static_cast<std::ptrdiff_t>(y * row));
  return pixels;
}

std::string OffScreen::png(bool transparent) const {
  std::vector<unsigned char> all = pixels(transparent ? 4 : 3);
  // What was blended over nothing is darker by its opacity.
  for (std::size_t i = 0; transparent && i + 3 < all.size(); i += 4)
    for (std::size_t channel = 0; channel < 3 && all[i + 3] > 0; ++channel)
      all[i + channel] = static_cast<unsigned char>(std::min(255, all[i + channel] * 255 / all[i + 3]));
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width_);
  image.height = static_cast<png_uint_32>(height_);
  image.format = transparent ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  if (!png_image_write_to_memory(&image, nullptr, &size, 0, all.data(), 0, nullptr)) return {};
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, all.data(), 0, nullptr)) return {};
  bytes.resize(size);
  return bytes;
}

std::string with_source(std::string png, const std::string& address) {
  constexpr std::size_t kAfterHeader = 33;  // the signature, and the first chunk
  if (png.size() < kAfterHeader || address.empty()) return png;
  const std::string chunk = std::string("tEXtSource") + '\0' + address;
  const auto whole = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  };
  const auto sum = crc32(0, reinterpret_cast<const unsigned char*>(chunk.data()), static_cast<unsigned>(chunk.size()));
  png.insert(kAfterHeader,
             whole(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk + whole(static_cast<std::uint32_t>(sum)));
  return png;
}

std::uint32_t texture_of_png(const std::string& png) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_memory(&image, png.data(), png.size())) return 0;
  image.format = PNG_FORMAT_RGBA;
  std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(image));
  if (!png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr)) return 0;
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(image.width), static_cast<GLsizei>(image.height), 0,
               GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  return texture;
}

}  // namespace snug::desktop
