#include "query/cull/classify.hpp"

namespace snug::query {

SNUG_CLASSIFY(, float, 2)
SNUG_CLASSIFY(, float, 3)
SNUG_CLASSIFY(, double, 2)
SNUG_CLASSIFY(, double, 3)

}  // namespace snug::query
