// The conversation about a run: what is asked at its steps, what the student chooses and gives as an answer, what is
// then played and told. A question is asked, answered (a wrong answer may have a second try), decided (the steps up to
// there are played), told, and acknowledged; only then is the next one asked.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/session/player.hpp"

namespace snug::lesson {

class Conversation final : public PlayerFollower {
 public:
  Conversation(const Lesson& lesson, Stage& stage, Player& player, Log& log);

  [[nodiscard]] const Lesson& lesson() const { return *lesson_; }
  [[nodiscard]] const Player& player() const { return *player_; }
  [[nodiscard]] const Stage& stage() const { return *stage_; }
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

  // ---- what is asked ----------------------------------------------------------------------------------------
  /// Every question of this run in the timeline's order, without those whose step the run does not have.
  [[nodiscard]] const std::vector<Asked>& questions() const { return asked_; }
  /// The open question at the current step; null while an outcome is shown. Playing waits for it. A lesson opens
  /// without one: what is seen first can be looked at, and the first step asks.
  [[nodiscard]] const Asked* asked() const;
  /// The question that stands open at this place, also while another's outcome is shown.
  [[nodiscard]] const Asked* question_here() const;
  /// The first open question about what is measured, which belongs to no step; null for none.
  [[nodiscard]] const Asked* to_predict() const { return open_at(Asked::kAnytime); }
  /// Asks those of the situation on the stage, where they wait until measuring is wanted.
  void ask_predictions();
  /// What questions are asked on now: the seed of the points to practise on; 0: the lesson's own, whose answers hold
  /// wherever else the stage is changed by hand.
  [[nodiscard]] std::uint64_t instance() const;
  /// Whether a question was neither answered nor skipped on what it is asked on now; one that a jump passed is open.
  [[nodiscard]] bool is_open(const Question& question) const;
  /// The lesson's other methods that still have open questions; none if the subject was edited, because then the
  /// questions may not come.
  [[nodiscard]] std::vector<const Method*> waiting() const;
  /// Whether something is asked of this run that holds on any points.
  [[nodiscard]] bool can_practise() const;
  /// Scatters to the next seed that raises a question, and asks there whatever was answered elsewhere, from the first
  /// step on, as one entry of undo. The answers given so far are kept. Returns false if none of the next hundred does.
  bool practise();

  // ---- the answer: chosen by hand, then given ---------------------------------------------------------------
  /// Chooses an answer; choosing it again gives it. If a question takes many choices, selects or deselects one. gives:
  /// whether an exercise takes it at once, as it takes a tap; a key that goes through the answers does not. Returns
  /// false if nothing is asked, or if this cannot be an answer: answer_says then tells what can.
  bool pick(const Answer& answer, bool gives = true);
  /// The same for a handle by its typed name ("B2", "p7").
  bool pick(std::string_view name);
  /// The chosen answer to the open question; null if there is none.
  [[nodiscard]] const Answer* picked() const { return picked_ && asked() != nullptr ? &*picked_ : nullptr; }
  void unpick();
  /// Gives the chosen answer, as a first one. Returns false if none is chosen.
  bool commit();
  /// Gives an answer, or skips the question: the player goes to the step that decides it, so that prediction and result
  /// can be compared. for_good: without a second try, and to that step at once. Otherwise a first answer that is wrong
  /// may only be called wrong, and where the app plays the steps (play_answers) the player stays for it to do so.
  /// Returns false, and changes nothing, if nothing is asked or if this cannot be an answer (a handle that is no
  /// choice).
  bool give(const Answer& given, bool for_good = true);
  /// The "next" key at a question: the first press announces that a second one skips the question, the second skips it.
  /// Returns false if nothing is asked.
  bool pass_by();
  /// Where answers are told at the end only: takes the last one back, and goes to where it is asked.
  bool take_back();
  /// The wrong first answer, while the question waits for the second; null otherwise.
  [[nodiscard]] const Answer* tried() const;
  /// What to say about the last pick: that it is chosen, or why it cannot be the answer. Empty for nothing.
  [[nodiscard]] const std::string& answer_says() const { return answer_says_; }
  /// The handles that can be the answer to the open question, in rising order; none if it is not answered on the stage.
  [[nodiscard]] std::vector<Index> targets() const;
  [[nodiscard]] std::vector<std::string> target_names() const;

