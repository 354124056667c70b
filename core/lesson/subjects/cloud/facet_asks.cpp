#include "lesson/subjects/cloud/facet_asks.hpp"

#include <algorithm>

#include "geometry/kdop.hpp"
#include "geometry/tolerance.hpp"
#include "io/text.hpp"
#include "lesson/decide.hpp"
#include "lesson/subjects/cloud/calipers_turn.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/subjects/cloud/hull_growth.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;

constexpr std::size_t kMostFacets = 10;  // more choices are not read

/// "P3 to P8"
std::string edge_name(const Asked& asked, const std::vector<Index>& ends) {
  return asked.subject->name_of(ends[0]) + " to " + asked.subject->name_of(ends[1]);
}

/// The edges that a rectangle may lie on: in space those that the calipers stood on just before.
std::vector<std::vector<Index>> edges_of(const Asked& asked, const Run& run) {
  const FitTrace trace = fit_run(run).trace();
  std::vector<std::vector<Index>> edges;
  for (const CalipersTurned<double, 3>* turned : calipers_turn(trace, asked.fact))
    edges.push_back({turned->touching.begin(), turned->touching.begin() + 2});
  if (asked.dim == 3) return edges;
  const HullFound* hull = nullptr;
  for (int i = asked.fact; hull == nullptr && i-- > 0;) hull = std::get_if<HullFound>(&trace[i].step.fact);
  for (std::size_t i = 0; hull != nullptr && i < hull->vertices.size(); ++i)
    edges.push_back({hull->vertices[i], hull->vertices[(i + 1) % hull->vertices.size()]});
  return edges;
}

}  // namespace

const char* offer_faces(Asked& asked, const Run& run) {
  const auto hull = growing_hull(fit_run(run).trace(), asked.fact);
  asked.many = true;
  for (const GrowingFacet& facet : hull->facets)
    if (facet.alive()) asked.add_choice(asked.names(facet.vertices), facet.vertices);
  return asked.choices.size() > kMostFacets ? "the hull has more than 10 facets at this step" : nullptr;
}

Truth faces_truth(const Asked& asked, const Run& run) {
  const auto& fact = fact_of<HorizonFound>(asked, run);
  const auto hull = growing_hull(fit_run(run).trace(), asked.fact);
  Truth truth;
  int choice = 0;
  for (std::size_t f = 0; f < hull->facets.size(); ++f) {
    if (!hull->facets[f].alive()) continue;
    if (std::find(fact.facets.begin(), fact.facets.end(), static_cast<Index>(f)) != fact.facets.end())
      truth.choices.push_back(choice);
    ++choice;
  }
  for (const int right : truth.choices) truth.happened += (truth.happened.empty() ? "" : "; ") + asked.choices[right];
  truth.sentence = asked.subject->name_of(fact.eye) + " sees " + io::counted(std::ssize(truth.choices), "facet") +
                   ": " + truth.happened + ".";
  return truth;
}

const char* offer_hull_edges(Asked& asked, const Run& run) {
  const auto edges = edges_of(asked, run);
  if (edges.empty() || fact_of<RectangleFound<double, 3>>(asked, run).edge_a == kNoIndex)
    return asked.dim == 2 ? "\"edge\" can only be asked of a rectangle on the points' hull"
                          : "in space \"edge\" can only be asked of a rectangle for which calipers turned step by step";
  if (edges.size() > kMostFacets) return "the hull has more than 10 edges";
  for (const std::vector<Index>& ends : edges) asked.add_choice(edge_name(asked, ends), ends);
  return nullptr;
}

/// In space, edges whose rectangles differ by rounding alone are equal.
Truth hull_edge_truth(const Asked& asked, const Run& run) {
  const auto& fact = fact_of<RectangleFound<double, 3>>(asked, run);
  const auto turn = calipers_turn(fit_run(run).trace(), asked.fact);
  const double least = turn.empty() ? fact.measure : turn.back()->least;
  const auto has = [](const std::vector<Index>& ends, Index i) {
    return std::find(ends.begin(), ends.end(), i) != ends.end();
  };
  Truth truth;
  for (std::size_t i = 0; i < asked.choices.size(); ++i) {
    const bool found = has(asked.choice_handles[i], fact.edge_a) && has(asked.choice_handles[i], fact.edge_b);
    const bool equal = i < turn.size() && turn[i]->area <= least * (1 + tolerance::kBoxProof);
    if (found || equal) truth.choices.push_back(static_cast<int>(i));
  }
  truth.points = {fact.edge_a, fact.edge_b};
  truth.happened = edge_name(asked, truth.points);
  truth.sentence =
      "The smallest rectangle lies on the edge from " + truth.happened + ", with area " + number_text(least) + ".";
  return truth;
}

Truth smaller_truth(const Asked& asked, const Run& run) {
  const auto turn = calipers_turn(fit_run(run).trace(), asked.fact + 1);
  const double area = turn.back()->area;
  if (turn.size() == 1) return yes("It is the first on this projection, with area " + number_text(area) + ".");
  const std::string before = number_text(turn[turn.size() - 2]->least), now = number_text(area);
  if (turn.back()->better) return yes("Its area is " + now + ", and the smallest before it had " + before + ".");
  return no("Its area is " + now + ", and the smallest before it has " + before + ".");
}

const char* offer_narrowest(Asked& asked, const Run& run) {
  const Step3& step = fit_run(run).trace()[asked.fact].step;
  const auto* kdop = std::get_if<Kdop<double, 3>>(&step.volume);
  if (kdop == nullptr) return "\"slab\" can only be asked of a k-DOP";
  for (int i = 0; i < kdop->k / 2; ++i) asked.add_choice(fit_run(run).slab_name(asked.fact, i));
  return nullptr;
}

/// Slabs whose widths differ by rounding alone are equal.
Truth narrowest_truth(const Asked& asked, const Run& run) {
  const Step3& step = fit_run(run).trace()[asked.fact].step;
  const auto& kdop = *std::get_if<Kdop<double, 3>>(&step.volume);
  std::vector<double> widths;
  for (int i = 0; i < kdop.k / 2; ++i)
    widths.push_back((kdop.max[i] - kdop.min[i]) / fit_run(run).slab_axis(asked.fact, i).norm());
  const double least = *std::min_element(widths.begin(), widths.end());
  Truth truth;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (widths[i] <= least * (1 + tolerance::kBoxProof)) truth.choices.push_back(static_cast<int>(i));
  }
  truth.happened = choice_words(asked, truth.choices);
  truth.sentence = "The narrowest slab is " + number_text(least) + " wide, along " + truth.happened + ".";
  return truth;
}

}  // namespace snug::lesson
