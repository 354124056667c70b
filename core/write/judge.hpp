// Judges what a student's function answered: a mark for each kind of cases that it passes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "write/function.hpp"

namespace snug::write {

/// What a function answered to a case, or why it did not: it threw, or what it returned has another shape.
using Answered = tl::expected<Numbers, std::string>;

/// All cases of a function, the random ones first. The same on every machine.
[[nodiscard]] std::vector<Case> cases_of(const Function& function, std::uint64_t seed);

/// A hash of the cases of one seed. A result with another hash was judged by other cases.
[[nodiscard]] std::uint64_t hash_of(const Function& function);

/// The inputs for the program that runs the function, one on each line: as JSON, or as plain numbers.
[[nodiscard]] std::string json_lines(const Function& function, const std::vector<Numbers>& inputs);
[[nodiscard]] std::string number_lines(const std::vector<Numbers>& inputs);
/// Reads what the program answered, one answer on each line: numbers, or ! and the reason why there are none. A missing
/// line means no answer.
[[nodiscard]] std::vector<Answered> read_answers(std::string_view lines, std::size_t count);

[[nodiscard]] bool is_right(const Function& function, const Numbers& input, const Answered& answer);

struct KindPassed {
  const Kind* kind = nullptr;
  int passed = 0, of = 0;
};
struct Judged {
  std::vector<KindPassed> kinds;
  std::optional<std::size_t> first;  // the first case that differs
  [[nodiscard]] int mark() const;
  [[nodiscard]] int of() const { return static_cast<int>(kinds.size()); }
};
/// answers: one for each case.
[[nodiscard]] Judged judge(const Function& function, const std::vector<Case>& cases,
                           const std::vector<Answered>& answers);
/// "All 400 random cases pass. It fails on boxes that only touch."
[[nodiscard]] std::string says(const Judged& judged);

/// A step in the search for the shortest input that fails: valid inputs that are shorter than this one.
[[nodiscard]] std::vector<Numbers> shorter(const Function& function, const Numbers& input);
/// Whether a wrong answer differs from the right one so much that it is seen on the stage.
[[nodiscard]] bool shows(const Function& function, const Numbers& input, const Answered& answer);
/// The first of them that fails; shown: and shows it. None if all are answered right.
[[nodiscard]] std::optional<std::size_t> first_wrong(const Function& function, const std::vector<Numbers>& inputs,
                                                     const std::vector<Answered>& answers, bool shown);

}  // namespace snug::write
