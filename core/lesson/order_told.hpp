// How an answer that was an order is told: the right order, line by line, each with the place that it had in the
// answer.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "lesson/ask.hpp"

namespace snug::lesson {

struct OrderLine {
  std::string words;
  int place = 0;  // in the answer, counted from 1; 0 if it has none
  bool right = false;
};

/// right: the choices in the right order.
[[nodiscard]] inline std::vector<OrderLine> order_told(const Asked& asked, const Outcome& outcome,
                                                       std::span<const int> right) {
  std::vector<OrderLine> lines;
  const std::span<const int> given = choices_of(outcome.given);
  for (std::size_t i = 0; i < right.size(); ++i) {
    const std::string& words = asked.choices[right[i]];
    // Equal ones may stand either way round.
    const bool same = i < given.size() && asked.choices[given[i]] == words;
    lines.push_back({words, place_in_order(outcome.given, right[i]), outcome.right || same});
  }
  return lines;
}

}  // namespace snug::lesson
