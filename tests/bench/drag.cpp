// What a frame of dragging costs the program, in the app without a screen: the hand moves a handle by a few pixels, the
// algorithms run anew, what a door shows of it in words is worked out, and stage, timeline and inspector are drawn into
// ImGui's triangles. What the graphics card does with them is not in it. Every algorithm of every lesson has a row;
// what is set by hand is dragged by its own knob. Prints milliseconds of the processor's time, because others on the
// machine do not add to it; RESULTS.md keeps them. bench_drag [--limit MS] [LESSON...]: exit status 1 if a row's median
// is above the limit.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "app/bench.hpp"
#include "app/cover.hpp"
#include "bench/lesson_files.hpp"
#include "bench/ratio.hpp"
#include "fit/catalogue.hpp"
#include "io/point_file.hpp"
#include "lesson/prose_figures.hpp"
#include "lesson/stored.hpp"

using namespace snug;

namespace {

constexpr int kFrames = 60;
constexpr float kReach = 24;  // pixels, to which the hand goes round

struct Row {
  std::string words;
  int steps = 0, moved = 0;
  double median = 0, most = 0;  // ms; most: the 95th percentile
};

/// The page's parts at 1280 x 800.
app::Layout page() { return {{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 280, 752}, false, 88}; }

lesson::Lesson cloud(int count, int dim, const char* first, const char* second) {
  lesson::Lesson lesson;
  lesson.id = "drag";
  lesson.points.dim = dim;
  lesson.points.generate = "gaussian";
  lesson.points.count = count;
  lesson.algorithms = {first, "aabb_center", "ritter", "ritter_iterative", "pca", "welzl"};
  lesson.compare = second;
  return lesson;
}

/// Works out what a door shows of a session beside the canvas, grades too. Returns something that depends on all of it.
double words_beside(const lesson::Session& session) {
  double seen = static_cast<double>(session.player().marks().size() + session.telling().caption().size());
  for (int slot = 0; slot < 2; ++slot)
    if (session.player().method(slot) != nullptr)
      seen += static_cast<double>(session.telling().figures(slot).size() + session.player().proofs(slot).size());
  for (std::size_t task = 0; task < session.lesson().tasks.size(); ++task)
    seen += static_cast<double>(session.grade(task).says.size());
  lesson::ProseFigures figures(session.conversation());
  for (const lesson::RunFigure& figure : session.lesson().figures)
    seen += static_cast<double>(figures.of(figure).text.size());
  return seen + static_cast<double>(lesson::stored_of(session).size());
}

/// The handle to drag: a point or a vertex, but what is set by hand has its own knobs.
std::string handle_to_drag(const app::Bench& bench, lesson::Session& session) {
  const bool by_hand = session.player().method(0)->by_hand;
  for (const app::Handle& handle : bench.app.handles())
    for (Index i = 0; i < session.stage().subject().size(); ++i) {
      const bool point =
          session.stage().subject().points() != nullptr && i < fit::count_of(*session.stage().subject().points());
      if (session.stage().subject().name_of(i) == handle.id && session.stage().may_move(i) && (!by_hand || !point))
        return handle.id;
    }
  return {};
}

/// Where all handles are. Another may lie over the one that was pressed, and be the one that is dragged.
std::vector<Vector<double, 3>> places_of(const lesson::Session& session) {
  std::vector<Vector<double, 3>> all;
  for (Index i = 0; i < session.stage().subject().size(); ++i) all.push_back(session.stage().subject().at(i));
  return all;
}

/// Skips all questions: while one is asked, only its answers respond.
void skip_questions(lesson::Session& session) {
  std::vector<lesson::Outcome> skipped;
  for (const lesson::Question& question : session.lesson().questions)
    skipped.push_back({.question = question.id, .given = {}, .skipped = true});
  session.take_up(std::move(skipped));
}

/// Drags a handle around a circle. Nothing where the stage has none.
std::optional<Row> drag_on(app::Bench& bench, std::string words) {
  lesson::Session& session = bench.session();
  skip_questions(session);
  session.jump(session.player().steps());
  if (!session.stage().subject().moves_at(session.player().step())) session.jump(0);
  if (bench.app.cover() != nullptr) bench.app.cover()->show(false);
  bench.frames(3);
  const std::string name = handle_to_drag(bench, session);
  if (name.empty()) return std::nullopt;
  const app::Handle from = bench.handle(name);
  bench.press(from.x, from.y);
  Row row{.words = std::move(words)};
  std::vector<double> all;
  auto before = places_of(session);
  for (int frame = 1; frame <= kFrames; ++frame) {
    const float turn = 0.1f * static_cast<float>(frame);
    ImGui::GetIO().AddMousePosEvent(from.x + kReach * std::sin(turn), from.y + kReach * (1 - std::cos(turn)));
    const std::clock_t start = std::clock();
    bench.frames(1);
    bench::keep(words_beside(session));
    all.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    auto now = places_of(session);
    if (now != before) ++row.moved;
    before = std::move(now);
  }
  bench.release();
  std::sort(all.begin(), all.end());
  if (row.moved == 0) std::fprintf(stderr, "%s: nothing was dragged by %s\n", row.words.c_str(), name.c_str());
  row.steps = session.player().steps(), row.median = all[kFrames / 2], row.most = all[kFrames * 95 / 100];
  return row;
}

void print_head(const char* what) {
  std::printf("| %s | steps | frames moved | median, ms | 95th percentile, ms |\n|---|---:|---:|---:|---:|\n", what);
}

/// Returns whether it is within the limit.
bool print(const Row& row, double limit) {
  std::printf("| %s | %d | %d | %.2f | %.2f |%s\n", row.words.c_str(), row.steps, row.moved, row.median, row.most,
              row.median > limit ? " <- above the limit" : "");
  std::fflush(stdout);
  return row.median <= limit;
}

bool clouds(double limit) {
  print_head("points, algorithm");
  bool fine = true;
  for (const char* algorithm : {"aabb_center", "ritter", "pca", "welzl", "ritter_iterative"})
    for (const auto& [count, dim, beside] :
         {std::tuple{1000, 2, ""}, std::tuple{1839, 3, ""}, std::tuple{1839, 3, "ritter_iterative"}}) {
      app::Bench bench(cloud(count, dim, algorithm, beside), page());
      const std::string words = std::to_string(count) + " in " + std::to_string(dim) + "-D, " + algorithm +
                                (*beside != 0 ? std::string(" + ") + beside : std::string());
      if (const auto row = drag_on(bench, words)) fine = print(*row, limit) && fine;
    }
  return fine;
}

bool every_lesson(const std::vector<std::string>& wanted, double limit) {
  print_head("lesson, algorithm");
  bool fine = true;
  for (const auto& path : bench::lesson_paths(wanted)) {
    const auto lesson = lesson::read_lesson(bench::text_of(path), path.filename().string());
    if (!lesson) std::abort();
    std::optional<io::PointFile> mesh;
    if (const std::string& name = lesson->points.mesh; !name.empty())
      mesh = *io::read_points(bench::text_of(SNUG_ASSETS_DIR "/meshes/" + name + ".ply"), name);
    for (const std::string& algorithm : lesson->algorithms) {
      app::Bench bench(*lesson, page(), mesh);
      if (!bench.session().player().choose(0, algorithm)) continue;
      if (const auto row = drag_on(bench, path.stem().string() + ", " + algorithm)) fine = print(*row, limit) && fine;
    }
  }
  return fine;
}

}  // namespace

int main(int count, char** words) {
  doctest::Context context;  // for what the front end without a screen asserts
  context.setAsDefaultForAssertsOutOfTestCases();
  context.setAssertHandler([](const doctest::AssertData& data) {
    if (!data.m_failed) return;
    std::fprintf(stderr, "%s:%d: %s\n", data.m_file, data.m_line, data.m_expr);
    std::abort();
  });
  double limit = HUGE_VAL;
  std::vector<std::string> wanted;
  for (int i = 1; i < count; ++i)
    if (std::string(words[i]) == "--limit" && i + 1 < count) limit = std::atof(words[++i]);
    else wanted.emplace_back(words[i]);
  bool fine = wanted.empty() ? clouds(limit) : true;
  if (wanted.empty()) std::puts("");
  fine = every_lesson(wanted, limit) && fine;
  return fine ? 0 : 1;
}
