#include "driver.hpp"
#include "sat.hpp"

int main() {
  for (lab::Cases cases; cases.next();) {
    const auto a = cases.obb(), b = cases.obb();
    cases.answer(overlap(a, b));
  }
}
