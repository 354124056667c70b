// Orders two volumes of a kind, so that merging them gives the same result whichever is named first.
#pragma once

#include "geometry/volume_fields.hpp"

namespace snug::fit {

/// Compares the volumes' numbers in order: -1, 0 or +1; 0 if all are equal.
template <class VolumeType>
[[nodiscard]] int order_of(const VolumeType& a, const VolumeType& b) {
  std::vector<double> of_a, of_b;
  const auto list = [](std::vector<double>& numbers) {
    return [&numbers](std::string_view, const auto& value) {
      if constexpr (requires {
                      value.data();
                      value.size();
                    }) {
        if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(*value.data())>>)
          for (std::size_t i = 0; i < static_cast<std::size_t>(value.size()); ++i)
            numbers.push_back(static_cast<double>(value.data()[i]));
        else
          for (const auto& v : value) numbers.insert(numbers.end(), v.data(), v.data() + v.size());
      } else {
        numbers.push_back(static_cast<double>(value));
      }
    };
  };
  fields_of(a, list(of_a));
  fields_of(b, list(of_b));
  if (of_a < of_b) return -1;
  return of_b < of_a ? 1 : 0;
}

}  // namespace snug::fit
