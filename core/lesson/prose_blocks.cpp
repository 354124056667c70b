// Splits the text of a section into paragraphs, lists and tables.
#include <algorithm>
#include <string>

#include "lesson/prose.hpp"

namespace snug::lesson {
namespace {

/// A line of the text: where its first letter is, and where it ends.
struct SourceLine {
  std::size_t begin, end;
  std::size_t indent;
};

/// Where a list's item begins.
struct ItemStart {
  Block::Kind kind;
  std::size_t words;   // where its words begin
  std::string number;  // of a numbered list
};

std::vector<SourceLine> lines_of(std::string_view text) {
  std::vector<SourceLine> lines;
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t line_end = std::min(text.find('\n', from), text.size());
    std::size_t begin = from, end = line_end;
    const auto blank = [&](std::size_t i) { return text[i] == ' ' || text[i] == '\t' || text[i] == '\r'; };
    while (begin < end && blank(begin)) ++begin;
    while (end > begin && blank(end - 1)) --end;
    lines.push_back({begin, end, begin - from});
    from = line_end + 1;
  }
  return lines;
}

/// Where the next sentence begins in plain words; npos if none does.
std::size_t next_sentence(std::string_view words) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (std::string_view(".?!").find(words[i]) != std::string_view::npos && words[i + 1] == ' ') return i + 2;
  return std::string_view::npos;
}

/// Counts the sentences of a paragraph with figures, and splits stretches where one begins.
Paragraph in_sentences(Paragraph paragraph) {
  const auto is_figure = [](const Stretch& one) { return one.figure.has_value(); };
  if (std::none_of(paragraph.begin(), paragraph.end(), is_figure)) return paragraph;
  Paragraph split;
  int sentence = 0;
  for (Stretch& rest : paragraph) {
    const bool plain = !rest.link && !rest.code && !rest.figure && rest.tex.empty();
    for (auto next = next_sentence(rest.text); plain && next != std::string::npos; next = next_sentence(rest.text)) {
      Stretch& one = split.emplace_back(rest);
      one.text.resize(next);
      one.sentence = sentence++;
      rest.text.erase(0, next);
      rest.at += next;
    }
    rest.sentence = sentence;
    if (!rest.text.empty()) split.push_back(std::move(rest));
  }
  return split;
}

class Reader {
 public:
  Reader(std::string_view text, std::vector<ProseFault>& faults)
      : text_(text), faults_(faults), lines_(lines_of(text)) {}

  std::vector<Block> blocks() {
    while (next_ < lines_.size()) {
      if (is_empty(next_)) ++next_;
      else if (is_row(next_)) table();
      else if (const auto item = item_at(next_)) list(item->kind);
      else paragraph();
    }
    return std::move(blocks_);
  }

 private:
  [[nodiscard]] bool is_empty(std::size_t line) const { return lines_[line].begin == lines_[line].end; }
  [[nodiscard]] bool is_row(std::size_t line) const { return !is_empty(line) && text_[lines_[line].begin] == '|'; }
  [[nodiscard]] std::string_view words_of(std::size_t line) const {
    return text_.substr(lines_[line].begin, lines_[line].end - lines_[line].begin);
  }
  void complain(std::string what, std::size_t at) { faults_.push_back({std::move(what), at}); }

  [[nodiscard]] std::optional<ItemStart> item_at(std::size_t line) const {
    constexpr std::size_t kMostDigits = 3;
    const std::string_view words = words_of(line);
    if (words.substr(0, 2) == "- ") return ItemStart{Block::Kind::kBullets, lines_[line].begin + 2, {}};
    const std::size_t digits = std::min(words.find_first_not_of("0123456789"), words.size());
    if (digits == 0 || digits > kMostDigits || words.substr(digits, 2) != ". ") return std::nullopt;
    return ItemStart{Block::Kind::kNumbers, lines_[line].begin + digits + 2, std::string(words.substr(0, digits))};
  }

  /// Whether a formula or code that began before a line goes on there: then the line begins nothing of its own.
  [[nodiscard]] bool is_within_span(std::size_t from, std::size_t line) const {
    const std::string_view before = text_.substr(from, lines_[line].begin - from);
    for (std::size_t i = 0; i < before.size();) {
      const std::size_t end = end_of_span(before, i);
      if (end == std::string_view::npos) return true;
      i = end == i ? i + 1 : end;
    }
    return false;
  }

  /// Goes to the end of the words that begin there: an empty line, a table, or a list. A list may begin among the lines
  /// of a paragraph only with a dash or with 1: other numbers happen to be at the beginning of a line.
  std::size_t end_of_words(std::size_t from, bool in_list) {
    std::size_t end = from;
    for (bool first = true; next_ < lines_.size() && !is_empty(next_); ++next_, first = false) {
      const auto item = item_at(next_);
      const bool begins = is_row(next_) || (item && (in_list || item->number.empty() || item->number == "1"));
      if (!first && begins && !is_within_span(from, next_)) break;
      end = lines_[next_].end;
    }
    return end;
  }

