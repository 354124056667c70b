// The parts of `snug lesson` that have files of their own: each adds itself to the group.
#pragma once

#include "desktop/cli/command.hpp"

namespace snug::desktop {

/// The options that name a lesson: LESSON and --lessons.
void add_lesson_options(CLI::App& command, std::string& folder, std::string& id);

void add_lesson_coverage(Commands& commands, CLI::App& group);
void add_lesson_facts(Commands& commands, CLI::App& group);
void add_lesson_table(Commands& commands, CLI::App& group);
void add_lesson_new(Commands& commands, CLI::App& group);

}  // namespace snug::desktop
