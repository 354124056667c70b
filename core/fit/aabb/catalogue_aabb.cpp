#include <array>

#include "fit/aabb/aabb_min_max.hpp"
#include "fit/aabb/certify_aabb.hpp"
#include "fit/catalogue_rows.hpp"

namespace snug::fit {
namespace {

constexpr auto kMinMax = [](auto p, const Options&, auto& o) { return aabb_min_max(p, o); };

constexpr std::array kAabbRows{
    row<kMinMax, true>(
        {"aabb", "min_max", "Min and max", kEricson, {"O(n)", growth::linear, true, kEricson}, kAabbMinMaxPseudocode}),
};

}  // namespace

std::span<const Algorithm> rows_of(const Aabb<double, 3>*) { return kAabbRows; }

}  // namespace snug::fit
