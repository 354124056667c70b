// In the place of Dear ImGui's imgui_tables.cpp: Snug lays out its tables itself, and without those of ImGui the page
// is 11 kB smaller on the wire. What the rest of ImGui calls of them, for a table that is never begun, does nothing.
#include <imgui.h>
#include <imgui_internal.h>

namespace ImGui {

void EndTable() {}
void TableEndCell(ImGuiTable*) {}
void TableEndRow(ImGuiTable*) {}
void TableGcCompactSettings() {}
void TableGcCompactTransientBuffers(ImGuiTable*) {}
void TableGcCompactTransientBuffers(ImGuiTableTempData*) {}
void TablePopBackgroundChannel() {}
void TablePopColumnChannel() {}
void TablePushBackgroundChannel() {}
void TablePushColumnChannel(int) {}
void TableSettingsAddSettingsHandler() {}
void EndColumns() {}
void PopColumnsBackground() {}
void PushColumnsBackground() {}

}  // namespace ImGui
