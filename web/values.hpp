// Makes JavaScript values.
#pragma once

#include <emscripten/val.h>

#include <string>
#include <string_view>

namespace snug::web {

[[nodiscard]] inline emscripten::val text(std::string_view words) { return emscripten::val(std::string(words)); }
[[nodiscard]] inline emscripten::val number(double value) { return emscripten::val(value); }

/// An array of make(item) for each item.
template <class Items, class Make>
[[nodiscard]] emscripten::val array_of(const Items& items, Make make) {
  emscripten::val array = emscripten::val::array();
  int i = 0;
  for (const auto& item : items) array.set(i++, make(item));
  return array;
}

}  // namespace snug::web
