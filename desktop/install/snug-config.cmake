include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4)
find_dependency(tl-expected)
include(${CMAKE_CURRENT_LIST_DIR}/snug-targets.cmake)
