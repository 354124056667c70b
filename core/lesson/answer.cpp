#include "lesson/answer.hpp"

namespace snug::lesson {

std::span<const int> choices_of(const Answer& answer) {
  if (const auto* several = std::get_if<SeveralChoices>(&answer)) return several->choices;
  if (const auto* order = std::get_if<ChoicesInOrder>(&answer)) return order->choices;
  return {};
}

int choice_bits(const SeveralChoices& several) {
  int bits = 0;
  for (const int choice : several.choices) bits |= 1 << choice;
  return bits;
}

SeveralChoices choices_of_bits(int bits) {
  SeveralChoices several;
  for (int choice = 0; bits >> choice != 0; ++choice)
    if ((bits >> choice & 1) != 0) several.choices.push_back(choice);
  return several;
}

}  // namespace snug::lesson
