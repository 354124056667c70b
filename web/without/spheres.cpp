// A program without the algorithms that fit spheres: see snug_program() in CMakeLists.txt.
#define SNUG_ALL_ROWS false  // as for the page's rooms
#include "fit/catalogue_rows.hpp"

namespace snug::fit {

std::span<const Algorithm> sphere_rows() { return {}; }

}  // namespace snug::fit
