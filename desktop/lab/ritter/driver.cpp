#include "driver.hpp"
#include "ritter.hpp"

int main() {
  for (lab::Cases cases; cases.next();) {
    const auto sphere = cases.sphere();
    const auto point = cases.vector();
    const auto grown = grow(sphere, point);
    cases.answer(grown.center, grown.radius);
  }
}
