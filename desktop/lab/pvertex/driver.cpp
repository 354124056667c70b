#include "driver.hpp"
#include "pvertex.hpp"

int main() {
  for (lab::Cases cases; cases.next();) {
    const auto box = cases.aabb();
    const auto normal = cases.vector();
    const Vertices found = vertices(box, normal);
    cases.answer(found.p, found.n);
  }
}
