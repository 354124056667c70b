// Answers queries of the GL state without asking the GPU.
//
// ImGui's renderer reads a dozen pieces of state before it draws, and restores them afterwards. In a browser each query
// waits for the GPU, which took 85 per cent of a frame during a drag. Here every frame starts from the state of a new
// context, and only the door and the stage draw, so all answers except the viewport are known in advance. The linker
// redirects glGetIntegerv and glViewport to this file (--wrap in CMakeLists.txt).
#include <algorithm>
#include <array>

#include "snug_gl.h"

namespace {
std::array<GLint, 4> g_viewport{};
}

extern "C" {

void __real_glViewport(GLint x, GLint y, GLsizei width, GLsizei height);

void __wrap_glViewport(GLint x, GLint y, GLsizei width, GLsizei height) {
  g_viewport = {x, y, width, height};
  __real_glViewport(x, y, width, height);
}

void __real_glGetIntegerv(GLenum name, GLint* values);

void __wrap_glGetIntegerv(GLenum name, GLint* values) {
  switch (name) {
    case GL_VIEWPORT:
    case GL_SCISSOR_BOX: std::copy(g_viewport.begin(), g_viewport.end(), values); return;
    case GL_ACTIVE_TEXTURE: *values = GL_TEXTURE0; return;
    case GL_CURRENT_PROGRAM:
    case GL_TEXTURE_BINDING_2D:
    case GL_SAMPLER_BINDING:
    case GL_ARRAY_BUFFER_BINDING:
    case GL_PIXEL_UNPACK_BUFFER_BINDING:
    case GL_VERTEX_ARRAY_BINDING: *values = 0; return;
    case GL_BLEND_SRC_RGB:
    case GL_BLEND_SRC_ALPHA: *values = GL_ONE; return;
    case GL_BLEND_DST_RGB:
    case GL_BLEND_DST_ALPHA: *values = GL_ZERO; return;
    case GL_BLEND_EQUATION_RGB:
    case GL_BLEND_EQUATION_ALPHA: *values = GL_FUNC_ADD; return;
    default: __real_glGetIntegerv(name, values);  // limits and versions, which are queried once
  }
}

}  // extern "C"
