// Recognizes the format, and adds the file's name to every error.
#include <algorithm>
#include <array>

#include "io/formats.hpp"

namespace snug::io {
namespace {

enum class Format { kRows, kCsv, kObj, kPly, kStlText, kStlBinary, kOff };

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
    if (line.front() != '#' && line.substr(0, 2) != "//") return line;
  }
  return {};
}

Format format_of_text(std::string_view text, std::string_view extension) {
  std::string_view rest = first_content(text);
  const std::string_view line = rest;
  const std::string_view word = take_word(rest);
  if (lower_case(word) == "solid") return Format::kStlText;
  if (lower_case(word) == "off") return Format::kOff;
  if (is_obj_keyword(word) && !rest.empty()) return Format::kObj;
  if (extension == "off" && !line.empty()) return Format::kOff;
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
  if (is_point_extension(extension)) return false;
  if (looks_binary(bytes)) return true;
  const std::string_view line = first_content(bytes);
  if (parse_number(line.substr(0, line.find_first_of(" \t,;")))) return false;
  return std::any_of(line.begin(), line.end(), [](char c) { return (c & 0x80) != 0 || (c < ' ' && c != '\t'); });
}

bool is_text(std::string_view bytes, bool zeros) {
  return std::none_of(bytes.begin(), bytes.end(),
                      [&](char c) { return c >= 0 && c < ' ' && (c < '\t' || c > '\r') && (c != '\0' || !zeros); });
}

/// Whether the bytes are text with stray zero bytes. In formats that are always text these may be anywhere; in others
/// everything before the first must be text, and more than the header of a binary STL, which names no facet.
bool is_text_with_zeros(std::string_view bytes, std::string_view extension) {
  const bool always_text = is_point_extension(extension) && extension != "stl" && extension != "ply";
  if (always_text && is_text(bytes.substr(0, 4096), true)) return true;
  const std::string_view start = bytes.substr(0, bytes.find('\0'));
  if (start.empty() || !is_text(start, false)) return false;
  return lower_case(start.substr(0, 5)) == "solid" ? start.find("facet") != std::string_view::npos
                                                   : start.find_first_of("\r\n") != std::string_view::npos;
}

/// The name of a format that has points but is not read; empty if the text is in none of these.
std::string_view not_read(std::string_view text, std::string_view extension) {
  const std::string_view line = first_content(text.substr(0, 4096));
  std::string_view rest = line;
  const std::string_view word = take_word(rest);
  if (text.substr(0, 7) == "# .PCD " || extension == "pcd") return "PCD is not read: save the points as PLY or xyz";
  const std::string kind = lower_case(word);
  if (kind == "coff" || kind == "noff" || kind == "cnoff" || kind == "stoff" || kind == "4off")
    return "only plain OFF is read, without colours or normals: save the points as OFF, PLY or OBJ";
  if (kind == "off" && lower_case(trim(rest)) == "binary") return "binary OFF is not read: save the points as text";
  if (!line.empty() && line[0] == '{' && text.substr(0, 4096).find("\"snug_result\"") != std::string_view::npos)
    return "this is a result file: hand it in";
  if (!line.empty() && (line[0] == '{' || line[0] == '['))
    return "JSON is not read: give a point file: xyz, csv, obj, ply, stl or off";
  return {};
}

/// The content decides if it can: binary STL is recognized by its size, because its header may begin with "solid".
Format format_of(std::string_view bytes, std::string_view extension) {
  const std::string_view start = bytes.substr(0, 4);
  if (lower_case(start.substr(0, 3)) == "ply" && start.find_first_of("\n\r \t", 3) == 3) return Format::kPly;
  if (has_size_of_stl(bytes)) return Format::kStlBinary;
  if (!looks_binary(bytes) || is_text_with_zeros(bytes, extension)) return format_of_text(bytes, extension);
  if (extension == "ply") return Format::kPly;
  return Format::kStlBinary;
}

Read<PointFile> read_as(Format format, std::string_view bytes, const Wanted& wanted) {
  switch (format) {
    case Format::kRows: return read_rows(bytes, false, wanted);
    case Format::kCsv: return read_rows(bytes, true, wanted);
    case Format::kObj: return read_obj(bytes, wanted);
    case Format::kPly: return read_ply(bytes, wanted);
    case Format::kStlText: return read_stl_text(bytes, wanted);
    case Format::kOff: return read_off(bytes, wanted);
    case Format::kStlBinary: break;
  }
  return read_stl_binary(bytes, wanted);
}

/// The text without a byte order mark.
Read<std::string_view> without_mark(std::string_view bytes) {
  if (has_size_of_stl(bytes)) return bytes;  // its header may contain anything
  if (is_utf16(bytes)) return at_byte(0, kIsUtf16);
  return bytes.substr(bytes.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0);
}

