#include "hierarchy/build.hpp"

namespace snug::hierarchy {

SNUG_TREES(, float, 2)
SNUG_TREES(, float, 3)
SNUG_TREES(, double, 2)
SNUG_TREES(, double, 3)

}  // namespace snug::hierarchy
