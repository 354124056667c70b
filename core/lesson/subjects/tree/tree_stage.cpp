#include "lesson/subjects/tree/tree_stage.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/generate.hpp"
#include "geometry/random.hpp"
#include "lesson/lesson.hpp"
#include "lesson/names.hpp"
#include "lesson/rows.hpp"
#include "lesson/subjects/tree/node_volume.hpp"
#include "lesson/subjects/tree/tree.hpp"

namespace snug::lesson {
namespace {

constexpr double kSpread = 2;  // generated centres are about so far from the origin

tl::unexpected<InputError> refused(std::string why) { return tl::unexpected(InputError{.what = std::move(why)}); }

Point3 lifted(const Point2& p) { return {p[0], p[1], 0}; }

void see_box(auto& box, auto&& see) {
  for (const int axis : {0, 1}) see(box.center[axis]);
  for (const int axis : {0, 1}) see(box.half[axis]);
}
void see_query(auto& query, auto&& see) {
  for (auto& at : query.at)
    for (const int axis : {0, 1}) see(at[axis]);
}

/// Reads boxes by their centres and half extents, of which one may stand for all.
std::vector<HeldBox> read_boxes(TomlTable& table) {
  const auto centers = table.points("center", 2);
  auto halves = table.points("half_extents", 2);
  if (halves.size() == 1) halves.resize(centers.size(), halves.front());
  if (halves.size() != centers.size() && !halves.empty() && !centers.empty())
    table.wrong("half_extents", "must be as many as the centres, or one for all boxes");
  halves.resize(centers.size(), Point3::Zero());
  std::vector<HeldBox> boxes;
  for (std::size_t i = 0; i < centers.size(); ++i) boxes.push_back({centers[i].head<2>(), halves[i].head<2>()});
  return boxes;
}

/// Reads one of the query's places.
void read_place(TomlTable& table, std::string_view key, Point2& place) {
  const std::vector<double> at = table.numbers(key);
  if (at.size() == 2) place = {at[0], at[1]};
  else if (table.has(key)) table.wrong(key, "must be two numbers");
}

BoxRecipe read_recipe(TomlTable& table) {
  BoxRecipe recipe{.kind = table.text("generate")};
  check_name(table, "generate", recipe.kind, generator_kinds());
  recipe.count = static_cast<int>(table.integer("count", kFewestBoxes, kMostBoxes));
  if (!table.has("size")) return static_cast<void>(table.any_number("size", 0)), recipe;
  const std::vector<double> size = table.numbers("size");
  if (size.size() == 2 && size[0] >= 0 && size[0] <= size[1] && size[1] < 1e6) recipe.size = {size[0], size[1]};
  else table.wrong("size", "must be two numbers, the least and the greatest half extent");
  return recipe;
}

/// Whether a method of a volume is among the lesson's.
bool offers(const Lesson& lesson, std::string_view volume, std::string_view method) {
  return (lesson.volume == volume && is_among(lesson.algorithms, method)) ||
         is_among(lesson.algorithms, std::string(volume) + '/' + std::string(method));
}

/// Whether one of the lesson's methods is a query.
bool asks_queries(const Lesson& lesson) {
  if (is_query(lesson.volume)) return true;
  const std::string prefix = std::string(kTreeQuery) + '/';
  return std::any_of(lesson.algorithms.begin(), lesson.algorithms.end(),
                     [&](const std::string& name) { return name.starts_with(prefix); });
}

void read_query(TomlTable& root, const Lesson& lesson, TreeTables& tables, Complaints& complaints) {
  const toml::table* toml = root.table("query");
  const bool due = asks_queries(lesson);
  if (toml == nullptr && due) root.lack("query", "the lesson lacks [query]");
  if (toml == nullptr) return;
  if (!due) root.wrong("query", "is for lessons with volume = \"" + std::string(kTreeQuery) + "\"");
  TomlTable own(*toml, "[query]", complaints);
  QueryPlaces query;
  read_place(own, "from", query.at[0]), read_place(own, "to", query.at[1]);
  tables.rule = own.text_or("tree", tables.rule);
  std::vector<std::string_view> rules;
  for (const Method& method : build_methods()) rules.push_back(method.name);
  check_name(own, "tree", tables.rule, rules);
  own.refuse_others();
  tables.stage.query = query;
}

/// Reads where the boxes were when the tree was built.
void read_built(TomlTable& table, const Lesson& lesson, TreeStage& stage) {
  if (!table.has("built")) return table.allow("built");
  for (const Point3& center : table.points("built", 2)) stage.built.push_back(center.head<2>());
  if (lesson.volume != kTreeUpdate)
    table.wrong("built", "is for lessons with volume = \"" + std::string(kTreeUpdate) + "\"");
  else if (!stage.boxes.empty() && stage.built.size() != stage.boxes.size())
    table.wrong("built", "must be as many as the boxes");
}

/// Reads what the nodes of the trees have around what is below them.
void read_nodes(TomlTable& table, const Lesson& lesson, TreeStage& stage) {
  const std::string name = table.text_or("nodes", node_kinds().front());
  check_name(table, "nodes", name, node_kinds());
  const auto kind = std::find(node_kinds().begin(), node_kinds().end(), name);
  if (kind != node_kinds().end()) stage.nodes = static_cast<NodeKind>(kind - node_kinds().begin());
  if (lesson.volume != kTreeBuild && stage.nodes != NodeKind::kAabb)
    table.wrong("nodes", "is for lessons with volume = \"" + std::string(kTreeBuild) + "\"");
}

}  // namespace

std::vector<Box2> TreeStage::aabbs() const {
  std::vector<Box2> all;
  for (const HeldBox& box : boxes) all.push_back(box.aabb());
  return all;
}

std::vector<Box2> TreeStage::aabbs_built() const {
  std::vector<Box2> all;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    all.push_back(HeldBox{built.empty() ? boxes[i].center : built[i], boxes[i].half}.aabb());
  return all;
}

std::string box_name(Index box) { return std::string(1, static_cast<char>('A' + box)); }

std::string box_names(std::span<const Index> boxes) {
  std::vector<std::string> names;
  for (const Index box : boxes) names.push_back(box_name(box));
  return names.empty() ? "no box" : listed(names, " and ");
}

std::string node_name(std::span<const Index> boxes, std::size_t all) {
  if (boxes.size() == all) return "the root";
  std::string name;
  for (const Index box : boxes) name += box_name(box);
  return name;
}

Done check_stage(const TreeStage& stage) {
  const auto count = static_cast<int>(stage.boxes.size());
  if (count < kFewestBoxes || count > kMostBoxes)
    return refused("there must be " + std::to_string(kFewestBoxes) + " to " + std::to_string(kMostBoxes) + " boxes");
  if (!stage.built.empty() && stage.built.size() != stage.boxes.size())
    return refused("the tree was built of " + std::to_string(stage.built.size()) + " boxes");
  if (stage.by_hand && !groups_left(stage.boxes.size(), *stage.by_hand))
    return refused("a merger by hand names groups that are not there");
  std::vector<Point3> all;
  for (const HeldBox& box : stage.boxes) {
    if (!(box.half.minCoeff() >= 0)) return refused("a half extent is below 0");
    all.push_back(lifted(box.aabb().min)), all.push_back(lifted(box.aabb().max));
  }
  if (stage.query)
    for (const Point2& at : stage.query->at) all.push_back(lifted(at));
  if (stage.query)
    if (auto frustum = frustum_of(*stage.query); !frustum) return tl::unexpected(std::move(frustum.error()));
  if (auto set = PointSet<double, 3>::make(std::move(all)); !set) return tl::unexpected(std::move(set.error()));
  return {};
}

std::vector<HeldBox> boxes_by(const BoxRecipe& recipe, std::uint64_t seed) {
  Random random(seed);
  std::vector<HeldBox> boxes;
  const auto centers = generate(recipe.kind, recipe.count, 2, seed);
  for (const Point3& center : *centers) {
    HeldBox& box = boxes.emplace_back(HeldBox{kSpread * center.head<2>()});
    for (const int axis : {0, 1}) box.half[axis] = random.between(recipe.size[0], recipe.size[1]);
  }
  return boxes;
}

std::vector<HeldBox> scattered(const std::vector<HeldBox>& like, std::uint64_t seed) {
  Random random(seed);
  Box2 room = like.front().aabb();
  for (const HeldBox& box : like) room = {room.min.cwiseMin(box.aabb().min), room.max.cwiseMax(box.aabb().max)};
  std::vector<HeldBox> boxes = like;
  for (HeldBox& box : boxes)
    for (const int axis : {0, 1}) box.center[axis] = random.between(room.min[axis], room.max[axis]);
  return boxes;
}

std::optional<std::vector<Index>> groups_left(std::size_t boxes, std::span<const HandPair> pairs) {
  std::vector<Index> left(boxes);
  std::iota(left.begin(), left.end(), 0);
  for (const HandPair& pair : pairs) {
    if (pair[0] == pair[1] || std::erase(left, pair[0]) == 0 || std::erase(left, pair[1]) == 0) return std::nullopt;
    left.push_back(static_cast<Index>(boxes++));
  }
  return left;
}

Rows rows_of(const TreeStage& stage) {
  Rows rows;
  for (const HeldBox& box : stage.boxes) {
    RowWriter writer(2);
    see_box(box, writer);
    rows.push_back(writer.take());
  }
  if (stage.query) {
    RowWriter writer(2);
    see_query(*stage.query, writer);
    rows.push_back(writer.take());
  }
  if (stage.by_hand) {
    std::vector<double>& mergers = rows.emplace_back(1, static_cast<double>(stage.by_hand->size()));
    for (const HandPair& pair : *stage.by_hand) mergers.insert(mergers.end(), pair.begin(), pair.end());
  }
  if (!stage.order) return rows;
  std::vector<double>& order = rows.emplace_back(1, static_cast<double>(stage.order->size()));
  order.insert(order.end(), stage.order->begin(), stage.order->end());
  return rows;
}

namespace {

/// The mergers in a row of numbers; none if it has none.
std::optional<std::vector<HandPair>> pairs_in(std::span<const double> row) {
  std::vector<HandPair> pairs;
  if (row.size() % 2 == 0 || row[0] != static_cast<double>(row.size() / 2)) return std::nullopt;
  for (std::size_t i = 1; i < row.size(); i += 2) {
    HandPair& pair = pairs.emplace_back();
    for (const std::size_t side : {0, 1}) {
      const double group = row[i + side];
      if (!(group >= 0 && group < 2 * kMostBoxes) || group != std::floor(group)) return std::nullopt;
      pair[side] = static_cast<Index>(group);
    }
  }
  return pairs;
}

/// The choices of a child in a row of numbers; none if it has none.
std::optional<std::vector<Index>> order_in(std::span<const double> row) {
  if (row.empty() || row.size() > kMostBoxes || row[0] != static_cast<double>(row.size() - 1)) return std::nullopt;
  std::vector<Index> order;
  for (const double choice : row.subspan(1)) {
    if (choice != 0 && choice != 1) return std::nullopt;
    order.push_back(choice == 1 ? 1 : 0);
  }
  return order;
}

}  // namespace

tl::expected<TreeStage, InputError> with_rows(const TreeStage& like, const Rows& all_rows) {
  const std::size_t own = like.query ? 1 : 0, hands = (like.by_hand ? 1 : 0) + (like.order ? 1 : 0);
  if (all_rows.size() <= own + hands) return refused("these are not the rows of boxes");
  TreeStage next = like;
  const std::span<const std::vector<double>> rows(all_rows.data(), all_rows.size() - hands);
  if (like.by_hand) {
    auto pairs = pairs_in(all_rows[rows.size()]);
    if (!pairs) return refused("mergers must be given as a count, then two groups for each");
    next.by_hand = *std::move(pairs);
  }
  if (like.order) {
    auto order = order_in(all_rows.back());
    if (!order) return refused("an order must be given as a count, then 0 or 1 for each choice");
    next.order = *std::move(order);
  }
  next.boxes.assign(rows.size() - own, HeldBox());
  bool fits = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    RowReader reader(rows[i], 2);
    if (i < next.boxes.size()) see_box(next.boxes[i], reader);
    else see_query(*next.query, reader);
    fits = fits && reader.fits();
  }
  if (!fits) return refused("a box must have four numbers, and so must a query");
  if (Done fine = check_stage(next); !fine) return tl::unexpected(std::move(fine.error()));
  return next;
}