std::int64_t line_at(std::string_view text, std::size_t at) {
  Lines lines(text);
  while (lines.next() && text.size() - lines.rest().size() <= at) {
  }
  return lines.number();
}

Read<PointFile> read_any(std::string_view bytes, std::string_view name, const Wanted& wanted) {
  if (const auto text = without_mark(bytes)) bytes = *text;
  else return tl::unexpected(text.error());
  const std::string extension = extension_of(name);
  if (!has_size_of_stl(bytes))
    if (const std::string_view what = not_read(bytes, extension); !what.empty())
      return tl::unexpected(InputError{.what = std::string(what)});
  const Format format = format_of(bytes, extension);
  std::int64_t padding = 0;
  if (format != Format::kPly && format != Format::kStlBinary) {
    padding = take_padding(bytes);
    if (const std::size_t zero = bytes.find('\0'); zero != std::string_view::npos)
      return at_line(line_at(bytes, zero), "there is a zero byte in the text");
  }
  const std::string_view start = bytes.substr(0, 5);
  const bool claims_none = format == Format::kRows || (format == Format::kStlBinary && !has_size_of_stl(bytes));
  if (claims_none && lower_case(start) != "solid" && is_something_else(bytes, extension))
    return tl::unexpected(InputError{.what = "this is not a point file: xyz, csv, obj, ply, stl or off"});
  if (format == Format::kStlBinary && !has_size_of_stl(bytes) && extension != "stl" && lower_case(start) != "solid")
    return at_byte(static_cast<std::int64_t>(bytes.find('\0')), "the data is binary, but neither PLY nor STL");
  Read<PointFile> file = read_as(format, bytes, wanted);
  if (file && file->points.empty()) return tl::unexpected(InputError{.what = "there are no points"});
  if (file) pass_over(*file, Passed::kBytes, padding);
  return file;
}

/// Takes out the points that are not finite, which a reader lets through if asked, and the faces that name them.
Read<PointFile> finite_part(PointFile file) {
  const auto is_lost = [](const Vector<double, 3>& point) { return !point.allFinite(); };
  const auto first = std::find_if(file.points.begin(), file.points.end(), is_lost);
  if (first == file.points.end()) return file;
  std::vector<Index> number(file.points.size(), -1);
  Index kept = 0;
  for (std::size_t i = 0; i < file.points.size(); ++i) {
    if (is_lost(file.points[i])) continue;
    file.points[static_cast<std::size_t>(kept)] = file.points[i];
    number[i] = kept++;
  }
  pass_over(file, Passed::kNan, static_cast<std::int64_t>(file.points.size()) - kept);
  file.points.resize(static_cast<std::size_t>(kept));
  const auto lost = [&](std::array<Index, 3>& face) {
    for (Index& corner : face) corner = number[static_cast<std::size_t>(corner)];
    return std::find(face.begin(), face.end(), -1) != face.end();
  };
  file.triangles.erase(std::remove_if(file.triangles.begin(), file.triangles.end(), lost), file.triangles.end());
  if (file.points.empty()) return tl::unexpected(InputError{.what = "there are no points"});
  return file;
}

}  // namespace

bool is_point_extension(std::string_view extension) {
  constexpr std::array<std::string_view, 7> kOurs{"xyz", "txt", "csv", "obj", "ply", "stl", "off"};
  return std::find(kOurs.begin(), kOurs.end(), extension) != kOurs.end();
}

std::string passed_text(const PassedOver& passed) {
  constexpr std::array<std::array<std::string_view, 2>, 9> kNames{{{"point", " with a coordinate that is not finite"},
                                                                   {"line", " with more columns than three"},
                                                                   {"header line", ""},
                                                                   {"statement", " unknown to OBJ"},
                                                                   {"face", " of fewer than three vertices"},
                                                                   {"damaged face", ""},
                                                                   {"line", " after the data"},
                                                                   {"byte", " after the data"},
                                                                   {"missing endsolid", ""}}};
  std::string text;
  for (std::size_t i = 0; i < passed.size(); ++i)
    if (passed[i] > 0)
      text.append(text.empty() ? "passed over: " : ", ").append(counted(passed[i], kNames[i][0])).append(kNames[i][1]);
  return text;
}

tl::expected<PointFile, InputError> read_points(std::string_view bytes, std::string_view name, const Wanted& wanted) {
  Read<PointFile> file = read_any(bytes, name, wanted);
  if (file) file = finite_part(std::move(*file));
  if (!file) file.error().file = name;
  return file;
}

}  // namespace snug::io
