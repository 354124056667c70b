#include "desktop/second_window.hpp"

#include <snug_gl.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include "desktop/glfw_host.hpp"

namespace snug::desktop {
namespace {

/// Makes another window's context and ImGui the current ones, for a while.
class Turned {
 public:
  Turned(GLFWwindow* window, ImGuiContext* imgui)
      : window_(glfwGetCurrentContext()), imgui_(ImGui::GetCurrentContext()) {
    glfwMakeContextCurrent(window);
    ImGui::SetCurrentContext(imgui);
  }
  ~Turned() {
    glfwMakeContextCurrent(window_);
    ImGui::SetCurrentContext(imgui_);
  }
  Turned(const Turned&) = delete;
  Turned& operator=(const Turned&) = delete;

 private:
  GLFWwindow* window_;
  ImGuiContext* imgui_;
};

}  // namespace

std::unique_ptr<SecondWindow> SecondWindow::make(const char* title, int width, int height) {
  std::unique_ptr<SecondWindow> second(new SecondWindow());
  second->first_ = glfwGetCurrentContext();
  glfwWindowHint(GLFW_VISIBLE, GLFW_TRUE);
  glfwWindowHint(GLFW_FOCUS_ON_SHOW, GLFW_FALSE);  // the clicker's keys go to the first
  second->window_ = glfwCreateWindow(width, height, title, nullptr, second->first_);
  if (second->window_ == nullptr) return nullptr;
  ImFontAtlas* const letters = ImGui::GetIO().Fonts;
  ImGuiContext* const before = ImGui::GetCurrentContext();
  second->imgui_ = ImGui::CreateContext(letters);
  ImGui::SetCurrentContext(before);
  {
    const Turned turned(second->window_, second->imgui_);
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplOpenGL3_Init("#version 330 core");
    glfwSwapInterval(0);  // the first waits for its screen
  }
  glfwSetWindowUserPointer(second->window_, second.get());
  static const auto found = [](GLFWwindow* window) {
    return static_cast<SecondWindow*>(glfwGetWindowUserPointer(window));
  };
  glfwSetKeyCallback(second->window_, [](GLFWwindow* window, int key, int, int action, int) {
    if (action == GLFW_RELEASE || !found(window)->on_key) return;
    found(window)->held_ = action == GLFW_REPEAT;
    if (const std::string name = key_name(key); !name.empty()) found(window)->on_key(name, found(window)->held_);
  });
  glfwSetCharCallback(second->window_, [](GLFWwindow* window, unsigned code) {
    if (code < 0x80 && found(window)->on_key)
      found(window)->on_key(std::string(1, static_cast<char>(code)), found(window)->held_);
  });
  glfwSetWindowRefreshCallback(second->window_, [](GLFWwindow* window) { found(window)->stale_ = true; });
  glfwSetFramebufferSizeCallback(second->window_, [](GLFWwindow* window, int, int) { found(window)->stale_ = true; });
  return second;
}

SecondWindow::~SecondWindow() {
  if (imgui_ != nullptr) {
    const Turned turned(window_, imgui_);
    ImGui_ImplOpenGL3_Shutdown();
  }
  if (imgui_ != nullptr) ImGui::DestroyContext(imgui_);
  if (window_ != nullptr) glfwDestroyWindow(window_);
}

bool SecondWindow::open() const { return !glfwWindowShouldClose(window_); }

void SecondWindow::draw(const app::Look& look, const std::function<void(ImDrawList*, const app::Rect&)>& paint) {
  const Turned turned(window_, imgui_);
  stale_ = false;
  int width = 0, height = 0;
  float scale = 1, scale_y = 1;
  glfwGetFramebufferSize(window_, &width, &height);
  glfwGetWindowContentScale(window_, &scale, &scale_y);
  if (width < 1 || height < 1) return;
  if (!(scale >= 0.5f)) scale = 1;
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width) / scale, static_cast<float>(height) / scale};
  io.DisplayFramebufferScale = {scale, scale};
  io.DeltaTime = 1.0f / 60;
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  paint(ImGui::GetBackgroundDrawList(), {0, 0, io.DisplaySize.x, io.DisplaySize.y});
  ImGui::Render();
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(look->ground);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glDisable(GL_SCISSOR_TEST);
  glViewport(0, 0, width, height);
  glClearColor(ground.x, ground.y, ground.z, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window_);
}

}  // namespace snug::desktop
