// The entries of the facts that building a tree and going through one report.
#pragma once

#include <algorithm>
#include <cmath>

#include "lesson/decide.hpp"
#include "lesson/subjects/tree/tree_run.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {

/// The fact that is asked about.
template <class Fact>
const Fact& tree_fact(const Asked& asked, const Run& run) {
  return *std::get_if<Fact>(&tree_run(run).trace()[asked.fact].step.fact);
}

using TreeWhere = TreeRun::Where;

const char* offer_split_axes(Asked& asked, const Run& run);
Truth priced_axis_truth(const Asked& asked, const Run& run);
double priced_axis_margin(const Asked& asked, const Run& run);
std::optional<Answer> longest_axis(const Asked& asked, const Run& run);
inline constexpr std::array kPricedRules{WrongRule{"longest", &longest_axis}};
Truth split_axis_truth(const Asked& asked, const Run& run);
const char* offer_pairs(Asked& asked, const Run& run);
Truth pair_truth(const Asked& asked, const Run& run);
double pair_margin(const Asked& asked, const Run& run);
std::optional<Answer> nearest_centers(const Asked& asked, const Run& run);
inline constexpr std::array kPairRules{WrongRule{"centers", &nearest_centers}};
const char* offer_places(Asked& asked, const Run& run);
Truth beside_truth(const Asked& asked, const Run& run);
Truth left_out_truth(const Asked& asked, const Run& run);
Truth pair_apart_truth(const Asked& asked, const Run& run);
Truth loses_truth(const Asked& asked, const Run& run);

/// How much larger a node's merged volume is than the one around the vertices, 0.1 for 10 per cent; 0 where rounding
/// alone makes the difference.
[[nodiscard]] double merging_loss(const TreeRun& run, Index node);
/// Writes a loss above 0: "8.3 %", "less than 0.1 %".
[[nodiscard]] inline std::string loss_words(double loss) {
  const std::string words = without_plus(percent_text(loss));
  return words == "0.0 %" ? "less than 0.1 %" : words;
}

/// "x".
[[nodiscard]] inline std::string axis_letter(int axis) { return std::string(1, "xy"[axis]); }
/// "1 test", "12 tests".
[[nodiscard]] inline std::string tests_text(std::int64_t tests) {
  return std::to_string(tests) + (tests == 1 ? " test" : " tests");
}

template <>
struct Entry<hierarchy::SplitsPriced> : EntryDefaults {
  using Fact = hierarchy::SplitsPriced;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "split_axis",
                                                          .offer = &offer_split_axes,
                                                          .truth = &priced_axis_truth,
                                                          .margin = &priced_axis_margin,
                                                          .rules = kPricedRules}};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const auto priced = std::count_if(fact.costs.begin(), fact.costs.end(), [](double c) { return std::isfinite(c); });
    return capital(where.beside_name(fact.node)) + ": of " + std::to_string(priced) +
           " possible splits, the cheapest is at " + axis_letter(fact.axis) + " = " +
           number_text(fact.position(fact.axis, fact.border)) + ", with " +
           number_text(fact.cost_at(fact.axis, fact.border)) + " expected tests.";
  }
};

template <>
struct Entry<hierarchy::SplitChosen> : EntryDefaults {
  using Fact = hierarchy::SplitChosen;
  static constexpr std::array kQuestionKinds{QuestionKind{"split_axis", &offer_split_axes, &split_axis_truth}};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const Branch& node = where.after().at(fact.node);
    const std::array<const char*, 2> sides = fact.axis == 1   ? std::array{"the lower child", "the upper"}
                                             : fact.axis == 0 ? std::array{"the left child", "the right"}
                                                              : std::array{"one child", "the other"};
    const auto side = [&](int i) {
      const std::vector<Index>& boxes = where.after().at(node.children[i]).boxes;
      return box_names(boxes) + (boxes.size() == 1 ? " goes into " : " go into ") + sides[i];
    };
    const std::string how =
        fact.axis == kNoIndex ? "all centres are in one place, so its boxes are halved in their order"
        : fact.cost == 0      ? "the centres spread most along " + axis_letter(fact.axis) + ", so it is halved there"
                              : "split at " + axis_letter(fact.axis) + " = " + number_text(fact.position);
    return capital(where.beside_name(fact.node)) + ": " + how + "; " + side(0) + ", " + side(1) + ".";
  }
  /// Those of the left child.
  static std::vector<Index> handles(const Fact& fact, const TreeWhere& where) {
    return where.after().at(where.after().at(fact.node).children[0]).boxes;
  }
  static std::string predicate(const Fact& fact, const TreeWhere&, bool plural) {
    const std::string side = fact.axis == 1 ? "lower" : fact.axis == 0 ? "left" : "first";
    return (plural ? "go into the " : "goes into the ") + side + " child";
  }
  static std::optional<Mark::Kind> mark(const Fact&, const TreeWhere&) { return Mark::Kind::kGrew; }
};

