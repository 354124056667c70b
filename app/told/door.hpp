// What else the page is told.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/told/words.hpp"

namespace snug::app::told {

/// What can be dragged, at its place on the canvas.
struct Handle {
  std::string id;
  float x = 0, y = 0;
  SNUG_FIELDS(id, x, y);
};

/// A place on the canvas.
struct Point {
  float x = 0, y = 0;
  SNUG_FIELDS(x, y);
};

/// What a lesson's file comes to. mesh: the one that the page must load for it, "" for none. error: the first mistake,
/// "" for none.
struct LessonRead {
  bool draws = false;
  std::string mesh, error;
  SNUG_FIELDS(draws, mesh, error);
};

/// Where one stands. whole: whether the address has room for all of it.
struct PlaceNow {
  std::string address;
  bool whole = false;
  SNUG_FIELDS(address, whole);
};

/// An address. bare: whether it names no place. mesh: that is needed on the way to it, "" for none.
struct PlaceRead {
  std::vector<std::string> mistakes;
  bool bare = false;
  std::optional<int> step;
  std::string mesh;
  SNUG_FIELDS(mistakes, bare, step, mesh);
};

/// A part of the way there. refused: why it was, "" if it was not.
struct WayGone {
  bool done = false;
  std::string refused;
  SNUG_FIELDS(done, refused);
};

/// A file of what a cover shows. text: empty for a PNG, which the page makes.
struct CoverFile {
  std::string name, text;
  SNUG_FIELDS(name, text);
};

}  // namespace snug::app::told
