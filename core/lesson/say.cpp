#include "lesson/say.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fit/catalogue.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostNamed = 8;  // longer lists of names do not help
constexpr std::size_t kShort = 64;     // characters: a line of the summary

/// "B0, B1, B2 or B3"; empty if there are too many.
std::string choice_of(std::span<const std::string> names) {
  return names.size() > kMostNamed ? std::string() : one_of(names);
}

/// How a volume's name begins a title; empty for k-DOPs, whose titles say it.
std::string_view volume_title(std::string_view volume) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTitles{{{"sphere", "Sphere"},
                                                                                  {"aabb", "AABB"},
                                                                                  {"obb", "OBB"},
                                                                                  {"capsule", "Capsule"},
                                                                                  {"lozenge", "Lozenge"},
                                                                                  {"hull", "Convex hull"}}};
  for (const auto& [name, title] : kTitles)
    if (name == volume) return title;
  return {};
}

/// A title that says its volume as well. source: where the method is published.
std::string with_volume(std::string_view of, std::string title, std::string_view source) {
  const std::string volume(volume_title(of));
  if (volume.empty()) return title;
  const auto is_capital = [&](std::size_t i) { return i < title.size() && title[i] >= 'A' && title[i] <= 'Z'; };
  const std::string first = title.substr(0, title.find_first_of(" ,"));
  const bool author = source.find(". " + first) != std::string_view::npos;  // "E. Welzl, ..."
  if (is_capital(0) && !is_capital(1) && !author) title[0] = static_cast<char>(title[0] - 'A' + 'a');  // PCA stays PCA
  return volume + ": " + title;
}

}  // namespace

std::string title_in(const Lesson& lesson, const Method& method) {
  std::string title(method.title);
  return is_mixed(lesson) ? with_volume(method.volume, std::move(title), method.source) : title;
}

std::string title_among_volumes(std::string_view volume, std::string_view algorithm) {
  const fit::Algorithm* found = fit::find_algorithm(volume, algorithm);
  if (found == nullptr) return std::string(volume) + " " + std::string(algorithm);
  return with_volume(volume, std::string(found->title), found->source);
}

std::string_view verdict_text(const Outcome& outcome) {
  if (outcome.skipped) return "Skipped";
  if (outcome.pending) return "Not decided";
  if (!outcome.right) return "Not quite";
  return outcome.tries > 1 ? "Correct on the second try" : "Correct";
}

std::string_view field_word(const Asked& asked) {
  if (asked.number) return "Number";
  if (!asked.on_stage || !asked.choices.empty()) return {};
  return asked.many ? "Names" : "Name";
}

std::string how_to_answer(const Asked& asked) {
  if (asked.number && is_measured(asked.unit)) return "Type a number, in " + asked.unit + ".";
  if (asked.number) return asked.unit.empty() ? "Type a number." : "Type the number of " + asked.unit + ".";
  if (asked.ordered) return "Choose them one after the other, first to last.";
  if (asked.many && asked.on_stage) return "Tap all that you mean, or type their names. Then press Answer.";
  if (asked.many) return "Choose as many as you like, then press Answer.";
  if (asked.on_axes) return "Choose here or in the table of axes.";
  if (!asked.on_stage) return "Choose your answer.";
  const std::string tap = "Tap one of the ringed " + std::string(asked.subject->handle_words()[1]);
  return tap + (asked.choices.empty() ? ", or type its name." : ", or choose here.");
}

std::string chosen_text(const Asked& asked, const Answer& answer, const std::string& name) {
  const auto several = [](const std::string& what) { return what + " chosen. Press Answer when you have them all."; };
  return std::visit(
      ByKind{
          [](const Skipped&) { return std::string(); },
          [&](const OneHandle&) { return name + " chosen. Tap it again or press Enter to answer."; },
          [&](const SeveralHandles& all) { return several(asked.names(all.handles)); },
          [&](const OneChoice& one) {
            return "“" + asked.choices[one.choice] + "” chosen. Choose it again or press Enter to answer.";
          },
          [&](const SeveralChoices& all) { return several(std::to_string(all.choices.size())); },
          [&](const ChoicesInOrder& all) {
            const std::size_t left = asked.choices.size() - all.choices.size();
            return left == 0 ? "All in order. Press Answer." : std::to_string(left) + " still to choose.";
          },
          [](const TypedNumber& typed) { return plain_number(typed.number) + " chosen. Press Enter to answer."; },
      },
      answer);
}

