#include "lesson/subjects/tree/tree.hpp"

#include "lesson/fact_run.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/tree/entries.hpp"
#include "lesson/subjects/tree/samples.hpp"
#include "lesson/subjects/tree/tree_figures.hpp"

namespace snug::lesson {

template class FactRun<TreeRun, TreeStep>;

namespace {

std::vector<std::string_view> tree_volumes() { return {kTreeBuild, kTreeQuery, kTreeUpdate}; }
std::span<const Method> tree_methods(std::string_view volume) {
  return is_query(volume) ? query_methods() : volume == kTreeUpdate ? update_methods() : build_methods_and_hand();
}

tl::expected<std::unique_ptr<Subject>, InputError> open_tree(const Lesson& lesson, std::optional<io::PointFile>,
                                                             Clock clock) {
  const auto& tables = static_cast<const TreeTables&>(*lesson.tables);
  if (const Done fine = check_stage(tables.stage); !fine) return tl::unexpected(fine.error());
  return std::make_unique<TreeSubject>(tables, lesson.seed, clock);
}

std::vector<double> numbers_of(const Point2& p) { return {p[0], p[1]}; }

}  // namespace

const SubjectRow kTreeRow{.name = "tree",
                          .table = "objects",
                          .volumes = &tree_volumes,
                          .methods = &tree_methods,
                          .facts = &FactList<TreeStep::Fact>::names,
                          .question_kinds = &FactList<TreeStep::Fact>::question_kinds,
                          .read = &read_tree,
                          .read_model = &read_tree_model,
                          .open = &open_tree,
                          .samples = kTreeSamples};

TreeSubject::TreeSubject(const TreeTables& tables, std::uint64_t seed, Clock clock)
    : clock_(clock), lesson_seed_(seed), recipe_(tables.recipe), rule_(tables.rule), stage_(tables.stage) {
  origin_.seed = seed;
}

Point3 TreeSubject::at(Index i) const {
  const Point2& p = i < boxes() ? stage_.boxes[i].center : stage_.query->at[i - boxes()];
  return {p[0], p[1], 0};
}

std::string TreeSubject::name_of(Index i) const { return i < boxes() ? box_name(i) : i == boxes() ? "Q" : "R"; }

std::vector<fit::Volume3> TreeSubject::on_paper() const {
  std::vector<fit::Volume3> all;
  for (const Box2& box : stage_.aabbs())
    all.push_back(Aabb<double, 3>{{box.min[0], box.min[1], 0}, {box.max[0], box.max[1], 0}});
  return all;
}

std::vector<NumberGroup> TreeSubject::numbers() const {
  const std::vector<std::string_view> axes{"x", "y"};
  constexpr std::array<std::string_view, kMostBoxes> kHeadings{"Box A", "Box B", "Box C", "Box D", "Box E",
                                                               "Box F", "Box G", "Box H", "Box I", "Box J",
                                                               "Box K", "Box L", "Box M", "Box N"};
  std::vector<NumberGroup> groups;
  for (Index i = 0; i < boxes(); ++i) {
    const HeldBox& box = stage_.boxes[i];
    NumberRow half{.words = "Half extents", .names = axes, .values = numbers_of(box.half), .drive = "half"};
    groups.push_back({kHeadings[i],
                      kHeadings[i].substr(4),
                      {{"Centre", axes, numbers_of(box.center)}, std::move(half)},
                      box_name(i)});
  }
  if (!stage_.query) return groups;
  groups.push_back({"Query, from Q", "Q", {{"Place", axes, numbers_of(stage_.query->at[0])}}, "Q"});
  groups.push_back({"Query, to R", "R", {{"Place", axes, numbers_of(stage_.query->at[1])}}, "R"});
  return groups;
}

Done TreeSubject::set_numbers(std::size_t group, std::size_t row, std::span<const double> values) {
  const bool of_box = group < stage_.boxes.size();
  if (group >= static_cast<std::size_t>(size()) || row > (of_box ? 1 : 0) || values.size() != 2)
    return Subject::set_numbers(group, row, values);
  TreeStage next = stage_;
  const Point2 to(values[0], values[1]);
  if (!of_box) next.query->at[group - stage_.boxes.size()] = to;
  else (row == 0 ? next.boxes[group].center : next.boxes[group].half) = to;
  return become(std::move(next));
}

Done TreeSubject::set_rows(const Rows& rows) {
  auto next = with_rows(stage_, rows);
  if (!next) return tl::unexpected(std::move(next.error()));
  return become(*std::move(next));
}

Done TreeSubject::move(Index i, const Point3& to) {
  TreeStage next = stage_;
  (i < boxes() ? next.boxes[i].center : next.query->at[i - boxes()]) = to.head<2>();
  return become(std::move(next));
}

Done TreeSubject::become(TreeStage next) {
  if (Done fine = check_stage(next); !fine) return fine;
  stage_ = std::move(next);
  origin_.edited = true;
  return {};
}

void TreeSubject::scatter(std::uint64_t seed, const Subject& own) {
  const auto& first = *as<TreeSubject>(own);
  stage_ = first.stage_;
  origin_ = own.origin();
  origin_.seed = seed;
  if (seed != lesson_seed_)
    stage_.boxes = recipe_.kind.empty() ? scattered(first.stage_.boxes, seed) : boxes_by(recipe_, seed);
}

void TreeSubject::begin_task(const Lesson&, const Task&, const Subject& own) {
  stage_ = as<TreeSubject>(own)->stage_;
  origin_ = own.origin();
}

std::unique_ptr<Run> TreeSubject::run(const Method& method, std::unique_ptr<Run>) const {
  if (method.name == kByHand) return std::make_unique<TreeRun>(stage_.aabbs(), mergers(), stage_.nodes);
  if (method.volume == kTreeBuild) return std::make_unique<TreeRun>(method.name, stage_.aabbs(), stage_.nodes);
  if (method.volume == kTreeUpdate) return std::make_unique<TreeRun>(method.name, stage_.aabbs(), stage_.aabbs_built());
  return std::make_unique<TreeRun>(method.name, stage_.aabbs(), rule_, *stage_.query, choices());
}

std::span<const Index> TreeSubject::choices() const {
  return stage_.order ? std::span<const Index>(*stage_.order) : std::span<const Index>();
}

std::span<const HandPair> TreeSubject::mergers() const {
  return stage_.by_hand ? std::span<const HandPair>(*stage_.by_hand) : std::span<const HandPair>();
}

TreeTime TreeSubject::timed(const Method& method) const {
  const std::vector<Box2> crowd = crowd_of(stage_.aabbs());
  if (method.volume == kTreeBuild) return time_of_building(method.name, crowd, clock_);
  if (!merges(method.name)) return time_of_building("top_down_sah", crowd, clock_);
  return time_of_refitting(crowd_of(stage_.aabbs_built()), crowd, clock_);
}

std::string TreeSubject::opening(const Method& method) const {
  return std::string(method.title) + ", " + std::to_string(boxes()) +
         " boxes: nothing is known yet. Take the first step.";
}

std::vector<Figure> TreeSubject::figures(const View& view) const { return tree_figures(view); }
std::vector<Proof> TreeSubject::proofs(const View& view) const {
  return tree_proofs(view, stage_.query ? &*stage_.query : nullptr);
}

std::optional<double> TreeSubject::result_size(const Method& method, bool, const View&) const {
  if (method.volume != kTreeBuild) return std::nullopt;
  const std::vector<Box2> boxes = stage_.aabbs();
  if (method.name == kByHand) {
    if (mergers().size() + 1 != stage_.boxes.size()) return std::nullopt;
    return cost_of_tree(tree_by_hand(mergers(), boxes), boxes, stage_.nodes);
  }
  return cost_of_tree(build_tree(method.name, boxes), boxes, stage_.nodes);
}

std::vector<Rival> TreeSubject::rivals(const Lesson& lesson, const View& view) const {
  std::vector<Rival> rivals;
  for (const std::string& name : lesson.algorithms) {
    const Method& method = *find_method(lesson, name);
    if (const auto cost = result_size(method, false, view)) rivals.push_back({&method, *cost, std::nullopt});
  }
  return rivals;
}

}  // namespace snug::lesson
