#include "lesson/warn_figures.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_place.hpp"

namespace snug::lesson {
namespace {

/// A number as it stands in a text.
struct Written {
  std::string text;
  double value = 0;
  int decimals = 0;
  bool per_cent = false;
  std::size_t at = 0;
};

/// The fractions of a text with three digits or more, or with a per cent sign: "0.634", "9.1 %". Shorter ones and whole
/// numbers are too likely to mean something else.
std::vector<Written> numbers_in(std::string_view text) {
  std::vector<Written> numbers;
  for (std::size_t i = 0; i < text.size();) {
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    Written number{.at = i};
    std::string digits;
    bool point = false;
    for (; i < text.size(); ++i) {
      const bool inside = i + 1 < text.size() && is_digit(text[i + 1]);
      if (is_digit(text[i])) digits += text[i], number.decimals += point ? 1 : 0;
      else if (text[i] == '.' && inside && !point) digits += '.', point = true;
      else if (text[i] != ',' || !inside) break;
    }
    number.text = text.substr(number.at, i - number.at);
    number.value = std::stod(digits);
    number.per_cent = text.substr(i).starts_with(" %") || text.substr(i).starts_with("%");
    const auto count = std::count_if(digits.begin(), digits.end(), is_digit);
    const bool word = number.at > 0 && std::isalpha(static_cast<unsigned char>(text[number.at - 1])) != 0;  // "P123"
    if (!word && point && (count >= 3 || number.per_cent)) numbers.push_back(std::move(number));
  }
  return numbers;
}

/// A figure at the end of a run, and how a text shows it.
struct Shown {
  double value = 0;
  bool per_cent = false;
  RunFigure name;
};

std::vector<Shown> figures_of(const Lesson& lesson, const Subject& own, const RunOf& run_of) {
  std::vector<Shown> all;
  for (const std::string& algorithm : lesson.algorithms) {
    const Run* run = run_of(algorithm);
    if (run == nullptr) continue;
    const View view{{Slot{find_method(lesson, algorithm), run}, Slot{}}, 0, run->steps()};
    for (const Figure& figure : own.figures(view))
      if (figure.known) all.push_back({std::abs(figure.value), figure.unit == "%", {figure.key, algorithm}});
  }
  return all;
}

bool is_same(const Written& number, const Shown& figure) {
  const double rounding = 0.5 * std::pow(10.0, -number.decimals);
  return number.per_cent == figure.per_cent && std::abs(number.value - figure.value) <= rounding;
}

}  // namespace

void warn_of_figures(const toml::table& toml, const Section& section, const Lesson& lesson, const Subject& own,
                     const RunOf& run_of, Complaints& complaints) {
  std::optional<std::vector<Shown>> figures;
  for (const Stretch* stretch : stretches_of(section)) {
    if (stretch->code || stretch->figure || !stretch->tex.empty()) continue;
    for (const Written& number : numbers_in(stretch->text)) {
      if (!figures) figures = figures_of(lesson, own, run_of);
      const auto same =
          std::find_if(figures->begin(), figures->end(), [&](const Shown& figure) { return is_same(number, figure); });
      if (same != figures->end())
        complaints.warn(place_in_text(toml, "text", stretch->at + number.at),
                        "\"text\" has " + number.text + (number.per_cent ? " %" : "") + ", a figure of the run: {" +
                            name_of(same->name) + "} stays true when the student drags");
    }
  }
}

}  // namespace snug::lesson
