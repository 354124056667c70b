// The header of a PLY file.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "io/text.hpp"

namespace snug::io {

enum class PlyType : std::uint8_t {
  kInt8,
  kUint8,
  kInt16,
  kUint16,
  kInt32,
  kUint32,
  kInt64,
  kUint64,
  kFloat32,
  kFloat64,
  kUnknown  // an error where the data is needed, or has to be gone over as bytes
};

[[nodiscard]] constexpr std::size_t bytes_of(PlyType type) {
  constexpr std::size_t kSizes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 0};
  return kSizes[static_cast<std::size_t>(type)];
}
[[nodiscard]] constexpr bool is_integer(PlyType type) { return type < PlyType::kFloat32; }

struct PlyProperty {
  std::string_view name;
  PlyType type;                       // for a list: the type of its items
  std::optional<PlyType> count_type;  // of a list only
  std::int64_t line = 0;              // the line that declares it
  std::string_view unknown = {};      // the name of its type, if PLY has no such type
};

struct PlyElement {
  std::string_view name;
  std::int64_t count = 0;
  std::int64_t line = 0;  // the line that declares it
  std::vector<PlyProperty> properties;
};

enum class PlyForm : std::uint8_t { kAscii, kLittleEndian, kBigEndian };

struct PlyHeader {
  PlyForm form = PlyForm::kAscii;
  std::vector<PlyElement> elements;
  std::string_view body;   // the bytes after the header; names are views into the file too
  std::int64_t lines = 0;  // how many the header has
};

/// Errors: with the header's line.
[[nodiscard]] Read<PlyHeader> read_ply_header(std::string_view bytes);

}  // namespace snug::io
