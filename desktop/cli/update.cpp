#include <cmath>
#include <numbers>
#include <optional>

#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/trace_file.hpp"
#include "fit/catalogue.hpp"
#include "fit/update/updates.hpp"
#include "geometry/turn.hpp"
#include "measure/rounding.hpp"

namespace snug::desktop {
namespace {

struct UpdateOptions {
  Reading reading;
  std::string volume;
  std::string strategy;
  std::string scalar = "double";
  int dim = 0;
  std::vector<double> axis{1, 2, 3};
  std::vector<double> move;
  double degrees = 360;
  int frames = 12;
  std::string steps;
  std::string file;
};

std::string strategy_names(std::string_view volume) {
  std::string list;
  std::string_view last;
  for (const fit::UpdateStrategy& strategy : fit::update_strategies()) {
    const std::string_view name = volume.empty() ? strategy.volume : strategy.name;
    if ((!volume.empty() && strategy.volume != volume) || name == last) continue;
    list.append(list.empty() ? "" : ", ").append(name);
    last = name;
  }
  return list;
}

tl::expected<const fit::UpdateStrategy*, InputError> strategy_of(const UpdateOptions& options) {
  if (const auto* strategy = fit::find_update(options.volume, options.strategy)) return strategy;
  const std::string known = strategy_names(options.volume);
  if (options.volume.empty() || known.empty())
    return tl::unexpected(
        InputError{.what = "there is no update of \"" + options.volume + "\"; known: " + strategy_names("")});
  return tl::unexpected(
      InputError{.what = "there is no update \"" + options.strategy + "\" of " + options.volume + "; known: " + known});
}

tl::expected<AnyPointSet, InputError> points_of(const UpdateOptions& options, const fit::UpdateStrategy& strategy) {
  auto points = read_point_file(options.file, options.reading).and_then([&](const io::PointFile& file) {
    return io::to_point_set(file, options.file, options.dim, options.scalar == "float");
  });
  if (points && !(fit::dim_of(*points) == 2 ? strategy.plane : strategy.space))
    return tl::unexpected(InputError{.what = options.strategy + " takes points of " + (strategy.plane ? "2" : "3") +
                                             " coordinates, and these have " + std::to_string(fit::dim_of(*points)),
                                     .file = options.file});
  return points;
}

/// The body's pose at a fraction of its motion. In 2-D it rotates about the origin.
Pose<double, 3> pose_at(const UpdateOptions& options, int dim, double share) {
  const double radians = options.degrees * share * std::numbers::pi / 180;
  Pose<double, 3> pose;
  if (dim == 2) pose.rotation.topLeftCorner<2, 2>() = turn(radians);
  else pose.rotation = turn(Vector<double, 3>(options.axis[0], options.axis[1], options.axis[2]), radians);
  for (std::size_t i = 0; i < options.move.size(); ++i) pose.translation[static_cast<int>(i)] = options.move[i] * share;
  return pose;
}

std::optional<std::string> wrong_with(const UpdateOptions& options, int dim) {
  const std::size_t size = dim;
  if (options.axis.size() != 3) return "--axis takes three numbers";
  if (options.axis[0] == 0 && options.axis[1] == 0 && options.axis[2] == 0)
    return "--axis has no direction: all three numbers are 0";
  if (!options.move.empty() && options.move.size() != size)
    return "--move takes " + std::to_string(dim) + " numbers for these points";
  for (const auto* list : {&options.axis, &options.move})
    for (const double number : *list)
      if (!(std::abs(number) <= 1e18)) return "--axis and --move take numbers up to 1e18";
  if (!(std::abs(options.degrees) <= 1e6)) return "--degrees takes a number up to 1e6";
  return std::nullopt;
}

/// noise: a measure no larger than this is only rounding.
Json json_of_frame(const fit::UpdateStrategy& strategy, const fit::UpdatedFrame& frame, int number, double degrees,
                   int dim, double noise) {
  Json json{{"frame", number}, {"degrees", degrees}};
  json[std::string(strategy.volume)] = json_of(frame.volume, dim);
  json["measure"] = frame.measure;
  json["slack"] = frame.tightest > noise ? Json(fit::slack(frame.measure, frame.tightest)) : Json();
  json["over_hull"] = frame.hull > noise ? Json(fit::over_hull(frame.measure, frame.hull)) : Json();
  json["contains"] = frame.contains;
  json["steps"] = frame.steps;
  for (std::size_t i = 0; i < kOperationNames.size(); ++i)
    json["operations"][std::string(kOperationNames[i])] = frame.counts[i];
  return json;
}

CommandResult run_update(const UpdateOptions& options) {
  const auto strategy = strategy_of(options);
  if (!strategy) return bad_input(strategy.error());
  const auto points = points_of(options, **strategy);
  if (!points) return bad_input(points.error());
  const int dim = fit::dim_of(*points);
  if (const auto wrong = wrong_with(options, dim)) return bad_input(*wrong);
  auto file = trace_file(options.steps, options.file);
  if (!file) return bad_input(file.error());

  const fit::UpdateBody update = fit::start_updates(**strategy, *points);
  const fit::SeeUpdateStep see = [&](const fit::UpdateStep3& step) { (*file)->write(fit::json_of(step, dim) + '\n'); };
  Printed printed;
  const double noise = cost::rounding_of(*points).noise(dim);
  for (int frame = 0; frame < options.frames; ++frame) {
    const double share = options.frames == 1 ? 1 : static_cast<double>(frame) / options.frames;
    const fit::UpdatedFrame updated = update(pose_at(options, dim, share), *file ? see : fit::SeeUpdateStep());
    if (!updated.contains) printed.status = 1;
    printed.text += line_of(json_of_frame(**strategy, updated, frame, options.degrees * share, dim, noise));
  }
  return with_trace(std::move(printed), *file);
}

constexpr const char* kUpdateFooter =
    R"(Rotates the points about the origin, moves them, and updates their volume frame by frame, beginning with the volume
fitted to the points as they are. Prints one JSON object a frame:
  frame, degrees    its number, and how far the body has rotated
  the volume        in the world frame, as `snug fit` prints it
  measure           its 3-D volume or 2-D area
  slack             how much larger it is than the tightest of its kind: 0.5 is half as large again. An oriented box is
                    compared with the box that rotates with the body. null if the tightest is flat
  over_hull         its measure divided by that of the points' convex hull: the same yardstick for every kind of volume.
                    null if the hull is flat
  contains          whether it contains all points where the body is now
  steps, operations the number of steps, and the operation counts by name

Exit status: 0 done, 1 in some frame the volume does not contain all points, 2 bad input or usage.)";

}  // namespace

