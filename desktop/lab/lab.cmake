cmake_minimum_required(VERSION 3.25)
project(lab-@NAME@ LANGUAGES CXX)
find_package(snug REQUIRED) # Debian's libsnug-dev
find_package(doctest REQUIRED) # Debian's doctest-dev
find_program(SNUG snug REQUIRED)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Debug)
endif()

add_executable(tests tests.cpp @NAME@.cpp)
target_link_libraries(tests PRIVATE snug::core doctest::doctest)
target_compile_options(tests PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion -fsanitize=address,undefined)
target_link_options(tests PRIVATE -fsanitize=address,undefined)

enable_testing()
add_test(NAME three-cases COMMAND tests)
add_test(NAME random-and-hard-cases COMMAND ${SNUG} lab check ${CMAKE_SOURCE_DIR})
