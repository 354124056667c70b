// How the prose is linked to the stage: which handles a mark lights, and which section the step is about.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lesson/session.hpp"

namespace snug::lesson {

/// The handle of that name.
[[nodiscard]] std::optional<Index> handle_named(const Subject& subject, std::string_view name);

/// The handles that a mark lights now. mark: "support", for the support set at the current step; a fact's name, for the
/// handles of its last step so far ("plane_tested/2" for the second of them); or a handle's name. None if there are no
/// such handles, or while a question is answered on the stage.
[[nodiscard]] std::vector<Index> marked_handles(const Session& session, std::string_view mark);

/// The marks that the lesson's prose links to, each once; and those of them that light a given handle now.
[[nodiscard]] std::vector<std::string_view> marks_of(const Lesson& lesson);
[[nodiscard]] std::vector<std::string_view> marks_at(const Session& session, Index handle);

/// Whether a subject knows a mark that lights something else than handles, as a row of its table; one for each such
/// subject, in subjects.cpp.
using MarkOn = bool (*)(const Subject& subject, std::string_view mark);
[[nodiscard]] std::span<const MarkOn> marks_on_subjects();

/// Whether a lesson on the subject can have this mark; and whether it lights anything at some step of a run.
[[nodiscard]] bool is_mark(const Subject& subject, std::string_view mark);
[[nodiscard]] bool lights(const Run& run, const Subject& subject, std::string_view mark);

/// The section that the open question is about or, without one, the last step; counted from 0. None before the first
/// step, or if no section is about the step.
[[nodiscard]] std::optional<int> section_at(const Session& session);

}  // namespace snug::lesson
