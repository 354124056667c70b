#include "lesson/text_change.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>

namespace snug::lesson {
namespace {

bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }
/// How many UTF-16 units the letter that begins with this byte has.
std::size_t units_of(char c) { return !begins_letter(c) ? 0 : static_cast<unsigned char>(c) >= 0xF0 ? 2 : 1; }

std::size_t units_in(std::string_view text) {
  std::size_t units = 0;
  for (const char c : text) units += units_of(c);
  return units;
}

/// The bytes of the first so many units; npos if there are fewer.
std::size_t bytes_of(std::string_view text, std::size_t units) {
  std::size_t at = 0;
  for (std::size_t seen = 0; at < text.size(); ++at) {
    if (begins_letter(text[at]) && seen >= units) break;
    seen += units_of(text[at]);
  }
  return units_in(text.substr(0, at)) == units ? at : std::string_view::npos;
}

/// Reads a whole number and the sign after it, off the text's front.
std::optional<std::size_t> taken_number(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const auto length = static_cast<std::size_t>(end - text.data());
  if (error != std::errc{} || length == text.size() || text[length] != '-') return std::nullopt;
  text.remove_prefix(length + 1);
  return number;
}

}  // namespace

std::string change_of(std::string_view from, std::string_view to) {
  if (from == to) return {};
  const std::size_t most = std::min(from.size(), to.size());
  std::size_t at = 0, end = 0;
  while (at < most && from[at] == to[at]) ++at;
  const auto splits = [](std::string_view text, std::size_t place) {
    return place < text.size() && !begins_letter(text[place]);
  };
  while (splits(from, at) || splits(to, at)) --at;
  while (end < most - at && from[from.size() - 1 - end] == to[to.size() - 1 - end]) ++end;
  while (splits(from, from.size() - end)) --end;
  const std::string_view gone = from.substr(at, from.size() - at - end);
  return std::to_string(units_in(from.substr(0, at))) + '-' + std::to_string(units_in(gone)) + '-' +
         std::string(to.substr(at, to.size() - at - end));
}

std::optional<std::string> changed(std::string_view from, std::string_view change) {
  const auto at = taken_number(change), gone = at ? taken_number(change) : std::nullopt;
  if (!gone) return std::nullopt;
  const std::size_t begin = bytes_of(from, *at), end = bytes_of(from, *at + *gone);
  if (begin == std::string_view::npos || end == std::string_view::npos) return std::nullopt;
  return std::string(from.substr(0, begin)) + std::string(change) + std::string(from.substr(end));
}

}  // namespace snug::lesson
