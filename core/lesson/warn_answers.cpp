#include "lesson/warn_answers.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "io/text.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/speaking.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

/// What the run says of a question with fixed choices.
struct Told {
  std::vector<int> right;  // the choices
  std::string says;        // the answer: "P7"
  std::string asks;        // what works it out: "point"
};

bool speaks_of(const Asked& asked, std::string_view words) {
  return io::lower_case(asked.question->prompt).find(io::lower_case(words)) != std::string::npos;
}

/// Where the choices are handles: those that the step is about.
std::optional<Told> told_by_handles(const Asked& asked, const Run& run) {
  const std::vector<Index> about = run.handles(asked.fact);
  Told told{{}, asked.names(about), about.size() > 1 ? "points" : "point"};
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const auto handle = handle_named(*asked.subject, asked.choices[i]);
    if (!handle) return std::nullopt;
    if (std::find(about.begin(), about.end(), *handle) != about.end()) told.right.push_back(static_cast<int>(i));
  }
  if (told.right.empty()) return std::nullopt;  // they are about something else
  return told;
}

/// Where the choices are algorithms: the tightest or the cheapest of them.
std::optional<Told> told_by_methods(const Asked& asked, const Run& run) {
  if (!asked.lesson->subject->compares) return std::nullopt;
  const bool tight = speaks_of(asked, "tight") || speaks_of(asked, "smallest");
  if (!tight && !speaks_of(asked, "cheap") && !speaks_of(asked, "fewest operations")) return std::nullopt;
  const Asking& asking = *general_asking(tight ? "tightest" : "cheapest", *asked.lesson->subject);
  Asked worked = asked;
  worked.choices.clear();
  if (asking.offer(worked, run) != nullptr) return std::nullopt;
  const Truth truth = asking.truth(worked, run);
  Told told{{}, truth.happened, std::string(asking.name)};
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const auto own = std::find(worked.choices.begin(), worked.choices.end(), asked.choices[i]);
    if (own == worked.choices.end()) return std::nullopt;
    const int choice = static_cast<int>(own - worked.choices.begin());
    if (std::find(truth.choices.begin(), truth.choices.end(), choice) != truth.choices.end())
      told.right.push_back(static_cast<int>(i));
  }
  return told;
}

/// Half of a number's last digit, as it is written: 0.005 for "1.25".
double rounding_of(std::string_view number) {
  const std::size_t point = number.find('.');
  std::size_t decimals = 0;
  if (point != std::string_view::npos)
    while (point + 1 + decimals < number.size() &&
           std::isdigit(static_cast<unsigned char>(number[point + 1 + decimals])) != 0)
      ++decimals;
  return 0.5 * std::pow(10.0, -static_cast<double>(decimals));
}

/// Where the choices are numbers: those of the figure that the prompt names.
std::optional<Told> told_by_figure(const Asked& asked, const Run& run) {
  const View view{{Slot{find_method(*asked.lesson, asked.question->gate.algorithm), &run}, Slot{}}, 0, asked.until};
  for (const Figure& figure : asked.subject->figures(view)) {
    if (!figure.known || !speaks_of(asked, figure.name)) continue;
    Told told{{}, figure.text, "figure"};
    for (std::size_t i = 0; i < asked.choices.size(); ++i) {
      const auto value = typed_number(asked.choices[i], figure.unit);
      if (!value) return std::nullopt;
      if (std::abs(*value - figure.value) <= rounding_of(asked.choices[i])) told.right.push_back(static_cast<int>(i));
    }
    return told;
  }
  return std::nullopt;
}

}  // namespace

void warn_of_answer(const Asked& asked, const Run& run, Complaints& complaints) {
  if (asked.question->asks != "choice") return;
  std::optional<Told> told = told_by_handles(asked, run);
  if (!told) told = told_by_methods(asked, run);
  if (!told) told = told_by_figure(asked, run);
  if (!told) return;
  const std::string better = "; asks = \"" + told->asks + "\" works it out from the run";
  const int fixed = asked.question->answer;
  const std::string& answer = asked.choices[static_cast<std::size_t>(fixed)];
  if (std::find(told->right.begin(), told->right.end(), fixed) == told->right.end())
    complaints.warn(asked.question->place,
                    "the run contradicts the answer \"" + answer + "\": it is " + told->says + better);
  else if (asked.question->holds == Holds::kAlways && asked.question->conditions.empty())
    complaints.warn(asked.question->place, "the answer \"" + answer +
                                               "\" is true only of the lesson's own stage, and needs holds = \"here\"" +
                                               better);
}

}  // namespace snug::lesson
