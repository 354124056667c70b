// A scene's frame in a sentence.
#pragma once

#include <string>

#include "lesson/session.hpp"

namespace snug::app {

/// The sentence ends before a figure that is still to be predicted. session: null where nothing is.
[[nodiscard]] std::string frame_caption(const fit::FrameTaken& fact, const lesson::Session* session);

/// An effect's name as people say it: "broad phase".
[[nodiscard]] std::string effect_words(std::string name);

}  // namespace snug::app
