# Finds Dear ImGui's sources and sets SNUG_IMGUI_DIR. The suite is the release that carries the version.
set(imgui_version 1.92.2b)
snug_pinned("Dear ImGui" ${imgui_version} SNUG_IMGUI_DIR ${CMAKE_CURRENT_SOURCE_DIR}/imgui.sha256
  https://github.com/ocornut/imgui/archive/refs/tags/v${imgui_version}.tar.gz imgui-${imgui_version} imgui forky)
