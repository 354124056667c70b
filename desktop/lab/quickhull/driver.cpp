#include "driver.hpp"
#include "quickhull.hpp"

int main() {
  for (lab::Cases cases; cases.next();) {
    const auto points = cases.points<2>();
    const int a = static_cast<int>(cases.number()), b = static_cast<int>(cases.number());
    cases.answer(farthest(points, a, b));
  }
}
