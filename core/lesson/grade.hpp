// The grade of a task, for what is on the stage.
#pragma once

#include <string>

namespace snug::lesson {

struct Grade {
  bool done = false;
  int points = 0;     // how many points there are, or how many of several goals are reached
  double excess = 0;  // its size / the smallest - 1, with the sizes of fit::size_of
  int support = 0;    // how many points support the smallest volume
  std::string says;   // what is reached and what is not, in a sentence or two
};

}  // namespace snug::lesson