template <>
struct Entry<hierarchy::LeafMade> : EntryDefaults {
  using Fact = hierarchy::LeafMade;
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    return box_names(where.after().at(fact.node).boxes) + " is alone, so its node is a leaf.";
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere& where) {
    return where.after().at(fact.node).boxes;
  }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "becomes a leaf"; }
};

template <>
struct Entry<hierarchy::NodesMerged> : EntryDefaults {
  using Fact = hierarchy::NodesMerged;
  static constexpr std::array kQuestionKinds{QuestionKind{
      .name = "pair", .offer = &offer_pairs, .truth = &pair_truth, .margin = &pair_margin, .rules = kPairRules}};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    if (where.run.is_by_hand())
      return where.name_before(fact.left) + " and " + where.name_before(fact.right) +
             " are merged by hand, into a box with a half perimeter of " + number_text(fact.area) + ".";
    return where.name_before(fact.left) + " and " + where.name_before(fact.right) +
           " are merged: of all pairs, the box around these two is smallest, with a half perimeter of " +
           number_text(fact.area) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere& where) {
    return where.after().at(fact.merged).boxes;
  }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "are in the merged node"; }
  static std::optional<Mark::Kind> mark(const Fact&, const TreeWhere&) { return Mark::Kind::kGrew; }
};

template <>
struct Entry<hierarchy::BodyInserted> : EntryDefaults {
  using Fact = hierarchy::BodyInserted;
  static constexpr std::array kQuestionKinds{QuestionKind{"beside", &offer_places, &beside_truth}};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const std::string box = box_name(fact.body);
    if (fact.made == kNoIndex) return box + " is the first box, and the root of the tree.";
    return box + " goes down to " + where.beside_name(fact.beside) +
           " and is inserted beside it: the half perimeters of the nodes grow by " + number_text(fact.growth) +
           " in all.";
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere&) { return {fact.body}; }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "is inserted"; }
  static std::optional<Mark::Kind> mark(const Fact& fact, const TreeWhere&) {
    return fact.made == kNoIndex ? std::nullopt : std::optional(Mark::Kind::kGrew);
  }
};

template <>
struct Entry<hierarchy::Rotated> : EntryDefaults {
  using Fact = hierarchy::Rotated;
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    return "A rotation: " + where.beside_name(fact.up) + " and " + where.beside_name(fact.down) +
           " change places, which makes a node's half perimeter smaller by " + number_text(fact.gain) + ".";
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere& where) {
    std::vector<Index> both = where.before().at(fact.up).boxes;
    const auto& down = where.before().at(fact.down).boxes;
    both.insert(both.end(), down.begin(), down.end());
    return both;
  }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "change places"; }
  static std::optional<Mark::Kind> mark(const Fact&, const TreeWhere&) { return Mark::Kind::kReplaced; }
};

