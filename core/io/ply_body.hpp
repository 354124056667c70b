// The data after a PLY header, one value at a time, as text and as bytes. Both remember the first error, so that a
// reader need only check whether it got a value.
#pragma once

#include "io/ply_header.hpp"
#include "io/point_file.hpp"

namespace snug::io {

/// Data as text: an instance of an element begins a line, and may go on to the next.
class PlyText {
 public:
  PlyText(const PlyHeader& header, std::string_view whole, const Wanted& wanted);

  /// The fewest bytes that an instance can take.
  [[nodiscard]] static std::int64_t smallest(const PlyElement& element);
  /// How many bytes are left, plus one for a line feed that the last line may lack.
  [[nodiscard]] std::int64_t left() const { return static_cast<std::int64_t>(lines_.rest().size()) + 1; }

  bool begin(const PlyElement& element, std::int64_t instance);
  bool number(PlyType type, double& value);
  /// Reads a number: value is none if it is not an integer. Returns false only at the end of the data.
  bool whole(PlyType type, std::optional<std::int64_t>& value);
  [[nodiscard]] std::string not_integer() const;
  bool skip(PlyType type, std::int64_t n);
  bool end();
  /// Counts what is left, which is passed over.
  void finish(PointFile& file);

  bool fail(std::string what);
  [[nodiscard]] InputError error() const { return error_; }

 private:
  bool word(std::string_view& word);

  Lines lines_;
  Wanted wanted_;
  std::string_view rest_, word_;
  std::int64_t first_ = 0;  // the line on which the instance begins
  InputError error_;
};

class PlyBytes {
 public:
  PlyBytes(const PlyHeader& header, std::string_view whole, const Wanted& wanted);

  [[nodiscard]] static std::int64_t smallest(const PlyElement& element);
  [[nodiscard]] std::int64_t left() const { return static_cast<std::int64_t>(bytes_.size() - at_); }

  bool begin(const PlyElement& element, std::int64_t instance);
  bool number(PlyType type, double& value);
  /// Reads a number: value is none if it is not an integer. Returns false only at the end of the data.
  bool whole(PlyType type, std::optional<std::int64_t>& value);
  [[nodiscard]] std::string not_integer() const;
  bool skip(PlyType type, std::int64_t n);
  bool end() { return true; }
  void finish(PointFile& file);

  bool fail(std::string what);
  [[nodiscard]] InputError error() const { return error_; }

 private:
  bool bits(PlyType type, std::uint64_t& value);
  bool cut_short();

  std::string_view bytes_;
  std::size_t at_;     // of the next value
  std::size_t value_;  // of the last value, for errors
  bool big_endian_;
  Wanted wanted_;
  InputError error_;
};

}  // namespace snug::io
