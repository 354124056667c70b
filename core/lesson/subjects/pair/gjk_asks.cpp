// What can be asked about GJK, and about what a test costs beside it.
#include "lesson/decide.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/difference.hpp"
#include "lesson/subjects/pair/entries.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostVertices = 9;  // as many choices as have a digit
constexpr double kAsFar = 1e-9;           // of the difference's size: farther by less than this is rounding

const VolumePair& pair_of(const Asked& asked) { return as<VolumesSubject>(*asked.subject)->pair(); }

/// The name of the pair's own test; empty where it has none but GJK.
std::string_view own_test(const VolumePair& pair) {
  const query::PairTest test = test_of(pair);
  return test == query::PairTest::kGjk ? "" : query::kPairTestNames[static_cast<std::size_t>(test)];
}

}  // namespace

const char* offer_difference(Asked& asked, const Run& run) {
  const auto outline = difference_outline(pair_of(asked));
  if (outline.size() < 3 || outline.size() > kMostVertices)
    return "\"next_vertex\" can only be asked in the plane, where A − B has from 3 to 9 vertices";
  const PairWhere where{pair_run(run), asked.fact, nullptr};
  for (const DifferenceVertex& vertex : outline)
    asked.add_choice(difference_name(vertex.a, vertex.b, where),
                     handles_of_vertices(std::array{vertex.a, vertex.b}, where));
  return nullptr;
}

namespace {

/// The point of the simplex that is nearest to the origin, before a step.
Point3 nearest_before(const Asked& asked, const Run& run) {
  Point3 v = Point3::Zero();
  for (int i = 0; i < asked.fact; ++i)
    if (const auto* nearest = std::get_if<query::NearestFound>(&pair_run(run).trace()[i].step.fact))
      v = nearest_of(difference_points(pair_of(asked), nearest->corners));
  return v;
}

/// The vertices of A − B by a value.
template <class Value>
Scores scores_of_vertices(const Asked& asked, Value value) {
  Scores scores;
  int choice = 0;
  for (const DifferenceVertex& vertex : difference_outline(pair_of(asked))) scores.add(choice++, value(vertex.at));
  return scores;
}

}  // namespace

double next_vertex_margin(const Asked& asked, const Run& run) {
  const Point3 v = nearest_before(asked, run).normalized();
  return scores_of_vertices(asked, [&](const Point3& at) { return -v.dot(at); }).lead() / extent_of(*asked.subject);
}
std::optional<Answer> vertex_along_v(const Asked& asked, const Run& run) {
  const Point3 v = nearest_before(asked, run);
  return by_choice(scores_of_vertices(asked, [&](const Point3& at) { return v.dot(at); }).greatest());
}
std::optional<Answer> vertex_nearest_origin(const Asked& asked, const Run&) {
  return by_choice(scores_of_vertices(asked, [](const Point3& at) { return at.norm(); }).least());
}

/// Every vertex as far along -v is a right answer.
Truth next_vertex_truth(const Asked& asked, const Run& run) {
  const Point3 v = nearest_before(asked, run);
  const auto outline = difference_outline(pair_of(asked));
  double farthest = -std::numeric_limits<double>::infinity(), size = 0;
  for (const DifferenceVertex& vertex : outline)
    farthest = std::max(farthest, -v.dot(vertex.at)), size = std::max(size, vertex.at.norm());
  Truth truth;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (-v.dot(outline[i].at) < farthest - kAsFar * size * v.norm()) continue;
    truth.choices.push_back(static_cast<int>(i));
  }
  truth.happened = choice_words(asked, truth.choices);
  truth.sentence = truth.happened + (truth.choices.size() == 1 ? " lies" : " lie") +
                   " farthest along −v: no other vertex of A − B reaches as far in that direction.";
  return truth;
}

Truth contains_origin_truth(const Asked& asked, const Run& run) {
  const PairSteps steps = pair_run(run).trace();
  if (contains_origin(steps, asked.fact)) return yes("The origin lies in the simplex: v is zero.");
  const auto& nearest = *std::get_if<query::NearestFound>(&steps[asked.fact].step.fact);
  return no("The origin lies outside: the simplex comes no nearer to it than " + number_text(nearest.distance) + ".");
}

// ---- the part of the simplex that is kept -------------------------------------------------------------------

