// Recognizes the format, and adds the file's name to every error.
#include <algorithm>
#include <array>

#include "io/formats.hpp"

namespace snug::io {
namespace {

enum class Format { kRows, kCsv, kObj, kPly, kStlText, kStlBinary };

std::string extension_of(std::string_view name) {
  const std::size_t dot = name.find_last_of("./\\");
  return dot == std::string_view::npos || name[dot] != '.' ? "" : lower_case(name.substr(dot + 1));
}

/// Text has no zero bytes; binary files have some near their start.
bool looks_binary(std::string_view bytes) { return bytes.substr(0, 4096).find('\0') != std::string_view::npos; }

/// The first line that has more than a comment.
std::string_view first_content(std::string_view text) {
  Lines lines(text);
  while (lines.next_filled()) {
    const std::string_view line = trim(lines.line());
    if (line.front() != '#') return line;
  }
  return {};
}

Format format_of_text(std::string_view text, std::string_view extension) {
  std::string_view rest = first_content(text);
  const std::string_view line = rest;
  const std::string_view word = take_word(rest);
  if (lower_case(word) == "solid") return Format::kStlText;
  if (is_obj_keyword(word) && !rest.empty()) return Format::kObj;
  const Format rows = extension == "csv" ? Format::kCsv : Format::kRows;
  if (line.empty() || parse_number(line.substr(0, line.find_first_of(" \t,;")))) return rows;
  if (extension == "obj") return Format::kObj;
  if (extension == "ply") return Format::kPly;
  if (extension == "stl") return Format::kStlText;
  return rows;
}

/// Whether a file has none of the formats' extensions, and its first line is not text that a person wrote: a picture or
/// an archive, for instance. Latin-1 is accepted in a comment, or in a table that begins with a number.
bool is_something_else(std::string_view bytes, std::string_view extension) {
  constexpr std::array<std::string_view, 6> kOurs{"xyz", "txt", "csv", "obj", "ply", "stl"};
  if (std::find(kOurs.begin(), kOurs.end(), extension) != kOurs.end()) return false;
  if (looks_binary(bytes)) return true;
  const std::string_view line = first_content(bytes);
  if (parse_number(line.substr(0, line.find_first_of(" \t,;")))) return false;
  return std::any_of(line.begin(), line.end(), [](char c) { return (c & 0x80) != 0 || (c < ' ' && c != '\t'); });
}

/// The content decides if it can: binary STL is recognized by its size, because its header may begin with "solid".
Format format_of(std::string_view bytes, std::string_view extension) {
  const std::string_view start = bytes.substr(0, 4);
  if (start == "ply\n" || start == "ply\r") return Format::kPly;
  if (has_size_of_stl(bytes)) return Format::kStlBinary;
  if (!looks_binary(bytes)) return format_of_text(bytes, extension);
  if (extension == "ply") return Format::kPly;
  return Format::kStlBinary;
}

Read<PointFile> read_as(Format format, std::string_view bytes) {
  switch (format) {
    case Format::kRows: return read_rows(bytes, false);
    case Format::kCsv: return read_rows(bytes, true);
    case Format::kObj: return read_obj(bytes);
    case Format::kPly: return read_ply(bytes);
    case Format::kStlText: return read_stl_text(bytes);
    case Format::kStlBinary: break;
  }
  return read_stl_binary(bytes);
}

/// The text without a byte order mark.
Read<std::string_view> without_mark(std::string_view bytes) {
  if (has_size_of_stl(bytes)) return bytes;  // its header may contain anything
  if (bytes.substr(0, 2) == "\xff\xfe" || bytes.substr(0, 2) == "\xfe\xff")
    return at_byte(0, "the text is UTF-16: save it as UTF-8");
  return bytes.substr(bytes.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0);
}

Read<PointFile> read_any(std::string_view bytes, std::string_view name) {
  if (const auto text = without_mark(bytes)) bytes = *text;
  else return tl::unexpected(text.error());
  const std::string extension = extension_of(name);
  const Format format = format_of(bytes, extension);
  const std::string_view start = bytes.substr(0, 5);
  const bool claims_none = format == Format::kRows || (format == Format::kStlBinary && !has_size_of_stl(bytes));
  if (claims_none && lower_case(start) != "solid" && is_something_else(bytes, extension))
    return tl::unexpected(InputError{.what = "this is not a point file: xyz, csv, obj, ply or stl"});
  if (format == Format::kStlBinary && !has_size_of_stl(bytes) && extension != "stl" && lower_case(start) != "solid")
    return at_byte(static_cast<std::int64_t>(bytes.find('\0')), "the data is binary, but neither PLY nor STL");
  Read<PointFile> file = read_as(format, bytes);
  if (file && file->points.empty()) return tl::unexpected(InputError{.what = "there are no points"});
  return file;
}

}  // namespace

tl::expected<PointFile, InputError> read_points(std::string_view bytes, std::string_view name) {
  Read<PointFile> file = read_any(bytes, name);
  if (!file) file.error().file = name;
  return file;
}

}  // namespace snug::io
