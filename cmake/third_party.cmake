# Header-only libraries of the system. Each is reached through a link of its own in the build
# tree: a room sees just those it asks for, and emcc never sees /usr/include.

# snug_headers(NAME FOLDER [DEFINES d...] [INSTALLED target]): interface target snug_NAME for <FOLDER/...>. INSTALLED: what
# a program that uses the installed core links instead.
function(snug_headers name folder)
  cmake_parse_arguments(PARSE_ARGV 2 lib "" "INSTALLED" "DEFINES")
  find_path(SNUG_${name}_ROOT ${folder} PATHS /usr/include /usr/local/include
    NO_CMAKE_FIND_ROOT_PATH)
  if(NOT SNUG_${name}_ROOT)
    message(FATAL_ERROR "Headers <${folder}/> not found: ./run installs every package needed.")
  endif()
  set(door ${PROJECT_BINARY_DIR}/third_party/${name})
  file(MAKE_DIRECTORY ${door})
  file(CREATE_LINK ${SNUG_${name}_ROOT}/${folder} ${door}/${folder} SYMBOLIC)
  add_library(snug_${name} INTERFACE)
  target_include_directories(snug_${name} SYSTEM INTERFACE $<BUILD_INTERFACE:${door}>)
  target_link_libraries(snug_${name} INTERFACE $<INSTALL_INTERFACE:${lib_INSTALLED}>)
  target_compile_definitions(snug_${name} INTERFACE ${lib_DEFINES})
endfunction()

# Eigen's packets add up in another order than its scalar code: other bits natively and in wasm.
snug_headers(eigen eigen3 DEFINES EIGEN_DONT_VECTORIZE EIGEN_MPL2_ONLY INSTALLED Eigen3::Eigen)
target_include_directories(snug_eigen SYSTEM INTERFACE
  $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/third_party/eigen/eigen3>) # so that it is <Eigen/Dense>
snug_headers(expected tl INSTALLED tl::expected)
snug_headers(fast_float fast_float)
snug_headers(toml toml++ DEFINES TOML_EXCEPTIONS=0 TOML_ENABLE_FORMATTERS=0)
snug_headers(cli11 CLI)
snug_headers(json nlohmann)
snug_headers(doctest doctest)
snug_headers(boost boost) # tests only: the exact oracle's rationals
