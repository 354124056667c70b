// libFuzzer: trees of any boxes, built in each of the four ways, refitted, and searched: they find what a search
// without a tree finds.
#include "fuzz/bytes.hpp"
#include "hierarchy/build.hpp"
#include "hierarchy/traverse.hpp"
#include "query/overlaps.hpp"

namespace {

using namespace snug;
using fuzz::require;
using Box = Aabb<double, 3>;
using Boxes = std::vector<Box>;

constexpr unsigned kMostBoxes = 24;

Box any_box(fuzz::Bytes& bytes) {
  const auto a = bytes.point<double, 3>(), b = bytes.point<double, 3>();
  return {a.cwiseMin(b), a.cwiseMax(b)};
}

void check_tree(const hierarchy::Tree<Box>& tree, const Boxes& boxes, const Box& sought) {
  std::vector<bool> found(boxes.size(), false);
  const auto visit = [&](const Box& box, char&) {
    return query::overlaps(box, sought) ? hierarchy::Answer::kDescend : hierarchy::Answer::kPrune;
  };
  hierarchy::traverse<Box>(tree, boxes, char{}, visit, [&](Index body, hierarchy::Answer) {
    require(!found[static_cast<std::size_t>(body)]);  // once each
    found[static_cast<std::size_t>(body)] = true;
  });
  for (std::size_t i = 0; i < boxes.size(); ++i)
    if (query::overlaps(boxes[i], sought)) require(found[i]);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  Boxes boxes(bytes.below(kMostBoxes));
  for (Box& box : boxes) box = any_box(bytes);
  const Box sought = any_box(bytes);
  const hierarchy::Options options{1 + static_cast<Index>(bytes.below(4))};
  std::array<hierarchy::Tree<Box>, 4> trees{
      hierarchy::build_median<Box>(boxes, options), hierarchy::build_surface_area<Box>(boxes, options),
      hierarchy::build_bottom_up<Box>(boxes), hierarchy::build_by_insertion<Box>(boxes)};
  for (const auto& tree : trees) check_tree(tree, boxes, sought);
  for (Box& box : boxes) box = any_box(bytes);  // they move
  for (auto& tree : trees) {
    hierarchy::refit<Box>(tree, boxes);
    check_tree(tree, boxes, sought);
  }
  return 0;
}
