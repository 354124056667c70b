// A place in a lesson's file, and what is wrong there.
#pragma once

#include <string>

#include "geometry/input_error.hpp"

namespace snug::lesson {

/// Both are counted from 1. A line alone is its beginning.
struct FilePlace {
  FilePlace(int line = 1, int column = 1) : line(line), column(column) {}  // NOLINT: a line is a place
  int line, column;
};

struct FileError {
  FilePlace place;
  std::string what;  // one sentence fragment, no full stop
  std::string file;

  /// "FILE:LINE:COLUMN: what"
  [[nodiscard]] std::string message() const {
    return file + ':' + std::to_string(place.line) + ':' + std::to_string(place.column) + ": " + what;
  }
  /// The same for those who know only lines.
  [[nodiscard]] InputError error() const { return {what, file, InputError::Unit::kLine, place.line}; }
};

}  // namespace snug::lesson
