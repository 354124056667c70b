#include "lesson/prose.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "lesson/formula.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kSigns = "\\*`_^{}[]()$|-.";  // what a backslash makes an ordinary sign
constexpr std::string_view kKeptSpace = "\u00a0";        // no line breaks at it
constexpr std::size_t kShortFormula = 28;                // bytes: up to this length, a formula is not broken

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

bool is_of_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

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

/// A hyphen before a digit is a minus sign.
std::string with_minus_signs(std::string words) {
  constexpr std::string_view kMinus = "−";
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == '-' && words[i + 1] >= '0' && words[i + 1] <= '9') words.replace(i, 1, kMinus);
  return words;
}

constexpr std::array<std::pair<std::string_view, Link::Kind>, 6> kLinkKinds{{{"lesson", Link::Kind::kLesson},
                                                                             {"mesh", Link::Kind::kMesh},
                                                                             {"algorithm", Link::Kind::kAlgorithm},
                                                                             {"step", Link::Kind::kStep},
                                                                             {"mark", Link::Kind::kMark},
                                                                             {"situation", Link::Kind::kSituation}}};

/// Parses a paragraph of prose, from left to right.
class Line {
 public:
  Line(std::string_view text, std::vector<ProseFault>& faults, Within within, std::size_t begin)
      : text_(text), rest_(text), faults_(faults), within_(within), begin_(begin) {}

  Paragraph stretches() {
    while (!rest_.empty()) {
      const std::size_t from = here();
      if (take("**")) toggle(strong_, "**", from);
      else if (take("*")) toggle(emphasis_, "*", from);
      else if (take("`")) code(from);
      else if (take("$")) formula(from);
      else if (take("_{")) script(Stretch::Script::kLow, "_{", from);
      else if (take("^{")) script(Stretch::Script::kHigh, "^{", from);
      else if (take("{")) figure(from);
      else if (take("}")) complain("has a } without a {", from);
      else if (take("\\")) sign(from);
      else if (!link()) add(rest_.front()), rest_.remove_prefix(1);
    }
    while (!plain_.empty() && plain_.back() == ' ') plain_.pop_back();
    flush();
    if (strong_ && !told_at(*strong_)) complain("has a ** without a partner", *strong_);
    if (emphasis_ && !told_at(*emphasis_)) complain("has a * without a partner", *emphasis_);
    if (displayed_ && within_ != Within::kSection)
      complain("has a $$ formula, which can only be a paragraph of a section's text", *displayed_);
    else if (displayed_ && paragraph_.size() > 1)
      complain("has a $$ formula among words: it must be a paragraph by itself", *displayed_);
    return std::move(paragraph_);
  }

 private:
  [[nodiscard]] std::size_t here() const { return text_.size() - rest_.size(); }
  [[nodiscard]] bool after_blank(std::size_t at) const { return at == 0 || is_blank(text_[at - 1]); }

  bool take(std::string_view mark) {
    if (rest_.substr(0, mark.size()) != mark) return false;
    rest_.remove_prefix(mark.size());
    return true;
  }

  /// Takes the text up to a sign, and the sign. Complains if it is not there.
  std::optional<std::string_view> take_up_to(std::string_view sign, std::string_view what, std::size_t from) {
    const auto end = rest_.find(sign);
    if (end == std::string_view::npos) return complain("has a " + std::string(what), from), std::nullopt;
    const std::string_view taken = rest_.substr(0, end);
    rest_.remove_prefix(end + sign.size());
    return taken;
  }

  void complain(std::string what, std::size_t at) { faults_.push_back({std::move(what), begin_ + at}); }

  void add(char c) {
    if (plain_.empty()) plain_at_ = here();
    if (!is_blank(c)) plain_ += c;
    else if (plain_.empty() ? !paragraph_.empty() : plain_.back() != ' ') plain_ += ' ';
  }

  void push(Stretch stretch, std::size_t at) {
    flush();
    stretch.strong = strong_.has_value(), stretch.emphasis = emphasis_.has_value(), stretch.at = begin_ + at;
    paragraph_.push_back(std::move(stretch));
  }

