// Puts the parts of a session together, and does what needs several of them.
#include "lesson/session.hpp"

#include <algorithm>

#include "lesson/packed_rows.hpp"
#include "lesson/patience.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {

tl::expected<Session, InputError> Session::open(Lesson lesson, std::optional<io::PointFile> mesh, Clock clock) {
  if (lesson.subject == nullptr) lesson.subject = find_subject(lesson.volume, "");
  if (lesson.algorithms.empty()) return tl::unexpected(InputError{.what = "the lesson offers no algorithm"});
  std::vector<Stage::Situated> situations;
  for (const std::string_view name : situation_names(lesson)) {
    auto own = open_situation(lesson, name, mesh, clock);
    if (!own) return tl::unexpected(std::move(own.error()));
    situations.push_back({*std::move(own), {}});
  }
  Session session(std::move(lesson), std::move(situations), clock);
  if (auto begun = session.player_->begin(); !begun) return tl::unexpected(std::move(begun.error()));
  return session;
}

Session::Session(Lesson lesson, std::vector<Stage::Situated> situations, Clock clock)
    : lesson_(std::make_unique<const Lesson>(std::move(lesson))), log_(std::make_unique<Log>(*lesson_, clock)),
      stage_(std::make_unique<Stage>(*lesson_, std::move(situations), *log_, clock)),
      player_(std::make_unique<Player>(*lesson_, *stage_)),
      conversation_(std::make_unique<Conversation>(*lesson_, *stage_, *player_, *log_)) {
  stage_->runs_ = player_.get();
  player_->questions_ = conversation_.get();
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

void Session::go(int step) {
  Conversation& talk = *conversation_;
  if (player_->previewing() && step == player_->steps()) return;
  if (step != player_->step()) talk.acknowledge();
  if (talk.deciding_) {  // a step on the way there; any other step ends it
    if (step > player_->step()) return talk.set_step(std::min(step, talk.shown_at_));
    talk.deciding_ = false;
  }
  const bool begin = player_->previewing() && step > player_->steps();
  const int from = player_->previewing() ? 0 : player_->step();
  int to = begin ? 1 : std::clamp(step, 0, player_->steps());
  for (const Asked& asked : talk.questions())
    if (asked.step != Asked::kAnytime && asked.step >= from && asked.step < to && talk.is_open(*asked.question))
      to = asked.step;
  talk.set_step(to);
}

void Session::forward() {
  if (!conversation_->acknowledge()) go(player_->step() + 1);
}

void Session::jump(int step) {
  Conversation& talk = *conversation_;
  // A lesson that starts at its end is there already; who has answered something comes back to the end itself.
  if (player_->previewing() && step >= player_->steps() && log_->outcomes().empty()) return;
  talk.deciding_ = false;
  const int to = std::clamp(step, 0, player_->steps());
  const int from = player_->previewing() ? 0 : player_->step();
  for (const Asked& asked : talk.questions()) {
    if (asked.step == Asked::kAnytime || asked.step < from || asked.step >= to || !talk.is_open(*asked.question))
      continue;
    Outcome outcome = talk.judged(asked, {});
    outcome.passed = true;
    log_->add(std::move(outcome));
  }
  talk.set_step(to);
}

Grade Session::grade(std::size_t task) const {
  const Task& own = lesson_->tasks[task];
  if (own.situation != stage_->situation())
    return {.says = "This task is about “" + situation_title(*lesson_, own.situation) + "”: start it."};
  Grade now = player_->judged(task);
  const bool keeps = own.only.empty() || (stage_->at_task() && stage_->task() == task);
  if (now.done && !keeps) now.done = false, now.says = only_text(own);
  const Subject& subject = stage_->subject();
  if (now.done && !stage_->dragging()) log_->add_done(task, subject);  // not what a hand only passes through
  // The grade comes from the run's result, which would give away the steps that are asked about.
  if (!now.done && telling().predicting() && stage_->is_own()) now.says = kTaskWaits;
  else if (!now.done && !subject.moves_at(player_->step()))
    now.says += " " + std::string(subject.frames()->fixed_now());
  return now;
}

std::optional<Grade> Session::grade() const {
  if (lesson_->tasks.empty()) return std::nullopt;
  return grade(stage_->task());
}

bool Session::was_done(std::size_t task) const {
  static_cast<void>(grade(task));
  return log_->done(task).has_value();
}

std::vector<DoneTask> Session::done_tasks() const {
  std::vector<DoneTask> done;
  for (std::size_t i = 0; i < lesson_->tasks.size(); ++i)
    if (was_done(i)) done.push_back({static_cast<int>(i), *log_->done(i)});
  return done;
}

bool Session::tasks_done() const { return !lesson_->tasks.empty() && done_tasks().size() == lesson_->tasks.size(); }

std::size_t Session::tasks_listed() const { return stage_->conduct().builds ? 0 : lesson_->tasks.size(); }

tl::expected<Grade, InputError> Session::solve_task(std::size_t task, const Rows& answer) {
  stage_->start_task(task);
  if (Done made = stage_->set_rows(answer); !made) return tl::unexpected(std::move(made.error()));
  stage_->task_started_ = true;
  player_->forget_grades();
  return grade(task);
}

bool Session::can_solve_again(std::size_t task) const {
  return was_done(task) && !log_->done(task)->empty() && !grade(task).done;
}

tl::expected<Grade, InputError> Session::solve_again(std::size_t task) {
  const auto rows = can_solve_again(task) ? unpacked_rows(*log_->done(task)) : std::nullopt;
  return rows ? solve_task(task, *rows) : grade(task);
}

void Session::conduct(Conduct conduct) {
  stage_->conduct_ = conduct;
  if (conduct.builds || conduct.decides) stage_->forget_undo();  // what led to this stage cannot be undone
  if (!conduct.decides) return;
  player_->step_ = -1;  // so that it stands anew, with the marks of an exercise
  conversation_->go_to_next_decision();
}

void Session::take_up(std::vector<Outcome> outcomes) {
  log_->take_up(std::move(outcomes));
  conversation_->take_as_asked();
  conversation_->show_nothing();
}

void Session::take_up(const std::vector<DoneTask>& tasks, std::vector<std::string> moved) {
  log_->take_up(tasks, std::move(moved));
  // The student goes on with the first that is left.
  if (const std::size_t left = log_->first_to_do(); left < lesson_->tasks.size()) stage_->task_ = left;
  ++stage_->revision_;
}

void Session::forget_answers() {
  log_->forget_answers();
  conversation_->forget();
  conversation_->summary_closed_ = false;
}

void Session::informed() {
  player_->forget_grades();
  conversation_->judge_again();
}

}  // namespace snug::lesson
