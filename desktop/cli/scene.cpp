// snug scene: runs a lesson's scene without a screen, and reports what each of its effects did.
#include <algorithm>
#include <charconv>
#include <optional>

#include "desktop/cli/command.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/lesson_commands.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/timing.hpp"
#include "lesson/subjects/scene/scene.hpp"
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
  std::vector<std::string> pushes;
};

/// A body that is pushed after a frame.
struct BodyPushed {
  int after = 0;
  std::size_t body = 0;
  std::string asked;  // as it was asked for
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
  int awake = 0;
  for (std::size_t i = 0; i < world.size(); ++i) awake += world.awake(i) ? 1 : 0;
  json["awake"] = awake;
  return json;
}

/// The body of a name: that of its handle on the stage, or the one in the file. None if there is none.
std::optional<std::size_t> body_named(const lesson::Subject& subject, const scene::World& world,
                                      std::string_view name) {
  if (const auto* own = lesson::as<lesson::SceneSubject>(subject); own != nullptr && own->set().at_points())
    for (Index i = 0; i < own->size(); ++i)
      if (own->name_of(i) == name) return own->set().first_at_points() + static_cast<std::size_t>(i);
  for (std::size_t i = 0; i < world.size(); ++i)
    if (!name.empty() && world.members[i].name == name) return i;
  return std::nullopt;
}

/// Reads "240:P1". Errors: it is not that; a frame that is not run; no such body.
tl::expected<BodyPushed, InputError> push_of(const std::string& asked, int frames, const lesson::Subject& subject,
                                             const scene::World& world) {
  const auto refuse = [&](const std::string& why) {
    return tl::unexpected(InputError{.what = "--push " + asked + ": " + why});
  };
  const std::size_t colon = asked.find(':');
  BodyPushed push{.asked = asked};
  const char* const end = asked.data() + std::min(colon, asked.size());
  const auto [read, error] = std::from_chars(asked.data(), end, push.after);
  if (colon == std::string::npos || error != std::errc{} || read != end || push.after < 1)
    return refuse("must be a frame from 1 on and the name of a body, as 240:P1");
  if (push.after >= frames) return refuse("frame " + std::to_string(frames) + " is the last one that is run");
  const auto body = body_named(subject, world, std::string_view(asked).substr(colon + 1));
  if (!body) return refuse("the scene has no body \"" + asked.substr(colon + 1) + "\"");
  push.body = *body;
  return push;
}

tl::expected<std::vector<BodyPushed>, InputError> pushes_of(const SceneOptions& options, const lesson::Subject& subject,
                                                            const scene::World& world) {
  std::vector<BodyPushed> pushes;
  for (const std::string& asked : options.pushes) {
    auto push = push_of(asked, options.frames, subject, world);
    if (!push) return tl::unexpected(std::move(push.error()));
    pushes.push_back(*std::move(push));
  }
  return pushes;
}

tl::expected<scene::Scene, InputError> open(const SceneOptions& options, const LessonFile& file,
                                            const lesson::Subject& subject) {
  const lesson::Lesson& own = file.lesson;
  const std::string algorithm = options.algorithm.empty() ? own.algorithms.front() : options.algorithm;
  if (std::find(own.algorithms.begin(), own.algorithms.end(), algorithm) == own.algorithms.end())
    return tl::unexpected(InputError{.what = own.id + " does not offer \"" + algorithm + "\""});
  auto scene = lesson::declared(subject, algorithm).and_then([](const scene::Declaration& declaration) {
    return scene::Scene::open(declaration, native_now);
  });
  if (!scene && scene.error().file.empty()) scene.error().file = file.path;
  return scene;
}

CommandResult run_scene(const SceneOptions& options) {
  // Its questions and its task are not checked here: `snug lesson check` does that, and runs every method for it.
  const auto file = find_lesson(options.folder, options.id, Read::kAsWritten);
  if (!file) return bad_input(file.error());
  const auto subject = subject_of(*file);
  if (!subject) return bad_input(subject.error());
  auto scene = open(options, *file, **subject);
  if (!scene) return bad_input(scene.error());
  const auto pushes = pushes_of(options, **subject, scene->world());
  if (!pushes) return bad_input(pushes.error());
  Printed printed;
  int drawn = 1;  // the start counts
  for (int frame = 0; frame < options.frames; ++frame) {
    for (const BodyPushed& push : *pushes)
      if (push.after == frame && !scene->push(push.body))
        return bad_input("--push " + push.asked + ": velocities do not move this body");
    scene->step();
    drawn += scene->changed() ? 1 : 0;
    if (options.every) printed.text += line_of(json_of_frame(*scene));
  }
  for (const scene::EffectTally& tally : scene->tallies())
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
   "awake","lesson","frames_drawn","frames_skipped","hash"}   the last frame: pairs whose boxes were compared, pairs
                    left by each phase; slack: how much larger the volumes are than the tightest of their kind, in per
                    cent; cost: points that their updates examined; over_hull, if the first body is made of points: its volume
                    divided by that of its convex hull, the same yardstick for every kind (null if the hull is flat). A
                    frame is drawn only if it changed something. The hash covers every bit of the bodies, and is the
                    same natively and in WebAssembly. awake: how many bodies that velocities move are not asleep
--push FRAME:BODY makes a body hop after that frame, as a tap on it does on the stage: 240:P1. What touches it wakes as
well. A body is named as on the stage, or as in the lesson's file.
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
  command
      .add_option("--push", options->pushes, "Make a body hop after a frame, FRAME:BODY; may be given several times")
      ->allow_extra_args(false);
  command.add_flag("--every", options->every, "Print every frame's figures");
}

}  // namespace snug::desktop
