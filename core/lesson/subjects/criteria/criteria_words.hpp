// What is said of volumes and their criteria: short names, figures, the tables.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"
#include "lesson/subjects/criteria/criteria.hpp"

namespace snug::lesson {

/// What can be asked: "least" and "order", each with the figure by which.
[[nodiscard]] std::vector<FactQuestionKind> criteria_question_kinds();

/// "Sphere", "AABB", "14-DOP", "Hull".
[[nodiscard]] std::string_view short_title(const Method& method);

/// Why the volume with the least total cost wins, from the terms as they were measured: which part it saves most on
/// beside the next, and what it does there. own: with that load.
[[nodiscard]] std::string winner_text(const CriteriaSubject& subject, const Load& own);

/// "35.1 ns", "1.20 µs", "3.40 ms", "2.10 s"; where operations were counted, "1,200".
[[nodiscard]] std::string cost_text(double ns, bool counted);

/// The three tables that the volumes have.
enum class CriteriaTableKind : std::uint8_t { kCriteria, kTotal, kRanks };

struct CriteriaCell {
  std::string text;           // a dash where it is not known
  std::optional<double> key;  // to sort by; less is better
};

struct CriteriaTable {
  std::vector<std::string> head;                 // of each column; that of the first is the volumes'
  std::vector<std::string> names;                // the first cell of each row
  std::vector<std::vector<CriteriaCell>> cells;  // of each row, without that
};

/// The table as the sliders stand. Without a measurement it has what is known without a clock.
[[nodiscard]] CriteriaTable criteria_table(const CriteriaSubject& subject, CriteriaTableKind kind);

/// "1.35 times the hull"; "flat" where the hull is.
[[nodiscard]] std::string looseness_words(const FittedVolume& volume);

/// Where the total cost of a volume goes, beside the least: what speaks for it, and what against it.
[[nodiscard]] std::string defence_text(const CriteriaSubject& subject, std::size_t volume);

}  // namespace snug::lesson
