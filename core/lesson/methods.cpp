#include "lesson/methods.hpp"

#include "lesson/box_tests.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/scene_runs.hpp"

namespace snug::lesson {

bool has_boxes(std::string_view volume) { return volume == kBoxPair || volume == kFrustumBox; }

std::span<const fit::Algorithm> methods_of(std::string_view volume) {
  if (volume == kScene) return scene_methods();
  return volume == kBoxPair ? box_tests() : volume == kFrustumBox ? frustum_tests() : fit::algorithms_of(volume);
}

const fit::Algorithm* find_method(std::string_view volume, std::string_view name) {
  for (const fit::Algorithm& method : methods_of(volume))
    if (method.name == name) return &method;
  return nullptr;
}

}  // namespace snug::lesson