  void flush() {
    if (plain_.empty()) return;
    Stretch words{.text = kept_together(std::exchange(plain_, {}))};
    push(std::move(words), plain_at_);
  }

  bool told_at(std::size_t at) const {
    return std::any_of(faults_.begin(), faults_.end(),
                       [&](const ProseFault& fault) { return fault.at == begin_ + at; });
  }

  void toggle(std::optional<std::size_t>& since, const std::string& mark, std::size_t from) {
    const bool apart = since ? after_blank(from) : rest_.empty() || is_blank(rest_.front());
    const bool within =
        mark == "*" && from > 0 && is_of_word(text_[from - 1]) && !rest_.empty() && is_of_word(rest_.front());
    if (apart) complain("has a " + mark + " beside a space: it must touch its words. A sign is written \\*", from);
    else if (within) complain("has a * within a word. A product is written ×, a sign \\*", from);
    flush();
    since = since ? std::nullopt : std::optional(from);
  }

  void code(std::size_t from) {
    const auto words = take_up_to("`", "` without a partner", from);
    if (!words) return;
    if (joined(*words).empty()) return complain("has `` without words between", from);
    push({.text = joined(*words), .code = true}, from);
  }

  void formula(std::size_t from) {
    const std::string signs = take("$") ? "$$" : "$";
    const auto inside = take_up_to(signs, signs + " without a partner", from);
    if (!inside) return;
    if (signs == "$$") displayed_ = from;
    const std::string tex = joined(*inside);
    auto plain = plain_formula(tex);
    if (!plain) return complain("has a formula that cannot be set, $" + tex + "$: " + plain.error(), from);
    if (plain->size() <= kShortFormula) plain = with_kept_spaces(*plain);
    push({.text = std::move(*plain), .tex = tex}, from);
  }

  void script(Stretch::Script script, const std::string& mark, std::size_t from) {
    const auto inside = take_up_to("}", mark + " without a }", from);
    if (!inside) return;
    if (after_blank(from)) return complain("has a " + mark + " with nothing before it that it belongs to", from);
    std::string words = with_minus_signs(joined(*inside));
    if (words.empty()) return complain("has an empty " + mark + '}', from);
    if (words.find_first_of("*`$[{") != std::string::npos)
      return complain("has markup within " + mark + "}, which can only have plain words", from);
    push({.text = std::move(words), .script = script}, from);
  }

  void figure(std::size_t from) {
    const auto inside = take_up_to("}", "{ without a }", from);
    if (!inside) return;
    const auto figure = figure_named(joined(*inside));
    if (figure) return push({.text = std::string(kHiddenFigure), .figure = figure}, from);
    complain("has no figure of the run between { and }: " + joined(*inside) +
                 ". It is {key}, {key algorithm} or {count key}; signs are written \\{ and \\}",
             from);
  }

  void sign(std::size_t from) {
    if (!rest_.empty() && kSigns.find(rest_.front()) != std::string_view::npos)
      return add(rest_.front()), rest_.remove_prefix(1);
    complain("has a \\ outside of a formula: TeX stands between two $", from);
  }

  /// Parses [words](kind:target). Other brackets are plain text.
  bool link() {
    if (rest_.front() != '[') return false;
    const auto middle = rest_.find(']');
    if (middle == std::string_view::npos || rest_.substr(middle + 1, 1) != "(") return false;
    const auto end = rest_.find(')', middle);
    if (end == std::string_view::npos) return false;
    const std::size_t from = here();
    const std::string words = joined(rest_.substr(1, middle - 1));
    const std::string to = joined(rest_.substr(middle + 2, end - middle - 2));
    rest_.remove_prefix(end + 1);
    const auto colon = std::min(to.find(':'), to.size());
    const auto* kind = std::find_if(kLinkKinds.begin(), kLinkKinds.end(),
                                    [&](const auto& one) { return one.first == to.substr(0, colon); });
    if (within_ == Within::kPrompt) return complain("has a link, which only a section's text can have", from), true;
    if (kind == kLinkKinds.end() || words.empty() || colon + 1 >= to.size()) {
      complain("has a link that leads nowhere, (" + to +
                   "): a target is lesson:, mesh:, algorithm:, step: or mark: and a name",
               from);
      return true;
    }
    check_words_of_link(words, from);
    push({.text = kept_together(words), .link = Link{kind->second, to.substr(colon + 1)}}, from);
    return true;
  }

