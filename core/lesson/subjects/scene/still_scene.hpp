// The stage of a lesson that declares no scene, as a scene in which nothing moves.
#pragma once

#include "lesson/subject.hpp"
#include "scene/declaration.hpp"

namespace snug::lesson {

/// A fixed body made of each thing's points, without any effect. In 2-D z is 0.
[[nodiscard]] scene::Declaration still_scene(const Subject& subject);

/// The scene of any lesson with a method applied; still_scene, if the lesson declares none. Errors: those of
/// declaration_with.
[[nodiscard]] tl::expected<scene::Declaration, InputError> declared(const Subject& subject, std::string_view method);

}  // namespace snug::lesson
