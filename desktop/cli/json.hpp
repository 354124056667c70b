// JSON output: keys in a fixed order, and numbers that read back to the same bits.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fit/any_step.hpp"
#include "geometry/volume_fields.hpp"

namespace snug::desktop {

using Json = nlohmann::ordered_json;

/// The value as one line, with its line feed.
[[nodiscard]] inline std::string line_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// The value of a key; null where there is none, or where the JSON is no object.
[[nodiscard]] inline const Json* value_at(const Json& json, std::string_view key) {
  if (!json.is_object()) return nullptr;
  const auto found = json.find(key);
  return found != json.end() ? &*found : nullptr;
}
/// A key's text or number; empty or none where there is none.
[[nodiscard]] inline std::string text_at(const Json& json, std::string_view key) {
  const Json* const value = value_at(json, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}
[[nodiscard]] inline std::optional<double> number_at(const Json& json, std::string_view key) {
  const Json* const value = value_at(json, key);
  return value != nullptr && value->is_number() ? std::optional(value->get<double>()) : std::nullopt;
}

/// The first dim coordinates of a vector.
[[nodiscard]] inline Json json_of(const Vector<double, 3>& v, int dim) {
  Json list = Json::array();
  for (int axis = 0; axis < dim; ++axis) list.push_back(v[axis]);
  return list;
}

/// A vector of any scalar, in its own dimension.
template <class Scalar, int Dim>
[[nodiscard]] Json json_of_point(const Vector<Scalar, Dim>& point) {
  Json list = Json::array();
  for (int i = 0; i < Dim; ++i) list.push_back(static_cast<double>(point[i]));
  return list;
}

/// A number as it is, a vector by its first dim coordinates, a matrix by rows, or a list of any of these.
[[nodiscard]] inline Json json_of(double value, int) { return value; }
[[nodiscard]] inline Json json_of(int value, int) { return value; }
[[nodiscard]] inline Json json_of(const Matrix<double, 3>& m, int dim) {
  Json rows = Json::array();
  for (int row = 0; row < dim; ++row) rows.push_back(json_of(Vector<double, 3>(m.row(row).transpose()), dim));
  return rows;
}
template <class Item>
[[nodiscard]] Json json_of(const std::vector<Item>& items, int dim) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(json_of(item, dim));
  return list;
}

/// The fields of a volume. volume: lifted from that dimension.
[[nodiscard]] inline Json json_of(const fit::Volume3& volume, int dim) {
  Json json;
  const auto see = [&](std::string_view name, const auto& value) { json[std::string(name)] = json_of(value, dim); };
  std::visit([&](const auto& kind) { fields_of(kind, see); }, volume);
  return json;
}

}  // namespace snug::desktop
