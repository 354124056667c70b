// The course: its lessons in order, under their chapters, as in lessons/course.toml.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"

namespace snug::lesson {

struct Chapter {
  std::string title;
  std::vector<std::string> lessons;  // their ids, in order
};

/// Something that the course is to teach, as a lecture has it.
struct Idea {
  std::string id;     // as lessons name what they cover: "L1.sphere.ritter"
  std::string slide;  // the title of the slide
};

struct Course {
  std::vector<Chapter> chapters;
  std::vector<Idea> ideas;  // in the lectures' order; none if the file lists none
  std::string playground;   // the id of the lesson that takes the points of any other (playground.hpp); empty for none
};

/// The slides of the ideas that a lesson covers, each once.
[[nodiscard]] std::vector<std::string> slides_of(const Course& course, std::span<const std::string> covers);

/// Reads a course file. name: for errors. ids: those of the existing lessons. Errors, each with its line: of TOML, an
/// unknown or missing key, a lesson that does not exist, is named twice or is in no chapter.
[[nodiscard]] tl::expected<Course, InputError> read_course(std::string_view toml, std::string_view name,
                                                           std::span<const std::string> ids);

}  // namespace snug::lesson
