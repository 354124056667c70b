# What `cpack` makes of the components: the Debian packages snug (command and lessons), snug-window and libsnug-dev, and an
# archive with the programs and their libraries that runs from any folder. `./run packages` makes them all.
set(SNUG_MAINTAINER "The Snug authors <snug@invalid.invalid>" CACHE STRING "Whom the Debian packages name")
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY TRUE) # else the tests are built for it

set(CPACK_GENERATOR DEB TZST)
set(CPACK_PACKAGE_VENDOR "The Snug authors")
set(CPACK_PACKAGE_CONTACT ${SNUG_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "bounding volumes: fitted, tested, measured and taught")
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_STRIP_FILES TRUE)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/package_each.cmake)

set(CPACK_ARCHIVE_FILE_NAME snug-${PROJECT_VERSION}-linux-${CMAKE_SYSTEM_PROCESSOR})

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
set(CPACK_DEBIAN_CLI_PACKAGE_NAME snug)
set(CPACK_DEBIAN_CLI_PACKAGE_RECOMMENDS snug-window)
set(CPACK_DEBIAN_CLI_PACKAGE_SUGGESTS "libsnug-dev, g++, cmake, make, doctest-dev, nodejs") # what students' code needs
set(CPACK_COMPONENT_CLI_DESCRIPTION
  "The command fits bounding volumes to point files, tests and measures them,\nand has the lessons. Its window is in snug-window.")
set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME snug-window)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "snug (= ${PROJECT_VERSION}), libgl1") # libepoxy opens it without naming it
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "libdbus-1-3, xdg-desktop-portal, xclip | wl-clipboard") # it runs without them
set(CPACK_COMPONENT_WINDOW_DESCRIPTION "Lessons in which points are dragged and each algorithm's steps are watched.")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsnug-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libexpected-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Headers and static libraries of the core, with an example.")

# What only Debian's packages have: a changelog each, a copyright for those that have no other, zsh's file in its place.
string(TIMESTAMP now "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(pair IN ITEMS cli:snug window:snug-window development:libsnug-dev)
  string(REPLACE : ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  string(TOUPPER ${component} upper)
  set(changelog ${CMAKE_CURRENT_BINARY_DIR}/${package}/changelog)
  file(CONFIGURE OUTPUT ${changelog} @ONLY CONTENT "${package} (@PROJECT_VERSION@) unstable; urgency=medium

  * Packaged from its source, whose log says what has changed.

 -- @SNUG_MAINTAINER@  @now@
")
  execute_process(COMMAND ${SNUG_GZIP} -knf9 ${changelog} COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${changelog}.gz DESTINATION share/doc/${package} COMPONENT deb_${component} EXCLUDE_FROM_ALL)
  if(NOT component STREQUAL cli)
    install(FILES copyright DESTINATION share/doc/${package} COMPONENT deb_${component} EXCLUDE_FROM_ALL)
  endif()
  foreach(part IN ITEMS ${component} deb_${component})
    string(TOUPPER ${part} part)
    set(CPACK_COMPONENT_${part}_GROUP ${component})
  endforeach()
  set(CPACK_COMPONENT_GROUP_${upper}_DESCRIPTION ${CPACK_COMPONENT_${upper}_DESCRIPTION})
endforeach()
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/snug.zsh DESTINATION share/zsh/vendor-completions RENAME _snug
  COMPONENT deb_cli EXCLUDE_FROM_ALL)
include(CPack)
