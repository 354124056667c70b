#include "lesson/prose_figures.hpp"

#include <algorithm>

#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

const Figure* figure_of_key(const std::vector<Figure>& figures, std::string_view key) {
  const auto found = std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.key == key; });
  return found == figures.end() ? nullptr : &*found;
}

/// Whether the result of a method must stay hidden now: until its questions are answered, and wherever results are
/// hidden beside the stage as well.
bool hides_result(const Conversation& now, const Method& method, std::string_view key) {
  const Telling telling(now);
  return now.asked() != nullptr || now.to_predict() != nullptr || telling.hides_result(method) ||
         telling.is_hidden(key) || telling.awaits(method, now.lesson().subject->compares ? key : std::string_view());
}

/// The number of "3 of 15", "2.118 units", "21 pairs" or "1 pair".
std::string number_alone(const Figure& figure) {
  const std::string text = figure.text.substr(0, figure.text.find(" of "));
  std::string one = figure.unit;
  if (!one.empty() && one.back() == 's') one.pop_back();
  for (const std::string& unit : {figure.unit, one})
    if (!unit.empty() && text.ends_with(" " + unit)) return text.substr(0, text.size() - unit.size() - 1);
  return text;
}

std::string on_one_line(const std::string& text) {
  std::string line;
  for (const char c : text)
    if (c == ' ') line += "\u00a0";
    else line += c;
  return line;
}

}  // namespace

const FigureNow& ProseFigures::of(const RunFigure& figure) {
  const auto [found, is_new] = found_.try_emplace(name_of(figure));
  if (is_new) found->second = look_up(figure);
  return found->second;
}

bool ProseFigures::tells(const Paragraph& paragraph, const Stretch& stretch) {
  return stretch.sentence < 0 || std::none_of(paragraph.begin(), paragraph.end(), [&](const Stretch& one) {
           return one.sentence == stretch.sentence && one.figure && of(*one.figure).says == kFigureUnknown;
         });
}

FigureNow ProseFigures::look_up(const RunFigure& figure) {
  const FigureNow hidden{std::string(kHiddenFigure), kFigureHidden},
      unknown{std::string(kHiddenFigure), kFigureUnknown};
  const Figure* found = nullptr;
  if (figure.algorithm.empty()) {
    if (Telling(now_).is_hidden(figure.key)) return hidden;
    if (!shown_) shown_ = Telling(now_).figures();
    found = figure_of_key(*shown_, figure.key);
  } else {
    const Method* method = find_method(now_.lesson(), figure.algorithm);
    if (method == nullptr) return unknown;
    if (!now_.stage().subject().suits(*method)) return {std::string(kHiddenFigure), kFigureRefused};
    if (hides_result(now_, *method, figure.key)) return hidden;
    found = figure_of_key(now_.player().result(*method), figure.key);
    if (found != nullptr && !found->known) return {"—", kFigureNone};  // nor later
  }
  if (found == nullptr || !found->known) return unknown;
  return {on_one_line(figure.count ? number_alone(*found) : found->text), {}};
}

bool may_tell_result(const Conversation& now, const Method& method, std::string_view key) {
  return !hides_result(now, method, key);
}

std::string plain_now(std::string_view text, ProseFigures& figures) {
  std::vector<ProseFault> ignored;  // the lesson's reader has told them
  std::string plain;
  for (const Stretch& stretch : paragraph_of(text, ignored))
    plain += stretch.figure ? figures.of(*stretch.figure).text : stretch.text;
  return plain;
}

}  // namespace snug::lesson
