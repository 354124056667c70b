// A student in a lesson: the stage as edited, the runs on it with the place in the timeline, the conversation about
// them, and the log of what was done. The page and the desktop window are thin views of this; no rule of an exercise is
// written anywhere else. Each part knows those before it: log, stage, player, conversation.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/session/telling.hpp"

namespace snug::lesson {

class Session {
 public:
  /// mesh: the one that lesson.points.mesh names, if any. clock: times the effects. Errors: those of the subject's
  /// open; no method of the lesson takes so many points.
  [[nodiscard]] static tl::expected<Session, InputError> open(Lesson lesson, std::optional<io::PointFile> mesh = {},
                                                              Clock clock = nullptr);
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();  // not inline: a sanitizer would look for type information in other rooms, and this room has none

  // The parts stay in place when the session is moved.
  [[nodiscard]] const Lesson& lesson() const { return *lesson_; }
  [[nodiscard]] const Log& log() const { return *log_; }
  [[nodiscard]] const Stage& stage() const { return *stage_; }
  [[nodiscard]] Stage& stage() { return *stage_; }
  [[nodiscard]] const Player& player() const { return *player_; }
  [[nodiscard]] Player& player() { return *player_; }
  [[nodiscard]] const Conversation& conversation() const { return *conversation_; }
  [[nodiscard]] Conversation& conversation() { return *conversation_; }
  [[nodiscard]] Telling telling() const { return Telling(*conversation_); }
  /// A number that changes whenever anything that a view shows has changed.
  [[nodiscard]] std::uint64_t revision() const {
    return stage_->revision() + player_->revision() + conversation_->revision();
  }

  // ---- from step to step, and from question to question -----------------------------------------------------
  /// Goes to a step, but forward only up to the first unanswered question. jump goes past questions (because an address
  /// names a step): they count as skipped, and are asked when the player comes to them again. If the result is shown
  /// already, jump goes to the end only if a question was answered.
  void go(int step);
  void jump(int step);
  /// Goes to the next step; if an outcome is shown, only acknowledges it.
  void forward();
  void last() { go(player_->steps()); }

  // ---- tasks ------------------------------------------------------------------------------------------------
  /// The grade of a task, as the stage is now.
  [[nodiscard]] Grade grade(std::size_t task) const;
  /// That of the task in hand; none if the lesson has no task.
  [[nodiscard]] std::optional<Grade> grade() const;
  /// Whether a task was done since the lesson was opened; those that were, by what; whether all were, of any at all.
  [[nodiscard]] bool was_done(std::size_t task) const;
  [[nodiscard]] std::vector<DoneTask> done_tasks() const;
  [[nodiscard]] bool tasks_done() const;
  /// How many tasks are listed: none where something is built, which has a card of its own.
  [[nodiscard]] std::size_t tasks_listed() const;
  /// Starts a task and places an answer, such as its model. Errors: those of the subject.
  tl::expected<Grade, InputError> solve_task(std::size_t task, const Rows& answer);
  /// Whether a task is not solved now, and it is known what it was done by; places that.
  [[nodiscard]] bool can_solve_again(std::size_t task) const;
  tl::expected<Grade, InputError> solve_again(std::size_t task);

  // ---- what it begins with, and what is known of it ---------------------------------------------------------
  /// Sets how answers are taken, before the first is given.
  void conduct(Conduct conduct);
  /// Takes over the outcomes of an earlier session of this lesson, without those of unknown questions; the tasks that
  /// were done in it, and the sliders that were moved, by what they drive.
  void take_up(std::vector<Outcome> outcomes);
  void take_up(const std::vector<DoneTask>& tasks, std::vector<std::string> moved = {});
  /// Forgets all answers.
  void forget_answers();
  /// Gives the subject information that changes no run, such as measurements, and decides pending answers again.
  template <class Type, class Tell>
  bool inform(Tell tell) {
    if (as<Type>(stage_->subject()) == nullptr) return false;
    tell(static_cast<Type&>(*stage_->now_));
    informed();
    return true;
  }

 private:
  Session(Lesson lesson, std::vector<Stage::Situated> situations, Clock clock);
  void informed();

  std::unique_ptr<const Lesson> lesson_;
  std::unique_ptr<Log> log_;
  std::unique_ptr<Stage> stage_;
  std::unique_ptr<Player> player_;
  std::unique_ptr<Conversation> conversation_;
};

}  // namespace snug::lesson
