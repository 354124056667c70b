// What the frames of a scene take: memory, and the time to go to any of them. One scene a run, by its name, since the
// peak of the memory is that of a process. Prints a row of a table; RESULTS.md keeps them.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <vector>

#include "bench/ratio.hpp"
#include "geometry/random.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/scene/scene_run.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

struct Case {
  std::string_view name;
  int bodies, frames;
  bool solid;  // they fall on a floor and bounce; else they go round and turn
};
constexpr Case kCases[] = {
    {"broad", 40, 120, false}, {"many", 2000, 125, false}, {"crowd", 2000, 125, true}, {"long", 2000, 2000, false}};

SceneSet scene_of(const Case& one) {
  SceneSet set;
  set.frames = one.frames;
  SceneBody body{.at_points = true};
  const Vector<double, 3> half(0.06, 0.014, 0.024);
  body.body.shape = scene::Volume3(Aabb<double, 3>{-half, half});
  body.body.position = {0, 1.2, 0};
  set.bodies = {body};
  if (one.solid) {
    SceneBody floor;
    floor.body.shape = scene::Volume3(Aabb<double, 3>{{-9, -1, -9}, {9, 0, 9}});
    floor.body.fixed = true;
    set.bodies.push_back(floor);
    set.effects = {{.name = "fall"}, {.name = "bounce"}};
  } else {
    set.effects = {{.name = "orbit", .settings = {{"turns_per_second", {0.08}, ""}, {"vary", {0.9}, ""}}},
                   {.name = "spin", .settings = {{"turns_per_second", {0.2}, ""}}}};
  }
  for (const char* effect : {"refit", "broad_phase", "narrow_phase"}) set.effects.push_back({.name = effect});
  return set;
}

double at(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double peak_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void measure(const Case& one) {
  Lesson lesson;
  lesson.points = {.dim = 3, .generate = "cube", .count = one.bodies};
  lesson.seed = 5;
  const SceneSet set = scene_of(one);
  const auto points = own_points(lesson, {});
  auto run = run_scene(set, "sweep_and_prune", points.value(), lesson.seed);
  if (!run) std::puts(run.error().what.c_str()), std::abort();
  const double seconds = bench::seconds([&] { run->up_to(one.frames); });
  const auto& frames = run->up_to(one.frames).frames;
  double seen = 0;
  const auto going = [&](std::size_t frame) {
    return 1e3 * bench::seconds([&] { seen += frames[frame].bodies.front().position[0]; });
  };
  std::vector<double> back, any;
  for (std::size_t i = 0; i < 300 && i < frames.size(); ++i) back.push_back(going(frames.size() - 1 - i));
  Random random(3);
  for (int i = 0; i < 200; ++i) any.push_back(going(static_cast<std::size_t>(random.between(0, one.frames))));
  bench::keep(seen);
  std::sort(back.begin(), back.end());
  std::sort(any.begin(), any.end());
  const double frame = 1e3 * seconds / one.frames;  // with its figures and its hash
  std::printf("| %s | %d | %d | %.0f | %.2f | %.2f | %.2f | %.1f | %.2f | %.1f |\n", one.name.data(), one.bodies,
              one.frames, peak_megabytes(), frame, at(back, 0.5) / frame, at(back, 1), at(back, 1) / frame,
              at(any, 0.5), at(any, 1));
}

}  // namespace

int main(int count, char** arguments) {
  std::puts("| scene | bodies | frames | peak, MB | a frame, ms | one back / frame, median | longest, ms "
            "| / frame | any, median, ms | longest, ms |");
  std::puts("|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
  for (const Case& one : kCases)
    if (count > 1 && one.name == arguments[1]) measure(one);
}
