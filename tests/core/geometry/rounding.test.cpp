// What the compilers must not do to our arithmetic.
#include <doctest/doctest.h>

#include "geometry/random.hpp"
#include "geometry/vector.hpp"

using namespace snug;

namespace {

template <int Dim>
__attribute__((noinline)) void there_and_back(const Vector<double, Dim>& v, Vector<double, Dim>& out) {
  const Vector<float, Dim> rounded = v.template cast<float>();
  out = rounded.template cast<double>();
}

template <int Dim>
void check_rounding() {
  Random random(3);
  for (int round = 0; round < 100; ++round) {
    Vector<double, Dim> v, out;
    for (int i = 0; i < Dim; ++i) v[i] = random.between(9999, 10001);
    there_and_back<Dim>(v, out);
    for (int i = 0; i < Dim; ++i) {
      volatile float one = static_cast<float>(v[i]);
      CHECK(out[i] == static_cast<double>(one));
    }
  }
}

}  // namespace

TEST_CASE("a double rounded to float stays rounded") {
  check_rounding<2>();
  check_rounding<3>();
}

TEST_CASE("a product and a sum are rounded each") {
  // Fused, this would be -2^-60 or so; rounded twice, it is 0.
  volatile double a = 1 + 0x1p-30, b = 1 - 0x1p-30, c = -1;
  CHECK(a * b + c == 0);
}
