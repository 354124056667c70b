// What can be asked about building a tree and going through one.
#include <set>

#include "fit/catalogue.hpp"
#include "geometry/sort.hpp"
#include "geometry/tolerance.hpp"
#include "lesson/decide.hpp"
#include "lesson/subjects/tree/entries.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostChoices = 4;

Truth axis_truth(int axis, const std::string& why) {
  const std::string letter = axis_letter(axis);
  return {{axis}, {}, letter, why + letter + "."};
}

/// Two groups of boxes, and how large the box around both is.
struct Pair {
  Index left, right;
  double size;
  std::string name;
};

std::string short_name(const Forest& forest, Index branch) {
  std::string name;
  for (const Index box : forest.at(branch).boxes) name += box_name(box);
  return name;
}

double half_perimeter(const Box2& a, const Box2& b) { return (a.max.cwiseMax(b.max) - a.min.cwiseMin(b.min)).sum(); }

/// The pairs of groups before a merger, the smallest first; equal ones by name.
std::vector<Pair> pairs_before(const Forest& forest) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < forest.roots.size(); ++i)
    for (std::size_t k = i + 1; k < forest.roots.size(); ++k) {
      const Index left = forest.roots[i], right = forest.roots[k];
      std::string a = short_name(forest, left), b = short_name(forest, right);
      if (b < a) std::swap(a, b);
      pairs.push_back({left, right, half_perimeter(forest.at(left).box, forest.at(right).box), a + " and " + b});
    }
  sort_stably(pairs,
              [](const Pair& a, const Pair& b) { return a.size < b.size || (a.size == b.size && a.name < b.name); });
  return pairs;
}

bool merges(const hierarchy::NodesMerged& fact, const Pair& pair) {
  return std::minmax(fact.left, fact.right) == std::minmax(pair.left, pair.right);
}

/// The pair that is merged, and the smallest of the others; in the order of their names.
std::vector<Pair> pairs_offered(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::NodesMerged>(asked, run);
  std::vector<Pair> pairs = pairs_before(tree_run(run).forest(asked.fact));
  std::stable_partition(pairs.begin(), pairs.end(), [&](const Pair& pair) { return merges(fact, pair); });
  pairs.resize(std::min(pairs.size(), kMostChoices));
  sort_stably(pairs, [](const Pair& a, const Pair& b) { return a.name < b.name; });
  return pairs;
}

/// The nodes beside which a box might be inserted: where it is, what is around, above and below there, and others.
std::vector<Index> places_offered(const Asked& asked, const Run& run) {
  const Forest& forest = tree_run(run).forest(asked.fact);
  const Index right = tree_fact<hierarchy::BodyInserted>(asked, run).beside;
  const Index parent = forest.parent_of(right);
  std::vector<Index> near{right};
  const auto add = [&](Index i) {
    if (i != kNoIndex && near.size() < kMostChoices && std::find(near.begin(), near.end(), i) == near.end())
      near.push_back(i);
  };
  add(parent);
  if (parent != kNoIndex)
    for (const Index child : forest.at(parent).children) add(child);
  for (const Index child : forest.at(right).children) add(child);
  for (const Index i : forest.there()) add(i);
  sort_stably(near, [&](Index a, Index b) { return short_name(forest, a) < short_name(forest, b); });
  return near;
}

}  // namespace

const char* offer_split_axes(Asked& asked, const Run& run) {
  const auto& fact = tree_run(run).trace()[asked.fact].step.fact;
  const auto* split = std::get_if<hierarchy::SplitChosen>(&fact);
  if (split != nullptr && split->axis == kNoIndex)
    return "\"split_axis\" cannot be asked where all centres are in one place";
  asked.of = tree_run(run).name_of(tree_run(run).forest(asked.fact), tree_run(run).branch_of(asked.fact));
  for (const int axis : {0, 1}) asked.add_choice(axis_letter(axis));
  return nullptr;
}
namespace {

/// The least cost of a split along an axis.
double cheapest_along(const hierarchy::SplitsPriced& fact, int axis) {
  double least = std::numeric_limits<double>::infinity();
  for (int border = 1; border <= fact.borders(); ++border) least = std::min(least, fact.cost_at(axis, border));
  return least;
}

}  // namespace

Truth priced_axis_truth(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::SplitsPriced>(asked, run);
  Truth truth = axis_truth(fact.axis, "The cheapest split is along ");
  const auto [x, y] = number_texts_apart(cheapest_along(fact, 0), cheapest_along(fact, 1));
  truth.sentence += " The cheapest border along x costs " + x + " tests, along y " + y + ".";
  return truth;
}
Truth split_axis_truth(const Asked& asked, const Run& run) {
  return axis_truth(tree_fact<hierarchy::SplitChosen>(asked, run).axis, "The node is split along ");
}

