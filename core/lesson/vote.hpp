// A class votes by raising its hands: the lecturer types the counts, and nothing of them is shown before it is
// revealed.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace snug::lesson {

/// What can be voted for. hands: in the first vote and in the second, after a discussion; -1: not counted.
struct VoteRow {
  std::string name, words;  // "B", and what that choice says; "P9"
  std::array<int, 2> hands{-1, -1};
};

class Vote {
 public:
  static constexpr int kMostHands = 9999;

  /// On choices, which are called A, B, C …; or else on the places of that name; or, where there are neither, on
  /// whatever is typed.
  Vote(const std::vector<std::string>& choices, const std::vector<std::string>& places);

  /// Takes a key, named as browsers do. A digit begins a count, and so does V, which after a first vote begins the
  /// second, also while counts are typed. "12" and Enter count the next row, "2 31" or "B 31" the row of that number or
  /// name. Backspace takes a letter back, or else the last count; Escape the line. Returns whether the key meant
  /// anything.
  bool take_key(std::string_view key);

  [[nodiscard]] const std::vector<VoteRow>& rows() const { return rows_; }
  /// The vote that is counted now: 0 or 1.
  [[nodiscard]] int round() const { return round_; }
  /// Whether anything was counted in a vote.
  [[nodiscard]] bool counted(int round) const;
  /// A row's share in a vote, in per cent; 0 where nothing was counted.
  [[nodiscard]] int percent(const VoteRow& row, int round) const;

  /// What the class sees before the vote is revealed: "Second vote: A, B counted". It has no number.
  [[nodiscard]] std::string hidden_text() const;
  /// What the lecturer sees: "First vote: A 12, B 31. Second vote: A 3. Typed: 40".
  [[nodiscard]] std::string told_text() const;
  /// "A 12 (28 %), then 3 (7 %)"; for the class once it is revealed.
  [[nodiscard]] std::string row_text(const VoteRow& row) const;

 private:
  void enter();
  /// Whether a V that is typed is no name's: nothing else of the line is there, and the first vote has counts.
  [[nodiscard]] bool begins_second() const;
  [[nodiscard]] VoteRow* next_row();
  [[nodiscard]] VoteRow* row_of(std::string_view name);
  [[nodiscard]] bool counts_any() const { return counted(0) || counted(1); }

  std::vector<VoteRow> rows_;
  std::vector<std::pair<std::size_t, int>> entered_;  // rows, and what they had before
  bool open_ = false;                                 // whether anything can be voted for
  bool typing_ = false;
  int round_ = 0;
  std::string line_, mistake_;
};

}  // namespace snug::lesson
