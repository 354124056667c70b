#include "lesson/kept_answers.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>

#include "lesson/lesson.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<int>::max();
constexpr std::int64_t kMostSeed = std::int64_t{1} << 53;  // what a page's numbers can hold

/// The text as a basic string of TOML.
std::string toml_string(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string out = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') (out += '\\') += c;
    else if (byte < 0x20 || byte == 0x7f) ((out += "\\u00") += kDigits[byte >> 4]) += kDigits[byte & 15];
    else out += c;
  }
  return out += '"';
}

void add_text(std::string& out, std::string_view key, std::string_view text) {
  if (!text.empty()) ((out += key) += " = ") += toml_string(text) + '\n';
}

void add_number(std::string& out, std::string_view key, int number) {
  ((out += key) += " = ") += std::to_string(number) + '\n';
}

void add_list(std::string& out, std::string_view key, const std::vector<int>& list) {
  if (list.empty()) return;
  (out += key) += " = [";
  for (const int entry : list) (out += std::to_string(entry)) += ", ";
  out += "]\n";
}

void add_tasks(std::string& out, const std::vector<DoneTask>& tasks) {
  if (tasks.empty()) return;
  std::vector<int> numbers;
  std::string words;
  for (const auto& [task, by] : tasks) numbers.push_back(task), (words += toml_string(by)) += ", ";
  add_list(out, "tasks", numbers);
  out += "solved = [" + words + "]\n";
}

/// All digits that tell a number from every other, as TOML writes it.
std::string plain_double(double number) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17e", number);
  return text.data();
}

void add_flag(std::string& out, std::string_view key, bool on) {
  if (on) (out += key) += " = true\n";
}

/// An answer as it is kept; of several choices the bits are the value.
struct KeptAnswer {
  std::string_view kind;
  int value = 0;
  std::vector<int> list = {};
};

KeptAnswer kept_of(const Answer& answer) {
  return std::visit(ByKind{
                        [](const Skipped&) { return KeptAnswer{"skipped"}; },
                        [](const OneHandle& one) {
                          return KeptAnswer{"point", one.handle};
                        },
                        [](const SeveralHandles& several) {
                          return KeptAnswer{"points", 0, several.handles};
                        },
                        [](const OneChoice& one) {
                          return KeptAnswer{"choice", one.choice};
                        },
                        [](const SeveralChoices& several) {
                          return KeptAnswer{"choice", choice_bits(several)};
                        },
                        [](const ChoicesInOrder& all) {
                          return KeptAnswer{"order", 0, all.choices};
                        },
                        [](const TypedNumber&) { return KeptAnswer{"number"}; },
                    },
                    answer);
}

Answer read_answer(TomlTable& table) {
  const std::string kind = table.text("kind");
  const int value = static_cast<int>(table.integer("value", -kMost, kMost));
  const double number = table.any_number("number", 0);
  std::vector<int> list;
  if (table.has("list"))
    for (const double entry : table.numbers("list")) list.push_back(static_cast<int>(entry));
  if (kind == "point") return OneHandle{value};
  if (kind == "points") return SeveralHandles{std::move(list)};
  if (kind == "choice") return OneChoice{value};
  if (kind == "order") return ChoicesInOrder{std::move(list)};
  if (kind == "number") return TypedNumber{number};
  return Skipped{};
}

Outcome read_outcome(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[answer]]", complaints);
  Outcome outcome;
  outcome.question = table.text("question");
  outcome.on = static_cast<std::uint64_t>(table.integer_or("on", 0, kMostSeed, 0));
  outcome.given = read_answer(table);
  outcome.from_step = static_cast<int>(table.integer("from_step", 0, kMost));
  outcome.step = static_cast<int>(table.integer("step", 0, kMost));
  outcome.right = table.flag_or("right", false);
  outcome.skipped = table.flag_or("skipped", false);
  outcome.passed = table.flag_or("passed", false);
  outcome.pending = table.flag_or("pending", false);
  outcome.tries = outcome.skipped ? 0 : table.flag_or("second", false) ? 2 : 1;
  outcome.predicted = table.text_or("predicted", "");
  outcome.happened = table.text_or("happened", "");
  outcome.says = table.text_or("says", "");
  outcome.because = table.text_or("because", "");
  return outcome;
}

}  // namespace

KeptAnswers answers_of(const Session& session) {
  return {session.log().outcomes(), session.done_tasks(), session.log().moved()};
}

void take_up(Session& session, const KeptAnswers& answers) {
  session.take_up(answers.outcomes);
  session.take_up(answers.tasks, answers.moved);
}

std::string kept_text(const KeptAnswers& answers) {
  std::string out;
  add_tasks(out, answers.tasks);
  if (!answers.moved.empty()) {
    out += "moved = [";
    for (const std::string& drives : answers.moved) (out += toml_string(drives)) += ", ";
    out += "]\n";
  }
  for (const Outcome& outcome : answers.outcomes) {
    out += "[[answer]]\n";
    add_text(out, "question", outcome.question);
    if (outcome.on != 0) ((out += "on = ") += std::to_string(outcome.on)) += '\n';
    const KeptAnswer given = kept_of(outcome.given);
    add_text(out, "kind", given.kind);
    add_number(out, "value", given.value);
    add_list(out, "list", given.list);
    if (const auto* typed = std::get_if<TypedNumber>(&outcome.given))
      ((out += "number = ") += plain_double(typed->number)) += '\n';
    add_number(out, "from_step", outcome.from_step);
    add_number(out, "step", outcome.step);
    add_flag(out, "right", outcome.right);
    add_flag(out, "skipped", outcome.skipped);
    add_flag(out, "passed", outcome.passed);
    add_flag(out, "pending", outcome.pending);
    add_flag(out, "second", outcome.tries > 1);
    add_text(out, "predicted", outcome.predicted);
    add_text(out, "happened", outcome.happened);
    add_text(out, "says", outcome.says);
    add_text(out, "because", outcome.because);
  }
  return out;
}

KeptAnswers kept_answers_of(std::string_view kept) {
  Complaints complaints("");
  const auto parsed = parse_file(kept, "the answers", complaints);
  if (!parsed) return {};
  TomlTable table(*parsed, "the answers", complaints);
  KeptAnswers answers;
  if (table.has("tasks"))
    for (const double task : table.numbers("tasks"))
      if (task >= 0 && task <= kMost) answers.tasks.push_back({static_cast<int>(task)});
  if (table.has("solved")) {
    const std::vector<std::string> solved = table.texts("solved", 0);
    for (std::size_t i = 0; i < std::min(solved.size(), answers.tasks.size()); ++i)
      if (unpacked_rows(solved[i])) answers.tasks[i].by = solved[i];
  }
  if (table.has("moved")) answers.moved = table.texts("moved", 0);
  for (const toml::table* answer : table.tables("answer"))
    answers.outcomes.push_back(read_outcome(*answer, complaints));
  if (complaints.first()) return {};
  return answers;
}

}  // namespace snug::lesson
