#include "lesson/names.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace snug::lesson {

std::string plain_name(std::string_view name) {
  constexpr std::string_view kMinus = "−";
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name.substr(i, kMinus.size()) == kMinus) plain += '-', i += kMinus.size() - 1;
    else if (name[i] >= 'A' && name[i] <= 'Z') plain += static_cast<char>(name[i] - 'A' + 'a');
    else if (name[i] != ' ') plain += name[i];
  }
  return plain;
}

int spelling_distance(std::string_view a, std::string_view b) {
  // Row i has the distances of a's first i letters from each beginning of b; the last three rows are kept.
  std::array<std::vector<int>, 3> rows;
  for (std::vector<int>& row : rows) row.resize(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<int>& row = rows[i % 3];
    const std::vector<int>&above = rows[(i - 1) % 3], &two_above = rows[(i + 1) % 3];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], two_above[j - 2] + 1);
    }
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace snug::lesson
