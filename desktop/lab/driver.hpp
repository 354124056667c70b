// Reads cases as numbers from standard input, and writes what the function gives. `snug lab check` talks to it.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <vector>

#include <snug/geometry/aabb.hpp>
#include <snug/geometry/obb.hpp>
#include <snug/geometry/sphere.hpp>

namespace lab {

/// What the function prints goes to standard error, for standard output has the answers.
class Cases {
 public:
  Cases() : answers_(fdopen(dup(STDOUT_FILENO), "w")) { dup2(STDERR_FILENO, STDOUT_FILENO); }
  Cases(const Cases&) = delete;
  Cases& operator=(const Cases&) = delete;
  ~Cases() { std::fclose(answers_); }

  /// Whether there is another case.
  bool next() { return std::scanf("%lf", &first_) == 1; }

  double number() {
    double value = first_;
    if (is_first_) is_first_ = false;
    else if (std::scanf("%lf", &value) != 1) value = 0;
    return value;
  }
  template <int Dim = 3>
  snug::Vector<double, Dim> vector() {
    snug::Vector<double, Dim> p;
    for (int i = 0; i < Dim; ++i) p[i] = number();
    return p;
  }
  template <int Dim = 3>
  std::vector<snug::Vector<double, Dim>> points() {
    std::vector<snug::Vector<double, Dim>> all(static_cast<std::size_t>(number()));
    for (auto& p : all) p = vector<Dim>();
    return all;
  }
  snug::Aabb<double, 3> aabb() {
    const auto min = vector();
    return {min, vector()};
  }
  snug::Sphere<double, 3> sphere() {
    const auto center = vector();
    return {center, number()};
  }
  snug::Obb<double, 3> obb() {
    snug::Obb<double, 3> box;
    box.center = vector();
    for (int i = 0; i < 3; ++i) box.axes.col(i) = vector();
    box.half_extents = vector();
    return box;
  }

  template <class... Parts>
  void answer(const Parts&... parts) {
    (put(parts), ...);
    std::fputc('\n', answers_);
    std::fflush(answers_);
    is_first_ = true;
  }

 private:
  void put(double value) { std::fprintf(answers_, "%.17g ", value); }
  void put(const snug::Vector<double, 3>& p) { put(p[0]), put(p[1]), put(p[2]); }

  std::FILE* answers_;
  double first_ = 0;
  bool is_first_ = true;
};

}  // namespace lab
