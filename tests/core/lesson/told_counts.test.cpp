// Counts that a lesson's prose tells, because no figure of a run can: they come out of many clouds.
#include <doctest/doctest.h>

#include "measure/trials.hpp"

using namespace snug;

namespace {

int wins_of_14_dop(std::string_view kind) {
  for (const cost::CensusRow& row : cost::census())
    if (row.kind == kind) return row.tighter();
  return -1;
}

}  // namespace

TEST_CASE("the lesson kdop-space counts right how often a 14-DOP is tighter than an OBB") {
  CHECK(wins_of_14_dop("gaussian") == 35);
  CHECK(wins_of_14_dop("stick") == 0);
}
