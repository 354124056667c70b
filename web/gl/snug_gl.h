#pragma once
/// OpenGL as the browser has it: WebGL 2, which is OpenGL ES 3.0.
#include <GLES3/gl3.h>

inline void let_shaders_size_points() {}  // they always do
