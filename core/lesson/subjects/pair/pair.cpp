#include "lesson/subjects/pair/pair.hpp"

#include <algorithm>

#include "lesson/fact_run.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/box_figures.hpp"
#include "lesson/subjects/pair/entries.hpp"
#include "lesson/subjects/pair/random_pairs.hpp"
#include "lesson/subjects/pair/samples.hpp"

namespace snug::lesson {

template class FactRun<PairRun, PairStep>;

namespace {

constexpr int kMostRandomPairs = 10000;  // more would hold up a frame

std::vector<std::string_view> pair_volumes() { return {kBoxPair}; }
std::span<const Method> pair_methods(std::string_view) { return box_tests(); }

void read_boxes(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto tables = std::make_shared<PairTables>();
  TomlTable own(*table.table("boxes"), "[boxes]", complaints);
  lesson.points.dim = static_cast<int>(own.integer_or("dim", 2, 3, 2));
  tables->boxes = read_pair(own, lesson.points.dim, 1);
  tables->random_pairs = static_cast<int>(own.integer_or("random_pairs", 0, kMostRandomPairs, 0));
  own.refuse_others();
  lesson.tables = std::move(tables);
}

Rows read_pair_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  return read_box_model(task, lesson, complaints,
                        [](TomlTable& table, const BoxPair& like) { return read_pair(table, like.dim, 1); });
}

tl::expected<std::unique_ptr<Subject>, InputError> open_pair(const Lesson& lesson, std::optional<io::PointFile>,
                                                             Clock) {
  const auto& tables = static_cast<const PairTables&>(*lesson.tables);
  return std::make_unique<PairSubject>(tables.boxes, lesson.seed, tables.random_pairs);
}

}  // namespace

const SubjectRow kPairRow{.name = "pair",
                          .table = "boxes",
                          .volumes = &pair_volumes,
                          .methods = &pair_methods,
                          .facts = &pair_facts,
                          .question_kinds = &pair_question_kinds,
                          .read = &read_boxes,
                          .read_model = &read_pair_model,
                          .goals = kPairGoals,
                          .open = &open_pair,
                          .samples = kPairSamples};

std::vector<std::string_view> pair_facts() { return FactList<decltype(PairStep::fact)>::names(); }
std::vector<FactQuestionKind> pair_question_kinds() { return FactList<decltype(PairStep::fact)>::question_kinds(); }

/// Every vertex of the box that the answer is on; for other volumes, every vertex.
std::vector<Index> PairRun::candidates(int i) const {
  std::vector<Index> all;
  const std::vector<Index> named = handles(i);
  for (const auto& side : vertices_)
    for (const CoreVertex& vertex : side)
      if (vertex.handle != kNoIndex) all.push_back(vertex.handle);
  if (!all.empty()) return all;
  for (const int box : {0, 1}) {
    if (std::none_of(named.begin(), named.end(), [&](Index at) { return place_of(dim_, at).box == box; })) continue;
    const std::vector<Index> vertices = vertices_of(dim_, box);
    all.insert(all.end(), vertices.begin(), vertices.end());
  }
  return all;
}

std::unique_ptr<Run> PairSubject::run(const Method& method, std::unique_ptr<Run>) const {
  PairTrace trace = record(method.name, boxes());
  std::vector<RowTruth> truths = row_truths(method.name, boxes(), trace);
  return std::make_unique<PairRun>(dim(), std::move(trace), std::move(truths));
}

std::string PairSubject::opening(const Method& method) const {
  return std::string(method.title) + ", boxes A and B: nothing is known yet. Take the first step.";
}

std::vector<Figure> PairSubject::figures(const View& view) const {
  std::vector<Figure> figures = box_figures(view, boxes());
  add_random_counts(figures, *this);
  return figures;
}
std::vector<Proof> PairSubject::proofs(const View& view) const { return box_proofs(view, boxes()); }

}  // namespace snug::lesson
