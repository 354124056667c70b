// The samples of the subjects' rows: one of each kind of lesson, and each opens.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "lesson/subjects.hpp"

namespace snug::lesson {

TEST_CASE("each kind of lesson has a sample in its subject's row") {
  for (const SubjectRow* row : subjects()) {
    if (row->experiment != nullptr) continue;  // it has the volumes of another
    for (const std::string_view volume : row->volumes())
      CHECK_MESSAGE(std::any_of(row->samples.begin(), row->samples.end(),
                                [&](const StageSample& sample) { return sample.volume == volume; }),
                    std::string(row->name), " ", std::string(volume));
  }
}

TEST_CASE("the samples of a subject are of its own kinds") {
  for (const SubjectRow* row : subjects())
    for (const StageSample& sample : row->samples)
      CHECK_MESSAGE(find_subject(sample.volume, row->experiment != nullptr ? row->experiment->chart : "") == row,
                    std::string(sample.volume));
}

}  // namespace snug::lesson
