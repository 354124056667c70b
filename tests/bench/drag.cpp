// What a frame of dragging costs: one point of a cloud is moved, the algorithms run anew, and everything that the
// page shows is worked out. Prints milliseconds; RESULTS.md keeps them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "bench/ratio.hpp"
#include "lesson/session.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

constexpr int kFrames = 200;

Lesson cloud(int count, int dim, const char* first, const char* second) {
  Lesson lesson;
  lesson.id = "drag";
  lesson.points.dim = dim;
  lesson.points.generate = "gaussian";
  lesson.points.count = count;
  lesson.algorithms = {first, "aabb_center", "ritter", "ritter_iterative", "pca", "welzl"};
  lesson.compare = second;
  return lesson;
}

/// What a view reads of a session for one frame. Returns something that depends on all of it.
double look(const Session& session) {
  double seen = static_cast<double>(session.rivals().size() + session.marks().size());
  for (int slot = 0; slot < 2; ++slot)
    if (session.method(slot) != nullptr)
      seen += static_cast<double>(session.figures(slot).size() + session.proofs(slot).size() +
                                  session.support(slot).size());
  return seen;
}

void one(int count, int dim, const char* first, const char* second) {
  auto session = Session::open(cloud(count, dim, first, second));
  if (!session) std::abort();
  session->last();
  session->begin_drag();
  std::vector<double> move, all;
  for (int frame = 0; frame < kFrames; ++frame) {
    const double turn = 0.05 * frame;
    const Vector<double, 3> to(1.5 * std::cos(turn), 1.5 * std::sin(turn), 0);
    const double moving = bench::seconds([&] { bench::keep(session->move(7, to)); });
    const double looking = bench::seconds([&] { bench::keep(look(*session)); });
    move.push_back(1e3 * moving);
    all.push_back(1e3 * (moving + looking));
  }
  session->end_drag();
  std::sort(move.begin(), move.end());
  std::sort(all.begin(), all.end());
  std::printf("| %d | %d-D | %s%s%s | %d | %.2f | %.2f | %.2f |\n", count, dim, first, *second != 0 ? " + " : "",
              second, session->steps(), move[kFrames / 2], all[kFrames / 2], all[kFrames * 95 / 100]);
}

}  // namespace

int main() {
  std::puts("| points | | algorithms | steps | moved, ms | with all that is shown, ms | 95th percentile, ms |");
  std::puts("|---:|---|---|---:|---:|---:|---:|");
  for (const char* algorithm : {"aabb_center", "ritter", "pca", "welzl", "ritter_iterative"}) {
    one(1000, 2, algorithm, "");
    one(1839, 3, algorithm, "");
    one(1839, 3, algorithm, "ritter_iterative");
  }
}
