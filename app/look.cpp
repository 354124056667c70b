#include "app/look.hpp"

#include <algorithm>
#include <array>

namespace snug::app {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_of_name(char c) { return is_letter(c) || c == '_' || (c >= '0' && c <= '9'); }

constexpr std::size_t kLongestSubscript = 3;  // "max"

/// Whether that is the comma before a second index: in "p_k,i".
bool is_index_after(std::string_view words, std::size_t at) {
  return words[at] == ',' && at + 1 < words.size() && is_letter(words[at + 1]) &&
         (at + 2 == words.size() || !is_of_name(words[at + 2]));
}

/// The name that ends before `at`.
std::string_view name_before(std::string_view words, std::size_t at) {
  std::size_t begin = at;
  while (begin > 0 && is_of_name(words[begin - 1])) --begin;
  return words.substr(begin, at - begin);
}

/// How many letters are lowered after that one, if it is the underscore of a letter and its subscript, or of "min_p".
std::size_t lowered_after(std::string_view words, std::size_t at) {
  if (words[at] != '_' || at == 0) return 0;
  const bool is_sign = (words[at - 1] & 0x80) != 0;  // "∑_i"
  const std::string_view name = name_before(words, at);
  const bool is_operator = name == "min" || name == "max";
  if (!is_sign && !is_operator && (name.size() != 1 || !is_letter(name.front()))) return 0;
  std::size_t end = at + 1;
  while (end < words.size() && words[end] != '_' && (is_of_name(words[end]) || is_index_after(words, end))) ++end;
  const std::size_t letters = end - at - 1;
  return letters <= (is_operator ? 1 : kLongestSubscript) && (end == words.size() || words[end] != '_') ? letters : 0;
}

/// How many letters are raised after that one, if it is the caret of "p^T" or "u_i^A".
std::size_t raised_after(std::string_view words, std::size_t at) {
  if (words[at] != '^' || at == 0 || at + 1 == words.size()) return 0;
  const bool has_base = is_of_name(words[at - 1]) || words[at - 1] == ')';
  const bool is_capital = words[at + 1] >= 'A' && words[at + 1] <= 'Z';
  return has_base && is_capital && (at + 2 == words.size() || !is_of_name(words[at + 2])) ? 1 : 0;
}

/// script: how large sub- and superscripts are, a part of the size.
float advance(ImFont* font, float size, float script, std::string_view words) {
  float width = 0;
  for (const Letters& letters : with_scripts(words))
    width += font->CalcTextSizeA(letters.script == Script::kNone ? size : size * script, FLT_MAX, 0,
                                 letters.text.data(), letters.text.data() + letters.text.size())
                 .x;
  return width;
}

// ImGui measures a font's size from ascender to descender; our sizes are in em, as everywhere else.
constexpr float kInterBox = 1.21f, kJetBrainsMonoBox = 1.32f;
constexpr float kAboveCapitals = 0.1f;  // of the em, from the top of a line's box to that of its capitals

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; }  // inside a UTF-8 character

}  // namespace

std::vector<Letters> with_scripts(std::string_view words) {
  constexpr std::string_view kSigns = "_^";
  std::vector<Letters> pieces;
  std::size_t begin = 0;
  for (std::size_t at = words.find_first_of(kSigns); at != std::string_view::npos;
       at = words.find_first_of(kSigns, at + 1)) {
    const std::size_t lowered = lowered_after(words, at), letters = lowered + raised_after(words, at);
    if (letters == 0) continue;
    if (at > begin) pieces.push_back({words.substr(begin, at - begin)});
    pieces.push_back({words.substr(at + 1, letters), lowered > 0 ? Script::kLowered : Script::kRaised});
    begin = at + 1 + letters;
  }
  if (begin < words.size()) pieces.push_back({words.substr(begin)});
  return pieces;
}

float Look::script(float size) const { return std::clamp(least / drawn_px(size), kScriptSize, 1.0f); }

float font_size(const Look& look, Face face, float size) {
  return look.drawn_px(size) * (face == Face::kMono || face == Face::kMonoBold ? kJetBrainsMonoBox : kInterBox);
}

ImVec2 measure(const Look& look, Face face, float size, std::string_view words) {
  if (words.empty()) return {0, look.drawn_px(size)};  // ImGui would look for the end of a null text
  return {advance(look.font(face), font_size(look, face, size), look.script(size), words), look.drawn_px(size)};
}

void text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, std::string_view words) {
  if (words.empty()) return;
  const float box = font_size(look, face, size), em = look.drawn_px(size), script = look.script(size);
  note_text(list, look, face, size, at, color, 0, words);
  if (look.words_apart) return;
  const float same_baseline = kBaseline * (1 - script);
  const std::array down{0.0f, same_baseline + kLowered, same_baseline - kRaised};
  for (const Letters& letters : with_scripts(words)) {
    const float scale = letters.script == Script::kNone ? 1 : script;
    const float below = em * down[static_cast<std::size_t>(letters.script)];
    list->AddText(look.font(face), box * scale, {at.x, at.y - (box - em) * scale / 2 + below}, color,
                  letters.text.data(), letters.text.data() + letters.text.size());
    at.x += advance(look.font(face), box * scale, script, letters.text);
  }
}

