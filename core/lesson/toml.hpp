// Includes toml++, which reads and writes numbers with <charconv> if the library has it, and else with streams, whose
// locales are a twentieth of the page. Emscripten's library has it only for integers; the rest is here.
#pragma once

#include <charconv>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
#include <fast_float/fast_float.h>

#include <cstdio>

namespace std {  // NOLINT: toml++ looks for them here

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  const auto read = fast_float::from_chars(first, last, value);
  return {read.ptr, read.ec};
}

/// Only for messages: enough digits to tell any two numbers apart.
inline to_chars_result to_chars(char* first, char* last, double value) {
  const int written = snprintf(first, static_cast<size_t>(last - first), "%.17g", value);
  return {first + written, errc{}};
}
inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int = 0) {
  return to_chars(first, last, value);
}

}  // namespace std

#define TOML_INT_CHARCONV 1
#define TOML_FLOAT_CHARCONV 1
#endif

// Its parser asserts conditions that a damaged file can break ("[[=" has no key), although it reports the error right
// after. Without the assertion there is a message; with NDEBUG it would be undefined behaviour.
#include <toml++/impl/preprocessor.h>
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT_ASSUME(...) static_assert(true)

#include <toml++/toml.h>
