// What a lesson has to compute for new points is estimated before it is begun, and then goes in pieces: nobody waits
// for a page that answers nothing.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/sliders.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// How long a lesson may take to show new points, and how long a piece of that should take, during which nothing
/// answers, ns. Half a second is promised, because a piece may take somewhat longer than estimated.
inline constexpr double kLongestShown = 10e9, kLongestPiece = 0.4e9;

/// How long a door waits for new points, ns: for all of them, and for one piece, which cannot be stopped. instead: what
/// can be done with points that would take longer; empty for nothing.
struct Patience {
  double shown = kLongestShown, held = 2e9;
  std::string_view instead = {};
};
/// The one of this program: a page's, unless its door has set its own before anything was opened.
[[nodiscard]] Patience& patience();

/// "34 s", "12 min", "3 hours"
[[nodiscard]] std::string long_time(double ns);

/// The time of a computation on more and more of its points, each time about twice as many. Of the same points measured
/// again, the shorter time counts.
class GrowingTime {
 public:
  void add(Index some, double time);
  /// Whether it follows from three times, of which the last is no noise.
  [[nodiscard]] bool tells() const;
  /// The time on n points, ns; and about how many points take `longest`.
  [[nodiscard]] double on(Index n) const;
  [[nodiscard]] Index most_in(double longest) const;

 private:
  [[nodiscard]] double power() const;
  std::array<double, 3> some_{}, time_{};  // the last three; 0 for none
};

/// New points on their way to the stage, with all that the lesson computes of them.
class Preparation {
 public:
  using Methods = std::array<const Method*, 2>;

  /// methods: those of the slots; null for none. estimates: whether it is estimated first, and refused if it would take
  /// too long. clock: null for none; then nothing is estimated.
  Preparation(const Lesson& lesson, Snapshot next, const Methods& methods, bool estimates, Clock clock);

  /// Whether a subject has so many points that it may take long.
  [[nodiscard]] static bool may_take_long(const Subject& subject);

  /// Computes the next piece.
  void go_on();
  [[nodiscard]] bool done() const { return refused_ || at_ == pieces_.size(); }
  /// How long the next piece will take, ns; 0 if that is not known.
  [[nodiscard]] double next_takes() const;
  /// How long all that is left will take, ns; 0 while that is being estimated, or if it is not known.
  [[nodiscard]] double left() const;
  /// How much of it is done: 0 to 1, by the time.
  [[nodiscard]] double share() const { return share_; }
  /// What is being done: "Working on 9,000 points: Quickhull".
  [[nodiscard]] std::string says() const;
  /// Why it is refused, with how many points can be shown; none if it is not.
  [[nodiscard]] const std::optional<InputError>& refused() const { return refused_; }

  /// What a lesson shows of some points.
  struct Work {
    std::array<std::unique_ptr<Run>, 2> runs;
    std::vector<Rival> rivals;
    std::map<const Method*, std::vector<Figure>> results;
  };

  // What is there once it is done. A run refers to its subject, which is next's.
  Snapshot next;
  Work work;
  [[nodiscard]] const Method* method(int slot) const { return methods_[slot]; }

 private:
  struct Piece {
    enum class Kind { kRun, kReference, kRival, kResult, kTold } kind;
    const Method* method = nullptr;
    int slot = 0;
    bool wanted = true;  // at once: the others come when somebody looks at them, one at a time
    GrowingTime growth;
  };
  void compute(const Piece& piece, const Subject& subject, Work& into) const;
  [[nodiscard]] View view_of(const Work& work) const;
  void compute_next();
  [[nodiscard]] double part_done() const;
  void estimate();
  void judge();
  [[nodiscard]] double whole(Index n) const;
  [[nodiscard]] bool is_lessons_own() const;
  void refuse(double time, Index most, const Piece* piece);

  const Lesson& lesson_;
  Methods methods_;
  Clock clock_;
  std::vector<Piece> pieces_;
  std::size_t at_ = 0;  // the next piece: of the estimate, and then of all
  std::vector<Point3> all_;
  Index some_ = 0;               // how many the estimate is at; 0: it is over
  bool measured_again_ = false;  // before it refuses: a slow moment of the machine is no reason to
  std::unique_ptr<Subject> sample_;
  Work of_sample_;
  double share_ = 0;
  std::optional<InputError> refused_;
};

}  // namespace snug::lesson
