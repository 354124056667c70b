# The core for other programs: find_package(snug), target snug::core, headers <snug/fit/...>. example/ shows it.
include(CMakePackageConfigHelpers)

set(rooms trace number geometry io query fit hierarchy measure physics scene)
set(targets snug_core snug_eigen snug_expected)
add_library(snug_core INTERFACE)
target_compile_features(snug_core INTERFACE cxx_std_20)
# The headers hold fitters, which promise containment of the bits that were computed as written (cmake/options.cmake).
target_compile_options(snug_core INTERFACE -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_include_directories(snug_core INTERFACE $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
foreach(room IN LISTS rooms)
  list(APPEND targets snug_${room})
  target_link_libraries(snug_core INTERFACE snug_${room})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/snug
    COMPONENT development FILES_MATCHING PATTERN *.hpp)
endforeach()
foreach(target IN LISTS targets)
  string(REPLACE snug_ "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
endforeach()

set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/snug)
install(TARGETS ${targets} EXPORT snug ARCHIVE COMPONENT development)
install(EXPORT snug NAMESPACE snug:: FILE snug-targets.cmake DESTINATION ${folder} COMPONENT development)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/snug-config-version.cmake
  COMPATIBILITY SameMinorVersion) # before 1.0 each may change names
install(FILES snug-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/snug-config-version.cmake DESTINATION ${folder}
  COMPONENT development)
install(DIRECTORY example DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT development)
