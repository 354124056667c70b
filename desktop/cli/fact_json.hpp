// Writes the steps of queries as JSON, from the fields that their facts list.
#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "desktop/cli/json.hpp"
#include "trace/fields.hpp"

namespace snug::desktop {

/// Adds a fact's fields. dim: how many coordinates of 3-D vectors are written; planar vectors have two.
template <class Fact>
void add_fields(Json& json, const Fact& fact, int dim) {
  const auto list_of = [dim](const auto& vector) {
    Json list = Json::array();
    for (int i = 0; i < std::min(dim, static_cast<int>(vector.size())); ++i)
      list.push_back(static_cast<double>(vector[i]));
    return list;
  };
  see_fields(fact, [&](std::string_view name, const auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    Json& field = json[std::string(name)];
    if constexpr (std::is_enum_v<Value>) {
      field = static_cast<int>(value);
    } else if constexpr (std::is_arithmetic_v<Value> || std::is_same_v<Value, std::vector<Index>> ||
                         std::is_same_v<Value, std::vector<double>>) {
      field = value;
    } else if constexpr (Value::ColsAtCompileTime == 1) {
      field = list_of(value);
    } else {
      field = Json::array();
      for (int row = 0; row < std::min(dim, static_cast<int>(value.rows())); ++row)
        field.push_back(list_of(value.row(row)));
    }
  });
}

/// A step as one line of a trace, with its line feed. about: what it is a step of, written first. Step: has a line and
/// a fact.
template <class Step>
[[nodiscard]] std::string trace_line(Json about, const Step& step, int dim) {
  std::visit(
      [&](const auto& fact) {
        about["step"] = std::string_view(fact.kName);
        about["line"] = step.line;
        add_fields(about, fact, dim);
      },
      step.fact);
  return line_of(about);
}

}  // namespace snug::desktop
