#include "check/warn_figures.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_place.hpp"

namespace snug::check {
namespace {

/// A number as it stands in a text.
struct Written {
  std::string text;
  double value = 0;
  int decimals = 0;
  bool per_cent = false;
  bool whole = false;      // then it counts if its unit follows, in
  std::string_view after;  // the rest of the text
  std::size_t at = 0;
};

/// The numbers of a text that can be figures: fractions with three digits or more, or with a per cent sign ("0.634",
/// "9.1 %"), and counts from ten on ("66 pairs"). Others are too likely to mean something else.
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
    const bool rough = number.value == 0 || digits.find_first_of("123456789") + 1 >= digits.size();  // "0.000001"
    const bool word = number.at > 0 && std::isalpha(static_cast<unsigned char>(text[number.at - 1])) != 0;  // "P123"
    number.whole = !point, number.after = text.substr(i);
    if (!word && (point ? (count >= 3 && !rough) || number.per_cent : count >= 2 && !number.per_cent))
      numbers.push_back(std::move(number));
  }
  return numbers;
}

/// A figure at the end of a run, and how a text shows it.
struct Shown {
  double value = 0;
  std::string unit;
  RunFigure name;
};

std::vector<Shown> figures_of(const Lesson& lesson, const OpenSituation& there) {
  std::vector<Shown> all;
  for (const std::string& algorithm : lesson.algorithms) {
    const Run* run = there.run_of(algorithm);
    if (run == nullptr) continue;
    const View view{{Slot{find_method(lesson, algorithm), run}, Slot{}}, 0, run->steps()};
    for (const Figure& figure : there.own->figures(view))
      if (figure.known) all.push_back({std::abs(figure.value), figure.unit, {figure.key, algorithm}});
  }
  return all;
}

/// Whether the word after a whole number is the figure's unit: "66 pairs".
bool has_unit(const Written& number, const Shown& figure) {
  // A number of points is mostly that of the lesson's own, which no drag changes.
  if (figure.unit.empty() || figure.unit == "points" || !number.after.starts_with(' ')) return false;
  const std::string_view word = number.after.substr(1);
  const bool ends =
      word.size() == figure.unit.size() ||
      (word.size() > figure.unit.size() && !std::isalpha(static_cast<unsigned char>(word[figure.unit.size()])));
  return word.starts_with(figure.unit) && ends;
}

bool is_same(const Written& number, const Shown& figure) {
  if (number.whole) return number.value == figure.value && has_unit(number, figure);
  const double rounding = 0.5 * std::pow(10.0, -number.decimals);
  return number.per_cent == (figure.unit == "%") && std::abs(number.value - figure.value) <= rounding;
}

/// The figures of each situation, worked out when a text first has a number.
class FiguresOf {
 public:
  FiguresOf(const Lesson& lesson, std::span<const OpenSituation> situations)
      : lesson_(lesson), situations_(situations), all_(situations.size()) {}
  /// The one that a number is; null for none.
  const Shown* like(const Written& number, std::string_view situation) {
    const OpenSituation* there = find_open(situations_, situation);
    if (there == nullptr) return nullptr;
    auto& figures = all_[there - situations_.data()];
    if (!figures) figures = figures_of(lesson_, *there);
    const auto same =
        std::find_if(figures->begin(), figures->end(), [&](const Shown& figure) { return is_same(number, figure); });
    return same == figures->end() ? nullptr : &*same;
  }

 private:
  const Lesson& lesson_;
  std::span<const OpenSituation> situations_;
  std::vector<std::optional<std::vector<Shown>>> all_;
};

void warn_of_stretch(const Stretch& stretch, const PlacedText& text, std::string_view situation, FiguresOf& figures,
                     Complaints& complaints) {
  if (stretch.code || stretch.figure || !stretch.tex.empty()) return;
  for (const Written& number : numbers_in(stretch.text)) {
    if (number.whole && text.of->contains("asks")) continue;  // warn_of_words tells counts in questions
    const Shown* same = figures.like(number, situation);
    if (same == nullptr) continue;
    const std::string count = number.whole ? "count " : "";
    complaints.warn(place_in_text(*text.table, text.key, stretch.at + number.at),
                    '"' + std::string(text.name()) + "\" has " + number.text + (number.per_cent ? " %" : "") +
                        ", a figure of the run: {" + count + name_of(same->name) +
                        "} stays true when the student drags");
  }
}

/// Whether a text is said of runs that are not the lesson's own, and is no task's.
bool is_said_of_any(const PlacedText& text) {
  return text.of->contains("asks") && !text.key.ends_with("_here") && text_of(*text.of, "holds") != "here";
}

}  // namespace

void warn_of_figures(const Lesson& lesson, const toml::table& toml, std::span<const OpenSituation> situations,
                     Complaints& complaints) {
  FiguresOf figures(lesson, situations);
  const toml::array* tables = toml["section"].as_array();
  for (std::size_t i = 0; i < lesson.sections.size(); ++i)
    for (const Stretch* stretch : stretches_of(lesson.sections[i])) {
      const toml::table* table = tables->get(i)->as_table();
      warn_of_stretch(*stretch, {table, "text", table}, lesson.sections[i].situation, figures, complaints);
    }
  if (lesson.subject->experiment != nullptr) return;  // such questions are asked of the lesson's own alone
  for (const PlacedText& text : prompts_of(toml)) {
    if (!is_said_of_any(text)) continue;
    std::vector<ProseFault> told;
    for (const Stretch& stretch : paragraph_of(text_of(*text.table, text.key), told))
      warn_of_stretch(stretch, text, text.situation(), figures, complaints);
  }
}

}  // namespace snug::check
