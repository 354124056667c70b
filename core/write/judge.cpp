#include "write/judge.hpp"

#include <algorithm>
#include <cmath>

#include "io/text.hpp"
#include "number/bits.hpp"
#include "number/fnv.hpp"
#include "write/shape.hpp"

namespace snug::write {
namespace {

constexpr std::string_view kNoAnswer = "it gave no answer";

std::string word_of(double value) { return std::isfinite(value) ? io::shortest_text(value) : "nan"; }

Answered read_answer(std::string_view line) {
  if (!line.empty() && line.front() == '!') return tl::unexpected(std::string(line.substr(1)));
  Numbers numbers;
  for (std::string_view word = io::take_word(line); !word.empty(); word = io::take_word(line)) {
    const auto number = io::parse_number(word);
    if (!number) return tl::unexpected(std::string(kNoAnswer));
    numbers.push_back(*number);
  }
  if (numbers.empty()) return tl::unexpected(std::string(kNoAnswer));
  return numbers;
}

/// Whether a number that has changed is now equal to another one: a box would become flat, or two would share an end
/// by chance.
bool coincides(const Numbers& before, const Numbers& now) {
  if (before.size() != now.size()) return false;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != before[i] && std::count(now.begin(), now.end(), now[i]) > 1) return true;
  return false;
}

}  // namespace

std::vector<const Function*> all_functions() {
  std::vector<const Function*> all;
  for (const auto rows : {box_functions(), round_functions(), turned_box_functions(), plane_functions(),
                          point_functions(), tree_functions()})
    for (const Function& one : rows) all.push_back(&one);
  return all;
}

const Function* find_function(std::string_view id) {
  for (const Function* one : all_functions())
    if (one->id == id) return one;
  return nullptr;
}

std::vector<Case> cases_of(const Function& function, std::uint64_t seed) {
  Cases cases(seed);
  function.make(cases);
  std::stable_sort(cases.made.begin(), cases.made.end(), [](const Case& a, const Case& b) { return a.kind < b.kind; });
  return std::move(cases.made);
}

std::uint64_t hash_of(const Function& function) {
  Fnv1a hash;
  for (const Case& one : cases_of(function, 1))
    for (const double value : one.input) hash.add_bits(bits_of(value));
  return hash.value();
}

std::string json_lines(const Function& function, const std::vector<Numbers>& inputs) {
  std::string text;
  for (const Numbers& input : inputs) text += json_of(function.takes, input) + '\n';
  return text;
}

std::string number_lines(const std::vector<Numbers>& inputs) {
  std::string text;
  for (const Numbers& input : inputs) {
    for (const double value : input) text += word_of(value) + ' ';
    text.back() = '\n';
  }
  return text;
}

std::vector<Answered> read_answers(std::string_view text, std::size_t count) {
  std::vector<Answered> answers;
  while (!text.empty() && answers.size() < count) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    answers.push_back(read_answer(text.substr(0, end)));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  answers.resize(count, tl::unexpected(std::string(kNoAnswer)));
  return answers;
}

bool is_right(const Function& function, const Numbers& input, const Answered& answer) {
  if (!answer || !fits(function.gives, *answer)) return false;
  return function.accepts != nullptr ? function.accepts(input, *answer) : *answer == function.right(input);
}

int Judged::mark() const {
  return static_cast<int>(
      std::count_if(kinds.begin(), kinds.end(), [](const KindPassed& one) { return one.passed == one.of; }));
}

Judged judge(const Function& function, const std::vector<Case>& cases, const std::vector<Answered>& answers) {
  Judged judged;
  for (const Kind& kind : function.kinds) judged.kinds.push_back({.kind = &kind});
  for (std::size_t i = 0; i < cases.size(); ++i) {
    KindPassed& own = judged.kinds[static_cast<std::size_t>(cases[i].kind)];
    const bool right = is_right(function, cases[i].input, answers[i]);
    own.of += 1;
    own.passed += right ? 1 : 0;
    if (!right && !judged.first) judged.first = i;
  }
  return judged;
}

std::string says(const Judged& judged) {
  const KindPassed& random = judged.kinds.front();
  std::string text = std::to_string(random.passed) + " of " + std::to_string(random.of) + " random cases pass.";
  if (random.passed == 1) text = "1 of " + std::to_string(random.of) + " random cases passes.";
  if (random.passed == 0) text = "No random case passes.";
  if (random.passed == random.of) text = "All " + std::to_string(random.of) + " random cases pass.";
  std::vector<std::string_view> failed;
  for (const KindPassed& one : judged.kinds)
    if (one.kind != random.kind && one.passed < one.of) failed.push_back(one.kind->says);
  if (failed.empty()) return text + (judged.mark() == judged.of() ? " So do all hard ones." : " All hard ones pass.");
  if (judged.mark() == 0 && failed.size() > 2) return text + " It fails on hard ones of each kind.";
  text += " It fails on ";
  for (std::size_t i = 0; i < failed.size(); ++i)
    text += std::string(i == 0 ? "" : i + 1 == failed.size() ? "; and on " : "; on ") + std::string(failed[i]);
  return text + '.';
}

std::vector<Numbers> shorter(const Function& function, const Numbers& input) {
  const std::size_t length = json_of(function.takes, input).size();
  std::vector<Numbers> found = simpler(function.takes, input);
  const bool has_ends = function.takes.find("min:") != std::string_view::npos;
  std::erase_if(found, [&](const Numbers& one) {
    if (has_ends && coincides(input, one)) return true;
    return json_of(function.takes, one).size() >= length || (function.valid != nullptr && !function.valid(one));
  });
  return found;
}

bool shows(const Function& function, const Numbers& input, const Answered& answer) {
  constexpr double kSeen = 0.02;  // of the largest number
  const bool is_one_of_few =
      function.gives == "b" || function.gives == "i" || function.gives.find('|') != function.gives.npos;
  if (!answer || !fits(function.gives, *answer)) return false;
  if (is_one_of_few) return true;
  double most = 0, apart = 0;
  const Numbers right = function.right(input);
  for (std::size_t i = 0; i < right.size(); ++i)
    most = std::max(most, std::abs(right[i])), apart = std::max(apart, std::abs((*answer)[i] - right[i]));
  return std::isfinite(apart) && apart > kSeen * most;
}

std::optional<std::size_t> first_wrong(const Function& function, const std::vector<Numbers>& inputs,
                                       const std::vector<Answered>& answers, bool shown) {
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (!is_right(function, inputs[i], answers[i]) && (!shown || shows(function, inputs[i], answers[i]))) return i;
  return std::nullopt;
}

}  // namespace snug::write
