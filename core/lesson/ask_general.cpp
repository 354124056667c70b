// What can be asked of any step, or of the lesson's algorithms.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/random.hpp"
#include "geometry/sort.hpp"
#include "geometry/tolerance.hpp"
#include "lesson/ask.hpp"
#include "lesson/decide.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

const char* offer_points(Asked& asked, const Run& run) {
  if (run.handles(asked.fact).empty()) return "\"point\" cannot be asked of a step that names no point";
  asked.on_stage = true;
  asked.stage_points = run.candidates(asked.fact);
  return nullptr;
}

const char* offer_all_points(Asked& asked, const Run& run) {
  asked.many = true;
  return offer_points(asked, run);
}

Truth point_truth(const Asked& asked, const Run& run) {
  Truth truth;
  truth.points = run.handles(asked.fact);
  truth.happened = asked.names(truth.points);
  truth.sentence = truth.happened + " " + run.predicate(asked.fact, truth.points.size() > 1) + ".";
  return truth;
}

const char* offer_choices(Asked& asked, const Run&) {
  for (const std::string& choice : asked.question->choices) asked.add_choice(in_words_of(asked.dim, choice));
  return nullptr;
}

/// Reads at least so many choices, none of them twice.
void read_choice_texts(TomlTable& table, Question& question, std::size_t least) {
  const std::vector<std::string>& choices = question.choices = table.texts("choices", least);
  for (auto choice = choices.begin(); choice != choices.end(); ++choice)
    if (std::find(choices.begin(), choice, *choice) != choice)
      return table.wrong("choices", "has " + *choice + " twice");
}

/// Reads the choices and the right one.
void read_choices(TomlTable& table, Question& question) {
  read_choice_texts(table, question, 2);
  const std::string answer = table.text("answer");
  const auto found = std::find(question.choices.begin(), question.choices.end(), answer);
  if (!question.choices.empty()) check_name(table, "answer", answer, question.choices);
  question.answer = static_cast<int>(found - question.choices.begin());
}

/// The lesson's choices, which its file has in the right order, shuffled; never into the right order.
std::vector<std::size_t> shuffled_places(const Question& question) {
  std::vector<std::size_t> places(question.choices.size());
  std::iota(places.begin(), places.end(), std::size_t{0});
  std::uint64_t seed = question.shuffled;
  for (const char c : question.id) seed = seed * 31 + static_cast<unsigned char>(c);
  Random random(seed);
  for (std::size_t left = places.size(); left > 1; --left)
    std::swap(places[left - 1], places[random.below(static_cast<std::uint32_t>(left))]);
  const auto in_place = [&](std::size_t a, std::size_t b) { return question.choices[a] == question.choices[b]; };
  bool right = true;
  for (std::size_t i = 0; i < places.size(); ++i) right = right && in_place(places[i], i);
  if (right) std::rotate(places.begin(), places.begin() + 1, places.end());
  return places;
}

const char* offer_sequence(Asked& asked, const Run&) {
  asked.ordered = true;
  for (const std::size_t i : shuffled_places(*asked.question))
    asked.add_choice(in_words_of(asked.dim, asked.question->choices[i]));
  return nullptr;
}

void read_sequence(TomlTable& table, Question& question) { read_choice_texts(table, question, 3); }

/// The right order, and its sentence. Each choice has its rank: equal ones may stand either way round.
Truth truth_of_ranks(const Asked& asked, std::vector<int> ranks) {
  Truth truth;
  truth.choices.resize(ranks.size());
  std::iota(truth.choices.begin(), truth.choices.end(), 0);
  sort_stably(truth.choices, [&](int a, int b) { return ranks[a] < ranks[b]; });
  truth.happened = choice_words(asked, truth.choices);
  truth.sentence = "The order is: " + truth.happened + ".";
  truth.ranks = std::move(ranks);
  return truth;
}

Truth sequence_truth(const Asked& asked, const Run&) {
  const std::vector<std::string>& right = asked.question->choices;
  std::vector<int> ranks;
  for (const std::size_t place : shuffled_places(*asked.question))
    ranks.push_back(static_cast<int>(std::find(right.begin(), right.end(), right[place]) - right.begin()));
  return truth_of_ranks(asked, std::move(ranks));
}

