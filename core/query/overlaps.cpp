#include "query/overlaps.hpp"

#include "query/overlaps_any.hpp"

namespace snug::query {

template <class Scalar, int Dim>
OverlapResult<Scalar, Dim> test_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  Ignore ignore;
  return test_any_overlap(a, b, ignore);
}

template <class Scalar, int Dim>
bool overlaps(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return test_overlap(a, b).overlap;
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
