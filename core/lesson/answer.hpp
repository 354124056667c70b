// An answer to a question, by its kind.
#pragma once

#include <span>
#include <variant>
#include <vector>

#include "geometry/vector.hpp"

namespace snug::lesson {

struct Skipped {
  bool operator==(const Skipped&) const = default;
};
/// A handle of the stage, by its index.
struct OneHandle {
  Index handle = 0;
  bool operator==(const OneHandle&) const = default;
};
/// Several, rising.
struct SeveralHandles {
  std::vector<Index> handles;
  bool operator==(const SeveralHandles&) const = default;
};
/// One of the question's choices, counted from 0.
struct OneChoice {
  int choice = 0;
  bool operator==(const OneChoice&) const = default;
};
/// Several, rising; none may be right.
struct SeveralChoices {
  std::vector<int> choices;
  bool operator==(const SeveralChoices&) const = default;
};
/// All choices, first to last.
struct ChoicesInOrder {
  std::vector<int> choices;
  bool operator==(const ChoicesInOrder&) const = default;
};
struct TypedNumber {
  double number = 0;
  bool operator==(const TypedNumber&) const = default;
};

using Answer = std::variant<Skipped, OneHandle, SeveralHandles, OneChoice, SeveralChoices, ChoicesInOrder, TypedNumber>;

/// One function for each kind: std::visit(ByKind{[](Skipped) {…}, …}, answer).
template <class... Functions>
struct ByKind : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
ByKind(Functions...) -> ByKind<Functions...>;

[[nodiscard]] inline bool is_skipped(const Answer& answer) { return std::holds_alternative<Skipped>(answer); }

/// The choices of an answer that can have several; empty for every other.
[[nodiscard]] std::span<const int> choices_of(const Answer& answer);

/// Choices as bits, the form in which several are kept and handed in; and back, rising.
[[nodiscard]] int choice_bits(const SeveralChoices& several);
[[nodiscard]] SeveralChoices choices_of_bits(int bits);

}  // namespace snug::lesson
