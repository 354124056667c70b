// The types of what is told (app/told), as tsc reads them.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "app/told/json.hpp"

namespace snug::app::told {

/// "Asked" of snug::app::told::Asked.
template <class Type>
[[nodiscard]] std::string name_of_type() {
  std::string_view name = __PRETTY_FUNCTION__;  // "… [with Type = snug::app::told::Asked; …"
  name.remove_prefix(name.find("Type = ") + 7);
  name = name.substr(0, name.find_first_of(";]"));
  return std::string(name.substr(name.rfind(':') + 1));
}

template <class>
struct IsWord : std::false_type {};
template <Literal... kWords>
struct IsWord<Word<kWords...>> : std::true_type {
  static std::string union_of() {
    std::string words;
    for (const std::string_view word : {kWords.view()...})
      words += (words.empty() ? "\"" : " | \"") + std::string(word) + '"';
    return words;
  }
};
template <class Type>
inline constexpr bool kIsOptional = false;
template <class Value>
inline constexpr bool kIsOptional<std::optional<Value>> = true;
template <class Type>
inline constexpr bool kIsByName = false;
template <class Value>
inline constexpr bool kIsByName<ByName<Value>> = true;
template <class Type>
inline constexpr bool kIsIfAny = false;
template <class Value>
inline constexpr bool kIsIfAny<IfAny<Value>> = true;

class Types {
 public:
  /// How a value's type is called; declares what it is made of.
  template <class Type>
  std::string of() {
    if constexpr (Listed<Type>) {
      declare<Type>();
      return name_of_type<Type>();
    } else if constexpr (IsWord<Type>::value) {
      return IsWord<Type>::union_of();
    } else if constexpr (kIsOptional<Type>) {
      return of<typename Type::value_type>() + " | null";
    } else if constexpr (kIsByName<Type>) {
      return "Record<string, " + of<typename Type::value_type::second_type>() + ">";
    } else if constexpr (std::same_as<Type, bool>) {
      return "boolean";
    } else if constexpr (std::is_arithmetic_v<Type>) {
      return "number";
    } else if constexpr (std::convertible_to<Type, std::string_view>) {
      return "string";
    } else {
      const std::string one = of<typename Type::value_type>();
      return one.find(' ') == std::string::npos ? one + "[]" : "(" + one + ")[]";
    }
  }

  template <class Type>
  void declare() {
    if (const std::string name = name_of_type<Type>(); std::find(told_.begin(), told_.end(), name) == told_.end()) {
      told_.push_back(name);
      std::string head = "interface " + name;
      if constexpr (requires { typename Type::Base; }) head += " extends " + of<typename Type::Base>();
      std::string lines;
      const Type none{};
      see_fields(none, [&](std::string_view field, const auto& value) {
        lines += "  " + line_of<std::remove_cvref_t<decltype(value)>>(camel_case(field)) + ";\n";
      });
      text_ += head + " {\n" + lines + "}\n\n";
    }
  }

  void add(const std::string& line) { text_ += line; }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] const std::vector<std::string>& names() const { return told_; }

 private:
  template <class Type>
  std::string line_of(const std::string& name) {
    if constexpr (kIsIfAny<Type>) return name + "?: " + of<decltype(Type::value)>();
    else return name + ": " + of<Type>();
  }

  std::vector<std::string> told_;
  std::string text_;
};

}  // namespace snug::app::told
