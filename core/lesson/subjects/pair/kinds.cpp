// Volumes whose kinds the student chooses: what a newly chosen one looks like, and how both are kept as rows.
#include <algorithm>
#include <cmath>

#include "geometry/kdop.hpp"
#include "geometry/turn.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "lesson/volume_rows.hpp"

namespace snug::lesson {
namespace {

/// The points of a usual hull, and of a usual k-DOP, around the origin.
std::vector<Point3> usual_points(int dim) {
  if (dim == 2) return {{0.9, 0.1, 0}, {0.3, 0.8, 0}, {-0.7, 0.55, 0}, {-0.8, -0.4, 0}, {0.2, -0.8, 0}};
  return {{0.9, 0.1, 0.2}, {0.1, 0.9, -0.1}, {-0.8, 0.3, 0.4}, {-0.3, -0.8, 0.3}, {0.1, 0.1, 0.9}, {0.2, -0.2, -0.8}};
}

Kdop<double, 3> usual_kdop(int dim) {
  const auto around = [&]<int Dim>(std::integral_constant<int, Dim>, int k) {
    Kdop<double, 3> kdop{.k = k};
    const auto axes = kdop_axes<Dim>(k);
    for (std::size_t i = 0; i < axes.size(); ++i)
      for (const Point3& p : usual_points(dim)) {
        const double along = project<double, Dim>(axes[i], p.head<Dim>());
        kdop.min[i] = std::min(kdop.min[i], along), kdop.max[i] = std::max(kdop.max[i], along);
      }
    return kdop;
  };
  return dim == 2 ? around(std::integral_constant<int, 2>(), 8) : around(std::integral_constant<int, 3>(), 14);
}

/// A volume of a kind, around the origin and about as large as 1.
fit::Volume3 usual_volume(std::string_view kind, int dim) {
  const double depth = dim == 2 ? 0 : 0.5;
  if (kind == "sphere") return Sphere<double, 3>{Point3::Zero(), 0.75};
  if (kind == "aabb") return Aabb<double, 3>{{-0.85, -0.55, -depth}, {0.85, 0.55, depth}};
  if (kind == "obb") return Obb<double, 3>{Point3::Zero(), snug::turn(Point3::UnitZ(), 0.45), {0.9, 0.45, depth}};
  if (kind == "capsule") return Capsule<double, 3>{{-0.5, -0.4, 0}, {0.5, 0.4, 0}, 0.35};
  if (kind == "lozenge") return Lozenge<double, 3>{{-0.35, -0.5, 0}, {Point3(1, 0.4, 0), Point3(-0.24, 0.6, 0)}, 0.25};
  if (kind == "kdop") return usual_kdop(dim);
  return ConvexHull<double, 3>{};  // its points follow
}

/// A volume of another kind, where that one is.
HeldVolume with_kind(const HeldVolume& before, std::size_t kind) {
  if (kind == before.volume.index()) return before;
  HeldVolume held{.volume = usual_volume(kVolumeNames[kind], before.dim), .dim = before.dim, .knob = before.knob};
  if (kVolumeNames[kind] == "hull") held.points = usual_points(before.dim);
  const Point3 to = at_handle(before, {}) - (held.points.empty() ? at_handle(held, {}) : Point3(Point3::Zero()));
  return placed(held, Matrix<double, 3>::Identity(), to);  // computes the hull
}

/// Gives a volume as many points or bounds as a row has numbers for.
void fit_to(HeldVolume& held, std::size_t numbers) {
  if (!held.points.empty())
    held.points.resize(std::max<std::size_t>(1, numbers / static_cast<std::size_t>(held.dim)), Point3::Zero());
  auto* kdop = std::get_if<Kdop<double, 3>>(&held.volume);
  if (kdop == nullptr || numbers > 2 * static_cast<std::size_t>(kMostSlabs<3>)) return;
  const auto k = static_cast<int>(numbers);
  if (held.dim == 2 ? !kdop_axes<2>(k).empty() : !kdop_axes<3>(k).empty()) kdop->k = k;
}

/// The volume of a row that begins with its kind.
tl::expected<HeldVolume, InputError> of_any_kind(const HeldVolume& before, std::span<const double> row) {
  const double kind = row.empty() ? -1 : row.front();
  if (!(kind >= 0 && kind < static_cast<double>(kVolumeNames.size())) || kind != std::floor(kind))
    return tl::unexpected(InputError{.what = "there is no such kind of volume"});
  HeldVolume like = with_kind(before, static_cast<std::size_t>(kind));
  fit_to(like, row.size() - 1);
  return with_row(like, row.subspan(1));
}

}  // namespace

VolumePair with_kinds(VolumePair pair, const Kinds& kinds) {
  for (const std::size_t side : {0, 1}) pair.held[side] = with_kind(pair.held[side], kinds[side]);
  return pair;
}

Rows rows_of(const VolumePair& pair) {
  Rows rows{row_of(pair.held[0]), row_of(pair.held[1])};
  for (const std::size_t side : {0, 1})
    if (pair.any) rows[side].insert(rows[side].begin(), static_cast<double>(kinds_of(pair)[side]));
  return rows;
}

tl::expected<VolumePair, InputError> with_rows(VolumePair pair, const Rows& rows) {
  if (rows.size() != 2) return tl::unexpected(InputError{.what = "there must be two volumes"});
  for (const std::size_t side : {0, 1}) {
    auto held = pair.any ? of_any_kind(pair.held[side], rows[side]) : with_row(pair.held[side], rows[side]);
    if (!held) return tl::unexpected(std::move(held.error()));
    pair.held[side] = *std::move(held);
  }
  if (kinds_of(pair)[0] > kinds_of(pair)[1])
    return tl::unexpected(InputError{.what = "the first volume must be of the kind that comes first"});
  return pair;
}

}  // namespace snug::lesson