/// The place right after the step that is asked about.
View view_after(const Asked& asked, const Run& run) {
  const Method* method = find_method(*asked.lesson, asked.question->gate.algorithm);
  return {{Slot{method, &run}, Slot{}}, 0, asked.until};
}

std::optional<Figure> figure_after(const Asked& asked, const Run& run) {
  for (Figure& figure : asked.subject->figures(view_after(asked, run)))
    if (figure.key == asked.question->figure && figure.known) return std::move(figure);
  return std::nullopt;
}

const char* offer_ranges(Asked& asked, const Run& run) {
  const auto figure = figure_after(asked, run);
  if (!figure) return kNoFigureAfter.data();
  for (std::string& range : range_texts(asked.question->bounds, figure->unit)) asked.add_choice(std::move(range));
  return nullptr;
}

Truth range_truth(const Asked& asked, const Run& run) {
  const Figure figure = *figure_after(asked, run);
  const std::vector<double>& bounds = asked.question->bounds;
  const auto range = std::lower_bound(bounds.begin(), bounds.end(), figure.value) - bounds.begin();
  return {{static_cast<int>(range)}, {}, figure.text, figure.name + ": " + figure.text + "."};
}

void read_figure(TomlTable& table, Question& question) {
  question.figure = table.text("figure");
  read_bounds(table, question);
}

const char* offer_number(Asked& asked, const Run& run) {
  const auto figure = figure_after(asked, run);
  if (!figure) return kNoFigureAfter.data();
  const bool whole = figure->value == std::floor(figure->value);
  if (asked.question->tolerance == 0 && !whole) return "a figure that is not a count needs a \"tolerance\"";
  asked.number = true;
  asked.unit = figure->unit;
  return nullptr;
}

Truth number_truth(const Asked& asked, const Run& run) {
  const Figure figure = *figure_after(asked, run);
  Truth truth{{}, {}, figure.text, figure.name + ": " + figure.text + "."};
  truth.number = figure.value;
  truth.tolerance = asked.question->tolerance;
  return truth;
}

void read_number(TomlTable& table, Question& question) {
  question.figure = table.text("figure");
  question.tolerance = table.any_number("tolerance", 0);
  if (!(question.tolerance >= 0) || std::isinf(question.tolerance)) table.wrong("tolerance", "must be 0 or above");
}

/// The methods that are compared: a student's own result can be anything.
std::vector<Rival> rivals_of(const Asked& asked, const Run& run) {
  std::vector<Rival> rivals = asked.subject->rivals(*asked.lesson, view_after(asked, run));
  std::erase_if(rivals, [](const Rival& rival) { return rival.method->by_hand; });
  return rivals;
}

const char* offer_methods(Asked& asked, const Run& run) {
  const std::vector<Rival> rivals = rivals_of(asked, run);
  if (rivals.size() < 2) return "the question compares algorithms, and only one takes these points";
  for (const Rival& rival : rivals) asked.add_choice(title_in(*asked.lesson, *rival.method));
  return nullptr;
}

const char* offer_order(Asked& asked, const Run& run) {
  asked.ordered = true;
  return offer_methods(asked, run);
}

/// The rank of each value: how many are below it by more than rounding.
std::vector<int> ranks_of(const std::vector<double>& values) {
  std::vector<int> ranks;
  for (const double value : values)
    ranks.push_back(static_cast<int>(std::count_if(
        values.begin(), values.end(), [&](double other) { return other * (1 + tolerance::kBoxProof) < value; })));
  return ranks;
}

std::vector<double> sizes_of(const Asked& asked, const Run& run) {
  std::vector<double> sizes;
  for (const Rival& rival : rivals_of(asked, run)) sizes.push_back(rival.size);
  return sizes;
}

std::vector<double> operations_of(const Asked& asked, const Run& run) {
  std::vector<double> counts;
  for (const Rival& rival : rivals_of(asked, run))
    counts.push_back(static_cast<double>(asked.subject->operations(*rival.method)));
  return counts;
}

