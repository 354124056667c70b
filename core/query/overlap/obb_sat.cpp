#include "query/overlap/obb_sat.hpp"

namespace snug::query {

SNUG_OBB_SAT(, float, 2)
SNUG_OBB_SAT(, float, 3)
SNUG_OBB_SAT(, double, 2)
SNUG_OBB_SAT(, double, 3)

}  // namespace snug::query
