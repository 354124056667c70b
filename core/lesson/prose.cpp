#include "lesson/prose.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "lesson/formula.hpp"

namespace snug::lesson {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// Replaces each run of white space by one space.
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

constexpr std::string_view kKeptSpace = "\u00a0";  // no line breaks at it
constexpr std::size_t kShortFormula = 28;          // bytes: up to this length, a formula is not broken

std::string with_kept_spaces(std::string_view words) {
  std::string out;
  for (const char c : words)
    if (c == ' ') out += kKeptSpace;
    else out += c;
  return out;
}

/// Puts no-break spaces within a sum of radii and before a per cent sign.
std::string kept_together(std::string line) {
  for (const std::string_view whole : {"r_A + r_B", " %"})
    for (auto at = line.find(whole); at != std::string::npos; at = line.find(whole, at + 1))
      for (auto end = at + whole.size(), i = at; i < end; ++i)
        if (line[i] == ' ') line.replace(i, 1, kKeptSpace), end += kKeptSpace.size() - 1;
  return line;
}

constexpr std::array<std::pair<std::string_view, Link::Kind>, 5> kLinkKinds{{{"lesson", Link::Kind::kLesson},
                                                                             {"mesh", Link::Kind::kMesh},
                                                                             {"algorithm", Link::Kind::kAlgorithm},
                                                                             {"step", Link::Kind::kStep},
                                                                             {"mark", Link::Kind::kMark}}};

/// Parses a paragraph of prose, from left to right.
class Line {
 public:
  Line(std::string_view rest, std::vector<ProseFault>& faults) : rest_(rest), faults_(faults) {}

  Paragraph stretches() {
    while (!rest_.empty()) {
      if (take("**")) flush(), strong_ = !strong_;
      else if (take("$")) formula();
      else if (!link()) plain_ += rest_.front(), rest_.remove_prefix(1);
    }
    flush();
    if (strong_) complain("has a ** without a partner");
    if (displayed_ && paragraph_.size() > 1) complain("has a $$ formula among words: it must be a paragraph by itself");
    return std::move(paragraph_);
  }

 private:
  bool take(std::string_view mark) {
    if (rest_.substr(0, mark.size()) != mark) return false;
    rest_.remove_prefix(mark.size());
    return true;
  }

  void complain(std::string what, std::string_view words = {}) {
    faults_.push_back({.what = std::move(what), .paragraph = {}, .words = std::string(words)});
  }

  void flush() {
    if (!plain_.empty()) paragraph_.push_back({.text = kept_together(std::move(plain_)), .strong = strong_});
    plain_.clear();
  }

  void formula() {
    const std::string_view signs = take("$") ? "$$" : "$";
    const auto end = rest_.find(signs);
    if (end == std::string_view::npos) return complain("has a " + std::string(signs) + " without a partner");
    flush();
    displayed_ = displayed_ || signs == "$$";
    const std::string_view tex = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end + signs.size());
    auto plain = plain_formula(tex);
    if (!plain) return complain("has a formula that cannot be set, $" + std::string(tex) + "$: " + plain.error(), tex);
    if (plain->size() <= kShortFormula) plain = with_kept_spaces(*plain);
    paragraph_.push_back({.text = std::move(*plain), .strong = strong_, .tex = std::string(tex)});
  }

  /// Parses [words](kind:target). Other brackets are plain text.
  bool link() {
    if (rest_.front() != '[') return false;
    const auto middle = rest_.find(']');
    if (middle == std::string_view::npos || rest_.substr(middle + 1, 1) != "(") return false;
    const auto end = rest_.find(')', middle);
    if (end == std::string_view::npos) return false;
    const std::string_view words = rest_.substr(1, middle - 1), to = rest_.substr(middle + 2, end - middle - 2);
    const auto colon = std::min(to.find(':'), to.size());
    const auto* kind = std::find_if(kLinkKinds.begin(), kLinkKinds.end(),
                                    [&](const auto& one) { return one.first == to.substr(0, colon); });
    rest_.remove_prefix(end + 1);
    if (kind == kLinkKinds.end() || words.empty() || colon + 1 >= to.size()) {
      complain("has a link that leads nowhere, (" + std::string(to) +
                   "): a target is lesson:, mesh:, algorithm:, step: or mark: and a name",
               to);
      return true;
    }
    if (words.find("**") != std::string_view::npos) complain("has ** within a link: put it around the link", to);
    if (words.find('$') != std::string_view::npos)
      complain("has a formula within a link, which can only have plain words", to);
    flush();
    paragraph_.push_back({.text = kept_together(std::string(words)),
                          .strong = strong_,
                          .link = Link{kind->second, std::string(to.substr(colon + 1))}});
    return true;
  }

  std::string_view rest_;
  std::vector<ProseFault>& faults_;
  std::string plain_;
  bool strong_ = false;
  bool displayed_ = false;  // whether the paragraph is a formula on its own line
  Paragraph paragraph_;
};

/// Takes the lines up to the next empty line off the text.
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

std::vector<Paragraph> paragraphs_of(std::string_view text, std::vector<ProseFault>& faults) {
  std::vector<Paragraph> paragraphs;
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty()) {
    const std::string_view block = next_block(text);
    const std::size_t before = faults.size();
    paragraphs.push_back(Line(joined(block), faults).stretches());
    for (std::size_t i = before; i < faults.size(); ++i) faults[i].paragraph = block.substr(0, block.find('\n'));
  }
  return paragraphs;
}

std::string plain_text(const Paragraph& paragraph) {
  std::string text;
  for (const Stretch& stretch : paragraph) text += stretch.text;
  return text;
}

}  // namespace snug::lesson
