// What a frame of the field takes: each way to cull it, and what the lesson does besides when its camera moves. Prints
// the table that RESULTS.md keeps: milliseconds of the processor's time, because others on the machine must not count.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "bench/ratio.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/field/field.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

Session session_with(int objects) {
  Lesson lesson;
  lesson.id = "bench";
  lesson.volume = kFrustumField;
  auto tables = std::make_shared<FieldTables>();
  tables->stage.recipe.objects = objects;
  tables->stage.now = tables->stage.before = {{-30, 8, 10}, {0, 6, 0}};
  lesson.tables = std::move(tables);
  for (const Method& method : field_methods()) lesson.algorithms.emplace_back(method.name);
  auto session = Session::open(std::move(lesson));
  if (!session) std::puts(session.error().message().c_str()), std::abort();
  return *std::move(session);
}

/// Milliseconds of the processor's time that work takes.
double milliseconds(auto&& work) {
  const std::clock_t start = std::clock();
  work();
  return 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

void measure(int objects) {
  Session session = session_with(objects);
  for (const Method& method : field_methods()) {
    if (!session.player().choose(0, method.name)) std::abort();
    session.last();
    const auto& subject = *as<FieldSubject>(session.stage().subject());
    std::vector<query::Culling> verdicts(subject.field().boxes.size());
    std::vector<std::int8_t> last(verdicts.size(), -1);
    std::vector<double> culls, frames;
    session.stage().begin_drag();
    for (int frame = 0; frame < 60; ++frame) {
      const double way = 0.05 * frame;
      frames.push_back(milliseconds([&] {
        static_cast<void>(session.stage().move(1, Point3(0, 6, way)));
        bench::keep(session.telling().figures());
        bench::keep(session.player().proofs());
        bench::keep(session.telling().caption());
      }));
      const FieldStage& stage = as<FieldSubject>(session.stage().subject())->stage();
      const auto frustum = *frustum_of(stage.recipe, stage.now);
      culls.push_back(milliseconds([&] {
        hierarchy::cull_field(subject.field(), frustum, way_of(method), last, verdicts);
        bench::keep(verdicts);
      }));
    }
    session.stage().end_drag();
    std::sort(culls.begin(), culls.end());
    std::sort(frames.begin(), frames.end());
    std::printf("| %d | %s | %.3f | %.2f | %.2f |\n", objects, method.name.data(), culls[30], frames[30], frames[57]);
  }
}

}  // namespace

int main() {
  std::puts("| boxes | way | culling, ms | a move of the camera, ms | the slowest of twenty |");
  std::puts("|---:|---|---:|---:|---:|");
  for (const int objects : {10'000, 100'000}) measure(objects);
}
