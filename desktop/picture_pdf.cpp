#include "desktop/picture_pdf.hpp"

#include <cstdint>
#include <cstdio>

namespace snug::desktop {
namespace {

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = at; i < at + 4; ++i) word = word << 8 | static_cast<unsigned char>(bytes.at(i));
  return word;
}

/// The compressed rows of a PNG, which PDF takes as they are.
std::string rows_of(const std::string& png) {
  std::string rows;
  for (std::size_t at = 8; at + 12 <= png.size();) {  // after the signature: size, kind, data, checksum
    const std::size_t size = word_at(png, at);
    if (png.compare(at + 4, 4, "IDAT") == 0) rows += png.substr(at + 8, size);
    at += 12 + size;
  }
  return rows;
}

std::string string_text(const std::string& words) {
  std::string text = "(";
  for (const char letter : words) {
    if (letter == '(' || letter == ')' || letter == '\\') text += '\\';
    text += letter;
  }
  return text + ')';
}

std::string stream(const std::string& entries, const std::string& bytes) {
  return "<<" + entries + "/Length " + std::to_string(bytes.size()) + ">>\nstream\n" + bytes + "\nendstream";
}

std::string reference(std::size_t object) { return std::to_string(object) + " 0 R"; }

constexpr std::size_t kFirstPage = 4, kOfAPage = 4;  // after catalog, pages and outlines: page, words, image, bookmark
std::size_t page_object(std::size_t page) { return kFirstPage + kOfAPage * page; }

}  // namespace

void PictureBook::add(const std::string& png, const std::string& title, const std::string& address) {
  pages_.push_back({std::to_string(word_at(png, 16)), std::to_string(word_at(png, 20)), rows_of(png), title, address});
}

std::string PictureBook::pdf() const {
  const std::size_t count = pages_.size();
  std::string kids;
  for (std::size_t i = 0; i < count; ++i) kids += reference(page_object(i)) + ' ';
  const auto bookmark = [](std::size_t page) { return reference(page_object(page) + 3); };
  const std::string counted = "/Count " + std::to_string(count) + ">>";
  std::vector<std::string> objects{"<</Type/Catalog/Pages 2 0 R/Outlines 3 0 R>>",
                                   "<</Type/Pages/Kids[" + kids + "]" + counted,
                                   "<</Type/Outlines/First " + bookmark(0) + "/Last " + bookmark(count - 1) + counted};
  for (std::size_t i = 0; i < count; ++i) {
    const Page& page = pages_[i];
    const std::size_t at = page_object(i);
    objects.push_back("<</Type/Page/Parent 2 0 R/MediaBox[0 0 " + page.width + ' ' + page.height + "]/Source" +
                      string_text(page.address) + "/Contents " + reference(at + 1) + "/Resources<</XObject<</I " +
                      reference(at + 2) + ">>>>>>");
    objects.push_back(stream("", page.width + " 0 0 " + page.height + " 0 0 cm /I Do"));
    objects.push_back(stream("/Type/XObject/Subtype/Image/Width " + page.width + "/Height " + page.height +
                                 "/ColorSpace/DeviceRGB/BitsPerComponent 8/Filter/FlateDecode/DecodeParms<</Predictor "
                                 "15/Colors 3/Columns " +
                                 page.width + ">>",
                             page.rows));
    objects.push_back("<</Title" + string_text(page.title) + "/Parent 3 0 R/Dest[" + reference(at) + "/Fit]" +
                      (i > 0 ? "/Prev " + bookmark(i - 1) : "") + (i + 1 < count ? "/Next " + bookmark(i + 1) : "") +
                      ">>");
  }
  std::string file = "%PDF-1.6\n%\xe2\xe3\xcf\xd3\n", table;  // bytes above 127 say that it is binary
  for (std::size_t i = 0; i < objects.size(); ++i) {
    char row[32];
    std::snprintf(row, sizeof row, "%010zu 00000 n \n", file.size());
    table += row;
    file += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::string size = std::to_string(objects.size() + 1), start = std::to_string(file.size());
  return file + "xref\n0 " + size + "\n0000000000 65535 f \n" + table + "trailer\n<</Size " + size +
         "/Root 1 0 R>>\nstartxref\n" + start + "\n%%EOF\n";
}

}  // namespace snug::desktop
