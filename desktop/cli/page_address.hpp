// The address at which the class's page shows what stands in a session.
#pragma once

#include <string>
#include <vector>

#include "lesson/session.hpp"

namespace snug::desktop {

/// "?lesson=ID&step=3&seed=7", after the address of the class's page if the defaults name one; "" if the lesson's
/// points cannot be read. camera: App::hand_view, if the address is to have it.
[[nodiscard]] std::string page_address(const lesson::Session& session, std::vector<double> camera = {});

/// The code of a state: its address, which is without the points of one's own if they are too many for a code; the
/// letters of its trace; and what is said below.
struct CodeWords {
  std::string address, letters, says;
};
/// camera: as for page_address.
[[nodiscard]] CodeWords code_words(const lesson::Session& session, std::vector<double> camera = {});

}  // namespace snug::desktop
