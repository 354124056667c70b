// What can be asked about the criteria, before they are measured: which volume is best by one of them, or the order.
#include <algorithm>
#include <numeric>

#include "geometry/sort.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects/criteria/criteria_words.hpp"

namespace snug::lesson {
namespace {

const CriteriaSubject& criteria_in(const Asked& asked) { return static_cast<const CriteriaSubject&>(*asked.subject); }

Criterion criterion_of(const Asked& asked) {
  const auto* const found = std::find(kCriterionNames.begin(), kCriterionNames.end(), asked.question->figure);
  return static_cast<Criterion>(found - kCriterionNames.begin());
}

const char* offer_volumes(Asked& asked, const Run&) {
  for (const FittedVolume& volume : criteria_in(asked).around().volumes)
    asked.add_choice(std::string(short_title(*volume.method)));
  return nullptr;
}

const char* offer_volumes_in_order(Asked& asked, const Run& run) {
  asked.ordered = true;
  return offer_volumes(asked, run);
}

/// "2.10 ms", "1.35 times the hull", "24 bytes"
std::string value_text(const CriteriaSubject& subject, std::size_t volume, Criterion criterion) {
  const auto value = subject.value(volume, criterion, subject.own_load());
  if (criterion == Criterion::kLooseness) return looseness_words(subject.around().volumes[volume]);
  if (criterion == Criterion::kBytes) return count_text(static_cast<std::int64_t>(*value)) + " bytes";
  return cost_text(*value, subject.is_counted()) + (subject.is_counted() ? " operations" : "");
}

/// All volumes, the best first, with their values.
std::string values_in_order(const Asked& asked) {
  const CriteriaSubject& subject = criteria_in(asked);
  const Criterion criterion = criterion_of(asked);
  std::vector<std::size_t> order(asked.choices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t i) { return subject.value(i, criterion, subject.own_load()).value_or(0); };
  sort_stably(order, [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::vector<std::string> values;
  for (const std::size_t i : order) values.push_back(asked.choices[i] + " " + value_text(subject, i, criterion));
  return listed(values, ", ");
}

/// What the situation's own load makes of them; pending until it is known.
std::vector<int> ranks_in(const Asked& asked) {
  const CriteriaSubject& subject = criteria_in(asked);
  if (!subject.is_measured()) return {};
  return subject.ranks(criterion_of(asked), subject.own_load());
}

Truth least_truth(const Asked& asked, const Run&) {
  const std::vector<int> ranks = ranks_in(asked);
  if (ranks.empty()) return {.pending = true};
  Truth truth;
  std::vector<std::string> best;
  for (std::size_t i = 0; i < ranks.size(); ++i)
    if (ranks[i] == 0) truth.choices.push_back(static_cast<int>(i)), best.push_back(asked.choices[i]);
  truth.happened = listed(best, " and ");
  truth.sentence = values_in_order(asked) + ".";
  if (criterion_of(asked) == Criterion::kTotal && truth.choices.size() == 1)
    truth.sentence += " " + winner_text(criteria_in(asked), criteria_in(asked).own_load());
  return truth;
}

Truth volume_order_truth(const Asked& asked, const Run&) {
  Truth truth{.ranks = ranks_in(asked)};
  if (truth.ranks.empty()) return {.pending = true};
  for (std::size_t i = 0; i < truth.ranks.size(); ++i) truth.choices.push_back(static_cast<int>(i));
  sort_stably(truth.choices, [&](int a, int b) { return truth.ranks[a] < truth.ranks[b]; });
  std::vector<std::string> names;
  for (const int choice : truth.choices) names.push_back(asked.choices[choice]);
  truth.happened = listed(names, ", ");
  truth.sentence = values_in_order(asked) + ".";
  return truth;
}

void read_criterion(TomlTable& table, Question& question) {
  question.figure = table.text("figure");
  check_name(table, "figure", question.figure, kCriterionNames);
}

constexpr std::string_view kLower = "Another one is lower.";
constexpr QuestionKind kLeast{.name = "least",
                              .offer = &offer_volumes,
                              .truth = &least_truth,
                              .read = &read_criterion,
                              .before = kLower,
                              .after = kLower},
    kOrder{.name = "order", .offer = &offer_volumes_in_order, .truth = &volume_order_truth, .read = &read_criterion};

}  // namespace

std::vector<FactQuestionKind> criteria_question_kinds() { return {{"", &kLeast}, {"", &kOrder}}; }

}  // namespace snug::lesson
