#include "check/draft_text.hpp"

#include <algorithm>
#include <tuple>

#include "geometry/sort.hpp"
#include "io/text.hpp"

namespace snug::check {
namespace {

struct Complaint {
  const FileError* error;
  bool warning;
};

bool comes_first(const Complaint& a, const Complaint& b) {
  const FilePlace x = a.error->place, y = b.error->place;
  return std::tie(x.line, x.column) < std::tie(y.line, y.column);
}

std::string heading_of(const Draft& draft, std::string_view file) {
  std::string text(file);
  const auto mistakes = static_cast<std::int64_t>(draft.mistakes.size());
  const auto warnings = static_cast<std::int64_t>(draft.warnings.size());
  text += ": ";
  if (mistakes > 0) text += io::counted(mistakes, "mistake");
  if (mistakes > 0 && warnings > 0) text += " and ";
  if (warnings > 0) text += io::counted(warnings, "warning");
  return text;
}

}  // namespace

DraftText text_of(const Draft& draft, std::string_view file) {
  if (draft.mistakes.empty() && draft.warnings.empty()) return {};
  std::vector<Complaint> all;
  for (const FileError& mistake : draft.mistakes) all.push_back({&mistake, false});
  for (const FileError& warning : draft.warnings) all.push_back({&warning, true});
  sort_stably(all, comes_first);
  DraftText text{heading_of(draft, file), {}};
  if (!draft.lesson) text.heading += ". It cannot be drawn like this.";
  for (const Complaint& told : all) {
    const FilePlace place = told.error->place;
    text.lines.push_back({std::to_string(place.line) + ':' + std::to_string(place.column) + ": " +
                              (told.warning ? "warning: " : "") + told.error->what,
                          told.warning});
  }
  return text;
}

DraftText text_of(const InputError& mistake, std::string_view file) {
  const Draft draft{
      {}, {{FilePlace(static_cast<int>(std::max<std::int64_t>(1, mistake.position))), mistake.what, {}}}, {}};
  return {heading_of(draft, file), {{std::to_string(draft.mistakes[0].place.line) + ": " + mistake.what, false}}};
}

}  // namespace snug::check