Truth order_truth(const Asked& asked, const Run& run) { return truth_of_ranks(asked, ranks_of(sizes_of(asked, run))); }
Truth cost_order_truth(const Asked& asked, const Run& run) {
  return truth_of_ranks(asked, ranks_of(operations_of(asked, run)));
}

/// Those of the first rank, each of which is right.
Truth truth_of_first(const Asked& asked, const std::vector<int>& ranks) {
  Truth truth;
  std::vector<std::string> firsts;
  for (std::size_t i = 0; i < ranks.size(); ++i) {
    if (ranks[i] > 0) continue;
    truth.choices.push_back(static_cast<int>(i));
    firsts.push_back(asked.choices[i]);
  }
  truth.happened = listed(firsts, " and ");
  return truth;
}

/// Sizes that differ by rounding alone are equal.
Truth tightest_truth(const Asked& asked, const Run& run) {
  const std::vector<double> sizes = sizes_of(asked, run);
  Truth truth = truth_of_first(asked, ranks_of(sizes));
  const bool one = truth.choices.size() == 1;
  truth.sentence = truth.happened + (one ? " is the tightest: " : " are the tightest: ") +
                   number_text(*std::min_element(sizes.begin(), sizes.end())) + ".";
  return truth;
}

Truth cheapest_truth(const Asked& asked, const Run& run) {
  const std::vector<double> counts = operations_of(asked, run);
  Truth truth = truth_of_first(asked, ranks_of(counts));
  truth.sentence = truth.happened + (truth.choices.size() == 1 ? " takes the fewest" : " take the fewest") +
                   " operations: " + count_text(std::llround(*std::min_element(counts.begin(), counts.end()))) + ".";
  return truth;
}

/// How far the values that are nearest to each other are apart, as a share of the larger one. Equal ones may stand
/// either way round.
double least_gap(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < values.size(); ++i)
    if (values[i - 1] * (1 + tolerance::kBoxProof) < values[i])
      least = std::min(least, (values[i] - values[i - 1]) / values[i]);
  return least;
}
double order_margin(const Asked& asked, const Run& run) { return least_gap(sizes_of(asked, run)); }
double cost_margin(const Asked& asked, const Run& run) { return least_gap(operations_of(asked, run)); }

/// The order the wrong way round.
template <Truth (*Ordered)(const Asked&, const Run&)>
std::optional<Answer> reversed(const Asked& asked, const Run& run) {
  const Truth truth = Ordered(asked, run);
  return ChoicesInOrder{{truth.choices.rbegin(), truth.choices.rend()}};
}
std::optional<Answer> tightest_first(const Asked& asked, const Run& run) {
  return ChoicesInOrder{order_truth(asked, run).choices};
}
constexpr std::array kOrderRules{WrongRule{"reversed", &reversed<order_truth>}};
constexpr std::array kCostRules{WrongRule{"reversed", &reversed<cost_order_truth>},
                                WrongRule{"tightest", &tightest_first}};

constexpr std::string_view kSmaller = "Another one is smaller.";
constexpr QuestionKind kPoint{"point", &offer_points, &point_truth}, kPoints{"points", &offer_all_points, &point_truth},
    kChoice{.name = "choice", .offer = &offer_choices, .truth = &choice_truth, .read = &read_choices},
    kSequence{.name = "sequence",
              .offer = &offer_sequence,
              .truth = &sequence_truth,
              .read = &read_sequence,
              .margin = &no_tie},
    kFigure{.name = "figure",
            .offer = &offer_ranges,
            .truth = &range_truth,
            .read = &read_figure,
            .before = kMore,
            .after = kLess},
    kNumber{.name = "number", .offer = &offer_number, .truth = &number_truth, .read = &read_number, .margin = &no_tie},
    kTightest{.name = "tightest",
              .offer = &offer_methods,
              .truth = &tightest_truth,
              .figure = kComparedFigure,
              .before = kSmaller,
              .after = kSmaller},
    kTightestOrder{.name = "tightest_order",
                   .offer = &offer_order,
                   .truth = &order_truth,
                   .figure = kComparedFigure,
                   .margin = &order_margin,
                   .rules = kOrderRules},
    kCheapest{.name = "cheapest", .offer = &offer_methods, .truth = &cheapest_truth},
    kCheapestOrder{.name = "cheapest_order",
                   .offer = &offer_order,
                   .truth = &cost_order_truth,
                   .margin = &cost_margin,
                   .rules = kCostRules};

