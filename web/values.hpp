// What the page is told (app/told), as JavaScript values.
#pragma once

#include <emscripten/val.h>

#include <string>

#include "app/told/json.hpp"

namespace snug::web {

[[nodiscard]] emscripten::val parsed(const std::string& json);

template <class Told>
[[nodiscard]] emscripten::val value_of(const Told& told) {
  return parsed(app::told::json_of(told));
}

}  // namespace snug::web
