#include "lesson/patience.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

/// So many points are shown at once, whatever the lesson does with them.
constexpr Index kFewPoints = 250;
/// How much longer a lesson takes than its pieces: questions and prose look at some results again, and the stage draws
/// them. Measured on the lessons about boxes and hulls, 5,000 to 20,000 points on a sphere.
constexpr double kBesideRuns = 1.5;
/// A time below this says little about how the next one grows, ns.
constexpr double kTellingTime = 5e6;
/// How often the figures of a step are worked out before a frame has shown it.
constexpr double kFiguresTold = 4;
/// The share of the whole time that the estimate takes, about.
constexpr double kEstimate = 0.15;
/// The most and the fewest points that an estimate begins with. It ends at one kLastPart-th of all points.
constexpr Index kFirst = 250, kFewest = 16, kLastPart = 8;

/// A copy with so many of all of its points, evenly taken; null if it cannot have them.
std::unique_ptr<Subject> sample_of(const Subject& subject, const std::vector<Point3>& all, Index count) {
  io::PointFile some{subject.dim(), {}, {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) some.points.push_back(all[i * all.size() / count]);
  auto sample = subject.clone();
  return sample->with_points()->load(some, "sample") ? std::move(sample) : nullptr;
}

/// Rounded down to one digit, so that it is a number to try. A fast method's count may be more than an Index holds.
Index round_number(double n) {
  n = std::clamp(n, 0.0, static_cast<double>(std::numeric_limits<Index>::max()));
  const double power = std::pow(10, std::floor(std::log10(std::max(n, 1.0))));
  return static_cast<Index>(std::floor(n / power) * power);
}

}  // namespace

// A piece longer than kLongestPiece is still computed if it takes no longer than a door's `held`: the page says what it
// is doing meanwhile, and a busy machine makes estimates too high.
Patience& patience() {
  static Patience of_door;
  return of_door;
}

std::string long_time(double ns) {
  const double seconds = ns / 1e9;
  const auto said = [](double value, const char* unit) { return number_text(value, 2) + unit; };
  return seconds < 100    ? said(seconds, " s")
         : seconds < 6000 ? said(seconds / 60, " min")
                          : said(seconds / 3600, " hours");
}

void GrowingTime::add(Index some, double time) {
  if (static_cast<double>(some) == some_[2]) return static_cast<void>(time_[2] = std::clamp(time, 1.0, time_[2]));
  some_ = {some_[1], some_[2], static_cast<double>(some)};
  time_ = {time_[1], time_[2], std::max(time, 1.0)};
}

bool GrowingTime::tells() const { return some_[0] > 0 && time_[2] > kTellingTime; }

/// Over two doublings, noise counts half.
double GrowingTime::power() const {
  if (some_[0] == 0) return 1;
  return std::clamp(std::log(time_[2] / time_[0]) / std::log(some_[2] / some_[0]), 1.0, 4.0);
}

double GrowingTime::on(Index n) const {
  return some_[2] == 0 ? 0 : time_[2] * std::pow(static_cast<double>(n) / some_[2], power());
}

Index GrowingTime::most_in(double longest) const {
  return round_number(some_[2] * std::pow(longest / time_[2], 1 / power()));
}

bool Preparation::may_take_long(const Subject& subject) {
  return subject.points() != nullptr && count_of(subject) > kFewPoints;
}

Preparation::Preparation(const Lesson& lesson, Snapshot next, const Methods& methods, bool estimates, Clock clock)
    : next(std::move(next)), lesson_(lesson), methods_(methods), clock_(clock) {
  using Kind = Piece::Kind;
  for (int slot = 0; slot < 2; ++slot)
    if (methods_[slot] != nullptr) pieces_.push_back({Kind::kRun, methods_[slot], slot});
  pieces_.push_back({Kind::kReference});
  for (const std::string& name : lesson_.algorithms) {
    const Method* method = find_method(lesson_, name);
    if (!this->next.subject->suits(*method)) continue;
    pieces_.push_back({Kind::kRival, method});
    const bool told = std::any_of(lesson_.figures.begin(), lesson_.figures.end(), [&](const RunFigure& figure) {
      return !figure.algorithm.empty() && find_method(lesson_, figure.algorithm) == method;
    });
    pieces_.push_back({.kind = Kind::kResult, .method = method, .wanted = told});
  }
  pieces_.push_back({Kind::kTold});
  const Index n = count_of(*this->next.subject);
  if (!estimates || is_lessons_own() || clock_ == nullptr || !may_take_long(*this->next.subject)) return;
  all_ = all_points(*this->next.subject->points());
  some_ = std::clamp(n / 32, kFewest, kFirst);
}

View Preparation::view_of(const Work& work) const {
  View view;
  for (std::size_t i = 0; i < methods_.size(); ++i) view.slots[i] = Slot{methods_[i], work.runs[i].get()};
  view.step = view.run().steps();
  return view;
}

void Preparation::compute(const Piece& piece, const Subject& subject, Work& into) const {
  using Kind = Piece::Kind;
  if (piece.kind == Kind::kRun) return static_cast<void>(into.runs[piece.slot] = subject.run(*piece.method, nullptr));
  View view = view_of(into);
  if (piece.kind == Kind::kResult)
    return static_cast<void>(into.results[piece.method] = subject.figures_at_end(*piece.method, view));
  if (piece.kind == Kind::kTold) {
    static_cast<void>(subject.figures(view));
    return static_cast<void>(subject.proofs(view));
  }
  // A rival is measured alone. Without a method, the subject computes what all of them are compared with.
  Lesson alone = lesson_;
  alone.algorithms.clear();
  if (piece.kind == Kind::kRival) alone.algorithms = {name_in(lesson_, *piece.method)};
  for (Rival& rival : subject.rivals(alone, view)) into.rivals.push_back(std::move(rival));
}

