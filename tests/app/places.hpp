// Where the tests find what they read.
#pragma once

#include <string>

namespace snug::app {

/// The folders of the prepared assets and of the lessons, each with a slash at its end. The file that defines these is
/// compiled with the clone's place, and no other, so that clones share what ccache keeps of all others.
const std::string& assets_folder();
const std::string& lessons_folder();

}  // namespace snug::app
