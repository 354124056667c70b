// Builds a student's C++ and tries it: what `snug lab check` does, and `snug grade` again with a file that was handed
// in.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/input_error.hpp"
#include "write/judge.hpp"

namespace snug::desktop {

/// A lab: its function, and what its README says of it.
struct Lab {
  std::string_view name, function, title, words;
};
[[nodiscard]] std::span<const Lab> labs();
/// Null if there is none of that name.
[[nodiscard]] const Lab* find_lab(std::string_view name);
/// A lab as result files name it: "lab:overlap".
inline constexpr std::string_view kLabPrefix = "lab:";

/// A case that was answered wrong.
struct CounterExample {
  std::string kind;
  write::Numbers input;
  write::Answered answer;
};
struct LabChecked {
  write::Judged judged;
  std::optional<CounterExample> first, shortest;  // none if all pass; the shortest only where one is shorter
  std::string ended;                              // how it ended, if it did not come to its end; names the line
};

/// source: a path. search: whether a shorter counter-example is searched for. Errors: it cannot be built, with what the
/// compiler says; the machine lacks what is needed.
[[nodiscard]] tl::expected<LabChecked, InputError> check_lab(const Lab& lab, const std::string& source,
                                                             std::uint64_t seed, bool search);

}  // namespace snug::desktop
