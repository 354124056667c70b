#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/kdop/certify_kdop.hpp"
#include "fit/kdop/kdop_fit.hpp"

namespace snug::fit {
namespace {

/// Each k belongs to one dimension. The row says so, so that no caller asks for it in the other.
template <int kK>
constexpr auto kFitter = []<class Scalar, int Dim>(PointSpan<Scalar, Dim> p, const Options&, auto& o) {
  return kdop_fit(p, kdop_axes<Dim>(kK).empty() ? 2 * Dim : kK, o);
};

constexpr std::string_view kKlosowski =
    "J. T. Klosowski, M. Held, J. S. B. Mitchell, H. Sowizral, K. Zikan, Efficient collision detection using bounding "
    "volume hierarchies of k-DOPs, 1998";

template <int kK>
constexpr Algorithm kdop_row(std::string_view name, std::string_view title, bool plane, bool space) {
  return row<kFitter<kK>, true>({.volume = "kdop",
                                 .name = name,
                                 .title = title,
                                 .source = kKlosowski,
                                 .theory = {"O(k n)", growth::linear, true, kKlosowski},
                                 .pseudocode = kKdopPseudocode,
                                 .plane = plane,
                                 .space = space});
}

constexpr std::array kKdopRows{
    kdop_row<4>("k4", "4-DOP", true, false),    kdop_row<6>("k6", "6-DOP", true, true),
    kdop_row<8>("k8", "8-DOP", true, false),    kdop_row<14>("k14", "14-DOP", false, true),
    kdop_row<18>("k18", "18-DOP", false, true), kdop_row<26>("k26", "26-DOP", false, true),
};

}  // namespace

std::span<const Algorithm> rows_of(const Kdop<double, 3>*) { return kKdopRows; }

}  // namespace snug::fit
