#include "driver.hpp"
#include "overlap.hpp"

int main() {
  for (lab::Cases cases; cases.next();) {
    const auto a = cases.aabb(), b = cases.aabb();
    cases.answer(overlap(a, b));
  }
}