  // ---- what is decided and told -----------------------------------------------------------------------------
  /// Whether the app plays the steps between a question and its outcome. If on, commit leaves the player where it is;
  /// if off, it goes to the outcome at once.
  void play_answers(bool on) { play_answers_ = on; }
  /// The outcome of a given answer, while the steps up to its decision are played; null otherwise.
  [[nodiscard]] const Outcome* deciding() const { return deciding_ ? &log_->outcomes()[shown_outcome_] : nullptr; }
  /// Goes at once to the step where it is decided.
  void decide();
  /// The outcome that is shown: from the step where it is decided (or where it was asked, if another question is asked
  /// there as well), until it is acknowledged or the player moves away; null otherwise.
  [[nodiscard]] const Outcome* outcome() const;
  /// Marks the outcome as read. Returns false if none is shown.
  bool acknowledge();
  /// Goes back to where its question was asked, and plays on. Returns false if there are no steps between.
  bool watch_outcome();
  /// Whether the outcome that is shown has such steps. It has none where it is told before its step.
  [[nodiscard]] bool can_watch_outcome() const;
  /// Shows a question's outcome again, at the step where it was decided. Returns false if it has none.
  bool review(std::string_view question);
  /// After a wrong answer: whether the right one can be marked; marks it; whether it is marked.
  [[nodiscard]] bool can_show_answer() const;
  bool show_answer();
  [[nodiscard]] bool answer_shown() const { return answer_shown_ && outcome() != nullptr; }
  /// The right choices of the outcome that is shown; none if its answers are handles only.
  [[nodiscard]] std::vector<int> right_choices() const;
  /// The question of an outcome; null if this run does not have it.
  [[nodiscard]] const Asked* question_of(const Outcome& outcome) const;
  /// The outcome of a question of this run; null for none.
  [[nodiscard]] const Outcome* outcome_of(const Asked& asked) const;
  /// The state of this run's questions, counted.
  [[nodiscard]] Tally tally() const;
  /// The score of the predictions (score_text), once the run is finished; otherwise empty.
  [[nodiscard]] std::string score() const;
  /// Whether the summary is shown: the run is finished, each question done and its outcome read. It can be closed.
  [[nodiscard]] bool at_summary() const;
  void close_summary();

 private:
  friend class Session;  // which goes from question to question

  bool follow(bool entered) override;
  /// Decides predictions that were made before anything was known, again whenever more is known.
  void judge_again();
  void set_step(int step);
  [[nodiscard]] std::vector<int> places() const;
  bool refuse(std::string why);
  void choose(Answer answer, const std::string& name = {});
  [[nodiscard]] const Asked* open_at(int step) const;
  void take_as_asked();
  [[nodiscard]] Outcome judged(const Asked& asked, const Answer& answer) const;
  void go_to_next_decision();
  bool try_again(const Asked& question, const Answer& answer);
  bool pick_one_more(const Asked& question, const Answer& chosen);
  bool pick_one_more_handle(Index handle);
  bool pick_number(const Asked& question, std::string_view typed);
  bool pick_names(std::string_view typed);
  [[nodiscard]] int told_at(const Asked& own) const;
  void show_nothing() { shown_outcome_ = -1, deciding_ = false, ++revision_; }
  void forget();

  const Lesson* lesson_;
  Stage* stage_;
  Player* player_;
  Log* log_;
  bool predicts_;               // whether to_predict() is asked
  std::uint64_t practice_ = 0;  // the seed that was scattered to practise; 0 for none
  std::vector<Asked> asked_;
  std::optional<Answer> picked_;  // chosen and not given yet
  std::string answer_says_;
  struct Tried {
    std::string question;  // its id
    Answer answer;
  };
  std::optional<Tried> tried_;  // the wrong first answer
  bool skips_next_ = false;     // it was announced that a second press skips
  bool play_answers_ = false;
  int shown_outcome_ = -1;  // its place in the log, shown once step shown_at_ is reached
  int shown_at_ = -1;
  bool deciding_ = false;  // whether the steps up to there are being played
  bool answer_shown_ = false;
  bool summary_closed_ = false;
  std::uint64_t revision_ = 1;
};

}  // namespace snug::lesson