void read_tree(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto tables = std::make_shared<TreeTables>();
  TomlTable own(*table.table("objects"), "[objects]", complaints);
  lesson.points.dim = 2;
  const std::size_t before = complaints.count();
  if (own.has("generate")) tables->recipe = read_recipe(own);
  else tables->stage.boxes = read_boxes(own);
  read_built(own, lesson, tables->stage);
  read_nodes(own, lesson, tables->stage);
  own.refuse_others();
  if (complaints.count() == before && !tables->recipe.kind.empty())
    tables->stage.boxes = boxes_by(tables->recipe, lesson.seed);
  read_query(table, lesson, *tables, complaints);
  if (offers(lesson, kTreeBuild, kByHand)) tables->stage.by_hand.emplace();
  if (offers(lesson, kTreeQuery, kRayByHand)) tables->stage.order.emplace();
  if (complaints.count() == before)
    if (const Done fine = check_stage(tables->stage); !fine)
      own.wrong(tables->recipe.kind.empty() ? "center" : "generate", fine.error().what);
  lesson.tables = std::move(tables);
}

Rows read_tree_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  const toml::table* model = task.table("model");
  if (model == nullptr) return task.lack("model", "the task lacks [task.model]"), Rows();
  TomlTable own(*model, "[task.model]", complaints);
  const std::size_t before = complaints.count();
  TreeStage stage = static_cast<const TreeTables&>(*lesson.tables).stage;
  if ((!stage.query && !own.has("mergers")) || own.has("center")) stage.boxes = read_boxes(own);
  if (stage.by_hand && own.has("mergers"))
    for (const Point3& pair : own.points("mergers", 2))
      stage.by_hand->push_back({static_cast<Index>(pair[0]), static_cast<Index>(pair[1])});
  if (stage.order && own.has("order"))
    for (const double choice : own.numbers("order")) {
      if (choice != 0 && choice != 1) own.wrong("order", "must be numbers 0 (the left child) and 1 (the right one)");
      stage.order->push_back(choice == 1 ? 1 : 0);
    }
  if (stage.query && own.has("from")) read_place(own, "from", stage.query->at[0]);
  if (stage.query && own.has("to")) read_place(own, "to", stage.query->at[1]);
  own.refuse_others();
  if (complaints.count() == before)
    if (const Done fine = check_stage(stage); !fine) own.wrong("center", fine.error().what);
  return rows_of(stage);
}

}  // namespace snug::lesson
