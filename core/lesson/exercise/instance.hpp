// What an exercise is about for one student: made from a seed, and vetted before it is handed out.
#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>

#include "lesson/exercise/exercise.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

struct Instance {
  std::uint64_t own = 0;  // that of its points, which no other exercise has
  int passed_over = 0;    // how many seeds were passed over, which do not keep the promise
  Lesson lesson;          // the stage, with a question for every decision of the run
};

/// The instance of a seed: the first of a sequence that begins there, and that each exercise has for itself, in which
/// the promise is kept. The same everywhere. Errors: the stage cannot be opened; none of the first thousand keeps it,
/// with what most of them lack.
[[nodiscard]] tl::expected<Instance, InputError> make_instance(const Exercise& exercise, std::uint64_t seed);

/// A session on it, with nothing decided yet. clock: times the decisions; null for no times.
/// practises: all is told at once.
[[nodiscard]] tl::expected<Session, InputError> open_instance(const Exercise& exercise, const Instance& instance,
                                                              Clock clock = nullptr, bool practises = false);

/// The seed of a name: so each student has an instance, and the name stays on the device.
[[nodiscard]] std::uint64_t seed_of(std::string_view name);

/// Which of the exercise's decisions a question of an instance is.
[[nodiscard]] std::size_t decision_of(const Exercise& exercise, const Question& question);
/// The wrong rule of that name; null if the question has none.
[[nodiscard]] const WrongRule* find_rule(const Asked& asked, std::string_view name);

}  // namespace snug::lesson
