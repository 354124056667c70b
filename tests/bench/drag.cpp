// What a frame of dragging costs: one handle is moved, the algorithms run anew, and everything that the page shows is
// worked out. First clouds, then every lesson of the course. Prints milliseconds; RESULTS.md keeps them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bench/ratio.hpp"
#include "io/point_file.hpp"
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

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The processor's time, because others on the machine do not add to it. A handle may be refused some places: then it
/// stays.
void drag_in(Session& session, const std::string& words) {
  constexpr int kFew = 60;
  session.jump(session.steps());
  Index handle = 0;
  while (handle < session.size() && !session.may_move(handle)) ++handle;
  if (handle == session.size()) return;
  const Vector<double, 3> from = session.point(handle);
  double reach = 0;
  for (Index i = 0; i < session.size(); ++i) reach = std::max(reach, (session.point(i) - from).norm());
  session.begin_drag();
  std::vector<double> all;
  int moved = 0;
  for (int frame = 1; frame <= kFew; ++frame) {
    const double turn = 0.1 * frame;
    const Vector<double, 3> to = from + 0.05 * reach * Vector<double, 3>(std::sin(turn), 1 - std::cos(turn), 0);
    const std::clock_t start = std::clock();
    if (session.move(handle, to)) ++moved;
    bench::keep(look(session));
    all.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  session.end_drag();
  std::sort(all.begin(), all.end());
  std::printf("| %s | %d | %d | %.2f | %.2f |\n", words.c_str(), session.steps(), moved, all[kFew / 2],
              all[kFew * 95 / 100]);
}

void every_lesson() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(SNUG_LESSONS_DIR))
    if (entry.path().extension() == ".toml" && entry.path().stem() != "course") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::puts("\n| lesson, algorithm | steps | frames moved | median, ms | 95th percentile, ms |");
  std::puts("|---|---:|---:|---:|---:|");
  for (const auto& path : paths) {
    const auto lesson = read_lesson(text_of(path), path.filename().string(), Checked::kAsWritten);
    if (!lesson) std::abort();
    std::optional<io::PointFile> mesh;
    if (const std::string& name = lesson->points.mesh; !name.empty())
      mesh = *io::read_points(text_of(SNUG_ASSETS_DIR "/meshes/" + name + ".ply"), name);
    for (const std::string& algorithm : lesson->algorithms) {
      auto session = Session::open(*lesson, mesh);
      if (!session) std::abort();
      if (session->choose(0, algorithm)) drag_in(*session, path.stem().string() + ", " + algorithm);
    }
  }
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
  every_lesson();
}