  void check_words_of_link(std::string_view words, std::size_t from) {
    for (const std::string_view mark : {"**", "*"})
      if (words.find(mark) != std::string_view::npos)
        return complain("has " + std::string(mark) + " within a link: put it around the link", from);
    if (words.find('$') != std::string_view::npos)
      return complain("has a formula within a link, which can only have plain words", from);
    if (words.find_first_of("`{}") != std::string_view::npos)
      complain("has markup within a link, which can only have plain words", from);
  }

  std::string_view text_, rest_;
  std::vector<ProseFault>& faults_;
  Within within_;
  std::size_t begin_;
  std::string plain_;
  std::size_t plain_at_ = 0;
  std::optional<std::size_t> strong_, emphasis_;  // since where
  std::optional<std::size_t> displayed_;          // where a formula on its own line begins
  Paragraph paragraph_;
};

}  // namespace

std::string joined(std::string_view text) {
  std::string line;
  bool space = false;
  for (const char c : text) {
    if (is_blank(c)) {
      space = !line.empty();
      continue;
    }
    if (space) line += ' ';
    space = false;
    line += c;
  }
  return line;
}

std::size_t end_of_span(std::string_view text, std::size_t at) {
  if (text[at] == '\\') return std::min(at + 2, text.size());
  const std::string_view sign = text.substr(at, 2) == "$$" ? "$$" : text.substr(at, 1);
  if (sign != "$" && sign != "$$" && sign != "`") return at;
  const std::size_t end = text.find(sign, at + sign.size());
  return end == std::string_view::npos ? end : end + sign.size();
}

std::optional<RunFigure> figure_named(std::string_view name) {
  constexpr std::string_view kOfNames = "abcdefghijklmnopqrstuvwxyz0123456789_/", kCount = "count ";
  RunFigure figure{.count = name.substr(0, kCount.size()) == kCount};
  if (figure.count) name.remove_prefix(kCount.size());
  const std::size_t space = std::min(name.find(' '), name.size());
  figure.key = name.substr(0, space);
  figure.algorithm = name.substr(std::min(space + 1, name.size()));
  const auto is_name = [&](const std::string& one) { return one.find_first_not_of(kOfNames) == std::string::npos; };
  if (figure.key.empty() || !is_name(figure.key) || !is_name(figure.algorithm)) return std::nullopt;
  return figure;
}

std::string name_of(const RunFigure& figure) {
  return (figure.count ? "count " : "") + figure.key + (figure.algorithm.empty() ? "" : " ") + figure.algorithm;
}

Paragraph paragraph_of(std::string_view text, std::vector<ProseFault>& faults, Within within, std::size_t begin) {
  return Line(text, faults, within, begin).stretches();
}

std::vector<const Paragraph*> paragraphs_of(const Section& section) {
  std::vector<const Paragraph*> all;
  for (const Block& block : section.blocks)
    for (const std::vector<Paragraph>& row : block.rows)
      for (const Paragraph& cell : row) all.push_back(&cell);
  return all;
}

std::vector<const Stretch*> stretches_of(const Section& section) {
  std::vector<const Stretch*> all;
  for (const Paragraph* paragraph : paragraphs_of(section))
    for (const Stretch& stretch : *paragraph) all.push_back(&stretch);
  return all;
}

std::string plain_text(const Paragraph& paragraph) {
  std::string text;
  for (const Stretch& stretch : paragraph) text += stretch.text;
  return text;
}

}  // namespace snug::lesson
