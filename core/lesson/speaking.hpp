// How prose speaks to the stage: which handles a mark lights, and which section the step is about.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lesson/session.hpp"

namespace snug::lesson {

/// The handles that a mark lights now. mark: "support", those that hold the volume as it stands; a fact's name, those
/// of its last step up to now, "plane_tested/2" the second of them; or a handle's name. None where there is nothing of
/// it, or where the question that stands asks for it.
[[nodiscard]] std::vector<Index> marked_handles(const Session& session, std::string_view mark);

/// The marks that the lesson's prose links to, each once; and those of them that light a handle now.
[[nodiscard]] std::vector<std::string_view> marks_of(const Lesson& lesson);
[[nodiscard]] std::vector<std::string_view> marks_at(const Session& session, Index handle);

/// Whether that can be a mark of a lesson on that subject; and whether it lights anything at some step of a run on it.
[[nodiscard]] bool is_mark(const Subject& subject, std::string_view mark);
[[nodiscard]] bool lights(const Run& run, const Subject& subject, std::string_view mark);

/// The section that the open question is about, or else the step that was done last; counted from 0. None before the
/// first step, and where none speaks of what was done.
[[nodiscard]] std::optional<int> section_at(const Session& session);

}  // namespace snug::lesson
