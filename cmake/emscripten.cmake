# Toolchain file: emcc wherever it is (a distribution's package, or emsdk on PATH).
find_program(SNUG_EM_CONFIG em-config NO_CMAKE_FIND_ROOT_PATH)
if(NOT SNUG_EM_CONFIG)
  message(FATAL_ERROR "emcc not found: ./run installs it, or put an emsdk on PATH.")
endif()
execute_process(COMMAND ${SNUG_EM_CONFIG} EMSCRIPTEN_ROOT
  OUTPUT_VARIABLE root OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include(${root}/cmake/Modules/Platform/Emscripten.cmake)
