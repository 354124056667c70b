// Counts over random pairs of boxes, by the real test, beside the pair on the stage.
#include "lesson/subjects/pair/random_pairs.hpp"

#include <cmath>

namespace snug::lesson {

const cost::AxisCounts* PairSubject::random_counts() const {
  if (random_pairs_ == 0) return nullptr;
  if (counted_ == nullptr || counted_->seed != origin_.seed) {
    const auto count = dim() == 2 ? &cost::count_axes<2> : &cost::count_axes<3>;
    counted_ = std::make_shared<const Counted>(Counted{origin_.seed, count(random_pairs_, origin_.seed)});
  }
  return &counted_->counts;
}

void add_random_counts(std::vector<Figure>& figures, const PairSubject& subject) {
  const cost::AxisCounts* counts = subject.random_counts();
  if (counts == nullptr) return;
  const auto add = [&](const char* name, const char* key, int count) {
    figures.push_back(
        {name, std::string(kRandomFigure) + key, count_text(count) + " pairs", static_cast<double>(count), "pairs"});
  };
  add("Random pairs", "pairs", counts->pairs);
  add("Random pairs that overlap", "overlap", counts->overlap);
  add("Random pairs that are apart", "apart", counts->pairs - counts->overlap);
  add("Random pairs that only an edge axis separates", "edges",
      subject.dim() == 2 ? counts->edges_alone<2>() : counts->edges_alone<3>());
  add("Random pairs that the first axis separates", "first", counts->first[0]);
  const double rows = static_cast<double>(axis_names(subject.dim()).size()), all = rows * counts->pairs;
  const double mean = static_cast<double>(counts->tests) / counts->pairs;
  const double saved = std::round(100 * (1 - static_cast<double>(counts->tests) / all));
  figures.push_back({"Axes tested until the first gap, mean", std::string(kRandomFigure) + "tests",
                     number_text(mean) + " axes", mean, "axes"});
  figures.push_back(
      {"Axes saved by the first gap", std::string(kRandomFigure) + "saved", plain_number(saved) + " %", saved, "%"});
}

}  // namespace snug::lesson
