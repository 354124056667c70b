// A table of a lesson file, read key by key. It collects all mistakes with their places; keys that nobody asked for are
// mistakes too. After a mistake, reading continues with empty values, so that callers need not check each time.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/vector.hpp"
#include "lesson/file_place.hpp"
#include "lesson/toml.hpp"

namespace snug::lesson {

/// Where a node stands in the file that it was read from; the beginning where it was not.
[[nodiscard]] FilePlace file_place(const toml::source_region& region);
[[nodiscard]] inline FilePlace file_place(const toml::node& node) { return file_place(node.source()); }

/// What is wrong with a file: mistakes, for which it is refused, and warnings.
class Complaints {
 public:
  explicit Complaints(std::string_view file) : file_(file) {}
  void add(FilePlace place, std::string what);
  void warn(FilePlace place, std::string what);
  /// Whether a mistake was told at that place.
  [[nodiscard]] bool has_at(FilePlace place) const;
  /// How many mistakes there are so far: what was read without a new one has none.
  [[nodiscard]] std::size_t count() const { return mistakes_.size(); }
  /// The mistake that was found first; null for none.
  [[nodiscard]] const FileError* first() const { return mistakes_.empty() ? nullptr : &mistakes_.front(); }
  /// In the order of the file.
  [[nodiscard]] std::vector<FileError> mistakes() const;
  [[nodiscard]] std::vector<FileError> warnings() const;

 private:
  std::string file_;
  std::vector<FileError> mistakes_, warnings_;
};

class TomlTable {
 public:
  /// name: the table's name in errors: "the lesson", "[points]", "[[question]]".
  TomlTable(const toml::table& table, std::string name, Complaints& complaints);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] FilePlace place() const { return place_; }
  /// The place of a key's value, or of the table where the key is missing.
  [[nodiscard]] FilePlace place_of(std::string_view key) const;
  /// Accepts a key that is not read because a mistake elsewhere leaves its meaning open.
  void allow(std::string_view key) { asked_.emplace_back(key); }
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

  /// Whether a key's value is that text; then it counts as read.
  bool is(std::string_view key, std::string_view text);

  // A key is required if no default is given. Text is trimmed, and must not be empty.
  std::string text(std::string_view key);
  std::string text_or(std::string_view key, std::string_view otherwise);
  std::int64_t integer(std::string_view key, std::int64_t least, std::int64_t most);
  std::int64_t integer_or(std::string_view key, std::int64_t least, std::int64_t most, std::int64_t otherwise);
  /// A number greater than 0.
  double number(std::string_view key, double most);
  bool flag_or(std::string_view key, bool otherwise);
  /// A list of at least `least` texts.
  std::vector<std::string> texts(std::string_view key, std::size_t least);
  /// Any number, even a NaN; `otherwise` if it is missing.
  double any_number(std::string_view key, double otherwise);
  /// A number, or a list of them; any sign.
  std::vector<double> numbers(std::string_view key);
  /// A list of points of dim numbers each.
  std::vector<Vector<double, 3>> points(std::string_view key, int dim);
  /// Null if it is missing.
  const toml::table* table(std::string_view key);
  /// An array of tables; empty if it is missing.
  std::vector<const toml::table*> tables(std::string_view key);

  /// Complains about a key's value, unless something was wrong with it already.
  void wrong(std::string_view key, const std::string& what);
  /// Notes that a key is missing; refuse_others complains about it.
  void lack(std::string_view key, std::string what);
  /// How many keys are missing so far.
  [[nodiscard]] std::size_t missing() const { return missing_.size(); }
  /// Complains about every key that was not asked for, and about every required key that is missing: at the unknown key
  /// that stands in its place, if there is one, and not at all if that is a misspelling of it. Only after this call is
  /// it known whether what was read has mistakes. Returns whether it can be used in spite of them: no required key is
  /// missing, and no unknown one is likely to be another's misspelling.
  bool refuse_others();

 private:
  const toml::node* find(std::string_view key);
  const toml::node* require(std::string_view key);
  /// Takes the next unreported sentence about a missing key, worded as the end of a sentence about another key.
  std::string next_missing();

  const toml::table& table_;
  std::string name_;
  Complaints& complaints_;
  FilePlace place_;
  std::vector<std::string> asked_;
  std::vector<std::string> missing_, missing_says_;  // keys, and what is said of each
};

}  // namespace snug::lesson
