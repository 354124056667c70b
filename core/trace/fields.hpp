// How facts list their fields: the names in kFields, and the fields themselves, to be read or written, by tie.
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace snug {

/// A type that lists its fields.
template <class Type>
concept Listed = requires(const Type& own) {
  Type::kFields.size();
  Type::tie(own);
};

/// Calls see(name, field) for each field, in order. The fields can be written if own is not const.
void see_fields(auto& own, auto&& see) {
  using Type = std::remove_const_t<std::remove_reference_t<decltype(own)>>;
  static_assert(Type::kFields.size() == std::tuple_size_v<decltype(Type::tie(own))>);
  const auto call = [&]<std::size_t... kAt>(std::index_sequence<kAt...>, auto fields) {
    (see(Type::kFields[kAt], std::get<kAt>(fields)), ...);
  };
  call(std::make_index_sequence<Type::kFields.size()>(), Type::tie(own));
}

}  // namespace snug
