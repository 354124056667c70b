# snug_room(NAME LINKS target... [LITTLE_ARITHMETIC])
#
# One static library snug_NAME of the .cpp files in this folder. Its include path is a folder
# of the build tree that holds a single link, NAME, to this one: a room can name the headers of
# the rooms it links ("geometry/sphere.hpp"), and those of no other.
#
# LITTLE_ARITHMETIC: nobody waits for what it computes. It is compiled quickly, and on the page as small as can be.
set(SNUG_SHARED_HEADER ${PROJECT_SOURCE_DIR}/cmake/shared.hpp)
function(snug_room name)
  cmake_parse_arguments(PARSE_ARGV 1 room "LITTLE_ARITHMETIC" "" "LINKS")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.cpp)
  snug_door(${name} ${CMAKE_CURRENT_SOURCE_DIR} door)
  set(headers $<BUILD_INTERFACE:${door}> $<INSTALL_INTERFACE:include/snug>)
  if(NOT sources) # a room may be headers alone
    add_library(snug_${name} INTERFACE)
    target_include_directories(snug_${name} INTERFACE ${headers})
    target_link_libraries(snug_${name} INTERFACE ${room_LINKS})
    return()
  endif()
  add_library(snug_${name} STATIC ${sources})
  target_include_directories(snug_${name} PUBLIC ${headers})
  target_link_libraries(snug_${name} PUBLIC ${room_LINKS} PRIVATE $<BUILD_INTERFACE:snug_options> $<BUILD_INTERFACE:snug_lean>)
  snug_batches(snug_${name} 8)
  snug_compiled(snug_${name} ${room_LITTLE_ARITHMETIC})
  # What every room's files read is read once for all rooms that are compiled alike.
  if(NOT room_LINKS)
    return() # number, which has no Eigen
  endif()
  set(first SNUG_PRECOMPILED_${room_LITTLE_ARITHMETIC})
  get_property(reused GLOBAL PROPERTY ${first})
  if(reused)
    target_precompile_headers(snug_${name} REUSE_FROM ${reused})
  else()
    target_precompile_headers(snug_${name} PRIVATE ${SNUG_SHARED_HEADER})
    set_property(GLOBAL PROPERTY ${first} snug_${name})
  endif()
endfunction()

# snug_compiled(TARGET LITTLE_ARITHMETIC): on the page every byte is waited for. Where size counts Clang inlines next to
# nothing, which makes each of Eigen's small functions a call with its operands in memory: more code, and up to twenty
# times as slow. Always inlined, they shrink to the few operations they stand for.
function(snug_compiled target little_arithmetic)
  if(EMSCRIPTEN)
    target_compile_options(${target} PRIVATE -Oz -finline-functions
      "-DEIGEN_STRONG_INLINE=inline __attribute__((always_inline))")
  elseif(little_arithmetic)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
endfunction()

# snug_door(NAME FOLDER OUT): an include directory in which NAME leads to FOLDER.
function(snug_door name folder out)
  set(door ${PROJECT_BINARY_DIR}/include/${name})
  file(MAKE_DIRECTORY ${door})
  file(CREATE_LINK ${folder} ${door}/${name} SYMBOLIC)
  set(${out} ${door} PARENT_SCOPE)
endfunction()
