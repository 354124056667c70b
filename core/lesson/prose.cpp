#include "lesson/prose.hpp"

#include <algorithm>
#include <string>

namespace snug::lesson {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// One space for each run of white space.
std::string joined(std::string_view text) {
  std::string line;
  bool space = false;
  for (const char c : text) {
    if (is_space(c)) {
      space = !line.empty();
      continue;
    }
    if (space) line += ' ';
    space = false;
    line += c;
  }
  return line;
}

/// With spaces that no line is broken at within a sum of radii and before a per cent sign.
std::string kept_together(std::string line) {
  constexpr std::string_view kSpace = "\u00a0";
  for (const std::string_view whole : {"r_A + r_B", " %"})
    for (auto at = line.find(whole); at != std::string::npos; at = line.find(whole, at + 1))
      for (auto end = at + whole.size(), i = at; i < end; ++i)
        if (line[i] == ' ') line.replace(i, 1, kSpace), end += kSpace.size() - 1;
  return line;
}

Paragraph stretches_of(std::string_view line, bool& closed) {
  Paragraph paragraph;
  bool strong = false;
  while (!line.empty()) {
    const auto mark = line.find("**");
    if (mark != 0) paragraph.push_back({std::string(line.substr(0, mark)), strong});
    if (mark == std::string_view::npos) break;
    strong = !strong;
    line.remove_prefix(mark + 2);
  }
  closed = closed && !strong;
  return paragraph;
}

/// Takes the lines up to an empty one off the text.
std::string_view next_block(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size()) {
    const auto line_end = std::min(text.find('\n', end), text.size());
    const bool blank = joined(text.substr(end, line_end - end)).empty();
    if (blank) break;
    end = std::min(line_end + 1, text.size());
  }
  const std::string_view block = text.substr(0, end);
  text.remove_prefix(end);
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  return block;
}

}  // namespace

std::vector<Paragraph> paragraphs_of(std::string_view text, bool& closed) {
  std::vector<Paragraph> paragraphs;
  closed = true;
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty()) paragraphs.push_back(stretches_of(kept_together(joined(next_block(text))), closed));
  return paragraphs;
}

}  // namespace snug::lesson
