// The memory that lists take.
#pragma once

#include <cstddef>
#include <vector>

namespace snug::scene {

template <class Value>
[[nodiscard]] std::size_t bytes_in(const std::vector<Value>& values) {
  return values.size() * sizeof(Value);
}
template <class Value>
[[nodiscard]] std::size_t bytes_in(const std::vector<std::vector<Value>>& lists) {
  std::size_t sum = lists.size() * sizeof(std::vector<Value>);
  for (const std::vector<Value>& values : lists) sum += bytes_in(values);
  return sum;
}

}  // namespace snug::scene