template <>
struct Entry<hierarchy::VolumeMade> : EntryDefaults {
  using Fact = hierarchy::VolumeMade;
  static constexpr std::array kQuestionKinds{QuestionKind{"loses", &offer_yes_no, &loses_truth}};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const std::string word(where.run.volume_word()), name = capital(where.beside_name(fact.node));
    const auto& children = where.before().at(fact.node).children;
    if (!where.before().at(fact.node).divides()) return name + ": a leaf has the " + word + " around its box.";
    const std::string merged = name + ": the " + word + "s of " + where.beside_name(children[0]) + " and " +
                               where.beside_name(children[1]) + " are merged";
    const double loss = merging_loss(where.run, fact.node);
    if (loss <= 0) return merged + ", and nothing is lost.";
    return merged + "; the result is " + loss_words(loss) + " larger than the smallest " + word +
           " around the vertices.";
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere& where) {
    return where.before().at(fact.node).boxes;
  }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "are in the node"; }
  static std::optional<Mark::Kind> mark(const Fact& fact, const TreeWhere& where) {
    return where.before().at(fact.node).divides() ? std::optional(Mark::Kind::kGrew) : std::nullopt;
  }
};

/// "next_node": which of the nodes that wait is taken up. Where a ray looks for the first box, a node waits once it is
/// tested, and is taken up when its children or its box are.
const char* offer_waiting(Asked& asked, const Run& run);
const char* offer_visited(Asked& asked, const Run& run);
Truth next_node_truth(const Asked& asked, const Run& run);
std::optional<Answer> first_waiting(const Asked& asked, const Run& run);
double left_out_margin(const Asked& asked, const Run& run);
std::optional<Answer> by_its_boxes(const Asked& asked, const Run& run);
double next_node_margin(const Asked& asked, const Run& run);
std::optional<Answer> left_child_first(const Asked& asked, const Run& run);
inline constexpr std::array kNextNodeRules{WrongRule{"queue", &first_waiting}, WrongRule{"left", &left_child_first}};
inline constexpr QuestionKind kNextNode{.name = "next_node",
                                        .offer = &offer_waiting,
                                        .truth = &next_node_truth,
                                        .margin = &next_node_margin,
                                        .rules = kNextNodeRules};
inline constexpr std::array kLeftOutRules{WrongRule{"its_boxes", &by_its_boxes}};

template <>
struct Entry<hierarchy::NodeVisited> : EntryDefaults {
  using Fact = hierarchy::NodeVisited;
  static constexpr std::array kQuestionKinds{QuestionKind{.name = "left_out",
                                                          .offer = &offer_visited,
                                                          .truth = &left_out_truth,
                                                          .margin = &left_out_margin,
                                                          .rules = kLeftOutRules},
                                             kNextNode};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const Branch& node = where.before().at(fact.node);
    const std::string name = capital(where.beside_name(fact.node));
    switch (fact.answer) {
      case hierarchy::Answer::kPrune:
        return name + ": the query misses it" +
               (node.boxes.size() == 1
                    ? "."
                    : ", so the " + std::to_string(node.boxes.size()) + " boxes below are left out.");
      case hierarchy::Answer::kAccept:
        return name + ": all of it is inside, so the " + std::to_string(node.boxes.size()) +
               " boxes below are taken without a test.";
      case hierarchy::Answer::kDescend: break;
    }
    return name + ": the query meets it" +
           (where.run.tests_before() ? ", so it waits." : ", so its children are opened.");
  }
  static std::optional<Mark::Kind> mark(const Fact& fact, const TreeWhere&) {
    return fact.answer == hierarchy::Answer::kDescend ? std::nullopt : std::optional(Mark::Kind::kBest);
  }
};

template <>
struct Entry<hierarchy::BodyTested> : EntryDefaults {
  using Fact = hierarchy::BodyTested;
  static constexpr std::array kQuestionKinds{kNextNode};
  static std::string sentence(const Fact& fact, const TreeWhere&) {
    return "Box " + box_name(fact.body) + " is tested itself: the query " +
           (fact.answer == hierarchy::Answer::kPrune ? "misses it." : "meets it.");
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere&) { return {fact.body}; }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "is tested"; }
  static std::optional<Mark::Kind> mark(const Fact& fact, const TreeWhere&) {
    return fact.answer == hierarchy::Answer::kPrune ? std::nullopt : std::optional(Mark::Kind::kReplaced);
  }
};

const char* offer_pair_tested(Asked& asked, const Run& run);
double pair_apart_margin(const Asked& asked, const Run& run);

