// The lessons' prose: paragraphs, lists and tables, with **strong**, *emphasised* and `code` words, x_{low} and
// x^{high} scripts, [words](kind:target) that link to the stage, $formulas$ in TeX, and {figures} of the run. A
// backslash before one of these signs makes it an ordinary one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// Something wrong with a text ("has a ** without a partner"), and where in it.
struct ProseFault {
  std::string what;
  std::size_t at = 0;
};

/// Where a paragraph stands, which decides what it may have: links in a section's text alone, a formula on a line of
/// its own only where it is a paragraph.
enum class Within : std::uint8_t { kSection, kCell, kPrompt };

/// Reads a text of one paragraph, such as a prompt. Each line end or other white space becomes one space. Adds what is
/// wrong to faults. begin: where the text begins in the whole one, in which faults are placed.
[[nodiscard]] Paragraph paragraph_of(std::string_view text, std::vector<ProseFault>& faults,
                                     Within within = Within::kPrompt, std::size_t begin = 0);

/// Reads the text of a section. Adds what is wrong to faults.
[[nodiscard]] std::vector<Block> blocks_of(std::string_view text, std::vector<ProseFault>& faults);

/// The paragraphs of a section, list items and cells among them; and all of their stretches.
[[nodiscard]] std::vector<const Paragraph*> paragraphs_of(const Section& section);
[[nodiscard]] std::vector<const Stretch*> stretches_of(const Section& section);

/// The words of a paragraph, without markup.
[[nodiscard]] std::string plain_text(const Paragraph& paragraph);

/// What stands between the braces of a figure, and the figure of that name; none if it is not a name.
[[nodiscard]] std::string name_of(const RunFigure& figure);
[[nodiscard]] std::optional<RunFigure> figure_named(std::string_view name);

/// What stands for a figure that is not shown.
inline constexpr std::string_view kHiddenFigure = "…";

/// The end of the code, the formula or the escaped sign that begins there in the text. The same place if none begins
/// there; npos if it does not end.
[[nodiscard]] std::size_t end_of_span(std::string_view text, std::size_t at);

/// The text with each run of white space as one space, and none around it.
[[nodiscard]] std::string joined(std::string_view text);

}  // namespace snug::lesson
