#include "query/overlaps.hpp"

namespace snug::query {

template <class Scalar, int Dim>
OverlapResult<Scalar, Dim> test_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return std::visit([](const auto& x, const auto& y) { return test_overlap(x, y); }, a, b);
}

template <class Scalar, int Dim>
bool overlaps(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return std::visit([](const auto& x, const auto& y) { return overlaps(x, y); }, a, b);
}

#define SNUG_INSTANTIATE(Scalar, Dim)                                                                                  \
  template OverlapResult<Scalar, Dim> test_overlap(const Volume<Scalar, Dim>&, const Volume<Scalar, Dim>&);            \
  template bool overlaps(const Volume<Scalar, Dim>&, const Volume<Scalar, Dim>&);
SNUG_INSTANTIATE(float, 2)
SNUG_INSTANTIATE(float, 3)
SNUG_INSTANTIATE(double, 2)
SNUG_INSTANTIATE(double, 3)
#undef SNUG_INSTANTIATE

}  // namespace snug::query