template <>
struct Entry<hierarchy::PairTested> : EntryDefaults {
  using Fact = hierarchy::PairTested;
  static constexpr std::array kQuestionKinds{QuestionKind{
      .name = "apart", .offer = &offer_pair_tested, .truth = &pair_apart_truth, .margin = &pair_apart_margin}};
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const TreePairing& pairing = *where.run.pairing();
    if (fact.bodies)
      return "Boxes " + box_name(fact.a) + " and " + small(box_name(fact.b)) + " are tested: they " +
             (fact.overlap ? "overlap." : "are apart.");
    const Forest &own = where.before(), &copy = pairing.copy;
    const Branch &a = own.at(fact.a), &b = copy.at(fact.b);
    const std::string names = capital(pair_name(own, copy, {fact.a, fact.b}));
    if (!fact.overlap)
      return names + " are apart, so the " + std::to_string(a.boxes.size() * b.boxes.size()) +
             " pairs of boxes below are left out.";
    if (a.divides() && b.divides())
      return names + " overlap, so each child of one node is paired with each child of the other.";
    const std::string leaf = a.divides() ? small(box_name(b.boxes.front())) : box_name(a.boxes.front());
    return names + " overlap, so " + leaf + " is paired with both children of the other.";
  }
  static std::vector<Index> handles(const Fact& fact, const TreeWhere&) {
    return fact.bodies ? std::vector<Index>{fact.a} : std::vector<Index>{};
  }
  static std::string predicate(const Fact&, const TreeWhere&, bool) { return "is tested"; }
  static std::optional<Mark::Kind> mark(const Fact& fact, const TreeWhere&) {
    if (fact.bodies) return fact.overlap ? std::optional(Mark::Kind::kReplaced) : std::nullopt;
    return fact.overlap ? std::nullopt : std::optional(Mark::Kind::kBest);
  }
};

template <>
struct Entry<hierarchy::Done> : EntryDefaults {
  using Fact = hierarchy::Done;
  static std::string sentence(const Fact& fact, const TreeWhere& where) {
    const TreeRun& run = where.run;
    if (const TreePairing* pairing = run.pairing()) {
      const std::size_t found = pairing->found().size(), boxes = run.boxes().size();
      return "The end: " + tests_text(fact.volume_tests) + " found " +
             (found == 0   ? "no pair of boxes that overlaps"
              : found == 1 ? "one pair of boxes that overlaps: " + pair_names(pairing->found())
                           : std::to_string(found) + " pairs of boxes that overlap") +
             "; testing every pair of boxes takes " + std::to_string(boxes * boxes) + ".";
    }
    if (run.undecided() != kNoIndex)
      return "The ray meets both children of " + where.beside_name(run.undecided()) +
             ": beside the stage, choose which one comes next.";
    if (!run.is_merging() && !run.is_query() && !run.is_whole())
      return "There are " + std::to_string(where.before().roots.size()) +
             " nodes without a parent: beside the stage, choose two of them to merge.";
    if (run.is_merging())
      return "Every node has its " + std::string(run.volume_word()) + ", after " + std::to_string(fact.nodes / 2) +
             " merges; each keeps its children.";
    if (!run.is_query())
      return "The tree is finished: " + std::to_string(fact.nodes) + " nodes, each inner one with the " +
             (run.nodes() == NodeKind::kAabb ? std::string("box") : std::string(word_of(run.nodes()))) +
             " around its children.";
    return "The end: " + tests_text(fact.volume_tests) + " found " + box_names(run.result().found) +
           "; testing the boxes one by one takes " + std::to_string(run.boxes().size()) + ".";
  }
  /// What a query found.
  static std::vector<Index> handles(const Fact&, const TreeWhere& where) {
    return where.run.is_query() ? where.run.result().found : std::vector<Index>{};
  }
  static std::string predicate(const Fact&, const TreeWhere&, bool plural) { return plural ? "are found" : "is found"; }
  static std::optional<Mark::Kind> mark(const Fact&, const TreeWhere&) { return std::nullopt; }
};

}  // namespace snug::lesson
