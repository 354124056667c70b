#include "measure/rounding.hpp"

#include <cmath>

#include "geometry/tolerance.hpp"

namespace snug::cost {

double Rounding::of(int lengths) const { return lengths * length * std::pow(size, lengths - 1); }

double Rounding::noise(int lengths) const { return tolerance::kKnownSize * of(lengths); }

std::optional<double> Rounding::ratio(double value, double least, int lengths) const {
  if (!(least > noise(lengths))) return std::nullopt;
  if (value < least && value >= least - of(lengths)) return 1;
  return value / least;
}

int lengths_of_size(std::string_view volume, int dim) { return volume == "sphere" ? 1 : dim; }

Rounding rounding_of(const AnyPointSet& points) {
  return std::visit(
      []<class Scalar, int Dim>(const PointSet<Scalar, Dim>& set) -> Rounding {
        Vector<Scalar, Dim> min = set[0], max = set[0];
        for (const auto& point : set.span()) {
          min = min.cwiseMin(point);
          max = max.cwiseMax(point);
        }
        const double size = (max.template cast<double>() - min.template cast<double>()).norm();
        const double farthest = std::max<double>(min.cwiseAbs().maxCoeff(), max.cwiseAbs().maxCoeff());
        return {tolerance::kVolumeLength<Scalar> * (farthest + size), size};
      },
      points);
}

}  // namespace snug::cost
