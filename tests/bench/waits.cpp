// How long a page answers nothing while a lesson takes in many new points: the longest of the pieces that it goes in,
// the time of all, and what was refused. Milliseconds of processor time, so that others on the machine do not add to
// it; the preset wasm's, under Node, are nearest to a page's. RESULTS.md keeps them.
// bench_waits [LESSON...]
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>

#include "bench/lesson_files.hpp"
#include "lesson/session.hpp"

using namespace snug;

namespace {

constexpr Index kCounts[] = {2'000, 10'000, 50'000, 99'999};

double now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }
double clock_ns() { return 1e6 * now_ms(); }

struct Wait {
  int pieces = 0;
  double longest = 0, all = 0;  // ms
};

/// Sets points of a generator and goes on until they are on the stage, or are refused. Prints a row.
void wait_for(lesson::Session& session, const std::string& id, const char* generator, Index count) {
  Wait wait;
  lesson::Done done;
  const auto timed = [&](auto&& work) {
    const double start = now_ms();
    work();
    const double took = now_ms() - start;
    ++wait.pieces, wait.all += took, wait.longest = std::max(wait.longest, took);
  };
  timed([&] { done = session.stage().set_generator(generator, count, session.stage().subject().dim(), 3); });
  while (done && session.stage().preparing() != nullptr) timed([&] { done = session.stage().go_on(0); });
  std::printf("| %s | %s:%d | %d | %.0f | %.0f | %s |\n", id.c_str(), generator, static_cast<int>(count), wait.pieces,
              wait.longest, wait.all, done ? "shown" : done.error().what.c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int count, char** words) {
  std::puts("| lesson | points | pieces | longest, ms | all, ms | |\n|---|---|---:|---:|---:|---|");
  for (const auto& path : bench::lesson_paths(std::vector<std::string>(words + 1, words + count))) {
    const std::string id = path.stem().string();
    const auto lesson = lesson::read_lesson(bench::text_of(path), path.filename().string());
    if (!lesson || !lesson->points.mesh.empty()) continue;
    for (const char* generator : {"sphere", "clusters"})
      for (const Index points : kCounts) {
        auto session = lesson::Session::open(*lesson, {}, &clock_ns);
        if (!session || session->stage().subject().points() == nullptr) continue;
        session->stage().give_way(true);
        wait_for(*session, id, generator, points);
      }
  }
}
