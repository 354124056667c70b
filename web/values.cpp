#include "web/values.hpp"

namespace snug::web {

emscripten::val parsed(const std::string& json) {
  return emscripten::val::global("JSON").call<emscripten::val>("parse", json);
}

}  // namespace snug::web