std::string no_target_text(const std::string& name, std::span<const std::string> targets) {
  const std::string others = choice_of(targets);
  return name + " cannot be the answer. " +
         (others.empty()
              ? "One of the ringed ones is."
              : (targets.size() == 1 ? "Only " : "Choose ") + others + (targets.size() == 1 ? " can." : "."));
}

std::string no_such_name_text(std::string_view typed, std::span<const std::string> targets) {
  const std::string others = choice_of(targets);
  const std::string like = targets.empty() ? "" : " Type a name such as " + targets.front() + ".";
  return "Nothing here is called “" + std::string(typed) + "”." +
         (others.empty() || targets.size() == 1 ? like : " Type " + others + ".");
}

std::string score_text(const Tally& tally) {
  const auto predictions = [](int n) { return std::to_string(n) + (n == 1 ? " prediction" : " predictions"); };
  if (tally.open == tally.all()) return {};
  if (tally.skipped == tally.all()) return predictions(tally.skipped) + " skipped.";
  std::string text = std::to_string(tally.right) + " of " + predictions(tally.all()) + " correct";
  if (tally.second > 0) text += " (" + std::to_string(tally.second) + " on the second try)";
  const auto add = [&](int n, std::string_view what) {
    if (n > 0) text += ", " + std::to_string(n) + " " + std::string(what);
  };
  add(tally.wrong, "wrong");
  add(tally.skipped, "skipped");
  add(tally.open, "open");
  return text + ".";
}

std::string_view answer_state_text(const Outcome* outcome) {
  switch (answer_state_of(outcome)) {
    case AnswerState::kRight: return outcome->tries > 1 ? "right on the second try" : "right";
    case AnswerState::kWrong: return "wrong";
    case AnswerState::kSkipped: return "skipped";
    case AnswerState::kOpen: break;
  }
  return "open";
}

std::string_view short_prompt(std::string_view prompt) {
  if (prompt.size() <= kShort) return prompt;
  const auto mark = prompt.rfind('?');
  const auto end = mark != std::string_view::npos ? mark : prompt.size() - 1;
  const auto begin_after = [&](std::string_view stop) {  // the last one before that end
    const auto at = prompt.substr(0, end).rfind(stop);
    return at == std::string_view::npos ? std::size_t{0} : at + stop.size();
  };
  const auto begin = std::max(begin_after(". "), begin_after("? "));
  return prompt.substr(begin, end + 1 - begin);
}

std::string place_text(const Asked& asked, std::span<const Asked> all) {
  const auto it = [&](const Asked& other) { return other.question == asked.question; };
  const auto at = std::find_if(all.begin(), all.end(), it) - all.begin() + 1;
  return std::to_string(at) + " of " + std::to_string(all.size());
}

std::string start_task_text(const Session& session, const Task& task) {
  if (task.points == 0) return "Start";
  return "Start with " + std::to_string(task.points) + " " + std::string(session.stage().subject().handle_words()[1]);
}

std::string task_heading(std::size_t task, std::size_t tasks) {
  const std::string turn(kTaskWord);
  return tasks == 1 ? turn : turn + ", " + std::to_string(task + 1) + " of " + std::to_string(tasks);
}

std::string task_says(const Session& session, std::size_t task) {
  const Grade grade = session.grade(task);
  const bool undone = session.was_done(task) && !grade.done;
  return (undone ? "Solved before. " : "") + grade.says;
}

std::string only_text(const Task& task) {
  const std::size_t count = task.only.size();
  return "In this task only " + listed(task.only, " and ") + (count == 1 ? " moves" : " move") +
         ". Press Start to begin it.";
}

std::string no_number_text(std::string_view typed) {
  return "“" + std::string(typed) + "” is not a number. Write it like 12 or 2.5.";
}

}  // namespace snug::lesson
