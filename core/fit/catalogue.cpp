#include "fit/catalogue.hpp"

#include <algorithm>
#include <vector>

#include "fit/catalogue_rows.hpp"
#include "geometry/hull_measure.hpp"
#include "geometry/kdop_measure.hpp"

namespace snug::fit {
namespace {

std::vector<Algorithm> all_rows() {
  std::vector<Algorithm> all;
  const auto add = [&](std::span<const Algorithm> rows) { all.insert(all.end(), rows.begin(), rows.end()); };
  const auto add_each = [&]<class... Kinds>(const std::variant<Kinds...>*) {
    (add(rows_of(static_cast<const Kinds*>(nullptr))), ...);
  };
  add_each(static_cast<const Volume3*>(nullptr));
  return all;
}

}  // namespace

std::span<const Algorithm> algorithms() {
  static const std::vector<Algorithm> all = all_rows();
  return all;
}

std::span<const Algorithm> algorithms_of(std::string_view volume) {
  const auto of_it = [&](const Algorithm& algorithm) { return algorithm.volume == volume; };
  const auto all = algorithms();
  const auto first = std::find_if(all.begin(), all.end(), of_it);
  return {first, std::find_if_not(first, all.end(), of_it)};
}

const Algorithm* find_algorithm(std::string_view volume, std::string_view name) {
  for (const Algorithm& algorithm : algorithms_of(volume))
    if (algorithm.name == name) return &algorithm;
  return nullptr;
}

const Algorithm* exact_algorithm(std::string_view volume) {
  // Three algorithms find the smallest sphere: this is the fastest of them.
  if (volume == "sphere") return find_algorithm(volume, "pivot");
  for (const Algorithm& algorithm : algorithms_of(volume))
    if (algorithm.exact) return &algorithm;
  return nullptr;
}

Recording Algorithm::record(const AnyPointSet& points, const Options& options, Recording room) const {
  Recording recording{.steps = std::move(room.steps)};
  recording.steps.clear();
  const Watched watched = watch(points, options, [&](Step3&& step, const OperationCounts& counts) {
    recording.steps.push_back({std::move(step), counts});
  });
  recording.result = watched.result;
  recording.counts = watched.counts;
  recording.certificate = watched.certificate;
  return recording;
}

namespace {

/// The measure of a volume that was lifted from that dimension.
template <int Dim>
struct Measure {
  double operator()(const Aabb<double, 3>& box) const { return (box.max - box.min).template head<Dim>().prod(); }
  double operator()(const Obb<double, 3>& box) const { return (2 * box.half_extents).template head<Dim>().prod(); }
  template <class VolumeType>
  double operator()(const VolumeType& volume) const {
    if constexpr (Dim == 3) return measure(volume);
    else return measure(converted<double, Dim>(volume));
  }
};

}  // namespace

double measure_of(const Volume3& volume, int dim) {
  return dim == 2 ? std::visit(Measure<2>{}, volume) : std::visit(Measure<3>{}, volume);
}

double size_of(const Volume3& volume, int dim) {
  const auto* ball = std::get_if<Sphere3>(&volume);
  return ball != nullptr ? ball->radius : measure_of(volume, dim);
}

int dim_of(const AnyPointSet& points) {
  return std::visit([]<class Scalar, int Dim>(const PointSet<Scalar, Dim>&) { return Dim; }, points);
}

Index count_of(const AnyPointSet& points) {
  return std::visit([](const auto& set) { return set.size(); }, points);
}

Vector<double, 3> point_of(const AnyPointSet& points, Index i) {
  return std::visit([&]<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) { return lift<Scalar, Dim>(set[i]); },
                    points);
}

}  // namespace snug::fit