/// The time of all pieces on n points, ns.
double Preparation::whole(Index n) const {
  double all = 0;
  for (const Piece& piece : pieces_) all += piece.wanted ? piece.growth.on(n) : 0;
  return kBesideRuns * all;
}

/// What the lesson itself offers is shown, however long it takes: on a busy machine an estimate may be far too high,
/// and a run that stops at a limit of its own takes less than its growth foretells.
bool Preparation::is_lessons_own() const {
  const Subject::Origin& origin = next.subject->origin();
  return is_among(mesh_names(), origin.source) || (origin.source == "own" && !origin.edited);
}

void Preparation::refuse(double time, Index most, const Piece* piece) {
  const std::string points = count_text(count_of(*next.subject)) + " such points",
                    up_to = "up to about " + count_text(most);
  const std::string what =
      piece == nullptr
          ? "this lesson would take about " + long_time(time) + " for " + points + "; " + up_to + " take less than " +
                long_time(patience().shown) + " here"
          : (piece->method != nullptr ? title_in(lesson_, *piece->method) + " alone" : std::string("this lesson")) +
                " would take about " + long_time(time) + " for " + points + ", and could not be stopped; " + up_to +
                " can be shown here";
  refused_ = InputError{.what = what + std::string(patience().instead)};
}

/// Whether the estimate goes on, is over, or refuses.
void Preparation::judge() {
  const Index n = count_of(*next.subject);
  const auto times = [](const Piece& piece) { return piece.kind == Piece::Kind::kTold ? kFiguresTold : 1; };
  const auto takes = [&](const Piece& piece) { return times(piece) * piece.growth.on(n); };
  const Piece& longest = *std::max_element(pieces_.begin(), pieces_.end(),
                                           [&](const Piece& a, const Piece& b) { return takes(a) < takes(b); });
  const bool holds = takes(longest) > patience().held, tells = longest.growth.tells();
  const Index most = std::min(n, longest.growth.most_in(patience().held / times(longest)));
  const double all = whole(n);
  const double longest_shown = patience().shown;
  const bool refuses = tells && (holds || all > longest_shown);
  if (refuses && !std::exchange(measured_again_, true)) return;
  if (all > longest_shown && tells) {
    // Each piece grows by its own law: the number that they all keep to is found by halving.
    Index few = 1, many = n;
    while (many > few + few / 16 + 1) {
      const Index middle = few + (many - few) / 2;
      (whole(middle) > longest_shown ? many : few) = middle;
    }
    return refuse(all, round_number(static_cast<double>(holds ? std::min(few, most) : few)), nullptr);
  }
  if (holds && tells) return refuse(takes(longest), most, &longest);
  const bool doubtful = holds || all > longest_shown;
  if (some_ >= n / (doubtful ? 2 : kLastPart)) return static_cast<void>((some_ = 0, all_.clear()));
  some_ = std::min(2 * some_, n), measured_again_ = false;
}

/// The next piece of the estimate.
void Preparation::estimate() {
  if (at_ == 0) {
    of_sample_ = {};
    sample_ = sample_of(*next.subject, all_, some_);
    if (sample_ == nullptr) return static_cast<void>((some_ = 0, all_.clear()));  // such a subject cannot be sampled
  }
  Piece& piece = pieces_[at_];
  const double begin = clock_();
  compute(piece, *sample_, of_sample_);
  piece.growth.add(some_, clock_() - begin);
  if (++at_ < pieces_.size()) return;
  at_ = 0;
  judge();
  if (some_ == 0) of_sample_ = {}, sample_.reset();
}

void Preparation::go_on() {
  if (done()) return;
  if (some_ > 0) estimate();
  else compute_next();
  share_ = std::max(share_, part_done());  // an estimate that goes on takes nothing back
}

void Preparation::compute_next() {
  compute(pieces_[at_], *next.subject, work);
  do ++at_;
  while (at_ < pieces_.size() && !pieces_[at_].wanted);
}

double Preparation::next_takes() const {
  if (done()) return 0;
  return pieces_[at_].growth.on(some_ > 0 ? some_ : count_of(*next.subject));
}

double Preparation::left() const {
  if (done() || some_ > 0) return 0;
  double all = 0;
  for (std::size_t i = at_; i < pieces_.size(); ++i)
    if (pieces_[i].wanted) all += pieces_[i].growth.on(count_of(*next.subject));
  return all;
}

double Preparation::part_done() const {
  if (done()) return 1;
  const auto n = static_cast<double>(count_of(*next.subject));
  const double pieces = static_cast<double>(pieces_.size()), at = static_cast<double>(at_);
  if (some_ > 0) return kEstimate * std::min(1.0, kLastPart * static_cast<double>(some_) / n) * (1 + at / pieces) / 2;
  double all = 0, done = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const double takes = pieces_[i].wanted ? std::max(pieces_[i].growth.on(static_cast<Index>(n)), 1.0) : 0;
    all += takes, done += i < at_ ? takes : 0;
  }
  return kEstimate + (1 - kEstimate) * done / all;
}

std::string Preparation::says() const {
  const std::string words = "Working on " + count_text(count_of(*next.subject)) + " points";
  if (some_ > 0) return words + ": how long it takes";
  const Method* method = done() ? nullptr : pieces_[at_].method;
  return method != nullptr ? words + ": " + title_in(lesson_, *method) : words;
}

}  // namespace snug::lesson
