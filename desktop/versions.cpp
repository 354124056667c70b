#include "desktop/versions.hpp"

#include <snug_gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <png.h>
#include <zlib.h>

#include <CLI/Version.hpp>
#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <sstream>

namespace snug::desktop {
namespace {

std::string text_of(GLenum name) {
  const auto* const text = reinterpret_cast<const char*>(glGetString(name));
  return text != nullptr ? text : "unknown";
}

}  // namespace

std::string versions_of_parts() {
  int major = 0, minor = 0, revision = 0;
  glfwGetVersion(&major, &minor, &revision);
  std::ostringstream text;
  text << "Dear ImGui " IMGUI_VERSION ", GLFW " << major << '.' << minor << '.' << revision << ", Eigen "
       << EIGEN_WORLD_VERSION << '.' << EIGEN_MAJOR_VERSION << '.' << EIGEN_MINOR_VERSION
       << ", CLI11 " CLI11_VERSION ", JSON for Modern C++ " << NLOHMANN_JSON_VERSION_MAJOR << '.'
       << NLOHMANN_JSON_VERSION_MINOR << '.' << NLOHMANN_JSON_VERSION_PATCH << ", libpng "
       << png_get_libpng_ver(nullptr) << ", zlib " << zlibVersion() << ", OpenGL " << text_of(GL_VERSION) << " by "
       << text_of(GL_RENDERER);
  return text.str();
}

}  // namespace snug::desktop
