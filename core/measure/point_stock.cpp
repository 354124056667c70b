#include "measure/point_stock.hpp"

#include <utility>

#include "fit/catalogue.hpp"
#include "measure/sample.hpp"

namespace snug::cost {
namespace {

/// About a millisecond's work in a browser.
constexpr Index kPiece = 10'000;

template <class Points>
Points empty_points(int dim, bool single) {
  if (single) return dim == 2 ? Points(std::in_place_index<2>) : Points(std::in_place_index<3>);
  return dim == 2 ? Points(std::in_place_index<0>) : Points(std::in_place_index<1>);
}

}  // namespace

PointStock::PointStock(std::string kind, int dim, bool single, std::uint64_t seed)
    : open_([kind = std::move(kind), dim, seed](Index n) { return *generate_stream(kind, n, dim, seed); }),
      none_(empty_points<Points>(dim, single)) {}

PointStock::PointStock(const AnyPointSet& points, std::uint64_t seed)
    : whole_(&points), open_([&points, seed](Index n) { return sample_stream(points, n, seed); }),
      none_(empty_points<Points>(fit::dim_of(points), points.index() >= 2)) {}

const AnyPointSet* PointStock::find(Index n) const {
  if (whole_ != nullptr && n >= fit::count_of(*whole_)) return whole_;
  const auto found = kept_.find(n);
  return found == kept_.end() ? nullptr : &found->second;
}

void PointStock::begin(Index n) {
  making_ = n;
  next_ = open_(n);
  made_ = none_;
  std::visit([&](auto& points) { points.reserve(n); }, made_);
}

bool PointStock::make(Index n) {
  if (find(n) != nullptr) return true;
  if (making_ != n) begin(n);
  return std::visit(
      [&]<class Scalar, int Dim>(std::vector<Vector<Scalar, Dim>>& points) {
        for (Index i = 0; i < kPiece && static_cast<Index>(points.size()) < n; ++i)
          points.push_back(next_().template head<Dim>().template cast<Scalar>());
        if (static_cast<Index>(points.size()) < n) return false;
        kept_.emplace(n,
                      *PointSet<Scalar, Dim>::make(std::move(points)));  // never refused: of unit size, or from a set
        making_ = 0;
        return true;
      },
      made_);
}

const AnyPointSet& PointStock::of(Index n) {
  while (!make(n)) {
  }
  return *find(n);
}

}  // namespace snug::cost
