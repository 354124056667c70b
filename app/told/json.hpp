// Writes what is told as JSON.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/told/words.hpp"

namespace snug::app::told {

/// "closeUp" of close_up, "short" of short_.
[[nodiscard]] std::string camel_case(std::string_view field);

/// Each adds a value to a text, after a comma if one is wanted there.
void write_word(std::string& json, std::string_view word);  // as it is
void write_text(std::string& json, std::string_view text);
void write_whole(std::string& json, std::int64_t number);
void write_whole(std::string& json, std::uint64_t number);
void write_number(std::string& json, double number);  // null if it is not finite
/// What comes before an object's or a list's contents.
void write_begin(std::string& json, char bracket);
/// What comes before a value: its name, and a colon.
void write_name(std::string& json, std::string_view name);

template <class Value>
void write(std::string& json, const Value& value);
template <class Value>
void write(std::string& json, const ByName<Value>& values);
template <class Value>
void write(std::string& json, const std::optional<Value>& value);
template <class Value>
void write(std::string& json, const IfAny<Value>& value);
inline void write(std::string& json, const std::vector<bool>& values);

template <Literal... kWords>
void write(std::string& json, const Word<kWords...>& one) {
  write_text(json, one.word);
}

template <class Value>
void write(std::string& json, const std::optional<Value>& value) {
  value ? write(json, *value) : write_word(json, "null");
}

template <class Value>
void write(std::string& json, const ByName<Value>& values) {
  write_begin(json, '{');
  for (const auto& [name, value] : values) write_name(json, name), write(json, value);
  json += '}';
}

inline void write(std::string& json, const std::vector<bool>& values) {
  write_begin(json, '[');
  for (const bool value : values) write(json, value);
  json += ']';
}

template <class Value>
void write(std::string& json, const IfAny<Value>& value) {
  if (value.any) write(json, value.value);
}

/// The same of a value whose type only the function knows: one function reads the fields of all objects from tables,
/// and one the values of all lists, which is a third of the code.
using WriteAny = void (*)(std::string& json, const void* value);
template <class Value>
void write_any(std::string& json, const void* value) {
  write(json, *static_cast<const Value*>(value));
}

/// A field of which nothing is written is left out.
void write_fields(std::string& json, std::span<const std::string_view> fields, const void* const* values,
                  const WriteAny* writes);
void write_list(std::string& json, const void* first, std::size_t count, std::size_t stride, WriteAny write);

template <class... Fields>
inline constexpr WriteAny kWrites[] = {&write_any<std::remove_cvref_t<Fields>>...};

/// Without the brackets, so that several can be one object.
template <class Type>
void write_fields(std::string& json, const Type& own) {
  if constexpr (requires { typename Type::Base; }) write_fields(json, static_cast<const typename Type::Base&>(own));
  const auto add = [&]<std::size_t... kAt, class... Fields>(
      std::index_sequence<kAt...>, const std::tuple<Fields...>& fields) __attribute__((always_inline)) {
    const void* const values[] = {&std::get<kAt>(fields)...};
    write_fields(json, Type::kFields, values, kWrites<Fields...>);
  };
  add(std::make_index_sequence<Type::kFields.size()>(), Type::tie(own));
}

template <class Value>
void write(std::string& json, const Value& value) {
  if constexpr (Listed<Value>) {
    write_begin(json, '{');
    write_fields(json, value);
    json += '}';
  } else if constexpr (std::same_as<Value, bool>) {
    write_word(json, value ? "true" : "false");
  } else if constexpr (std::unsigned_integral<Value>) {
    write_whole(json, static_cast<std::uint64_t>(value));
  } else if constexpr (std::integral<Value>) {
    write_whole(json, static_cast<std::int64_t>(value));
  } else if constexpr (std::floating_point<Value>) {
    write_number(json, value);
  } else if constexpr (std::convertible_to<Value, std::string_view>) {
    write_text(json, value);
  } else if constexpr (requires { std::data(value); }) {
    using One = std::remove_cvref_t<decltype(*std::data(value))>;
    write_list(json, std::data(value), std::size(value), sizeof(One), &write_any<One>);
  } else {
    write_begin(json, '[');
    for (const auto& one : value) write(json, one);
    json += ']';
  }
}

template <class Value>
[[nodiscard]] std::string json_of(const Value& value) {
  std::string json;
  write(json, value);
  return json;
}

}  // namespace snug::app::told
