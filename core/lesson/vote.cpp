#include "lesson/vote.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

namespace snug::lesson {
namespace {

constexpr std::size_t kLongestLine = 24;

bool is_count_digit(char c) { return c >= '0' && c <= '9'; }
char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::optional<int> whole_of(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && value >= 0 ? std::optional(value) : std::nullopt;
}

/// Whether that is how a row is called: "p9" and "9" are P9.
bool is_row_called(const VoteRow& row, std::string_view typed) {
  const auto same = [](char a, char b) { return upper(a) == upper(b); };
  if (std::equal(row.name.begin(), row.name.end(), typed.begin(), typed.end(), same)) return true;
  const auto digits = std::find_if(row.name.begin(), row.name.end(), is_count_digit);
  return digits != row.name.end() && row.name.substr(digits - row.name.begin()) == typed;
}

constexpr std::array<std::string_view, 2> kVotes{"First vote", "Second vote"};

}  // namespace

Vote::Vote(const std::vector<std::string>& choices, const std::vector<std::string>& places)
    : open_(choices.empty() && places.empty()) {
  for (const std::string& choice : choices)
    rows_.push_back({.name = std::string(1, static_cast<char>('A' + rows_.size() % 26)), .words = choice});
  if (choices.empty())
    for (const std::string& place : places) rows_.push_back({.name = place, .words = {}});
}

bool Vote::counted(int round) const {
  return std::any_of(rows_.begin(), rows_.end(), [&](const VoteRow& row) { return row.hands[round] >= 0; });
}

int Vote::percent(const VoteRow& row, int round) const {
  int all = 0;
  for (const VoteRow& each : rows_) all += std::max(0, each.hands[round]);
  return all == 0 ? 0 : static_cast<int>(std::lround(100.0 * std::max(0, row.hands[round]) / all));
}

bool Vote::begins_second() const {
  const auto of_v = [](const VoteRow& row) { return upper(row.name.front()) == 'V'; };
  return round_ == 0 && counted(0) && line_.empty() && !open_ && std::none_of(rows_.begin(), rows_.end(), of_v);
}

VoteRow* Vote::next_row() {
  for (VoteRow& row : rows_)
    if (row.hands[round_] < 0 && !row.words.empty()) return &row;
  return nullptr;
}

VoteRow* Vote::row_of(std::string_view name) {
  VoteRow* found = nullptr;
  for (VoteRow& row : rows_) {
    if (!is_row_called(row, name)) continue;
    if (found != nullptr) return nullptr;  // "1" may be A1 and B1
    found = &row;
  }
  if (found != nullptr) return found;
  const auto number = whole_of(name);
  const bool choices = !rows_.empty() && !rows_.front().words.empty();
  if (choices && number && *number >= 1 && *number <= static_cast<int>(rows_.size())) return &rows_[*number - 1];
  return open_ ? &rows_.emplace_back(VoteRow{std::string(name), {}}) : nullptr;
}

void Vote::enter() {
  const std::string line = std::exchange(line_, {});
  const std::size_t gap = line.rfind(' ');
  const auto hands = whole_of(gap == std::string::npos ? line : line.substr(gap + 1));
  if (!hands || *hands > kMostHands) return static_cast<void>(mistake_ = '"' + line + "\" has no number of hands");
  const std::string name = gap == std::string::npos ? "" : line.substr(0, line.find_last_not_of(' ', gap) + 1);
  VoteRow* const row = name.empty() ? next_row() : row_of(name);
  if (row == nullptr) {
    mistake_ =
        name.empty() ? "For which? Type its name, a space, and its hands" : "There is no \"" + name + "\" to vote for";
    return;
  }
  entered_.emplace_back(row - rows_.data(), row->hands[round_]);
  row->hands[round_] = *hands;
}

bool Vote::take_key(std::string_view key) {
  const bool letter = key.size() == 1, digit = letter && is_count_digit(key[0]);
  if (letter && upper(key[0]) == 'V' && (!typing_ || begins_second())) {
    if (round_ == 0 && counted(0)) round_ = 1, entered_.clear();
    return mistake_.clear(), typing_ = true;
  }
  if (!typing_ && digit) typing_ = true;
  if (!typing_) return false;
  if (key == "Escape") return line_.clear(), mistake_.clear(), typing_ = false, true;
  if (key == "Enter") {
    mistake_.clear();
    if (line_.empty()) typing_ = false;
    else enter();
    return true;
  }
  if (key == "Backspace" && line_.empty() && !entered_.empty()) {
    const auto [row, before] = entered_.back();
    rows_[row].hands[round_] = before;
    return entered_.pop_back(), true;
  }
  if (key == "Backspace") return line_.empty() || (line_.pop_back(), true);
  const bool black = key == "." && (line_.empty() || !open_);                        // "2.5" can only be what is typed
  if (!letter || black || static_cast<unsigned char>(key[0]) >= 0x80) return false;  // a clicker goes on
  if (line_.size() < kLongestLine && (key[0] != ' ' || !line_.empty())) line_ += upper(key[0]);
  return mistake_.clear(), true;
}

std::string Vote::hidden_text() const {
  if (!typing_ && !counts_any()) return {};
  std::string text(kVotes[round_]), names;
  for (const VoteRow& row : rows_)
    if (row.hands[round_] >= 0) names += (names.empty() ? ": " : ", ") + row.name;
  return text + names + (names.empty() ? "" : " counted");
}

std::string Vote::told_text() const {
  std::string text;
  for (int round = 0; round < 2; ++round) {
    if (!counted(round) && (round != round_ || !typing_)) continue;
    std::string rows;
    for (const VoteRow& row : rows_)
      if (row.hands[round] >= 0)
        rows += (rows.empty() ? ": " : ", ") + row.name + ' ' + std::to_string(row.hands[round]);
    text += (text.empty() ? "" : ". ") + std::string(kVotes[round]) + rows;
  }
  if (!mistake_.empty()) return text + ". " + mistake_;
  return line_.empty() ? text : text + ". Typed: " + line_;
}

std::string Vote::row_text(const VoteRow& row) const {
  std::string text = row.name;
  for (int round = 0; round < 2; ++round)
    if (counted(round))
      text += (text == row.name ? " " : ", then ") + std::to_string(std::max(0, row.hands[round])) + " (" +
              std::to_string(percent(row, round)) + " %)";
  return text;
}

}  // namespace snug::lesson
