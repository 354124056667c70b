// A student at an exercise: hints, marks, and what is said to a decision. The decisions themselves are the session's.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/exercise/attempt.hpp"
#include "lesson/exercise/instance.hpp"

namespace snug::lesson {

/// What became of a decision, for the list of all of them.
struct Marked {
  const Asked* asked = nullptr;
  AnswerState standing = AnswerState::kOpen;  // open: not made yet, or not told before the end
  int hints = 0;
  double mark = 0;  // 1 at the first try, a half at the second, less the price of hints
};

/// What was built: the stage, the levels that it reaches, and when.
struct Built {
  Rows rows;
  int level = 0;
  double seconds = 0;
};

class Sitting {
 public:
  /// session: one that open_instance gave for this seed. It is not kept: each call is given it again, for it may move.
  /// practises: without a mark, so that hints cost nothing.
  Sitting(std::shared_ptr<const Exercise> exercise, std::uint64_t seed, const Session& session, bool practises = false)
      : exercise_(std::move(exercise)), seed_(seed), practises_(practises),
        hints_(exercise_->build ? 1 : session.conversation().questions().size()) {}

  [[nodiscard]] const Exercise& exercise() const { return *exercise_; }
  [[nodiscard]] std::uint64_t seed() const { return seed_; }
  [[nodiscard]] bool practises() const { return practises_; }
  /// A number that changes with what is kept of it beside the session's answers: hints, and what was built.
  [[nodiscard]] std::uint64_t changes() const { return changes_; }
  /// Whether there is a harder level, and what was earned leads there: four fifths of the marks.
  [[nodiscard]] bool leads_on(const Session& session) const;
  /// Whether each decision is told at once.
  [[nodiscard]] bool tells_at_once() const { return practises_ || exercise_->told_at_once; }

  /// The number of the open decision, counted from 0, while another's outcome is shown, that of this; as many as there
  /// are at the end.
  [[nodiscard]] std::size_t at(const Session& session) const;
  /// Whether all is decided, and stays so while a decision is looked at again.
  [[nodiscard]] bool finished(const Session& session) const;
  /// All decisions, in order.
  [[nodiscard]] std::vector<Marked> marked(const Session& session) const;
  /// The mark so far, in quarters, of one for each decision; where nothing is told before the end, it is not to be
  /// shown before.
  [[nodiscard]] double mark(const Session& session) const;
  [[nodiscard]] int of() const { return exercise_->build ? exercise_->build->levels : static_cast<int>(hints_.size()); }

  // What is built has one mark for each level, and the best stage counts.
  /// The best stage so far, once the hand rests; and the level that it reaches.
  void see(const Session& session);
  [[nodiscard]] const std::optional<Built>& best() const { return best_; }
  /// Whether more may change on the stage than where some handles are.
  [[nodiscard]] bool adds() const { return exercise_->build && exercise_->stage.tasks.front().only.empty(); }
  /// Puts the best stage back. Returns false if there is none, or if it stands there.
  bool back_to_best(Session& session) const;
  /// The student is done with it. Returns false if nothing was reached, or if it is over already.
  bool finish();
  /// At the end: puts a solution on the stage.
  bool show_model(Session& session) const;

  /// Takes the next hint for the open decision. Returns false if there is none.
  bool take_hint(const Session& session);
  /// The hints taken for it, in words.
  [[nodiscard]] std::vector<std::string> hints(const Session& session) const;
  [[nodiscard]] bool has_hint(const Session& session) const;
  /// "Hint (costs 0.25)"; empty for none left.
  [[nodiscard]] std::string hint_words(const Session& session) const;
  /// What the next one costs, a share of the decision's mark; 0 for none left, and where one practises.
  [[nodiscard]] double next_price(const Session& session) const;

  /// What is said of the wrong rule that the last answer follows; empty if it follows none, or is right. Of several
  /// rules it is the one that explains most of what was decided before.
  [[nodiscard]] std::string rule_says(const Session& session) const;
  /// At the end: the wrong rules that explain each decision in which they differ from what is right, if there are at
  /// least two of these.
  [[nodiscard]] std::vector<std::string> rules_followed(const Session& session) const;

  // When it is over, the student's run and the right one stand on one timeline. A mistake is followed by the right
  // step, so they differ in single decisions: the student's are shown one by one, each with what was right beside it.
  /// Which run is looked at; none before the end, and at the end of the timeline.
  enum class Looked { kNeither, kOwn, kRight };
  [[nodiscard]] Looked looks_at(const Session& session) const;
  /// From the right run to the student's, at the next decision, and back; from the end to where they first differ.
  bool change_run(Session& session) const;
  /// In the student's run, goes to the next decision, or with by = -1 to the one before. Returns false if there is
  /// none.
  bool step_own(Session& session, int by) const;
  /// In the right run, what was decided here, and what is right.
  [[nodiscard]] std::string compared(const Session& session) const;
  /// At the end, where both first differ; empty if they do not.
  [[nodiscard]] std::string first_difference(const Session& session) const;

  [[nodiscard]] Attempt attempt(const Session& session) const;
  /// Makes the decisions of an attempt, as far as they can be made. Errors: it has more than there are, or one that is
  /// no answer to what is asked.
  tl::expected<void, InputError> take_up(Session& session, const Attempt& attempt);

 private:
  tl::expected<void, InputError> take_up_built(Session& session, const Attempt& attempt);
  [[nodiscard]] bool show(Session& session, std::size_t decision) const;
  [[nodiscard]] const std::string* rule_of(const Session& session, const Asked& asked, const Answer& answer) const;

  std::shared_ptr<const Exercise> exercise_;
  std::uint64_t seed_;
  bool practises_;
  std::vector<int> hints_;  // taken for each decision
  std::optional<Built> best_;
  std::uint64_t seen_ = 0;  // the session's revision
  std::uint64_t changes_ = 0;
  bool over_ = false;  // whether the student is done with what was built
};

/// Whether every decision of an exercise is made, and stays so while one is looked at again; and then the first that is
/// not right, null for none.
[[nodiscard]] bool all_decided(const Session& session);
[[nodiscard]] const Asked* first_wrong(const Session& session);

inline constexpr std::string_view kRightRunWord = "The right run", kYourRunWord = "Your run",
                                  kBothRunsWord = "Go through your run", kNextDecisionWord = "Next decision";

/// The prices of the hints, shares of a decision's mark: of one, of two, of all.
inline constexpr std::array<double, kMostHints + 1> kHintPrices{0, 0.25, 0.5, 1};

struct Graded {
  double mark = 0;
  int of = 0;
  int decided = 0;
};
/// Replays every decision on the instance of its seed. Errors: those of make_instance and take_up.
[[nodiscard]] tl::expected<Graded, InputError> grade(std::shared_ptr<const Exercise> exercise, const Attempt& attempt);

/// An attempt that is right everywhere, but for one decision (counted from 1, 0 for none), which follows a wrong rule,
/// or without one is any wrong answer. Errors: those of make_instance; there is no such decision or rule, or the rule
/// is right there.
[[nodiscard]] tl::expected<Attempt, InputError> model_attempt(const Exercise& exercise, std::uint64_t seed, int wrong,
                                                              std::string_view rule);

}  // namespace snug::lesson
