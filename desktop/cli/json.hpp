// JSON as the contract has it: keys in their order, numbers that read back to the same bits.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/sphere.hpp"
#include "geometry/vector.hpp"

namespace snug::desktop {

using Json = nlohmann::ordered_json;

/// As one line with its line feed.
[[nodiscard]] inline std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// The first dim coordinates.
[[nodiscard]] inline Json json_of(const Vector<double, 3>& v, int dim) {
  Json list = Json::array();
  for (int axis = 0; axis < dim; ++axis)
    list.push_back(v[axis]);
  return list;
}

[[nodiscard]] inline Json json_of(const Sphere<double, 3>& sphere, int dim) {
  return {{"center", json_of(sphere.center, dim)}, {"radius", sphere.radius}};
}

}  // namespace snug::desktop
