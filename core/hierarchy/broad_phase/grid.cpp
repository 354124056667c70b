#include "hierarchy/broad_phase/grid.hpp"

#include <algorithm>

#include "query/overlap/aabb_overlap.hpp"

namespace snug::hierarchy {
namespace {

constexpr double kMostCells = 64;  // along an axis

/// A body in a cell of the grid, which its box reaches into.
struct InCell {
  std::uint64_t key;
  Index body;
  friend bool operator<(const InCell& a, const InCell& b) { return a.key != b.key ? a.key < b.key : a.body < b.body; }
};

std::uint64_t key_of(const Grid::Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t at : cell) key = key << 16 | static_cast<std::uint64_t>(at);
  return key;
}

/// Where the boxes go.
struct CellsFilled {
  std::vector<InCell> cells;  // by cell, then by body
  std::vector<Index> large;   // the bodies whose boxes reach into too many cells, rising
};

CellsFilled fill_cells(const Grid& grid, std::span<const Aabb<double, 3>> boxes) {
  CellsFilled filled;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const auto body = static_cast<Index>(i);
    const Grid::Cell from = grid.cell_of(boxes[i].min), to = grid.cell_of(boxes[i].max);
    if ((to[0] - from[0] + 1) * (to[1] - from[1] + 1) * (to[2] - from[2] + 1) > kMostCellsOfBox) {
      filled.large.push_back(body);
      continue;
    }
    for (std::int64_t x = from[0]; x <= to[0]; ++x)
      for (std::int64_t y = from[1]; y <= to[1]; ++y)
        for (std::int64_t z = from[2]; z <= to[2]; ++z) filled.cells.push_back({key_of({x, y, z}), body});
  }
  std::sort(filled.cells.begin(), filled.cells.end());
  return filled;
}

}  // namespace

Grid::Cell Grid::cell_of(const Vector<double, 3>& place) const {
  Cell at{};
  for (int i = 0; i < 3; ++i)
    at[i] = static_cast<std::int64_t>(std::clamp((place[i] - origin[i]) / cell[i], 0.0, 2 * kMostCells));
  return at;
}

Grid grid_of(std::span<const Aabb<double, 3>> boxes) {
  Vector<double, 3> least = boxes.front().min, greatest = boxes.front().max, sum = Vector<double, 3>::Zero();
  for (const Aabb<double, 3>& box : boxes) {
    least = least.cwiseMin(box.min);
    greatest = greatest.cwiseMax(box.max);
    sum += box.max - box.min;
  }
  Grid grid{least, 2 * sum / static_cast<double>(boxes.size())};
  grid.cell = grid.cell.cwiseMax((greatest - least) / kMostCells);
  for (int i = 0; i < 3; ++i)
    if (!(grid.cell[i] > 0)) grid.cell[i] = 1;  // all boxes are flat, and in one plane
  return grid;
}

PairsFound pairs_by_grid(std::span<const Aabb<double, 3>> boxes, std::vector<BodyPair>* seen) {
  PairsFound found;
  if (boxes.empty()) return found;
  const Grid grid = grid_of(boxes);
  const auto [cells, large] = fill_cells(grid, boxes);
  found.cells = std::ssize(cells);
  const auto compare = [&](Index a, Index b) {
    ++found.compared;
    if (seen != nullptr) seen->push_back(BodyPair::of(a, b));
    if (query::aabbs_overlap(boxes[a], boxes[b])) found.pairs.push_back(BodyPair::of(a, b));
  };
  // Two boxes may share several cells. They are compared in the first of these, where the later of both begins.
  const auto first_shared = [&](Index i, Index j) { return key_of(grid.cell_of(boxes[i].min.cwiseMax(boxes[j].min))); };
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (std::size_t j = i + 1; j < cells.size() && cells[j].key == cells[i].key; ++j)
      if (first_shared(cells[i].body, cells[j].body) == cells[i].key) compare(cells[i].body, cells[j].body);
  // Two large boxes are compared once, when the first of them meets the second.
  for (const Index a : large)
    for (Index b = 0; b < static_cast<Index>(boxes.size()); ++b)
      if (b > a || !std::binary_search(large.begin(), large.end(), b)) compare(a, b);
  return found;
}

}  // namespace snug::hierarchy
