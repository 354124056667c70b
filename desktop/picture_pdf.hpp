// Pictures as the pages of one PDF, for a projector that shows nothing else.
#pragma once

#include <string>
#include <vector>

namespace snug::desktop {

class PictureBook {
 public:
  /// png: RGB with 8 bits a channel and not interlaced, as OffScreen::png writes it. title: its bookmark, in ASCII.
  /// address: of what it shows; the page has it as /Source.
  void add(const std::string& png, const std::string& title, const std::string& address);
  [[nodiscard]] std::string pdf() const;

 private:
  struct Page {
    std::string width, height;  // pixels, each a point
    std::string rows;           // compressed
    std::string title, address;
  };
  std::vector<Page> pages_;
};

}  // namespace snug::desktop
