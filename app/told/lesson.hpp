// What stays while a lesson is open.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/told/prose.hpp"
#include "app/told/stage.hpp"

namespace snug::app::told {

struct PointSet {
  std::string_view generate;
  int count = 0;
  std::string_view mesh;
  Scalar scalar;
  SNUG_FIELDS(generate, count, mesh, scalar);
};

struct Section {
  std::string_view title, situation;
  List<Block> blocks;
  SNUG_FIELDS(title, situation, blocks);
};

struct LessonAlgorithm {
  std::string_view name;
  std::string title;
  std::string_view source;
  Index max_points = 0;
  SNUG_FIELDS(name, title, source, max_points);
};

struct Tools {
  std::string_view word, title;
  bool points = false;
  SNUG_FIELDS(word, title, points);
};

struct Situation : PointSet {
  using Base = PointSet;
  std::string_view name;
  std::string title;
  SNUG_FIELDS(name, title);
};

struct LessonTask {
  std::string heading;
  Paragraph prompt, hint;
  std::string_view algorithm;
  int points = 0;
  std::string start;
  SNUG_FIELDS(heading, prompt, hint, algorithm, points, start);
};

/// situations: none where the lesson has only its own.
struct Lesson : PointSet {
  using Base = PointSet;
  std::string_view id;
  int minutes = 0;
  std::string_view title, summary;
  List<Section> sections;
  List<LessonAlgorithm> algorithms;
  Word<"step", "frame"> step_word;
  bool measures = false;
  Tools tools;
  std::string_view stage_says;
  std::array<std::string_view, 2> handle_words;
  List<Situation> situations;
  int dim = 2;
  std::uint64_t seed = 0;
  std::span<const std::string> meshes, generators;
  std::string_view compare;
  List<LessonTask> tasks;
  SNUG_FIELDS(id, minutes, title, summary, sections, algorithms, step_word, measures, tools, stage_says, handle_words,
              situations, dim, seed, meshes, generators, compare, tasks);
};

[[nodiscard]] Lesson lesson_of(const lesson::Session& session);
/// The same as JSON: whoever wants no more need not compile what destroys it.
[[nodiscard]] std::string lesson_text(const lesson::Session& session);

}  // namespace snug::app::told
