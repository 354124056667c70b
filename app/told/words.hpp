// What a door tells a page or a script of a lesson is plain structs, one header for each part. SNUG_FIELDS lists their
// fields, app/told/json.hpp writes them, and tests/app/told/types.hpp says their types as the page's JavaScript has
// them. There a field is called as here, but in camelCase; a trailing _ keeps its name apart from a word of C++. A type
// that extends another has it as its Base. A view or a span looks into the session: what is told is written before that
// changes. These are the kinds of fields that C++ has no type for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "trace/fields.hpp"

namespace snug::app::told {

template <std::size_t kSize>
struct Literal {
  consteval Literal(const char (&from)[kSize]) { std::copy_n(from, kSize, text); }
  [[nodiscard]] constexpr std::string_view view() const { return {text, kSize - 1}; }
  char text[kSize] = {};
};

/// One of these words.
template <Literal... kWords>
struct Word {
  Word() = default;
  Word(std::string_view one) : word(one) {}
  bool operator==(const Word&) const = default;
  std::string_view word;
};

/// A field that is left out where it has nothing to tell: false, 0, an empty text, none.
template <class Value>
struct IfAny {
  IfAny() = default;
  IfAny(Value one) : any(one != Value{}), value(std::move(one)) {}
  IfAny(const std::optional<Value>& one) : any(one.has_value()), value(one.value_or(Value{})) {}
  bool any = false;
  Value value{};
};

/// Several of what has fields. They stay in place: what a vector's moves of them compile to, of each kind, would be
/// ten kB on the page.
template <class Value>
using List = std::list<Value>;

/// Values by their names, which the program does not fix. Of equal names the last one counts.
template <class Value>
using ByName = std::list<std::pair<std::string, Value>>;

}  // namespace snug::app::told
