// The numbers on which a sphere's certificate is decided, without any rounding, so that a reader can check each line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/rounded.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "number/dyadic.hpp"

namespace snug::lesson {

/// A number as it is, to the last bit: a whole number times a power of two.
struct ExactNumber {
  std::string whole;  // "−1,234,567", "0"
  std::string power;  // " × 2⁻⁴⁸"; empty for 2⁰
  int sign = 0;       // -1, 0 or +1
  [[nodiscard]] std::string text() const { return whole + power; }
};
[[nodiscard]] ExactNumber exact_number(const Dyadic& value);

struct CertificateLines {
  /// The first line, of a point: |p − c|² − r², above 0 where the point is outside.
  struct Containment {
    Index point = kNoIndex;
    ExactNumber excess;
  };
  /// The second and third, of a point of the support set.
  struct Support {
    Index point = kNoIndex;
    double ulps = 0;               // how far it is from the boundary, in ulps of the radius; above 0 outside
    std::optional<double> weight;  // none if the support set is affinely dependent
  };

  std::vector<Containment> contained;  // the farthest points, by falling excess
  Index others = 0, others_outside = 0;
  std::vector<Support> support;
  // Where there are weights: how far their sum is from 1, and their mean of the support set from the centre, along each
  // axis.
  std::optional<ExactNumber> sum_off;
  std::vector<ExactNumber> mean_off;
  std::optional<fit::Rounded> rounded;  // in float: what lines about the rounded points leave out
};

/// Those of a finished run; none if its result is no sphere. given: its points before they were rounded to float;
/// null if they are not known.
[[nodiscard]] std::optional<CertificateLines> certificate_lines(const FitRun& run, const AnyPointSet* given = nullptr);

/// Which points the lines are about, where the run is in float: "These points are rounded to float, …".
[[nodiscard]] std::string rounded_text(const fit::Rounded& rounded);

/// The ulps by which the radius is larger than the farthest point's distance, once that is rounded to the nearest
/// number of its scalar. A certified radius is widened by so much.
[[nodiscard]] double widened_ulps(const AnyPointSet& points, const fit::Sphere3& sphere);

}  // namespace snug::lesson
