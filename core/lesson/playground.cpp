#include "lesson/playground.hpp"

#include <algorithm>

#include "geometry/convert.hpp"
#include "geometry/random.hpp"
#include "lesson/point_subject.hpp"
#include "query/distance/support_function.hpp"

namespace snug::lesson {
namespace {

/// So many directions find each vertex of a box, and cover a sphere well.
constexpr int kWays = 200;
constexpr std::uint64_t kWaysSeed = 1;

bool is_empty(const auto& volume) {
  if constexpr (query::HasCorners<std::remove_cvref_t<decltype(volume)>>)
    return core_corners(volume, anchor(volume)).empty();
  else return false;
}

/// The volume's farthest points, each once.
template <int Dim>
std::vector<Point3> farthest_points(const fit::Volume3& lifted) {
  std::vector<Point3> points;
  std::visit(
      [&](const auto& kind) {
        const auto volume = converted<double, Dim>(kind);
        if (is_empty(volume)) return;
        Random random(kWaysSeed);
        for (int i = 0; i < kWays; ++i) {
          Vector<double, Dim> way;
          for (int k = 0; k < Dim; ++k) way[k] = random.between(-1, 1);
          Point3 point = Point3::Zero();
          point.template head<Dim>() = query::support(volume, way);
          if (std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
        }
      },
      lifted);
  return points;
}

}  // namespace

std::optional<io::PointFile> points_to_try(const Session& session) {
  const Subject& subject = session.stage().subject();
  io::PointFile file{.dim = session.stage().subject().dim(), .points = {}, .triangles = {}};
  if (const AnyPointSet* points = subject.points()) {
    file.points = all_points(*points);
    const auto triangles = subject.with_points()->triangles();
    file.triangles.assign(triangles.begin(), triangles.end());
  } else if (const HasVolumes* const own = subject.with_volumes(); own != nullptr && !own->volumes().empty()) {
    const std::vector<fit::Volume3> volumes = own->volumes();
    file.points = file.dim == 2 ? farthest_points<2>(volumes.front()) : farthest_points<3>(volumes.front());
  }
  return file.points.empty() ? std::nullopt : std::optional(std::move(file));
}

std::string_view playground_text(const Session& session) {
  if (session.stage().subject().points() != nullptr) return "Try every volume on these points";
  return points_to_try(session) ? "Try every volume on this body" : "Every volume, side by side";
}

std::string way_back_text(std::string_view title) { return "Back to " + std::string(title); }

}  // namespace snug::lesson
