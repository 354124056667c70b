#include "driver.hpp"
#include "welzl.hpp"

int main() {
  for (lab::Cases cases; cases.next();) {
    const auto sphere = smallest(cases.points());
    cases.answer(sphere.center, sphere.radius);
  }
}
