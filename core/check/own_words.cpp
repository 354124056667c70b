#include "check/own_words.hpp"

#include <array>
#include <vector>

#include "io/text.hpp"
#include "lesson/names.hpp"
#include "lesson/text_place.hpp"

namespace snug::check {

using namespace lesson;

namespace {

constexpr std::array<std::string_view, 2> kThis{"this", "these"};
// What a student moves, scatters or replaces.
constexpr std::array<std::string_view, 20> kThings{
    "point", "points", "box",    "boxes",  "circle",  "circles", "sphere", "spheres",  "cloud",   "clouds",
    "cube",  "body",   "bodies", "volume", "volumes", "pair",    "pairs",  "vertices", "triples", "tetrahedron"};
constexpr std::array<std::string_view, 10> kIs{"is",       "are",   "has",     "have", "overlap",
                                               "overlaps", "touch", "touches", "lie",  "lies"};
// After these, "this" only says which one is meant: "the sum of these points is".
constexpr std::array<std::string_view, 10> kPrepositions{"of", "along", "around", "beside", "in",
                                                         "on", "to",    "from",   "than",   "with"};
constexpr std::array<std::string_view, 9> kFourAndMore{"four", "five", "six",    "seven", "eight",
                                                       "nine", "ten",  "twelve", "twenty"};
constexpr std::array<std::string_view, 2> kMany{"dozens", "hundreds"};
constexpr std::size_t kAdjectives = 2;  // between "this" and what it points at: "these small slender boxes"

struct Word {
  std::string text;  // in lower case
  std::size_t begin = 0, end = 0;
  bool stops = false;  // a comma, a full stop or the like follows
};

bool is_in_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '\'' || (c & 0x80) != 0;
}

/// A comma between two digits belongs to the number.
std::vector<Word> words_in(std::string_view text) {
  std::vector<Word> words;
  const auto groups = [&](std::size_t i) {
    return text[i] == ',' && i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]);
  };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t begin = i;
    while (i < text.size() && (is_in_word(text[i]) || groups(i))) ++i;
    if (i == begin) {
      if (!words.empty() && text[i] != ' ' && text[i] != '\n') words.back().stops = true;
      ++i;
      continue;
    }
    words.push_back({io::lower_case(text.substr(begin, i - begin)), begin, i});
  }
  return words;
}

/// A number of four or more, in digits or in a word. Two and three of a kind are often those of any run.
bool is_count(const Word& word) {
  if (is_among(kFourAndMore, word.text)) return true;
  return is_digit(word.text.front()) && word.text.find_first_not_of("0123456789,") == std::string::npos &&
         (word.text.size() > 1 || word.text.front() > '3');
}

/// The last word of what is said of the run in words that begin with "this" or "these"; 0 for nothing.
std::size_t end_of_pointing(const std::vector<Word>& words, std::size_t from) {
  if (!is_among(kThis, words[from].text)) return 0;
  if (from + 1 < words.size() && is_count(words[from + 1])) return from + 1;
  if (from > 0 && !words[from - 1].stops && is_among(kPrepositions, words[from - 1].text)) return 0;
  for (std::size_t i = from + 1; i + 1 < words.size() && i <= from + 1 + kAdjectives; ++i) {
    if (words[i - 1].stops || words[i].stops) return 0;
    if (is_among(kThings, words[i].text)) return is_among(kIs, words[i + 1].text) ? i + 1 : 0;
  }
  return 0;
}

}  // namespace

std::string words_of_one_run(std::string_view text) {
  const std::vector<Word> words = words_in(text);
  const auto said = [&](std::size_t from, std::size_t to) {
    return std::string(text.substr(words[from].begin, words[to].end - words[from].begin));
  };
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (const std::size_t end = end_of_pointing(words, i); end != 0) return said(i, end);
    const bool follows = i + 1 < words.size() && !words[i].stops;
    const bool divides = text.substr(0, words[i].begin).ends_with("/ ");  // in a formula
    if (follows && !divides && is_count(words[i]) && is_digit(words[i].text.front()) &&
        is_among(kThings, words[i + 1].text))
      return said(i, i + 1);
    if (follows && is_among(kMany, words[i].text) && words[i + 1].text == "of") return said(i, i + 1);
  }
  return {};
}

}  // namespace snug::check