const char* offer_pairs(Asked& asked, const Run& run) {
  const Forest& forest = tree_run(run).forest(asked.fact);
  if (tree_run(run).is_by_hand()) return "\"pair\" cannot be asked of what is done by hand";
  if (forest.roots.size() < 3) return "\"pair\" cannot be asked of the last two groups";
  for (const Pair& pair : pairs_offered(asked, run)) {
    std::vector<Index> boxes = forest.at(pair.left).boxes;
    boxes.insert(boxes.end(), forest.at(pair.right).boxes.begin(), forest.at(pair.right).boxes.end());
    asked.add_choice(pair.name, std::move(boxes));
  }
  return nullptr;
}

/// A pair whose box is as large, to the last bit, is right as well.
Truth pair_truth(const Asked& asked, const Run& run) {
  const std::vector<Pair> pairs = pairs_offered(asked, run);
  const auto& fact = tree_fact<hierarchy::NodesMerged>(asked, run);
  const Pair& merged = *std::find_if(pairs.begin(), pairs.end(), [&](const Pair& pair) { return merges(fact, pair); });
  Truth truth{{},
              {},
              merged.name,
              "The box around " + merged.name + " has a half perimeter of " + number_text(fact.area) +
                  ", the least of all."};
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].size == merged.size) truth.choices.push_back(static_cast<int>(i));
  return truth;
}

const char* offer_places(Asked& asked, const Run& run) {
  const Forest& forest = tree_run(run).forest(asked.fact);
  if (forest.there().size() < 3) return "\"beside\" cannot be asked of the first two boxes";
  for (const Index i : places_offered(asked, run)) {
    const std::size_t there = forest.at(forest.roots.front()).boxes.size();
    asked.add_choice(node_name(forest.at(i).boxes, there), forest.at(i).boxes);
  }
  return nullptr;
}
Truth beside_truth(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::BodyInserted>(asked, run);
  const std::vector<Index> places = places_offered(asked, run);
  const auto right = static_cast<int>(std::find(places.begin(), places.end(), fact.beside) - places.begin());
  const std::string& name = asked.choices[right];
  return {{right},
          {},
          name,
          box_name(fact.body) + " goes beside " + name + ": the half perimeters then grow by " +
              number_text(fact.growth) + " in all."};
}

Truth left_out_truth(const Asked& asked, const Run& run) {
  switch (tree_fact<hierarchy::NodeVisited>(asked, run).answer) {
    case hierarchy::Answer::kPrune: return yes("The query misses the node's box, and so everything in it.");
    case hierarchy::Answer::kAccept: return no("The node is inside the query, so everything below it is taken.");
    case hierarchy::Answer::kDescend: break;
  }
  return no("The query meets the node's box, so what is below has to be looked at.");
}
double merging_loss(const TreeRun& run, Index node) {
  const std::size_t at = node;
  const double merged = fit::measure_of(run.volumes().merged[at], 2),
               tight = fit::measure_of(run.volumes().tight[at], 2);
  return tight > 0 && merged > tight * (1 + tolerance::kBoxProof) ? merged / tight - 1 : 0;
}

Truth loses_truth(const Asked& asked, const Run& run) {
  const double loss = merging_loss(tree_run(run), tree_fact<hierarchy::VolumeMade>(asked, run).node);
  if (loss > 0) return yes("The merged volume is " + loss_words(loss) + " larger.");
  return no("Both are equally large.");
}

Truth pair_apart_truth(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::PairTested>(asked, run);
  const std::string what = fact.bodies ? "The two boxes " : "The boxes of the two nodes ";
  return fact.overlap ? no(what + "overlap.") : yes(what + "are apart along an axis.");
}

// ---- margins and wrong rules --------------------------------------------------------------------------------

/// As a share of the cheaper one's cost.
double priced_axis_margin(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::SplitsPriced>(asked, run);
  const double x = cheapest_along(fact, 0), y = cheapest_along(fact, 1);
  return std::abs(x - y) / std::min(x, y);
}
std::optional<Answer> longest_axis(const Asked& asked, const Run& run) {
  const auto& fact = tree_fact<hierarchy::SplitsPriced>(asked, run);
  return by_choice(fact.high[0] - fact.low[0] >= fact.high[1] - fact.low[1] ? 0 : 1);
}

double pair_margin(const Asked& asked, const Run& run) {
  Scores sizes;
  for (const Pair& pair : pairs_before(tree_run(run).forest(asked.fact))) sizes.add(0, -pair.size);
  return sizes.lead() / extent_of(*asked.subject);
}
std::optional<Answer> nearest_centers(const Asked& asked, const Run& run) {
  const Forest& forest = tree_run(run).forest(asked.fact);
  const auto center = [&](Index branch) { return Point2((forest.at(branch).box.min + forest.at(branch).box.max) / 2); };
  Scores distances;
  int choice = 0;
  for (const Pair& pair : pairs_offered(asked, run))
    distances.add(choice++, (center(pair.left) - center(pair.right)).norm());
  return by_choice(distances.least());
}

}  // namespace snug::lesson
