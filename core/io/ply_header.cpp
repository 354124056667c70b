#include "io/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace snug::io {
namespace {

std::optional<PlyType> type_named(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 10> kNames{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"long", "int64"},
                                                                    {"ulong", "uint64"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (name == kNames[i][0] || name == kNames[i][1]) return static_cast<PlyType>(i);
  return std::nullopt;
}

/// Far more than any real header has, and so few that comparing names pair by pair costs nothing.
constexpr std::size_t kMost = 1000;

class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : lines_(bytes) {}

  Read<PlyHeader> read() {
    if (!lines_.next() || lower_case(trim(lines_.line())) != "ply")
      return at_line(1, "the file does not begin with \"ply\"");
    while (lines_.next()) {
      std::string_view rest = lines_.line();
      const std::string_view word = take_word(rest);
      if (word == "end_header") return finish();
      const std::string wrong = take(word, rest);
      if (!wrong.empty()) return at_line(lines_.number(), wrong);
    }
    return at_line(lines_.number(), "the file ends within its header");
  }

 private:
  /// Takes a line. Returns what is wrong with it, or an empty text.
  std::string take(std::string_view word, std::string_view rest) {
    if (word.empty() || word == "comment" || word == "obj_info") return {};
    if (word == "format") return take_format(rest);
    if (word == "element") return take_element(rest);
    if (word == "property") return take_property(rest);
    return quoted(word) + " is not a line of a PLY header";
  }

  std::string take_format(std::string_view rest) {
    const std::string_view name = take_word(rest);
    const std::string_view version = take_word(rest);
    constexpr std::array<std::string_view, 3> kForms{"ascii", "binary_little_endian", "binary_big_endian"};
    const auto form = std::find(kForms.begin(), kForms.end(), name);
    if (form == kForms.end()) return quoted(name) + " is not a format of PLY";
    if (version != "1.0") return quoted(version) + " is not a known version of PLY";
    if (std::exchange(has_format_, true)) return "the header names a format twice";
    header_.form = static_cast<PlyForm>(form - kForms.begin());
    return trim(rest).empty() ? "" : "there is more on the line than a format and its version";
  }

  std::string take_element(std::string_view rest) {
    const std::string_view name = take_word(rest);
    const std::string_view digits = take_word(rest);
    const auto count = parse_integer(digits);
    if (!count || *count < 0) return quoted(digits) + " is not a count of elements";
    if (!trim(rest).empty()) return "there is more on the line than an element's name and count";
    for (const PlyElement& other : header_.elements)
      if (other.name == name) return "the header has the element " + quoted(name) + " twice";
    if (header_.elements.size() == kMost) return "the header has more than 1000 elements";
    header_.elements.push_back({name, *count, lines_.number(), {}});
    return {};
  }

  std::string take_property(std::string_view rest) {
    if (header_.elements.empty()) return "the property belongs to no element";
    std::string_view type_name = take_word(rest);
    std::optional<PlyType> count_type;
    std::string_view unknown;
    if (type_name == "list") {
      const std::string_view count_name = take_word(rest);
      count_type = type_named(count_name).value_or(PlyType::kUnknown);
      type_name = take_word(rest);
      if (count_type == PlyType::kUnknown) unknown = count_name;
    }
    const auto type = type_named(type_name).value_or(PlyType::kUnknown);
    if (type == PlyType::kUnknown && unknown.empty()) unknown = type_name;
    const std::string_view name = take_word(rest);
    if (name.empty()) return "the property has no name";
    if (!trim(rest).empty()) return "there is more on the line than a property's type and name";
    auto& properties = header_.elements.back().properties;
    for (const PlyProperty& other : properties)
      if (other.name == name) return "the element has the property " + quoted(name) + " twice";
    if (properties.size() == kMost) return "the element has more than 1000 properties";
    properties.push_back({name, type, count_type, lines_.number(), unknown});
    return {};
  }

  Read<PlyHeader> finish() {
    if (!has_format_) return at_line(lines_.number(), "the header names no format");
    for (const PlyElement& element : header_.elements)
      if (element.count > 0 && element.properties.empty())
        return at_line(element.line, "the element " + quoted(element.name) + " has no properties");
    header_.body = lines_.rest();
    header_.lines = lines_.number();
    return std::move(header_);
  }

  Lines lines_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

Read<PlyHeader> read_ply_header(std::string_view bytes) { return HeaderReader(bytes).read(); }

}  // namespace snug::io
