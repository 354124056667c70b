// snug scene: runs a lesson's scene without a screen, and reports what each of its effects did.
#include <algorithm>

#include "desktop/cli/command.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/timing.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"
#include "lesson/subjects/scene/scene_run.hpp"
#include "lesson/subjects/scene/still_scene.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

struct SceneOptions {
  std::string folder;
  std::string id;
  std::string algorithm;
  int frames = 120;
  bool every = false;
};

Json json_of_frame(const scene::Scene& scene) {
  const lesson::FrameTaken frame = lesson::frame_of(scene);
  Json json{{"frame", frame.frame}};
  for (const std::string_view figure : lesson::scene_figure_names())
    json[std::string(figure)] = lesson::figure_of(frame, figure);
  const scene::World& world = scene.world();
  if (const auto& cloud = world.members.front().shape.cloud)
    json[std::string(lesson::kOverHull)] = lesson::over_hull(world.state.refitted.first, *cloud);
  json["resting"] = frame.resting;
  return json;
}

tl::expected<scene::Scene, InputError> open(const SceneOptions& options, const LessonFile& file) {
  const lesson::Lesson& own = file.lesson;
  const std::string algorithm = options.algorithm.empty() ? own.algorithms.front() : options.algorithm;
  if (std::find(own.algorithms.begin(), own.algorithms.end(), algorithm) == own.algorithms.end())
    return tl::unexpected(InputError{.what = own.id + " does not offer \"" + algorithm + "\""});
  auto scene =
      subject_of(file)
          .and_then(
              [&](const std::unique_ptr<lesson::Subject>& subject) { return lesson::declared(*subject, algorithm); })
          .and_then([](const scene::Declaration& declaration) { return scene::Scene::open(declaration, native_now); });
  if (!scene && scene.error().file.empty()) scene.error().file = file.path;
  return scene;
}

CommandResult run_scene(const SceneOptions& options) {
  // Its questions and its task are not checked here: `snug lesson check` does that, and runs every method for it.
  const auto file = find_lesson(options.folder, options.id, lesson::Checked::kAsWritten);
  if (!file) return bad_input(file.error());
  auto scene = open(options, *file);
  if (!scene) return bad_input(scene.error());
  Printed printed;
  int drawn = 1;  // the start counts
  for (int frame = 0; frame < options.frames; ++frame) {
    scene->step();
    drawn += scene->changed() ? 1 : 0;
    if (options.every) printed.text += line_of(json_of_frame(*scene));
  }
  for (const scene::Tally& tally : scene->tallies())
    printed.text += line_of({{"effect", tally.effect},
                             {"constructed", tally.constructed},
                             {"run", tally.run},
                             {"skipped", tally.skipped},
                             {"microseconds", tally.nanoseconds / 1000}});
  Json last = json_of_frame(*scene);
  last["lesson"] = file->lesson.id;
  last["frames_drawn"] = drawn;
  last["frames_skipped"] = options.frames + 1 - drawn;
  last["hash"] = hex_of(scene->world().hash());
  printed.text += line_of(last);
  return printed;
}

constexpr const char* kSceneFooter = R"(Runs a lesson's scene and prints JSON Lines:
  {"effect","constructed","run","skipped","microseconds"}   for each effect that the scene declares, in the order in
                    which a frame runs them; skipped counts the frames in which nothing that the effect reads had changed
  {"frame","all_pairs","compared","after_broad","after_loose","touching","slack","cost","energy","over_hull","resting",
   "lesson","frames_drawn","frames_skipped","hash"}   the last frame: pairs whose boxes were compared, pairs left by each
                    phase; slack: how much larger the volumes are than the tightest of their kind, in per cent; cost:
                    points that their updates examined; over_hull, if the first body is made of points: its volume
                    divided by that of its convex hull, the same yardstick for every kind (null if the hull is flat). A
                    frame is drawn only if it changed something. The hash covers every bit of the bodies, and is the
                    same natively and in WebAssembly
A lesson that declares no scene stands still: it has no effects, and only its first frame is drawn.
With --every, a line for each frame comes first.)";

}  // namespace

void add_scene(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("scene", "Run a lesson's scene without a screen");
  command.footer(kSceneFooter);
  const auto options = add_command<SceneOptions>(commands, command, run_scene);
  add_lesson_options(command, options->folder, options->id);
  command.add_option("--frames", options->frames, "Number of frames")
      ->transform(whole_number(1, 10'000'000))
      ->capture_default_str();
  command.add_option("--algorithm", options->algorithm, "One of the lesson's algorithms; by default its first");
  command.add_flag("--every", options->every, "Print every frame's figures");
}

}  // namespace snug::desktop
