// Opens a session, chooses its methods, and computes what is computed on demand.
#include "lesson/session.hpp"

#include <algorithm>

#include "lesson/packed_rows.hpp"
#include "lesson/patience.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostLetters = 8000;  // of what a task was done by, as a device keeps it

/// What stands on the stage, packed; empty if that is too long to be kept.
std::string word_of(const Subject& subject) {
  std::string word = packed_rows(subject.rows());
  return word.size() <= kMostLetters ? word : std::string();
}

}  // namespace

tl::expected<Session, InputError> Session::open(Lesson lesson, std::optional<io::PointFile> mesh, Clock clock) {
  if (lesson.subject == nullptr) lesson.subject = find_subject(lesson.volume, "");
  if (lesson.algorithms.empty()) return tl::unexpected(InputError{.what = "the lesson offers no algorithm"});
  std::vector<Situated> places;
  for (const std::string_view name : situation_names(lesson)) {
    auto own = open_situation(lesson, name, mesh, clock);
    if (!own) return tl::unexpected(std::move(own.error()));
    places.push_back({*std::move(own), {}});
  }
  Session session(std::move(lesson), std::move(places));
  session.clock_ = clock;
  session.opened_at_ = clock != nullptr ? clock() : 0;
  if (auto made = session.make_room_for(*session.now_); !made) return tl::unexpected(std::move(made.error()));
  session.subject_changed();
  session.step_ = 0;
  if (session.lesson_->start == Lesson::Start::kEnd) {
    session.step_ = session.steps();
    session.previewing_ = true;
  }
  return session;
}

Session::Session(Lesson lesson, std::vector<Situated> places)
    : lesson_(std::make_unique<const Lesson>(std::move(lesson))), places_(std::move(places)), now_(own().clone()),
      slid_(opened().slid), grades_(lesson_->tasks.size()), predicts_(!lesson_->subject->predict_when_measuring),
      done_(lesson_->tasks.size()) {
  use(0, find_method(*lesson_, lesson_->algorithms.front()));
  if (!lesson_->compare.empty()) use(1, find_method(*lesson_, lesson_->compare));
}

Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

View Session::view(int slot) const {
  return {{Slot{slots_[0].method, slots_[0].run.get()}, Slot{slots_[1].method, slots_[1].run.get()}},
          slot,
          step_of(slot),
          drag_.subject != nullptr};
}

void Session::use(int slot, const Method* method) {
  Used& own = slots_[slot];
  own = {method, nullptr, {}};
  if (method == nullptr) return;
  const auto pseudocode = pseudocode_of(*method, dim());
  own.pseudocode.assign(pseudocode.begin(), pseudocode.end());
  for (const Pseudocode& words : lesson_->pseudocode)
    if (find_method(*lesson_, words.algorithm) == method) own.pseudocode.assign(words.lines.begin(), words.lines.end());
}

Done Session::choose(int slot, std::string_view name) {
  const bool clear = name.empty() && slot == 1;
  const Method* method = clear ? nullptr : find_method(*lesson_, name);
  if (method == nullptr && !clear)
    return tl::unexpected(InputError{.what = "there is no algorithm " + std::string(name)});
  if (method != nullptr && !now_->suits(*method)) return tl::unexpected(InputError{.what = now_->refusal(*method)});
  if (method == this->method(slot)) return {};
  if (conduct_.decides) return tl::unexpected(InputError{.what = std::string(kStageIsFixed)});
  const bool at_end = step_ == steps();
  use(slot, method);
  run_again(slot);
  if (slot == 0) {
    step_ = 0;
    run_changed(at_end);
    forget_grades();
  }
  ++revision_;
  return {};
}

const Method* Session::first_that_suits(const Subject& subject) const {
  for (const std::string& name : lesson_->algorithms)
    if (const Method* offered = find_method(*lesson_, name); subject.suits(*offered)) return offered;
  return nullptr;
}

/// A method that cannot take the next points gives way: the main one to the first of the lesson's that can.
const Method* Session::method_for(int slot, const Subject& next) const {
  const Method* own = slots_[slot].method;
  if (own == nullptr || next.suits(*own)) return own;
  return slot == 0 ? first_that_suits(next) : nullptr;
}

Done Session::make_room_for(const Subject& next) {
  const Method* main = method_for(0, next);
  if (main == nullptr) return tl::unexpected(InputError{.what = next.refusal(*slots_[0].method)});
  if (main != slots_[0].method) use(0, main);
  if (slots_[1].method != nullptr && method_for(1, next) == nullptr) use(1, nullptr);
  return {};
}

void Session::run_again(int slot) {
  Used& own = slots_[slot];
  if (own.method == nullptr) return;
  const bool is_there = ready_ != nullptr && ready_->method(slot) == own.method && ready_->work.runs[slot] != nullptr;
  own.run = is_there ? std::move(ready_->work.runs[slot]) : now_->run(*own.method, std::move(own.run));
}

void Session::subject_changed() {
  const bool at_end = slots_[0].run != nullptr && step_ == steps() && step_ > 0;
  rivals_.reset(), results_.clear();
  if (!waits()) forget_grades();
  run_again(0);
  run_again(1);
  run_changed(at_end);
  ++revision_;
}

std::vector<Switch> Session::switches() const {
  return now_->parts() != nullptr ? now_->parts()->switches(view()) : std::vector<Switch>();
}

