#include "lesson/formula.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace snug::lesson {
namespace {

struct Name {
  std::string_view tex, plain;
};

constexpr auto kSymbols = std::to_array<Name>({
    {"alpha", "α"},      {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"}, {"varepsilon", "ε"},
    {"theta", "θ"},      {"lambda", "λ"}, {"mu", "μ"},    {"pi", "π"},    {"rho", "ρ"},     {"sigma", "σ"},
    {"tau", "τ"},        {"varphi", "φ"}, {"phi", "φ"},   {"omega", "ω"}, {"Delta", "Δ"},   {"Sigma", "Σ"},
    {"Omega", "Ω"},      {"sum", "∑"},    {"prod", "∏"},  {"cdot", "·"},  {"times", "×"},   {"pm", "±"},
    {"le", "≤"},         {"leq", "≤"},    {"ge", "≥"},    {"geq", "≥"},   {"ne", "≠"},      {"neq", "≠"},
    {"approx", "≈"},     {"equiv", "≡"},  {"in", "∈"},    {"notin", "∉"}, {"to", "→"},      {"rightarrow", "→"},
    {"Rightarrow", "⇒"}, {"infty", "∞"},  {"cap", "∩"},   {"cup", "∪"},   {"ldots", "…"},   {"dots", "…"},
    {"lVert", "‖"},      {"rVert", "‖"},  {"Vert", "‖"},  {"lvert", "|"}, {"rvert", "|"},   {"min", "min"},
    {"max", "max"},      {"cos", "cos"},  {"sin", "sin"}, {"log", "log"}, {"left", ""},     {"right", ""},
    {"quad", " "},       {",", " "},      {";", " "},     {" ", " "},     {"{", "{"},       {"}", "}"},
    {"|", "‖"},
});
/// Commands that only change the typeface of their argument.
constexpr auto kFaces = std::to_array<std::string_view>({"mathbf", "mathrm", "mathit", "text", "operatorname"});
/// Relations, which TeX separates from their neighbours by spaces.
constexpr auto kRelations = std::to_array<std::string_view>(
    {"+", "−", "=", "<", ">", "≤", "≥", "≠", "≈", "≡", "∈", "∉", "→", "⇒", "±", "·", "×", "∩", "∪"});
/// Operators, which are separated by a space from what they apply to.
constexpr auto kOperators = std::to_array<std::string_view>({"min", "max", "cos", "sin", "log", "∑", "∏"});
constexpr auto kRaised = std::to_array<Name>({{"0", "⁰"},
                                              {"1", "¹"},
                                              {"2", "²"},
                                              {"3", "³"},
                                              {"4", "⁴"},
                                              {"5", "⁵"},
                                              {"6", "⁶"},
                                              {"7", "⁷"},
                                              {"8", "⁸"},
                                              {"9", "⁹"},
                                              {"+", "⁺"},
                                              {"−", "⁻"},
                                              {"n", "ⁿ"}});
constexpr auto kLowered = std::to_array<Name>({{"0", "₀"},
                                               {"1", "₁"},
                                               {"2", "₂"},
                                               {"3", "₃"},
                                               {"4", "₄"},
                                               {"5", "₅"},
                                               {"6", "₆"},
                                               {"7", "₇"},
                                               {"8", "₈"},
                                               {"9", "₉"},
                                               {"+", "₊"},
                                               {"−", "₋"}});

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// Whether a byte begins a Greek letter, which has two bytes.
bool is_greek(char c) { return c == '\xce' || c == '\xcf'; }
/// Whether a byte is a digit, or begins a letter.
bool is_word(char c) { return is_letter(c) || (c >= '0' && c <= '9') || is_greek(c); }
bool ends_in_word(std::string_view text) {
  return !text.empty() && (is_word(text.back()) || (text.size() > 1 && is_greek(text[text.size() - 2])));
}

/// Takes one UTF-8 character off the front.
std::string_view next_character(std::string_view& rest) {
  std::size_t length = 1;
  while (length < rest.size() && (static_cast<unsigned char>(rest[length]) & 0xc0) == 0x80) ++length;
  const std::string_view one = rest.substr(0, length);
  rest.remove_prefix(length);
  return one;
}

/// The words as superscripts or subscripts; empty if a character has none.
std::string in_script(std::string_view words, const auto& script) {
  std::string out;
  while (!words.empty()) {
    const std::string_view one = next_character(words);
    const auto* found = std::find_if(script.begin(), script.end(), [&](const Name& name) { return name.tex == one; });
    if (found == script.end()) return {};
    out += found->plain;
  }
  return out;
}

bool is_compound(std::string_view words) { return words.find(' ') != std::string_view::npos; }

class Formula {
 public:
  explicit Formula(std::string_view rest) : rest_(rest) {}

  tl::expected<std::string, std::string> line() {
    std::string out = list(false);
    if (error_.empty() && !rest_.empty()) error_ = "a } has no {";
    if (!error_.empty()) return tl::unexpected(error_);
    return out;
  }

 private:
  /// Reads up to the end, or to the closing brace.
  std::string list(bool in_braces) {
    std::string out;
    last_ = {};
    while (error_.empty() && !rest_.empty() && rest_.front() != '}') add(out);
    if (in_braces && error_.empty()) {
      if (rest_.empty()) error_ = "a { has no }";
      else rest_.remove_prefix(1);
    }
    while (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
  }

  void add(std::string& out) {
    if (rest_.front() == '_' || rest_.front() == '^') return add_script(out);
    const Last last = std::exchange(last_, {});
    const std::string atom = this->atom();
    if (atom.empty()) {
      last_ = last;
      return;
    }
    // A letter right after a script would be read as a part of it.
    if (last.script && is_word(atom.front())) out += ' ';
    last_.base = atom.size() == 1 && is_letter(atom.front()) ? out.size() : std::string::npos;
    if (std::find(kRelations.begin(), kRelations.end(), atom) != kRelations.end()) {
      const bool begins = out.empty() || (out.back() == ' ' && !last.is_operator) || out.back() == '(';
      const bool sign = begins && (atom == "−" || atom == "+" || atom == "±");  // the sign of a number
      if (!begins && out.back() != ' ') out += ' ';
      out += atom;
      if (!sign) out += ' ';
    } else if (std::find(kOperators.begin(), kOperators.end(), atom) != kOperators.end()) {
      add_operator(out, atom);
    } else if (atom != " " || (!out.empty() && out.back() != ' ')) {
      out += atom;
    }
  }

  /// Appends an operator with its scripts, and then a space, so that the next letter does not look like a script.
  void add_operator(std::string& out, const std::string& name) {
    if (!out.empty() && out.back() != ' ' && out.back() != '(' && out.back() != '|') out += ' ';
    out += name;
    while (!rest_.empty() && (rest_.front() == '_' || rest_.front() == '^')) add_script(out);
    const bool called = !rest_.empty() && rest_.front() == '(' && is_letter(name.front());  // max(a, b)
    if (!called) out += ' ';
    last_ = {.is_operator = true};
  }

  void add_script(std::string& out) {
    const bool raised = rest_.front() == '^';
    rest_.remove_prefix(1);
    const std::size_t base = last_.base;
    const std::string words = argument();
    last_ = {};
    const std::string script = raised ? in_script(words, kRaised) : in_script(words, kLowered);
    if (!script.empty()) {
      out += script;
      return;
    }
    if (base != std::string::npos && ends_in_word(std::string_view(out).substr(0, base))) out.insert(base, 1, ' ');
    (out += raised ? '^' : '_') += is_compound(words) ? '(' + words + ')' : words;
    last_.script = true;
  }

  /// Reads an argument: a group in braces, or the next atom.
  std::string argument() {
    while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    if (!rest_.empty() && rest_.front() != '}') return atom();
    error_ = "something is missing at the end";
    return {};
  }

  std::string atom() {
    if (rest_.front() == '\\') return command();
    if (rest_.front() == '{') return rest_.remove_prefix(1), list(true);
    const std::string_view one = next_character(rest_);
    if (one == " ") return {};  // a space in the TeX source
    if (one == "'") return "′";
    return one == "-" ? "−" : std::string(one);
  }

  std::string command() {
    rest_.remove_prefix(1);
    std::size_t length = 0;
    while (length < rest_.size() && is_letter(rest_[length])) ++length;
    const std::string_view name = rest_.substr(0, std::max<std::size_t>(length, rest_.empty() ? 0 : 1));
    rest_.remove_prefix(name.size());
    while (length > 0 && !rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
    if (std::find(kFaces.begin(), kFaces.end(), name) != kFaces.end()) return argument();
    if (name == "frac") {
      const std::string above = argument(), below = argument();
      while (!rest_.empty() && rest_.front() == ' ') rest_.remove_prefix(1);
      const auto enclosed = [](const std::string& part) { return is_compound(part) ? '(' + part + ')' : part; };
      const bool factor = !rest_.empty() && (rest_.front() == '(' || rest_.front() == '\\' ||
                                             is_letter(rest_.front()));  // (a/b) c, not a/(b c)
      return enclosed(above) + '/' + enclosed(below) + (factor ? " " : "");
    }
    if (name == "sqrt") {
      const std::string of = argument();
      return of.size() > 1 ? "√(" + of + ')' : "√" + of;
    }
    const auto* found =
        std::find_if(kSymbols.begin(), kSymbols.end(), [&](const Name& one) { return one.tex == name; });
    if (found != kSymbols.end()) return std::string(found->plain);
    if (error_.empty()) error_ = "\\" + std::string(name) + " is not known here";
    return {};
  }

  /// What was appended last.
  struct Last {
    bool script = false;                   // in letters of the usual size
    bool is_operator = false;              // with its scripts and a space
    std::size_t base = std::string::npos;  // where it begins, if it is a letter
  };

  std::string_view rest_;
  std::string error_;
  Last last_;
};

}  // namespace

tl::expected<std::string, std::string> plain_formula(std::string_view tex) { return Formula(tex).line(); }

}  // namespace snug::lesson
