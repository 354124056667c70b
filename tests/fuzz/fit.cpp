// libFuzzer: every fitter on any few points, held to its certificate.
#include "fit/catalogue.hpp"
#include "fuzz/bytes.hpp"

namespace {

using namespace snug;
using fuzz::require;

constexpr unsigned kMostPoints = 12;
constexpr std::int64_t kMostSteps = 20'000;  // for so few points; the exact box takes the most

void check(const fit::Algorithm& algorithm, const AnyPointSet& points) {
  const fit::Watched run = algorithm.watch(points, {}, {});
  require(run.steps > 0 && run.steps <= kMostSteps);
  if (algorithm.naive) return;  // rounding may break its promises, but not the program
  const fit::Certificate& certificate = run.certificate;
  require(certificate.contains && certificate.outside == 0 && certificate.max_outside == 0);
  require(certificate.on_boundary);
  require(certificate.optimal == (algorithm.exact ? std::optional(true) : std::nullopt));
  require(std::isfinite(fit::size_of(run.result.volume, fit::dim_of(points))));
  require(algorithm.fit(points, {}).support == run.result.support);  // being watched changes nothing
}

template <class Scalar, int Dim>
void check_all(fuzz::Bytes& bytes) {
  const auto points = PointSet<Scalar, Dim>::make(bytes.cloud<Scalar, Dim>(kMostPoints));
  require(points.has_value());
  const AnyPointSet set = *points;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (fit::takes(algorithm, Dim) && fit::count_of(set) <= algorithm.max_points) check(algorithm, set);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  fuzz::Bytes bytes(data, size);
  switch (bytes.below(4)) {
    case 0: check_all<double, 2>(bytes); break;
    case 1: check_all<double, 3>(bytes); break;
    case 2: check_all<float, 2>(bytes); break;
    default: check_all<float, 3>(bytes); break;
  }
  return 0;
}
