#include "check/warn_lesson.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "check/own_words.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_place.hpp"
#include "lesson/texts.hpp"

namespace snug::check {
namespace {

constexpr int kMostWords = 60;  // of a paragraph

bool is_letter_or_digit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }

/// The words that are a capital letter and a number, as names of handles are: "P12", "A0".
std::vector<std::string> names_like_handles(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size();) {
    const bool starts = text[i] >= 'A' && text[i] <= 'Z' && (i == 0 || !is_letter_or_digit(text[i - 1]));
    std::size_t end = i + 1;
    while (starts && end < text.size() && is_digit(text[end])) ++end;
    const bool ends = end == text.size() || (!is_letter_or_digit(text[end]) && text[end] != '-');
    if (starts && ends && end > i + 1) names.emplace_back(text.substr(i, end - i));
    i = end;
  }
  return names;
}

/// The handles that a text may name.
struct Handles {
  std::vector<std::string> names;
  explicit Handles(std::span<const Subject* const> subjects) {
    for (const Subject* subject : subjects)
      for (Index i = 0; i < subject->size(); ++i) names.push_back(subject->name_of(i));
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return std::find(names.begin(), names.end(), name) != names.end();
  }
  /// The last handle of that letter and another number; empty for none.
  [[nodiscard]] std::string last_such(const std::string& name) const {
    const auto alike = [&](const std::string& own) {
      return own.size() > 1 && own[0] == name[0] && std::all_of(own.begin() + 1, own.end(), is_digit);
    };
    const auto last = std::find_if(names.rbegin(), names.rend(), alike);
    return last == names.rend() ? "" : *last;
  }
};

/// Warns of each handle in a text that is not there.
void warn_of_handles(const PlacedText& text, const Handles& handles, Complaints& complaints) {
  for (const std::string& name : names_like_handles(text_of(*text.table, text.key)))
    if (const std::string last = handles.last_such(name); !last.empty() && !handles.has(name))
      complaints.warn(place_in_text(*text.table, text.key, name), '"' + std::string(text.name()) + "\" speaks of " +
                                                                      name + ", which is not there: the last one is " +
                                                                      last);
}

int words_of(const Paragraph& paragraph) {
  int words = 0;
  for (const Stretch& stretch : paragraph) {
    bool inside = false;
    for (const char c : stretch.tex.empty() ? stretch.text : std::string("x")) {
      const bool space = c == ' ';
      if (!space && !inside) ++words;
      inside = !space;
    }
  }
  return words;
}

void warn_of_length(const toml::table& table, const Section& section, Complaints& complaints) {
  for (const Paragraph* paragraph : paragraphs_of(section))
    if (const int words = words_of(*paragraph); words > kMostWords)
      complaints.warn(place_in_text(table, "text", paragraph->front().at),
                      "a paragraph has " + std::to_string(words) + " words: beside a stage at most " +
                          std::to_string(kMostWords) + " are read");
}

void warn_of_own_words(const toml::table& table, std::string_view key, std::string_view mend, Complaints& complaints) {
  const std::string words = words_of_one_run(text_of(table, key));
  if (!words.empty())
    complaints.warn(place_in_text(table, key, words),
                    '"' + std::string(key) + "\" says \"" + words +
                        "\", which a drag or other points may make false: " + std::string(mend));
}

/// Warns of words that stand on every run and may be true of one. handles: null where they are not known.
void warn_of_own_words(const toml::table& table, const Handles* handles, Complaints& complaints) {
  if (text_of(table, "holds") == "here") return;
  warn_of_own_words(table, "prompt", "\"prompt_here\" is for the lesson's own run", complaints);
  warn_of_own_words(table, "because", "\"because_here\" is for the lesson's own run", complaints);
  if (const toml::table* wrong = table["wrong"].as_table())
    for (const auto& [key, text] : *wrong)
      if (handles == nullptr || !handles->has(std::string(key.str())))  // what is said to a handle is of one run alone
        warn_of_own_words(*wrong, key.str(), "it stands on every run", complaints);
}

}  // namespace

void warn_of_words(const Lesson& lesson, const toml::table& toml, std::span<const Subject* const> subjects,
                   Complaints& complaints) {
  std::optional<Handles> handles;
  if (!subjects.empty()) handles.emplace(subjects);
  const auto each_of = [&](std::string_view key, auto see) {
    const toml::array* tables = toml[key].as_array();
    for (std::size_t i = 0; tables != nullptr && i < tables->size(); ++i)
      if (const toml::table* table = tables->get(i)->as_table()) see(*table, i);
  };
  each_of("section", [&](const toml::table& table, std::size_t i) {
    if (handles) {
      warn_of_handles({&table, "title", &table}, *handles, complaints);
      warn_of_handles({&table, "text", &table}, *handles, complaints);
    }
    if (i < lesson.sections.size()) warn_of_length(table, lesson.sections[i], complaints);
  });
  each_of("question", [&](const toml::table& table, std::size_t) {
    if (lesson.subject->experiment == nullptr) warn_of_own_words(table, handles ? &*handles : nullptr, complaints);
  });
  if (!handles) return;
  for (const PlacedText& text : prompts_of(toml)) warn_of_handles(text, *handles, complaints);
}

}  // namespace snug::check
