# How everything of ours is compiled. Link snug_options and have it all.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug or Release" FORCE)
endif()

# Compilers spend their time on the headers here, Eigen's above all: files of a room are compiled several at once, and
# what they share is read and instantiated once. No two of a room share a name in their unnamed namespaces, therefore.
# The room fit takes 231 seconds of a processor so, and 269 file by file (release, GCC 12).
# The presets ask for it.
option(SNUG_BATCHES "Compile the files of a room several at once" OFF)
# snug_batches(TARGET SIZE): so many at once.
function(snug_batches target size)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${SNUG_BATCHES} UNITY_BUILD_BATCH_SIZE ${size})
endfunction()

find_program(CCACHE ccache)
if(CCACHE)
  # Without sloppiness it keeps nothing of what uses a precompiled header. One of other comments is another one: compilers
  # know by a file's bytes what such a header has read already. The name keeps apart what was kept without them.
  set(launcher ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_COMMENTS=1 CCACHE_NAMESPACE=comments)
  if(EMSCRIPTEN)
    list(APPEND launcher CCACHE_COMPILERTYPE=clang) # it does not know emcc by its name
  endif()
  list(APPEND launcher ${CCACHE})
  set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
  set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
  # What Clang precompiles names the clone that it lies in, and so nothing that uses it would be shared with another clone.
  # It reads the same headers each time instead: four of wasm's files take 60 seconds of a processor so, and 54 with them
  # precompiled; what another clone has built takes next to none. The ending .read is one that Clang does not look for.
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    set(CMAKE_PCH_EXTENSION .read)
    set(CMAKE_CXX_COMPILE_OPTIONS_CREATE_PCH -x c++-header -E -include <PCH_HEADER>)
    set(CMAKE_CXX_COMPILE_OPTIONS_USE_PCH -include <PCH_HEADER>)
    file(GLOB_RECURSE precompiled ${PROJECT_BINARY_DIR}/cmake_pch.hxx.pch) # left by an older build: Clang would use it
    if(precompiled)
      file(REMOVE ${precompiled})
    endif()
  endif()
endif()

add_library(snug_options INTERFACE)
target_compile_options(snug_options INTERFACE
  -ffp-contract=off # a fused multiply-add rounds once where wasm rounds twice: other bits
  # GCC 12 vectorises (double)(float)x to x, two at a time: a rounding that never happens. Tested by
  # "a double rounded to float stays rounded".
  -fno-tree-slp-vectorize
  -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
  -Wno-missing-field-initializers # designated initialisers leave the rest at their defaults
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> # ccache wants it
  # Doctest and debuggers are told each file's name from the clone's root on, so that clones share what is compiled. Not
  # for GCC: its precompiled headers would differ between clones.
  $<$<CXX_COMPILER_ID:Clang>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}/=>
  # GCC 12 mistakes string's operator+ (its bug 105329), and variants in optionals that are moved.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow
    -Wno-stringop-overread>
  # A file that is compiled with others is included, and what it includes may well be its own.
  $<$<AND:$<BOOL:${SNUG_BATCHES}>,$<CXX_COMPILER_ID:GNU>>:-Wno-subobject-linkage>
  $<$<BOOL:${SNUG_WERROR}>:-Werror>)

# Rooms report errors as values, and pay for neither exceptions nor type information.
add_library(snug_lean INTERFACE)
target_compile_options(snug_lean INTERFACE -fno-exceptions -fno-rtti)

if(EMSCRIPTEN)
  target_compile_options(snug_options INTERFACE -msimd128)
  # From 3.1.27 on a stack has 64 kB, too little for the recursion that a lesson lets go deep (kWelzlDepthLimit).
  if(EMSCRIPTEN_VERSION VERSION_GREATER_EQUAL 3.1.27)
    target_link_options(snug_options INTERFACE -sSTACK_SIZE=5MB)
  endif()
  # A Node that is not Debian's own does not look where Debian's emscripten keeps acorn.
  if(NOT DEFINED ENV{NODE_PATH} AND EXISTS /usr/share/nodejs/acorn)
    set_property(GLOBAL PROPERTY RULE_LAUNCH_LINK
      "${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs")
  endif()
endif()
