// Converts volumes to float. Bounds, half extents and lengths are rounded outward, so that no box or k-DOP loses a
// point.
#pragma once

#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

#include "geometry/convert.hpp"
#include "geometry/volume.hpp"

namespace snug::desktop {

/// The least float that is not below the value.
inline float float_above(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) < value ? std::nextafter(nearest, std::numeric_limits<float>::infinity())
                                              : nearest;
}
inline float float_below(double value) { return -float_above(-value); }

enum class RoundTo { kNearest, kBelow, kAbove };

inline void round_field(float& to, double from, RoundTo round) {
  to = round == RoundTo::kBelow ? float_below(from) : float_above(from);
}
template <class To, class From>
void round_field(To& to, const From& from, RoundTo round) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(from.size()); ++i) round_field(to[i], from[i], round);
}

/// The direction in which a field with that name is rounded. A single number is a length.
template <class Field>
constexpr RoundTo outward(std::string_view field) {
  if (field == "min") return RoundTo::kBelow;
  const bool above = std::is_same_v<Field, double> || field == "max" || field == "half_extents";
  return above ? RoundTo::kAbove : RoundTo::kNearest;
}

template <int Dim>
[[nodiscard]] Volume<float, Dim> in_float(const Volume<double, Dim>& volume) {
  const auto rounded = []<template <class, int> class Kind>(const Kind<double, Dim>& own) {
    auto result = converted<float, Dim>(own);
    [&]<std::size_t... kAt>(std::index_sequence<kAt...>, auto to, auto from) {
      const auto field = [&]<std::size_t at>(std::integral_constant<std::size_t, at>) {
        using Field = std::remove_cvref_t<std::tuple_element_t<at, decltype(from)>>;
        constexpr RoundTo kRound = outward<Field>(Kind<double, Dim>::kFields[at]);
        if constexpr (kRound != RoundTo::kNearest) round_field(std::get<at>(to), std::get<at>(from), kRound);
      };
      (field(std::integral_constant<std::size_t, kAt>()), ...);
    }
    (std::make_index_sequence<Kind<double, Dim>::kFields.size()>(), Kind<float, Dim>::tie(result),
     Kind<double, Dim>::tie(own));
    return Volume<float, Dim>(std::move(result));
  };
  return std::visit(rounded, volume);
}

}  // namespace snug::desktop
