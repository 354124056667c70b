// What a task's grading says of what stands on the stage.
#pragma once

#include <string>

namespace snug::lesson {

struct Grade {
  bool done = false;
  int points = 0;     // how many there are; of several goals, how many are reached
  double excess = 0;  // its size / the smallest - 1, as fit::size_of has sizes
  int support = 0;    // how many points hold the smallest volume
  std::string says;   // what is reached and what is not, in a sentence or two
};

}  // namespace snug::lesson
