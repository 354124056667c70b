#include "query/overlap/overlaps.hpp"

#include "query/overlap/overlaps_any.hpp"

namespace snug::query {

template <class Scalar, int Dim>
OverlapResult<Scalar, Dim> test_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  Ignore ignore;
  return test_any_overlap(a, b, ignore);
}

namespace {

template <class Scalar, int Dim>
bool own_test_overlap(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  return std::visit(
      [&](const auto& x) {
        return std::visit(
            [&]<class B>(const B& y) {
              using A = std::decay_t<decltype(x)>;
              if constexpr (VolumeKind<A>::kIndex <= VolumeKind<B>::kIndex && kPairTest<A, B> != PairTest::kGjk)
                return overlap_in_order(x, y);
              else return false;  // cannot happen
            },
            b);
      },
      a);
}

}  // namespace

template <class Scalar, int Dim>
bool overlaps(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b) {
  if (a.index() > b.index()) return overlaps(b, a);
  if (kPairTests[a.index()][b.index()] != PairTest::kGjk) return own_test_overlap(a, b);
  Ignore ignore;  // compiled once for all pairs that GJK tests
  return swapped<Scalar, Dim>(a, b) ? any_pair::by_gjk(b, a, ignore, true).overlap
                                    : any_pair::by_gjk(a, b, ignore, true).overlap;
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
