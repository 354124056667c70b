#pragma once
/// OpenGL as the desktop has it: libepoxy finds the functions of the 3.3 core profile.
#include <epoxy/gl.h>

inline void let_shaders_size_points() { glEnable(GL_PROGRAM_POINT_SIZE); }
