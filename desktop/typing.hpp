// Text fields of any length.
#pragma once

#include <imgui.h>

#include <string>

namespace snug::desktop {

/// Lets ImGui write into a string of any length, which is the callback's UserData.
inline int grow(ImGuiInputTextCallbackData* data) {
  if (data->EventFlag != ImGuiInputTextFlags_CallbackResize) return 0;
  auto& text = *static_cast<std::string*>(data->UserData);
  text.resize(data->BufTextLen);
  data->Buf = text.data();
  return 0;
}

}  // namespace snug::desktop
