#include "lesson/search.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lesson/prose.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostRepeated = 40;  // bytes of what was asked for

/// Small letters without accents and apostrophes; a space that keeps words together is one that does not.
std::string plain(std::string_view text) {
  // What the letters from U+00C0 on, two bytes each, are without their accents.
  constexpr std::string_view kLatin = "aaaaaa?ceeeeiiii?nooooo??uuuuy??aaaaaa?ceeeeiiii?nooooo??uuuuy?y";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
    const char c = text[i];
    if (c == '\'') continue;
    if (text.substr(i, 3) == "’") i += 2;
    else if (text.substr(i, 2) == "\u00a0") out += ' ', i += 1;
    else if (byte(i) == 0xc3 && i + 1 < text.size() && kLatin[byte(i + 1) & 0x3f] != '?')
      out += kLatin[byte(++i) & 0x3f];
    else out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return out;
}

std::vector<std::string> words_of(std::string_view asked) {
  std::vector<std::string> words(1);
  for (const char c : plain(asked))
    if (c != ' ' && c != ',') words.back() += c;
    else if (!words.back().empty()) words.emplace_back();
  if (words.back().empty()) words.pop_back();
  return words;
}

}  // namespace

std::string search_text(const Lesson& lesson, int number, std::string_view chapter,
                        std::span<const std::string> slides) {
  std::string text = std::to_string(number);
  const auto add = [&](std::string_view words) { text += ' ', text += words; };
  add(lesson.title), add(lesson.summary), add(chapter);
  for (const std::string_view slide : slides) add(slide);
  for (const Section& section : lesson.sections) {
    add(section.title);
    for (const Stretch* stretch : stretches_of(section))
      if (stretch->strong && stretch->tex.empty() && !stretch->figure) add(stretch->text);
  }
  for (std::string name : lesson.algorithms) std::replace(name.begin(), name.end(), '_', ' '), add(name);
  return plain(text);
}

bool is_found(std::string_view search_text, std::string_view asked) {
  const auto words = words_of(asked);
  return std::all_of(words.begin(), words.end(),
                     [&](const std::string& word) { return search_text.find(word) != std::string_view::npos; });
}

bool is_search(std::string_view asked) { return !words_of(asked).empty(); }

std::string found_text(const Found& found, std::string_view asked) {
  std::string says;
  for (const auto& [count, one] : {std::pair{found.lessons, " lesson"}, std::pair{found.sheets, " lab sheet"},
                                   std::pair{found.exercises, " exercise"}})
    if (count > 0) says += (says.empty() ? "" : ", ") + std::to_string(count) + one + (count == 1 ? "" : "s");
  if (!says.empty()) return says;
  while (!asked.empty() && asked.back() == ' ') asked.remove_suffix(1);
  while (!asked.empty() && asked.front() == ' ') asked.remove_prefix(1);
  std::size_t length = std::min(asked.size(), kMostRepeated);
  while (length < asked.size() && length > 0 && (static_cast<unsigned char>(asked[length]) & 0xc0) == 0x80) --length;
  return "No lesson or exercise has “" + std::string(asked.substr(0, length)) + "”.";
}

}  // namespace snug::lesson