void add_update(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("update", "Rotate a body and update its volume, frame by frame");
  command.footer(kUpdateFooter);
  const auto options = add_command<UpdateOptions>(commands, command, run_update);
  command.add_option("--volume", options->volume, "Kind of volume: " + strategy_names(""))->required();
  command
      .add_option("--strategy", options->strategy,
                  "sphere: " + strategy_names("sphere") + "; aabb: " + strategy_names("aabb") +
                      "; obb: " + strategy_names("obb") + "; kdop: " + strategy_names("kdop"))
      ->required();
  command.add_option("--scalar", options->scalar, "Number type: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", options->dim, "2 or 3; by default that of the file")->transform(whole_number(2, 3));
  command.add_option("--axis", options->axis, "Axis that a 3-D body rotates about: x,y,z or x y z")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->capture_default_str();
  command.add_option("--degrees", options->degrees, "How far it rotates over all frames")->capture_default_str();
  command.add_option("--move", options->move, "How far it moves over all frames: x,y,z or x,y")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--frames", options->frames, "Number of frames")
      ->transform(whole_number(1, 1'000'000))
      ->capture_default_str();
  command.add_option("--steps", options->steps, "File to write the trace of all frames to, one JSON object a line");
  command.add_option("FILE", options->file, "Point file, as for snug fit; - is xyz on standard input")->required();
  add_reading(command, options->reading);
}

}  // namespace snug::desktop