  void paragraph() {
    const std::size_t from = lines_[next_].begin, end = end_of_words(from, false);
    Paragraph words = paragraph_of(text_.substr(from, end - from), faults_, Within::kSection, from);
    blocks_.push_back({.rows = {{in_sentences(std::move(words))}}});
  }

  void list(Block::Kind kind) {
    const std::size_t indent = lines_[next_].indent;
    const bool continues =
        !blocks_.empty() && blocks_.back().kind == kind && item_at(next_)->number != "1";  // after an empty line
    if (!continues) blocks_.push_back({.kind = kind});
    for (auto item = item_at(next_); item && item->kind == kind;
         item = next_ < lines_.size() && !is_empty(next_) ? item_at(next_) : std::nullopt) {
      auto& rows = blocks_.back().rows;
      const std::string due = std::to_string(rows.size() + 1);
      if (kind == Block::Kind::kNumbers && item->number != due)
        complain("has a list whose numbers are not in order: here comes " + due, lines_[next_].begin);
      if (lines_[next_].indent > indent) complain("has a list within a list", lines_[next_].begin);
      const std::size_t end = end_of_words(item->words, true);
      rows.push_back({paragraph_of(text_.substr(item->words, end - item->words), faults_, Within::kCell, item->words)});
    }
  }

  /// Where the cells of a row begin and end: between bars outside of formulas and code.
  std::vector<std::pair<std::size_t, std::size_t>> cells_of(std::size_t line) {
    const std::string_view words = words_of(line);
    std::vector<std::pair<std::size_t, std::size_t>> cells;
    std::size_t from = 1;
    for (std::size_t i = 1; i < words.size();) {
      const std::size_t end = end_of_span(words, i);
      if (words[i] == '|') cells.emplace_back(lines_[line].begin + from, lines_[line].begin + i), from = i + 1;
      i = end == i ? i + 1 : std::min(end, words.size());
    }
    if (cells.empty()) complain("has a row of a table without cells", lines_[line].begin);
    if (from == words.size()) return cells;
    complain("has a row of a table that does not end with |", lines_[line].begin);
    cells.emplace_back(lines_[line].begin + from, lines_[line].end);
    return cells;
  }

  /// Reads the line of dashes under the head of a table, which says which columns are flush right.
  void dashes(Block& table, std::size_t line) {
    for (const auto& [from, end] : cells_of(line)) {
      const std::string dashes = joined(text_.substr(from, end - from));
      const bool right = !dashes.empty() && dashes.back() == ':';
      if (dashes.find_first_not_of('-') != (right ? dashes.size() - 1 : std::string::npos) || dashes.size() < 3)
        complain("has a table whose second line is not of dashes, |---|---|, or |---|---:| for figures flush right",
                 lines_[line].begin);
      table.right.push_back(right);
    }
  }

  void table() {
    Block table{.kind = Block::Kind::kTable};
    const std::size_t head = next_, faults = faults_.size();
    for (; next_ < lines_.size() && is_row(next_); ++next_) {
      if (next_ == head + 1) {
        dashes(table, next_);
        if (table.right.size() != table.rows.front().size()) wrong_count(table.right.size(), table, next_);
        continue;
      }
      std::vector<Paragraph> row;
      for (const auto& [from, end] : cells_of(next_))
        row.push_back(paragraph_of(text_.substr(from, end - from), faults_, Within::kCell, from));
      if (next_ > head && row.size() != table.rows.front().size()) wrong_count(row.size(), table, next_);
      if (next_ > head) row.resize(table.rows.front().size());
      table.rows.push_back(std::move(row));
    }
    table.right.resize(table.rows.front().size());
    if (table.rows.size() < 2 && faults_.size() == faults)
      complain("has a table without rows: below its head come a line of dashes and the rows", lines_[head].begin);
    if (!table.right.empty()) blocks_.push_back(std::move(table));
  }

  void wrong_count(std::size_t cells, const Block& table, std::size_t line) {
    const std::size_t due = table.rows.front().size();
    complain("has a row of " + std::to_string(cells) + (cells == 1 ? " cell" : " cells") +
                 " in a table whose head has " + std::to_string(due),
             lines_[line].begin);
  }

  std::string_view text_;
  std::vector<ProseFault>& faults_;
  std::vector<SourceLine> lines_;
  std::size_t next_ = 0;  // the line
  std::vector<Block> blocks_;
};

}  // namespace

std::vector<Block> blocks_of(std::string_view text, std::vector<ProseFault>& faults) {
  return Reader(text, faults).blocks();
}

}  // namespace snug::lesson
