// Which bodies share an island.
#include "physics/islands.hpp"

#include <doctest/doctest.h>

namespace snug::physics {

TEST_CASE("bodies in contact form an island; what is fixed does not join two") {
  System system;
  system.members.resize(6);
  system.bodies.resize(6);
  for (Member& member : system.members) member.mass = 1;
  system.members[5].mass = 0;  // the floor under all of them
  system.contacts = {{{0, 1}, true}, {{1, 2}, false}, {{0, 5}, true}, {{3, 5}, true}};
  Islands islands = islands_of(system);
  CHECK(islands.of(0) == islands.of(2));
  CHECK(islands.of(3) != islands.of(0));
  CHECK(islands.of(4) == 4);
  CHECK(island_of(system, islands, {3, 5}) == islands.of(3));
}

}  // namespace snug::physics
