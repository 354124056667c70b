// Reads the exercises in which a function is written (lessons/README.md, "Written"), and answers and checks them.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "desktop/cli/json.hpp"
#include "geometry/input_error.hpp"
#include "write/function.hpp"

namespace snug::desktop {

/// A usual mistake: what of the reference solution it has in place of what, and the kind of cases that shows it.
struct UsualMistake {
  std::string says, fails, from, to;
};
/// Another method, for the chart of what it costs.
struct OtherMethod {
  std::string title, code;
  bool exact = false;  // whether it earns every mark
};
struct WrittenExercise {
  std::string id, path;  // "write:overlap-min-max"
  std::string title, lesson, model, stub;
  int minutes = 0;
  std::vector<OtherMethod> methods;
  std::vector<UsualMistake> mistakes;
  const write::Function* function = nullptr;
};

/// The exercises of a lessons folder ("" is the program's own), by id. Errors: the first bad file; a function that the
/// program does not have.
[[nodiscard]] tl::expected<std::vector<WrittenExercise>, InputError> read_written(const std::string& folder);
/// Errors: those of its file; no such exercise.
[[nodiscard]] tl::expected<WrittenExercise, InputError> find_written(const std::string& folder, const std::string& id);

/// The line of `snug exercise list`, of `make`, and of `check`, which tries the reference solution on so many seeds,
/// and the stub, the other methods and the usual mistakes on one; and the result file of `answer`. wrong: the number of
/// a mistake, 0 for none. sets: those that name it, beside the one of all that are written. Errors: there is no such
/// mistake; the engine did not start.
[[nodiscard]] Json listed(const WrittenExercise& exercise, Json sets);
[[nodiscard]] Json instance_of(const WrittenExercise& exercise, std::uint64_t seed);
[[nodiscard]] tl::expected<Json, InputError> checked(const WrittenExercise& exercise, int seeds);
[[nodiscard]] tl::expected<Json, InputError> answered(const WrittenExercise& exercise, std::uint64_t seed, int wrong);

}  // namespace snug::desktop
