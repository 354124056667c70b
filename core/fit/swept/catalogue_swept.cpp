#include <array>

#include "fit/catalogue_rows.hpp"
#include "fit/swept/capsule_pca.hpp"
#include "fit/swept/certify_swept.hpp"
#include "fit/swept/lozenge_pca.hpp"

namespace snug::fit {
namespace {

constexpr auto kCapsule = [](auto p, const Options& options, auto& o) { return capsule_pca(p, options, o); };
constexpr auto kLozenge = [](auto p, const Options&, auto& o) { return lozenge_pca(p, o); };

constexpr std::array kCapsuleRows{
    row<kCapsule>(
        {"capsule", "pca", "PCA", "D. Eberly, 3D Game Engine Design, 2000", kFewPasses, kCapsulePcaPseudocode}),
};
constexpr std::array kLozengeRows{
    row<kLozenge>(
        {"lozenge", "pca", "PCA",
         "E. Larsen, S. Gottschalk, M. C. Lin, D. Manocha, Fast proximity queries with swept sphere volumes, 1999",
         kFixedPasses, kLozengePcaPseudocode}),
};

}  // namespace

std::span<const Algorithm> rows_of(const Capsule<double, 3>*) { return kCapsuleRows; }
std::span<const Algorithm> rows_of(const Lozenge<double, 3>*) { return kLozengeRows; }

}  // namespace snug::fit