bool Session::turn(std::string_view name, bool on) {
  if (conduct_.decides || now_->parts() == nullptr || !now_->parts()->turn(name, on, view())) return false;
  results_.clear();
  run_again(0);
  run_again(1);
  run_changed(false);
  ++revision_;
  return true;
}

bool Session::waits() const { return drag_.subject != nullptr && now_->frames() != nullptr; }

const std::vector<Rival>& Session::rivals() const {
  if (!rivals_) rivals_ = now_->rivals(*lesson_, view());
  return *rivals_;
}

void Session::forget_grades() {
  for (std::optional<Grade>& grade : grades_) grade.reset();
}

Grade Session::grade(std::size_t task) const {
  const Task& own = lesson_->tasks[task];
  if (own.situation != situation())
    return {.says = "This task is about “" + situation_title(*lesson_, own.situation) + "”: start it."};
  if (!grades_[task]) grades_[task] = now_->grade(*lesson_, own, view());
  Grade now = *grades_[task];
  if (now.done && !own.only.empty() && !(task_started_ && task_ == task)) now.done = false, now.says = only_text(own);
  if (now.done && !drag_.subject && !done_[task]) done_[task] = word_of(*now_);  // not what a hand only passes through
  // The grade comes from the run's result, which would give away the steps that are asked about.
  if (!now.done && predicting() && is_own()) now.says = kTaskWaits;
  else if (!now.done && !now_->moves_at(step_)) now.says += " " + std::string(now_->frames()->fixed_now());
  return now;
}

std::optional<Grade> Session::grade() const {
  if (lesson_->tasks.empty()) return std::nullopt;
  return grade(task_);
}

bool Session::was_done(std::size_t task) const {
  static_cast<void>(grade(task));
  return done_[task].has_value();
}

std::vector<Session::DoneTask> Session::done_tasks() const {
  std::vector<DoneTask> done;
  for (std::size_t i = 0; i < lesson_->tasks.size(); ++i)
    if (was_done(i)) done.push_back({static_cast<int>(i), *done_[i]});
  return done;
}

bool Session::can_solve_again(std::size_t task) const {
  return was_done(task) && !done_[task]->empty() && !grade(task).done;
}

void Session::take_up_tasks(const std::vector<DoneTask>& done) {
  for (const auto& [task, by] : done)
    if (task >= 0 && task < std::ssize(done_)) done_[task] = by;
  // The student goes on with the first that is left.
  const auto open = std::find(done_.begin(), done_.end(), std::nullopt);
  if (open != done_.end()) task_ = open - done_.begin();
}

bool Session::tasks_done() const { return !done_.empty() && done_tasks().size() == done_.size(); }

std::uint64_t Session::trace_hash() const {
  if (!hash_) hash_ = run(0).hash();
  return *hash_;
}

std::string Session::caption() const {
  const WithDecimals wished(lesson_->view.decimals);
  return step_ == 0 ? now_->opening(*method(0)) : run(0).sentence(step_ - 1, untold());
}

std::string_view Session::asked_figure() const {
  const Asked* now = standing();  // also while another question's outcome is shown
  return now == nullptr ? std::string_view() : std::string_view(now->hidden_figure());
}

bool Session::predicting() const {
  const Asked* question = fresh_ ? standing() : asked();
  return question != nullptr && question->step != Asked::kAnytime;
}

Untold Session::untold() const {
  Untold untold;
  untold.now = asked_figure();
  if (!untold.now.empty()) untold.figures.push_back(untold.now);
  std::vector<std::string_view> seen;
  for (const Asked& asked : asked_) {
    const std::string_view figure = asked.question->figure;
    if (figure.empty() || std::find(seen.begin(), seen.end(), figure) != seen.end()) continue;
    seen.push_back(figure);
    if (step() < asked.until && is_open(*asked.question)) untold.figures.push_back(figure);
  }
  // A run's result gives too much of the run away, whatever is asked.
  if (std::any_of(asked_.begin(), asked_.end(),
                  [&](const Asked& asked) { return step() < asked.until && is_open(*asked.question); }))
    untold.figures.push_back(kResultFigure);
  if (predicting()) untold.figures.push_back("excess");  // it is relative to the result of another run
  return untold;
}

std::vector<Figure> Session::figures(int slot) const {
  if (method(slot) == nullptr) return {};
  const WithDecimals wished(lesson_->view.decimals);
  std::vector<Figure> figures = now_->figures(view(slot));
  const Untold hidden = untold();
  for (Figure& figure : figures)
    if ((figure.of_step ? hidden.now == figure.key : hidden.hides(figure.key)) ||
        (slot == 1 && awaits(*method(1), figure.key)))
      figure.text = "—", figure.known = false;
  return figures;
}

const std::vector<Figure>& Session::result(const Method& of) const {
  static const std::vector<Figure> kNotYet;
  if (waits()) return kNotYet;
  const auto [found, is_new] = results_.try_emplace(&of);
  if (is_new && now_->suits(of)) found->second = now_->figures_at_end(of, view());
  return found->second;
}

std::vector<Proof> Session::proofs(int slot) const {
  if (method(slot) == nullptr) return {};
  const WithDecimals wished(lesson_->view.decimals);
  return now_->proofs(view(slot));
}

}  // namespace snug::lesson
