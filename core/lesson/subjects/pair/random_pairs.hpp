#pragma once

#include "lesson/subjects/pair/pair.hpp"

namespace snug::lesson {

/// The figures of the counts over random pairs, if the lesson wants them.
void add_random_counts(std::vector<Figure>& figures, const PairSubject& subject);

}  // namespace snug::lesson
