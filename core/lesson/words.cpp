#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace

std::string_view volume_word(std::string_view name, int dim) {
  if (name == "sphere") return ball_word(dim);
  if (name == "aabb" || name == "obb") return "box";
  return name == "kdop" ? "k-DOP" : name;
}

std::string in_words_of(int dim, std::string_view text) {
  constexpr std::string_view kCircle = "ircle", kSphere = "phere";
  std::string words(text);
  if (dim == 2) return words;
  for (auto at = words.find(kCircle); at != std::string::npos; at = words.find(kCircle, at + 1)) {
    if (at == 0 || (words[at - 1] != 'c' && words[at - 1] != 'C') || (at > 1 && is_letter(words[at - 2]))) continue;
    words[at - 1] = words[at - 1] == 'C' ? 'S' : 's';
    words.replace(at, kCircle.size(), kSphere);
  }
  return words;
}

std::string direction_name(const Vector<double, 3>& direction) {
  std::string name;
  for (int i = 0; i < 3; ++i)
    if (direction[i] != 0) name += std::string(direction[i] > 0 ? "+" : "−") + "xyz"[i];
  return name;
}

std::string axis_name(const Vector<double, 3>& direction) {
  const std::string name = direction_name(direction);
  return name.starts_with('+') ? name.substr(1) : name;
}

std::string capital(std::string text) {
  if (text.front() >= 'a' && text.front() <= 'z') text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

}  // namespace snug::lesson
