// What an exercise asks of a climb over a hull, and of the AABBs of several updates.
#include <algorithm>
#include <limits>
#include <numeric>

#include "geometry/random.hpp"
#include "geometry/tolerance.hpp"
#include "lesson/decide.hpp"
#include "lesson/names.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/update/entries.hpp"
#include "lesson/subjects/update/update.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

const fit::NeighborsCompared& compared_of(const Asked& asked, const Run& run) {
  return *std::get_if<fit::NeighborsCompared>(&update_run(run).trace()[asked.fact].step.fact);
}

/// How far the vertex and its neighbours reach towards the side that is climbed.
Scores reaches(const Asked& asked, const Run& run) {
  const fit::NeighborsCompared& fact = compared_of(asked, run);
  const Point3 towards = update_run(run).axis(fact.axis) * (fact.greatest ? 1 : -1);
  Scores scores;
  const auto add = [&](Index i) { scores.add(static_cast<int>(i), update_run(run).placed(i).dot(towards)); };
  add(fact.vertex);
  for (const Index i : fact.neighbors) add(i);
  return scores;
}

}  // namespace

const char* offer_climb(Asked& asked, const Run& run) {
  const UpdateWhere where{update_run(run), asked.fact, nullptr};
  const fit::NeighborsCompared& fact = compared_of(asked, run);
  asked.of = where.side(fact.axis, fact.greatest) + ", now at " + where.name(fact.vertex);
  asked.on_stage = true;
  asked.stage_points = fact.neighbors;
  asked.stage_points.push_back(fact.vertex);
  return nullptr;
}

Truth climb_truth(const Asked& asked, const Run& run) {
  const fit::NeighborsCompared& fact = compared_of(asked, run);
  Truth truth{{}, {fact.best}, asked.subject->name_of(fact.best), {}};
  truth.sentence = extreme_truth(asked, run).sentence;
  return truth;
}

double climb_margin(const Asked& asked, const Run& run) {
  return reaches(asked, run).lead() / extent_of(*asked.subject);
}

/// The first neighbour that reaches farther, where the best of all is climbed to.
std::optional<Answer> first_higher(const Asked& asked, const Run& run) {
  const Scores scores = reaches(asked, run);
  for (std::size_t i = 1; i < scores.of.size(); ++i)
    if (scores.values[i] > scores.values[0]) return by_handle(scores.of[i]);
  return std::nullopt;
}

/// One step too many: from the extreme to its best neighbour.
std::optional<Answer> always_on(const Asked& asked, const Run& run) {
  Scores scores = reaches(asked, run);
  scores.of.erase(scores.of.begin()), scores.values.erase(scores.values.begin());
  return by_handle(scores.greatest());
}

// ---- which update gives which AABB --------------------------------------------------------------------------

namespace {

/// The widths of a method's AABB.
Point3 widths_of(const Asked& asked, const Method& method) {
  const Aabb<double, 3> box = body_of(*asked.subject).box_of(method);
  return box.max - box.min;
}

bool are_equal(const Point3& a, const Point3& b) {
  return (a - b).cwiseAbs().maxCoeff() <= tolerance::kBoxProof * a.cwiseAbs().maxCoeff();
}

/// The widths of the AABBs of all the lesson's updates, each once, shuffled alike for all questions about them.
std::vector<Point3> boxes_of(const Asked& asked) {
  std::vector<Point3> all;
  for (const std::string& name : asked.lesson->algorithms) {
    const Point3 widths = widths_of(asked, *find_method(*asked.lesson, name));
    if (std::none_of(all.begin(), all.end(), [&](const Point3& other) { return are_equal(other, widths); }))
      all.push_back(widths);
  }
  Random random(asked.question->shuffled);
  for (std::size_t left = all.size(); left > 1; --left)
    std::swap(all[left - 1], all[random.below(static_cast<std::uint32_t>(left))]);
  return all;
}

/// "4.83 wide, 2.11 high"
std::string widths_text(const Asked& asked, const Point3& widths) {
  const std::string text = number_text(widths[0]) + " wide, " + number_text(widths[1]) + " high";
  return asked.dim == 2 ? text : text + ", " + number_text(widths[2]) + " deep";
}

/// The area, or the volume.
double measure_of(const Asked& asked, const Point3& widths) { return widths.head(asked.dim).prod(); }

Answer by_measure(const Asked& asked, auto before) {
  const std::vector<Point3> boxes = boxes_of(asked);
  const auto found = std::min_element(boxes.begin(), boxes.end(), [&](const Point3& a, const Point3& b) {
    return before(measure_of(asked, a), measure_of(asked, b));
  });
  return by_choice(static_cast<int>(found - boxes.begin()));
}

}  // namespace

const char* offer_boxes(Asked& asked, const Run&) {
  for (const std::string_view name : kToldApart)
    if (!is_among(asked.lesson->algorithms, name)) return "it needs all four updates among the algorithms";
  for (const Point3& widths : boxes_of(asked)) asked.add_choice(widths_text(asked, widths));
  return nullptr;
}

template <std::size_t kUpdate>
Truth box_truth(const Asked& asked, const Run&) {
  const Method& method = *find_method(*asked.lesson, kToldApart[kUpdate]);
  const std::vector<Point3> boxes = boxes_of(asked);
  const Point3 own = widths_of(asked, method);
  const auto found = std::find_if(boxes.begin(), boxes.end(), [&](const Point3& one) { return are_equal(one, own); });
  const int choice = static_cast<int>(found - boxes.begin());
  return {{choice}, {}, asked.choices[choice], title_in(*asked.lesson, method) + ": " + asked.choices[choice] + "."};
}

template <std::size_t kUpdate>
double box_margin(const Asked& asked, const Run&) {
  const Point3 own = widths_of(asked, *find_method(*asked.lesson, kToldApart[kUpdate]));
  double least = std::numeric_limits<double>::infinity();
  for (const Point3& other : boxes_of(asked))
    if (!are_equal(other, own)) least = std::min(least, (other - own).cwiseAbs().maxCoeff());
  return least / extent_of(*asked.subject);
}

template Truth box_truth<0>(const Asked&, const Run&);
template Truth box_truth<1>(const Asked&, const Run&);
template Truth box_truth<2>(const Asked&, const Run&);
template Truth box_truth<3>(const Asked&, const Run&);
template double box_margin<0>(const Asked&, const Run&);
template double box_margin<1>(const Asked&, const Run&);
template double box_margin<2>(const Asked&, const Run&);
template double box_margin<3>(const Asked&, const Run&);

std::optional<Answer> tightest_box(const Asked& asked, const Run&) { return by_measure(asked, std::less<>()); }
std::optional<Answer> loosest_box(const Asked& asked, const Run&) { return by_measure(asked, std::greater<>()); }

}  // namespace snug::lesson