constexpr std::array<const QuestionKind*, 6> kOfAnyStep{&kPoint, &kPoints, &kChoice, &kSequence, &kFigure, &kNumber};
constexpr std::array<const QuestionKind*, 4> kOfMethods{&kTightest, &kTightestOrder, &kCheapest, &kCheapestOrder};

}  // namespace

Truth choice_truth(const Asked& asked, const Run&) {
  const int right = asked.question->answer;
  const std::string& text = asked.choices[right];
  return {{right}, {}, text, "The answer is “" + text + "”."};
}

std::string no_figure_after(const Asked& asked, const Run& run) {
  std::vector<std::string> keys;
  for (Figure& figure : asked.subject->figures(view_after(asked, run)))
    if (figure.known && !is_among(keys, figure.key)) keys.push_back(std::move(figure.key));
  const std::string after = "\"figure\" after " + asked.question->gate.fact + " ";
  return after + (keys.empty() ? "is not there: there are none" : none_of_text(asked.question->figure, keys));
}

std::vector<std::string_view> general_question_kinds(const SubjectRow& subject) {
  if (subject.experiment != nullptr) return {kChoice.name};
  std::vector<std::string_view> names;
  for (const QuestionKind* kind : kOfAnyStep) names.push_back(kind->name);
  if (subject.compares)
    for (const QuestionKind* kind : kOfMethods) names.push_back(kind->name);
  return names;
}

const QuestionKind* general_question_kind(std::string_view name, const SubjectRow& subject) {
  if (!is_among(general_question_kinds(subject), name)) return nullptr;
  for (const QuestionKind* kind : kOfAnyStep)
    if (kind->name == name) return kind;
  for (const QuestionKind* kind : kOfMethods)
    if (kind->name == name) return kind;
  return nullptr;
}

void read_bounds(TomlTable& table, Question& question) {
  question.bounds = table.numbers("bounds");
  double last = -std::numeric_limits<double>::infinity();
  const auto rises = [&](double bound) {
    return bound > std::exchange(last, bound) && std::isfinite(bound);
  };  // no NaN does
  if (question.bounds.empty() || !std::all_of(question.bounds.begin(), question.bounds.end(), rises))
    table.wrong("bounds", "must be numbers that rise"), question.bounds = {0};
}

bool is_measured(std::string_view unit) {
  return unit == "%" || unit == "degrees" || unit.find("units") != std::string_view::npos || unit == "times";
}

std::vector<std::string> range_texts(std::span<const double> bounds, std::string_view unit) {
  const bool measured = is_measured(unit);
  const auto whole = [](double bound) { return bound == std::floor(bound); };
  const bool count = !measured && std::all_of(bounds.begin(), bounds.end(), whole);
  const auto number = [&](double value) { return count ? count_text(std::llround(value)) : plain_number(value); };
  const auto with_unit = [&](double value) {
    const bool one = value == 1 && unit.ends_with('s') && unit != "times";
    return number(value) + (unit.empty() ? "" : " ") + std::string(unit.substr(0, unit.size() - (one ? 1 : 0)));
  };
  std::vector<std::string> texts{count && bounds.front() == 0 ? "none" : "at most " + with_unit(bounds.front())};
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    const double above = count ? bounds[i - 1] + 1 : bounds[i - 1];
    texts.push_back((above == bounds[i] ? "" : number(above) + " to ") + with_unit(bounds[i]));
  }
  texts.push_back("more than " + with_unit(bounds.back()));
  return texts;
}

}  // namespace snug::lesson