void note_text(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color, Color halo,
               std::string_view words) {
  if (look.drawn == nullptr || words.empty()) return;
  look.drawn->push_back({std::string(words),
                         {at.x, at.y + look.drawn_px(size) * kAboveCapitals},
                         {at.x + measure(look, face, size, words).x, at.y + look.drawn_px(size)},
                         list->GetClipRectMin(),
                         list->GetClipRectMax(),
                         list,
                         list->IdxBuffer.Size,
                         face,
                         look.drawn_px(size),
                         at,
                         color,
                         halo});
}

void text_right(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color,
                std::string_view words) {
  text(list, look, face, size, {at.x - measure(look, face, size, words).x, at.y}, color, words);
}

void text_middle(ImDrawList* list, const Look& look, Face face, float size, ImVec2 at, Color color,
                 std::string_view words) {
  text(list, look, face, size, {at.x - measure(look, face, size, words).x / 2, at.y}, color, words);
}

std::string shortened(const Look& look, Face face, float size, std::string_view words, float width) {
  if (measure(look, face, size, words).x <= width) return std::string(words);
  std::size_t length = words.size();
  while (length > 0) {
    do --length;
    while (length > 0 && continues(words[length]));
    const std::string cut = std::string(words.substr(0, length)) + "…";
    if (measure(look, face, size, cut).x <= width) return cut;
  }
  return "…";
}

std::vector<std::string_view> lines_of(const Look& look, Face face, float size, std::string_view words, float width) {
  std::vector<std::string_view> lines;
  ImFont* font = look.font(face);
  const float px = font_size(look, face, size);
  std::size_t begin = 0;
  while (begin < words.size()) {
    std::size_t end = begin, space = std::string_view::npos;
    while (end < words.size() && words[end] != '\n') {
      std::size_t next = end + 1;
      while (next < words.size() && continues(words[next])) ++next;
      if (advance(font, px, look.script(size), words.substr(begin, next - begin)) > width && end > begin &&
          words[end] != ' ')
        break;
      if (words[end] == ' ') space = end;
      end = next;
    }
    const bool whole = end == words.size() || words[end] == '\n';
    if (!whole && space != std::string_view::npos) end = space;
    lines.push_back(words.substr(begin, end - begin));
    begin = end;
    if (begin < words.size() && (words[begin] == ' ' || words[begin] == '\n')) ++begin;
  }
  return lines;
}

float paragraph(ImDrawList* list, const Look& look, Face face, float size, float leading, ImVec2 at, float width,
                Color color, std::string_view words) {
  const float step = look.px(leading);
  float y = at.y + (step - look.px(size)) / 2;
  const auto lines = lines_of(look, face, size, words, width);
  for (const std::string_view line : lines) {
    text(list, look, face, size, {at.x, y}, color, line);
    y += step;
  }
  return step * static_cast<float>(lines.size());
}

void apply_style(const Look& look) {
  ImGuiStyle& style = ImGui::GetStyle();
  style.CircleTessellationMaxError =
      0.2f / std::max(1.0f, ImGui::GetIO().DisplayFramebufferScale.x);  // 0.2 device pixels
  style.WindowPadding = {0, 0};
  style.WindowBorderSize = 0;
  style.WindowRounding = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.PopupRounding = style.FrameRounding = style.GrabRounding = 8;
  style.FrameBorderSize = 1;
  style.FramePadding = {8, look.fingers ? 12.0f : 8.0f};
  style.ItemSpacing = {8, 8};
  style.ScrollbarSize = 10;
  style.ScrollbarRounding = 5;
  style.FontSizeBase = look.px(15);
  style.WindowMinSize = {1, 1};
  const auto color = [](Color c) { return ImGui::ColorConvertU32ToFloat4(c); };
  const Palette& p = *look.palette;
  for (ImVec4& each : style.Colors) each = color(p.raised);
  style.Colors[ImGuiCol_Text] = color(p.ink);
  style.Colors[ImGuiCol_TextDisabled] = color(p.muted);
  style.Colors[ImGuiCol_WindowBg] = style.Colors[ImGuiCol_ChildBg] = style.Colors[ImGuiCol_ScrollbarBg] =
      style.Colors[ImGuiCol_NavCursor] = {0, 0, 0, 0};
  style.Colors[ImGuiCol_PopupBg] = color(p.panel);
  style.Colors[ImGuiCol_Border] = color(p.line);
  style.Colors[ImGuiCol_BorderShadow] = {0, 0, 0, 0};
  style.Colors[ImGuiCol_FrameBg] = style.Colors[ImGuiCol_FrameBgHovered] = style.Colors[ImGuiCol_FrameBgActive] =
      color(p.panel);
  style.Colors[ImGuiCol_ScrollbarGrab] = color(p.line);
  style.Colors[ImGuiCol_ScrollbarGrabHovered] = style.Colors[ImGuiCol_ScrollbarGrabActive] = color(p.muted);
  style.Colors[ImGuiCol_TextSelectedBg] = color(with_alpha(p.current, 0.35f));
  style.Colors[ImGuiCol_InputTextCursor] = color(p.ink);
}

}  // namespace snug::app
