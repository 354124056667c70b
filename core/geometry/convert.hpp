// Volumes and facts in another scalar and dimension, field by field: the one place that lifts, lowers and casts.
#pragma once

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "geometry/vector.hpp"
#include "trace/fields.hpp"

namespace snug {

/// Going up, the added coordinates are 0, the added axes coordinate axes, and the added indices kNoIndex or 0; going
/// down, whatever the smaller dimension lacks is dropped.
template <class To, class From>
void convert_into(To& to, const From& from);

namespace converting {

template <class To, class From>
void each(To& to, const From& from) {
  for (std::size_t i = 0; i < std::min(to.size(), from.size()); ++i) convert_into(to[i], from[i]);
}

template <class To, class From>
void matrix(To& to, const From& from) {
  constexpr int kRows = std::min(int{To::RowsAtCompileTime}, int{From::RowsAtCompileTime});
  using Scalar = typename To::Scalar;
  if constexpr (To::ColsAtCompileTime == 1) {
    to.setZero();
    to.template head<kRows>() = from.template head<kRows>().template cast<Scalar>();
  } else {
    to.setIdentity();
    to.template topLeftCorner<kRows, kRows>() = from.template topLeftCorner<kRows, kRows>().template cast<Scalar>();
  }
}

template <class Type>
inline constexpr bool kIsArray = false;
template <class Item, std::size_t size>
inline constexpr bool kIsArray<std::array<Item, size>> = true;

template <class Type>
inline constexpr bool kIsVector = false;
template <class Item>
inline constexpr bool kIsVector<std::vector<Item>> = true;

}  // namespace converting

template <class To, class From>
void convert_into(To& to, const From& from) {
  if constexpr (std::is_same_v<To, From>) {
    to = from;
  } else if constexpr (std::is_arithmetic_v<From> || std::is_enum_v<From>) {
    to = static_cast<To>(from);
  } else if constexpr (requires { From::RowsAtCompileTime; }) {
    converting::matrix(to, from);
  } else if constexpr (converting::kIsVector<From>) {
    to.resize(from.size());
    converting::each(to, from);
  } else if constexpr (converting::kIsArray<From>) {
    using Item = typename To::value_type;
    if constexpr (std::is_same_v<Item, Index>) to.fill(kNoIndex);
    else if constexpr (std::is_arithmetic_v<Item>) to.fill(Item());
    converting::each(to, from);
  } else {
    static_assert(Listed<From> && Listed<To>, "a field of a kind that nobody has converted yet");
    [&]<std::size_t... kAt>(std::index_sequence<kAt...>, auto fields_to, auto fields_from) {
      (convert_into(std::get<kAt>(fields_to), std::get<kAt>(fields_from)), ...);
    }
    (std::make_index_sequence<From::kFields.size()>(), To::tie(to), From::tie(from));
  }
}

/// A volume or a fact in another scalar and dimension. From float to double and from the plane to space nothing is
/// lost, and the way back is exact.
template <class Scalar, int Dim, template <class, int> class Kind, class From, int kFrom>
[[nodiscard]] Kind<Scalar, Dim> converted(const Kind<From, kFrom>& own) {
  if constexpr (std::is_same_v<Kind<Scalar, Dim>, Kind<From, kFrom>>) return own;
  Kind<Scalar, Dim> result;
  convert_into(result, own);
  return result;
}

}  // namespace snug
