// Axis-aligned boxes in the plane, over which trees are built, and the query that goes through one.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "geometry/aabb.hpp"
#include "lesson/subject.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {

using Point2 = Vector<double, 2>;
using Box2 = Aabb<double, 2>;

/// How many boxes there may be: each has a letter, and its node a place in the tree's picture.
inline constexpr int kFewestBoxes = 2, kMostBoxes = 14;

struct HeldBox {
  Point2 center = Point2::Zero(), half = Point2::Zero();
  [[nodiscard]] Box2 aabb() const { return {center - half, center + half}; }
};

/// A query's two places: Q is its point, or where it begins; R is where a ray, a box or a frustum goes to.
struct QueryPlaces {
  std::array<Point2, 2> at{Point2::Zero(), Point2::Zero()};
};

/// Two groups that were merged by hand: boxes first, then merged groups in their order (hierarchy/steps.hpp).
using HandPair = std::array<Index, 2>;

/// How boxes are generated; an empty kind: they are a list.
struct BoxRecipe {
  std::string kind;
  int count = 0;
  std::array<double, 2> size{0.08, 0.25};  // least and greatest half extent
};

/// What a tree's nodes have around what is below them (node_volume.hpp).
enum class NodeKind : std::uint8_t { kAabb, kSphere, kObb };

struct TreeStage {
  std::vector<HeldBox> boxes;
  std::optional<QueryPlaces> query = {};
  std::vector<Point2> built = {};  // where the centres were when the tree was built; empty: where they are
  std::optional<std::vector<HandPair>> by_hand = {};  // the mergers so far, in a lesson with that method
  /// The order of a ray that is steered by hand, in a lesson with that method. An entry for each node whose children
  /// are both met: 0 if the left one comes first, 1 if the right one does.
  std::optional<std::vector<Index>> order = {};
  NodeKind nodes = NodeKind::kAabb;  // of trees that are built
  [[nodiscard]] std::vector<Box2> aabbs() const;
  [[nodiscard]] std::vector<Box2> aabbs_built() const;
  /// Whether it has places where the boxes were before.
  [[nodiscard]] bool has_moved() const { return !built.empty(); }
  /// Which of its rows has the mergers by hand, and which the order.
  [[nodiscard]] std::size_t row_of_mergers() const { return boxes.size() + (query ? 1 : 0); }
  [[nodiscard]] std::size_t row_of_order() const { return row_of_mergers() + (by_hand ? 1 : 0); }
};

/// The subject's tables in a lesson's file.
struct TreeTables final : Tables {
  TreeStage stage;
  BoxRecipe recipe;
  std::string rule = "top_down_sah";  // by which method the tree is built that a query goes through
};

/// "A" … "N".
[[nodiscard]] std::string box_name(Index box);
/// "A, B and D".
[[nodiscard]] std::string box_names(std::span<const Index> boxes);
/// A node by the boxes below it: "the root" for all of them, "BDE", and for a leaf "B".
[[nodiscard]] std::string node_name(std::span<const Index> boxes, std::size_t all);

/// Errors: mergers of groups that are not there; too few or too many boxes; not as many as the tree was built of; a
/// half extent below 0; a coordinate that a point may not have.
[[nodiscard]] Done check_stage(const TreeStage& stage);

/// Generated boxes. recipe: of an existing kind.
[[nodiscard]] std::vector<HeldBox> boxes_by(const BoxRecipe& recipe, std::uint64_t seed);
/// The boxes of the same sizes, in other places.
[[nodiscard]] std::vector<HeldBox> scattered(const std::vector<HeldBox>& like, std::uint64_t seed);

/// The groups that have no parent yet, of so many boxes; none if these are no mergers of them.
[[nodiscard]] std::optional<std::vector<Index>> groups_left(std::size_t boxes, std::span<const HandPair> pairs);

/// A row for each box, of its centre and its half extents; one for the query, of both places; one for the mergers by
/// hand, of how many there are and two groups each; and one for the order by hand, of how many choices there are and
/// the choices.
[[nodiscard]] Rows rows_of(const TreeStage& stage);
/// The stage with these rows. Errors: these are none of such a stage; those of check_stage.
[[nodiscard]] tl::expected<TreeStage, InputError> with_rows(const TreeStage& like, const Rows& rows);

void read_tree(TomlTable& table, Lesson& lesson, Complaints& complaints);
[[nodiscard]] Rows read_tree_model(TomlTable& task, const Lesson& lesson, Complaints& complaints);

}  // namespace snug::lesson