namespace {

/// The vertices of A and B, in pairs: those that were kept last, and those found since.
std::vector<Index> simplex_before(const Asked& asked, const Run& run) {
  std::vector<Index> corners;
  for (int i = 0; i < asked.fact; ++i) {
    const auto& fact = pair_run(run).trace()[i].step.fact;
    if (const auto* nearest = std::get_if<query::NearestFound>(&fact)) corners = nearest->corners;
    else if (const auto* support = std::get_if<query::SupportFound>(&fact)) {
      corners.push_back(support->a);
      corners.push_back(support->b);
    }
  }
  return corners;
}

/// Whether each vertex of the simplex is kept.
std::vector<bool> kept_of(const Asked& asked, const Run& run) {
  const std::vector<Index> before = simplex_before(asked, run);
  const auto& after = std::get_if<query::NearestFound>(&pair_run(run).trace()[asked.fact].step.fact)->corners;
  std::vector<bool> kept;
  for (std::size_t i = 0; i < before.size(); i += 2) {
    bool found = false;
    for (std::size_t k = 0; k < after.size(); k += 2) found |= after[k] == before[i] && after[k + 1] == before[i + 1];
    kept.push_back(found);
  }
  return kept;
}

}  // namespace

const char* offer_simplex(Asked& asked, const Run& run) {
  const std::vector<Index> corners = simplex_before(asked, run);
  if (asked.dim != 2 || corners.size() < 4) return "\"kept\" can only be asked in the plane, of several vertices";
  const PairWhere where{pair_run(run), asked.fact, nullptr};
  for (std::size_t i = 0; i < corners.size(); i += 2)
    asked.add_choice(difference_name(corners[i], corners[i + 1], where),
                     handles_of_vertices(std::array{corners[i], corners[i + 1]}, where));
  asked.many = true;
  return nullptr;
}

Truth kept_truth(const Asked& asked, const Run& run) {
  const std::vector<bool> kept = kept_of(asked, run);
  Truth truth;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (kept[i]) truth.choices.push_back(static_cast<int>(i));
  truth.happened = choice_words(asked, truth.choices);
  const bool all = truth.choices.size() == 3;
  truth.sentence = all                         ? "The triangle contains the origin: all three vertices are kept."
                   : truth.choices.size() == 1 ? "The vertex " + truth.happened + " is the nearest point itself."
                                               : "The nearest point lies on the edge of " + truth.happened + ".";
  return truth;
}

/// No vertex that is kept can be spared, and none that is dropped lies before the line through the nearest point.
double kept_margin(const Asked& asked, const Run& run) {
  const std::vector<Point3> simplex = difference_points(pair_of(asked), simplex_before(asked, run));
  const std::vector<bool> kept = kept_of(asked, run);
  std::vector<Point3> own;
  for (std::size_t i = 0; i < simplex.size(); ++i)
    if (kept[i]) own.push_back(simplex[i]);
  const Point3 v = nearest_of(own);
  const double distance = own.size() > 2 ? 0 : v.norm();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < own.size() && own.size() > 1; ++i) {
    std::vector<Point3> others = own;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    least = std::min(least, nearest_of(others).norm() - distance);
  }
  for (std::size_t i = 0; i < simplex.size() && distance > 0; ++i)
    if (!kept[i]) least = std::min(least, simplex[i].dot(v) / distance - distance);
  return least / extent_of(*asked.subject);
}

std::optional<Answer> keep_all(const Asked& asked, const Run&) { return by_every_choice(asked); }
std::optional<Answer> keep_newest(const Asked& asked, const Run&) {
  return SeveralChoices{{static_cast<int>(std::ssize(asked.choices)) - 1}};
}

const char* offer_own_and_gjk(Asked& asked, const Run&) {
  const std::string_view own = own_test(pair_of(asked));
  if (own.empty()) return "\"cheaper\" can only be asked of two volumes that have a test of their own besides GJK";
  asked.add_choice(std::string(find_method(volume_tests(), own)->title));
  asked.add_choice("GJK");
  return nullptr;
}

Truth cheaper_truth(const Asked& asked, const Run&) {
  const VolumePair& pair = pair_of(asked);
  const std::int64_t own = operations_in(record(own_test(pair), pair)), gjk = operations_in(record("gjk", pair));
  Truth truth;
  if (own <= gjk) truth.choices.push_back(0);
  if (gjk <= own) truth.choices.push_back(1);
  truth.happened = truth.choices.size() == 2 ? "both the same" : asked.choices[truth.choices[0]];
  truth.sentence = asked.choices[0] + " takes " + count_text(own) + (own == 1 ? " operation" : " operations") +
                   " on these volumes, GJK " + count_text(gjk) + ".";
  return truth;
}

}  // namespace snug::lesson
