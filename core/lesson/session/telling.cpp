#include "lesson/session/telling.hpp"

#include <algorithm>
#include <array>

#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {

std::string Telling::caption() const {
  const WithDecimals wished(now_.lesson().view.decimals);
  if (player_.step() > 0) return player_.run(0).sentence(player_.step() - 1, untold());
  constexpr std::string_view kFirstStep = " Take the first step.";
  std::string opening = stage_.subject().opening(*player_.method(0));
  // No step can be taken before the answer.
  if (predicting() && opening.ends_with(kFirstStep)) opening.resize(opening.size() - kFirstStep.size());
  return opening;
}

std::string_view Telling::asked_figure() const {
  const Asked* now = now_.question_here();  // also while another question's outcome is shown
  return now == nullptr ? std::string_view() : std::string_view(now->hidden_figure());
}

bool Telling::predicting() const {
  const Asked* question = player_.fresh() ? now_.question_here() : now_.asked();
  return question != nullptr && question->step != Asked::kAnytime;
}

Untold Telling::untold() const {
  Untold untold;
  untold.now = asked_figure();
  if (!untold.now.empty()) untold.figures.push_back(untold.now);
  std::vector<std::string_view> seen;
  for (const Asked& asked : now_.questions()) {
    const std::string_view figure = asked.question->figure;
    if (figure.empty() || std::find(seen.begin(), seen.end(), figure) != seen.end()) continue;
    seen.push_back(figure);
    if (player_.step() < asked.until && now_.is_open(*asked.question)) untold.figures.push_back(figure);
  }
  // A run's result gives too much of the run away, whatever is asked.
  if (std::any_of(now_.questions().begin(), now_.questions().end(),
                  [&](const Asked& asked) { return player_.step() < asked.until && now_.is_open(*asked.question); }))
    untold.figures.push_back(kResultFigure);
  if (predicting()) untold.figures.push_back("excess");  // it is relative to the result of another run
  return untold;
}

std::vector<Figure> Telling::figures(int slot) const {
  if (player_.method(slot) == nullptr) return {};
  const WithDecimals wished(now_.lesson().view.decimals);
  std::vector<Figure> figures = stage_.subject().figures(player_.view(slot));
  const Untold hidden = untold();
  for (Figure& figure : figures)
    if ((figure.of_step ? hidden.now == figure.key : hidden.hides(figure.key)) ||
        (slot == 1 && awaits(*player_.method(1), figure.key)))
      figure.text = "—", figure.known = false;
  return figures;
}

bool Telling::comparing() const {
  if (!stage_.is_own()) return false;
  return std::any_of(now_.lesson().questions.begin(), now_.lesson().questions.end(), [&](const Question& question) {
    const QuestionKind* kind = general_question_kind(question.asks, *now_.lesson().subject);
    return kind != nullptr && kind->figure == kComparedFigure && question.situation == stage_.situation() &&
           now_.is_open(question);
  });
}

bool Telling::awaits(const Method& of, std::string_view figure) const {
  if (!stage_.is_own()) return false;
  return std::any_of(now_.lesson().questions.begin(), now_.lesson().questions.end(), [&](const Question& question) {
    return (figure.empty() || question.figure == figure) && question.situation == stage_.situation() &&
           find_method(now_.lesson(), question.gate.algorithm) == &of && now_.is_open(question);
  });
}

bool Telling::hides_result(const Method& of) const {
  constexpr std::array<std::string_view, 3> kSizes{"radius", "measure", "excess"};
  return predicting() || comparing() || (&of == player_.method(0) && is_hidden(kResultFigure)) ||
         std::any_of(kSizes.begin(), kSizes.end(), [&](std::string_view size) { return awaits(of, size); });
}

}  // namespace snug::lesson
