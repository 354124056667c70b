// What a student did in a lesson: the answers given, the tasks done, the sliders moved.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/ask.hpp"

namespace snug::lesson {

/// An answer that was given: right or not, and at which try.
struct Given {
  std::string question;  // its id
  Answer answer;
  bool right = false;
  double seconds = 0;  // since the lesson was opened; 0 without a clock
};

/// A task that was done, by its number, and what stood on the stage when it first was (packed_rows); empty if that is
/// not known, or too long to be kept.
struct DoneTask {
  int task = 0;
  std::string by = {};
  bool operator==(const DoneTask&) const = default;
};

class Log {
 public:
  Log(const Lesson& lesson, Clock clock);

  /// The time since the lesson was opened; 0 without a clock.
  [[nodiscard]] double seconds() const;
  /// What became of each question, on whatever it was asked.
  [[nodiscard]] const std::vector<Outcome>& outcomes() const { return outcomes_; }
  /// The outcome of a question on an instance (Conversation::instance); null for none.
  [[nodiscard]] const Outcome* outcome_of(std::string_view question, std::uint64_t on) const;
  /// Every answer that was given, in order, without those that were taken back.
  [[nodiscard]] const std::vector<Given>& given() const { return given_; }
  /// The situations besides this one that still have open questions, on whatever points.
  [[nodiscard]] std::vector<std::string> situations_waiting(std::string_view besides) const;
  /// What a task was done by; none if it was not done.
  [[nodiscard]] const std::optional<std::string>& done(std::size_t task) const { return done_[task]; }
  /// The first task that was not done; as many as there are if all were.
  [[nodiscard]] std::size_t first_to_do() const;
  /// The sliders that the lesson is about (must_move) which were moved, by what they drive; and the others.
  [[nodiscard]] const std::vector<std::string>& moved() const { return moved_; }
  [[nodiscard]] std::vector<const Slider*> to_move() const;

  /// Adds an outcome, or puts it in the place of the question's earlier one. Returns its place among outcomes.
  std::size_t add(Outcome outcome);
  /// Adds an answer that was given.
  void add(std::string_view question, const Answer& answer, bool right);
  /// Takes back the last given answer, and the outcome of its question, of which it was the only one.
  void take_back();
  /// Notes a task that is done by what stands on the stage.
  void add_done(std::size_t task, const Subject& by);
  /// Notes a slider that was moved.
  void add_moved(const Slider& slider);
  /// Takes over what is known of an earlier session, without unknown questions and tasks.
  void take_up(std::vector<Outcome> outcomes);
  void take_up(const std::vector<DoneTask>& tasks, std::vector<std::string> moved);
  /// Reads the answers to a question as it means them (as_asked).
  void take_as_asked(const Asked& asked);
  /// Forgets all but the tasks.
  void forget_answers();

 private:
  const Lesson* lesson_;
  Clock clock_;
  double opened_at_;  // by the clock, ns
  std::vector<Outcome> outcomes_;
  std::vector<Given> given_;
  std::vector<std::optional<std::string>> done_;  // by the tasks: none, or DoneTask::by
  std::vector<std::string> moved_;
};

}  // namespace snug::lesson
