// A scene as text: the part of a lesson's file that declares it, which the student reads and edits beside the stage.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/file_place.hpp"
#include "lesson/subjects/scene/scene_set.hpp"
#include "lesson/toml.hpp"

namespace snug::lesson {

/// The table [scene] of a lesson or of a situation as a text of its own, in the order of the file, without "graph".
[[nodiscard]] std::string write_scene(const toml::table& scene);

/// The text with "called = false" in the effects that are not called for. called: one for each effect, in its order.
[[nodiscard]] std::string with_calls(std::string_view text, const std::vector<bool>& called);

/// A scene that was typed, or what is wrong with it.
struct SceneTyped {
  std::optional<SceneSet> set;
  std::vector<FileError> mistakes;  // in the order of the text
};
/// Reads a text like that of write_scene, whose effects the student edits.
[[nodiscard]] SceneTyped read_typed(std::string_view text);

}  // namespace snug::lesson
