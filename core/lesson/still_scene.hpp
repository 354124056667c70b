// A lesson that declares no scene, as one: what stands on its stage, which nothing moves.
#pragma once

#include "lesson/lesson.hpp"

namespace snug::lesson {

/// Fixed bodies, of its points or of its two boxes' corners, and no effect, for it calls for none. In 2-D z is 0.
[[nodiscard]] SceneSet still_scene(const Lesson& lesson);

}  // namespace snug::lesson
