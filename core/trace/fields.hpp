// How facts and volumes list their fields: the names in kFields, and the fields themselves, to be read or written, by
// tie. SNUG_FIELDS(a, b) lists both for a type whose members are called a and b.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

namespace snug {

/// How many names there are in "a, b"; and the names.
consteval std::size_t count_of_names(std::string_view all) {
  return all.empty() ? 0 : 1 + static_cast<std::size_t>(std::count(all.begin(), all.end(), ','));
}
template <std::size_t kCount>
consteval std::array<std::string_view, kCount> names_in(std::string_view all) {
  std::array<std::string_view, kCount> names;
  for (std::string_view& name : names) {
    name = all.substr(0, all.find(','));
    all.remove_prefix(std::min(name.size() + std::string_view(", ").size(), all.size()));
  }
  return names;
}

#define SNUG_FIELDS(...)                                                                                               \
  auto fields() { return std::tie(__VA_ARGS__); }                                                                      \
  auto fields() const { return std::tie(__VA_ARGS__); }                                                                \
  static auto tie(auto& own) { return own.fields(); }                                                                  \
  static constexpr auto kFields = ::snug::names_in<::snug::count_of_names(#__VA_ARGS__)>(#__VA_ARGS__)

/// A type that lists its fields.
template <class Type>
concept Listed = requires(const Type& own) {
  Type::kFields.size();
  Type::tie(own);
};

/// Calls see(name, field) for each of the fields, in order.
template <std::size_t kCount>
void see_each(const std::array<std::string_view, kCount>& names, auto fields, auto&& see) {
  static_assert(kCount == std::tuple_size_v<decltype(fields)>);
  const auto call = [&]<std::size_t... kAt>(std::index_sequence<kAt...>) {
    (see(names[kAt], std::get<kAt>(fields)), ...);
  };
  call(std::make_index_sequence<kCount>());
}
/// The same for the members that are named, within a member function.
#define SNUG_SEE(see, ...)                                                                                             \
  ::snug::see_each(::snug::names_in<::snug::count_of_names(#__VA_ARGS__)>(#__VA_ARGS__), std::tie(__VA_ARGS__), see)

/// The same for all fields of a type that lists them. They can be written if own is not const.
void see_fields(auto& own, auto&& see) {
  using Type = std::remove_const_t<std::remove_reference_t<decltype(own)>>;
  see_each(Type::kFields, Type::tie(own), see);
}

}  // namespace snug
