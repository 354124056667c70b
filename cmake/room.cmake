# snug_room(NAME LINKS target...)
#
# One static library snug_NAME of the .cpp files in this folder. Its include path is a folder
# of the build tree that holds a single link, NAME, to this one: a room can name the headers of
# the rooms it links ("geometry/sphere.hpp"), and those of no other.
set(SNUG_SHARED_HEADER ${PROJECT_SOURCE_DIR}/cmake/shared.hpp)
set(SNUG_ROOM_OPTIONS -Os -finline-functions)
set(SNUG_PAGE_OPTIONS ${SNUG_ROOM_OPTIONS}) # a room may set others
function(snug_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "" "" "LINKS")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  if(NOT sources) # a room may be headers alone
    set(sources ${PROJECT_BINARY_DIR}/include/${name}/nothing.cpp)
    file(CONFIGURE OUTPUT ${sources} CONTENT "" @ONLY)
  endif()
  add_library(snug_${name} STATIC ${sources})
  snug_door(${name} ${CMAKE_CURRENT_SOURCE_DIR} door)
  target_include_directories(snug_${name} PUBLIC ${door})
  target_link_libraries(snug_${name} PUBLIC ${room_LINKS} PRIVATE snug_options snug_lean)
  snug_batches(snug_${name} 8)
  # On the page every byte is waited for. Emscripten has Clang inline nothing where size counts, which makes each of Eigen's small
  # functions a call: twice the code, and thirty times as slow.
  if(EMSCRIPTEN)
    target_compile_options(snug_${name} PRIVATE ${SNUG_PAGE_OPTIONS})
  endif()
  # What every room's files read is read once for all rooms, but for one that is compiled in another way.
  if(NOT room_LINKS OR (EMSCRIPTEN AND NOT SNUG_PAGE_OPTIONS STREQUAL SNUG_ROOM_OPTIONS))
    return() # trace, which has no Eigen, and such
  elseif(name STREQUAL geometry)
    target_precompile_headers(snug_${name} PRIVATE ${SNUG_SHARED_HEADER})
  else()
    target_precompile_headers(snug_${name} REUSE_FROM snug_geometry)
  endif()
endfunction()

# snug_door(NAME FOLDER OUT): an include directory in which NAME leads to FOLDER.
function(snug_door name folder out)
  set(door ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${door})
  file(CREATE_LINK ${folder} ${door}/${name} SYMBOLIC)
  set(${out} ${door} PARENT_SCOPE)
endfunction()
