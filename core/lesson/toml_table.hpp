// A table of a lesson file, read key by key. It keeps the first error with its line; keys that nobody asked for are
// errors too. After an error, reading continues with empty values, so that callers need not check each time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/vector.hpp"
#include "lesson/toml.hpp"

namespace snug::lesson {

/// The first error of a file.
class Complaints {
 public:
  explicit Complaints(std::string_view file) : file_(file) {}
  /// line: counted from 1.
  void add(int line, std::string what);
  [[nodiscard]] const std::optional<InputError>& first() const { return first_; }

 private:
  std::string file_;
  std::optional<InputError> first_;
};

class TomlTable {
 public:
  /// name: the table's name in errors: "the lesson", "[points]", "[[question]]".
  TomlTable(const toml::table& table, std::string name, Complaints& complaints);

  [[nodiscard]] int line() const { return line_; }
  /// The line of a key, or of the table where the key is missing.
  [[nodiscard]] int line_of(std::string_view key) const;
  [[nodiscard]] bool has(std::string_view key) const { return table_.contains(key); }

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

  /// Complains about a key's value.
  void wrong(std::string_view key, const std::string& what);
  /// Complains about every key that was not asked for.
  void refuse_others();

 private:
  const toml::node* find(std::string_view key);
  const toml::node* require(std::string_view key);

  const toml::table& table_;
  std::string name_;
  Complaints& complaints_;
  int line_;
  std::vector<std::string> asked_;
};

}  // namespace snug::lesson
