# What `snug lab check` builds: a student's file, with what calls it. SNUG_LAB: the lab's name, SOURCE: the file.
cmake_minimum_required(VERSION 3.25)
project(check LANGUAGES CXX)
find_package(snug REQUIRED)
add_executable(check driver.cpp ${SOURCE})
target_include_directories(check PRIVATE ${CMAKE_SOURCE_DIR})
target_link_libraries(check PRIVATE snug::core)
set(checked -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
target_compile_options(check PRIVATE -O1 -g ${checked} -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
  -fdiagnostics-color=never)
target_link_options(check PRIVATE ${checked})
