#include "hierarchy/build.hpp"

namespace snug::hierarchy {

SNUG_ALL_TREES()

}  // namespace snug::hierarchy
