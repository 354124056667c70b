#include "lesson/subjects/tree/forest.hpp"

#include <algorithm>

namespace snug::lesson {
namespace {

Box2 around(std::span<const Index> below, std::span<const Box2> boxes) {
  Box2 all = boxes[below.front()];
  for (const Index i : below) {
    const Box2& one = boxes[i];
    all = {all.min.cwiseMin(one.min), all.max.cwiseMax(one.max)};
  }
  return all;
}

/// The sum of the tests below each node times its perimeter, which is proportional to the tests that random lines make.
double tests_times_perimeters(const Forest& forest) {
  double sum = 0;
  for (const Index i : forest.there())
    sum += (forest.at(i).divides() ? 2.0 : static_cast<double>(forest.at(i).boxes.size())) *
           half_perimeter_of(forest.at(i).volume);
  return sum;
}

}  // namespace

std::vector<Index> Forest::there() const {
  std::vector<Index> all, open(roots.rbegin(), roots.rend());
  while (!open.empty()) {
    const Index i = open.back();
    open.pop_back();
    all.push_back(i);
    if (at(i).divides()) open.push_back(at(i).children[1]), open.push_back(at(i).children[0]);
  }
  return all;
}

Index Forest::parent_of(Index i) const {
  for (const Index parent : there())
    if (at(parent).divides() && (at(parent).children[0] == i || at(parent).children[1] == i)) return parent;
  return kNoIndex;
}

Forest forest_of(const TreeOfBoxes& tree, std::span<const Box2> boxes, NodeKind kind) {
  Forest forest;
  forest.branches.resize(tree.nodes.size());
  forest.roots = {0};
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    Branch& branch = forest.branches[i];
    const auto below = tree.bodies_below(static_cast<Index>(i));
    branch.boxes.assign(below.begin(), below.end());
    std::sort(branch.boxes.begin(), branch.boxes.end());
    branch.box = around(branch.boxes, boxes);
    if (!tree.nodes[i].is_leaf()) branch.children = {tree.nodes[i].first, tree.nodes[i].first + 1};
  }
  for (auto branch = forest.branches.rbegin(); branch != forest.branches.rend(); ++branch)  // children come first
    branch->volume = kind == NodeKind::kAabb || !branch->divides()
                         ? volume_around(kind, branch->box)
                         : merged(forest.at(branch->children[0]).volume, forest.at(branch->children[1]).volume);
  return forest;
}

double expected_cost(const Forest& whole) {
  const double root = half_perimeter_of(whole.at(whole.roots.front()).volume);
  double tests = 0;
  if (root > 0) return tests_times_perimeters(whole) / root;
  for (const Index i : whole.there())
    tests += whole.at(i).divides() ? 2.0 : static_cast<double>(whole.at(i).boxes.size());
  return tests;
}

double tests_of_lines(const Forest& one, const Forest& other) {
  const double tests = tests_times_perimeters(other);
  return tests > 0 ? tests_times_perimeters(one) / tests : 1;
}

Growth::Growth(Way way, const TreeOfBoxes& tree, std::span<const Box2> boxes, NodeKind kind)
    : boxes_(boxes), kind_(kind) {
  const auto count = static_cast<Index>(boxes.size());
  if (way == Way::kDown) {
    whole_ = now_ = forest_of(tree, boxes, kind);
    for (Branch& branch : now_.branches) branch.children = {kNoIndex, kNoIndex};
    return;
  }
  now_.branches.resize(2 * boxes.size());
  for (Index i = 0; i < count; ++i) {
    at(i).boxes = {i}, at(i).box = boxes[i];
    at(i).volume = volume_around(kind, at(i).box);
    if (way == Way::kUp) now_.roots.push_back(i);
  }
}

void Growth::operator()(const hierarchy::SplitChosen& fact) { at(fact.node).children = whole_.at(fact.node).children; }

void Growth::operator()(const hierarchy::NodesMerged& fact) {
  join(fact.merged, fact.left, fact.right);
  std::erase(now_.roots, fact.right);
  std::replace(now_.roots.begin(), now_.roots.end(), fact.left, fact.merged);
}

void Growth::operator()(const hierarchy::BodyInserted& fact) {
  if (fact.made == kNoIndex) return now_.roots.push_back(fact.body);
  const Index parent = now_.parent_of(fact.beside);
  join(fact.made, fact.beside, fact.body);
  if (parent == kNoIndex) now_.roots = {fact.made};
  else std::replace(at(parent).children.begin(), at(parent).children.end(), fact.beside, fact.made);
  for (Index above = parent; above != kNoIndex; above = now_.parent_of(above)) refresh(above);
}

void Growth::operator()(const hierarchy::Rotated& fact) {
  const Index middle = now_.parent_of(fact.up);
  std::replace(at(fact.group).children.begin(), at(fact.group).children.end(), fact.down, fact.up);
  std::replace(at(middle).children.begin(), at(middle).children.end(), fact.up, fact.down);
  refresh(middle), refresh(fact.group);
}

void Growth::join(Index made, Index left, Index right) {
  at(made).children = {left, right};
  refresh(made);
}

/// Finds anew what is below a branch, and the volumes around it.
void Growth::refresh(Index i) {
  Branch& branch = at(i);
  branch.boxes.clear();
  for (const Index child : branch.children)
    branch.boxes.insert(branch.boxes.end(), at(child).boxes.begin(), at(child).boxes.end());
  std::sort(branch.boxes.begin(), branch.boxes.end());
  branch.box = around(branch.boxes, boxes_);
  branch.volume = kind_ == NodeKind::kAabb ? NodeVolume(branch.box)
                                           : merged(at(branch.children[0]).volume, at(branch.children[1]).volume);
}

}  // namespace snug::lesson
