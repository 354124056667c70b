// What stands on the stage of a lesson that declares no scene, as one: nothing moves it.
#pragma once

#include "lesson/subject.hpp"
#include "scene/declaration.hpp"

namespace snug::lesson {

/// Fixed bodies, of its points or of its two boxes' vertices, and no effect, for it calls for none. In 2-D z is 0.
[[nodiscard]] scene::Declaration still_scene(const Subject& subject);

/// The scene of any lesson, as a method of its subject has it: of one that declares none, still_scene. Errors: as of
/// declaration_with.
[[nodiscard]] tl::expected<scene::Declaration, InputError> declared(const Subject& subject, std::string_view method);

}  // namespace snug::lesson
