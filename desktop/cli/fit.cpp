#include "desktop/cli/cases.hpp"
#include "desktop/cli/command.hpp"
#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/timing.hpp"
#include "desktop/cli/trace_file.hpp"
#include "desktop/cli/words.hpp"
#include "fit/catalogue.hpp"
#include "fit/rounded.hpp"
#include "lesson/point_subject.hpp"

namespace snug::desktop {
namespace {

struct FitOptions {
  Reading reading;
  std::string volume;
  std::string algorithm;
  std::string scalar;  // empty: double, or a case's own
  int dim = 0;
  std::uint64_t seed = 1;
  int repeat = 5;
  std::string steps;
  std::string file, name;  // a file's path, or a case's name
};

/// The volumes, or one volume's algorithms.
std::vector<std::string> known_names(std::string_view volume) {
  std::vector<std::string> names;
  for (const fit::Algorithm& algorithm : fit::algorithms()) {
    const std::string_view name = volume.empty() ? algorithm.volume : algorithm.name;
    const bool listed = !names.empty() && names.back() == name;
    if (!listed && (volume.empty() || algorithm.volume == volume)) names.emplace_back(name);
  }
  return names;
}

/// "; known: sphere, aabb, …", and what may have been meant.
std::string known_text(const std::string& word, std::string_view volume) {
  const auto known = known_names(volume);
  return "; known: " + joined(known) + did_you_mean(word, known);
}

/// The error if there is no such volume.
tl::expected<void, InputError> check_volume(const std::string& volume) {
  if (volume.empty()) return tl::unexpected(InputError{.what = "--volume is required" + known_text("", "")});
  if (!known_names(volume).empty()) return {};
  return tl::unexpected(InputError{.what = "there is no volume \"" + volume + '"' + known_text(volume, "")});
}

tl::expected<const fit::Algorithm*, InputError> algorithm_of(const FitOptions& options) {
  if (const fit::Algorithm* algorithm = fit::find_algorithm(options.volume, options.algorithm)) return algorithm;
  return tl::unexpected(InputError{.what = "there is no algorithm \"" + options.algorithm + "\" for " + options.volume +
                                           known_text(options.algorithm, options.volume)});
}

/// The points that are fitted, and where they are in float, what they were before they were rounded.
struct FitPoints {
  AnyPointSet set;
  std::vector<Vector<double, 3>> given = {};
};
FitPoints with_given(AnyPointSet&& set, std::vector<Vector<double, 3>>&& given) {
  if (!fit::are_float(set)) return {std::move(set)};
  return {std::move(set), std::move(given)};
}

tl::expected<FitPoints, InputError> read_points(const FitOptions& options) {
  const bool single = options.scalar == "float";
  if (!options.name.empty())
    return point_case(options.name).and_then([&](PointCase&& own) -> tl::expected<FitPoints, InputError> {
      if (options.scalar.empty() && options.dim == 0) return with_given(std::move(own.points), std::move(own.given));
      const int dim = options.dim == 0 ? fit::dim_of(own.points) : options.dim;
      return lesson::to_set(lesson::all_points(own.points), dim, single).map([&](AnyPointSet&& set) {
        return with_given(std::move(set), std::move(own.given));
      });
    });
  return read_point_file(options.file, options.reading).and_then([&](io::PointFile&& file) {
    return io::to_point_set(file, options.file, options.dim, single).map([&](AnyPointSet&& set) {
      return with_given(std::move(set), std::move(file.points));
    });
  });
}

/// Takes what a case offers first where the user names no volume or no algorithm.
tl::expected<FitOptions, InputError> completed(FitOptions options) {
  if (!options.name.empty() && !options.file.empty())
    return tl::unexpected(InputError{.what = "give either --case or a file, not both"});
  if (!options.name.empty() && options.algorithm.empty()) {
    const auto own = point_case(options.name);
    if (!own) return tl::unexpected(own.error());
    if (options.volume.empty() || options.volume == own->volume)
      options.volume = own->volume, options.algorithm = own->algorithm;
  }
  if (const auto checked = check_volume(options.volume); !checked) return tl::unexpected(checked.error());
  if (options.algorithm.empty())
    return tl::unexpected(InputError{.what = "--algorithm is required" + known_text("", options.volume)});
  if (options.name.empty() && options.file.empty()) return tl::unexpected(InputError{.what = "FILE is required"});
  return options;
}

tl::expected<FitPoints, InputError> points_of(const FitOptions& options, const fit::Algorithm& algorithm) {
  auto points = read_points(options);
  if (points && !fit::takes(algorithm, fit::dim_of(points->set)))
    return tl::unexpected(InputError{.what = options.algorithm + " takes points of " + (algorithm.plane ? "2" : "3") +
                                             " coordinates, and these have " + std::to_string(fit::dim_of(points->set)),
                                     .file = options.file});
  if (points && fit::count_of(points->set) > algorithm.max_points)
    return tl::unexpected(InputError{.what = "there are " + std::to_string(fit::count_of(points->set)) +
                                             " points, and " + options.algorithm + " takes at most " +
                                             std::to_string(algorithm.max_points),
                                     .file = options.file});
  return points;
}

/// Runs with counts, and writes the trace to a file if one is given. Each step is written as it happens, because a
/// trace can be far larger than memory.
tl::expected<fit::Watched, InputError> watch(const FitOptions& options, const fit::Algorithm& algorithm,
                                             const AnyPointSet& points) {
  const fit::Options chosen{.seed = options.seed};
  auto trace = trace_file(options.steps, options.file);
  if (!trace) return tl::unexpected(trace.error());
  if (!*trace) return algorithm.watch(points, chosen, {});
  const int dim = fit::dim_of(points);
  const fit::Watched watched = algorithm.watch(points, chosen, [&](fit::Step3&& step, const OperationCounts&) {
    (*trace)->write(fit::json_of(step, dim) + '\n');
  });
  return (*trace)->put_in_place().map([&] { return watched; });
}

Json result_of(const fit::Algorithm& algorithm, const FitPoints& points, const fit::Watched& watched,
               const cost::Timing& timing) {
  const int dim = fit::dim_of(points.set);
  const fit::Certificate& proof = watched.certificate;
  Json json;
  json[std::string(algorithm.volume)] = json_of(watched.result.volume, dim);
  json["points"] = fit::count_of(points.set);
  json["support"] = Json::array();
  for (const Index i : watched.result.support) json["support"].push_back(i);
  if (const auto* hull = std::get_if<ConvexHull<double, 3>>(&watched.result.volume); hull != nullptr && dim == 3)
    json["faces"] = hull->facets;
  json["measure"] = fit::measure_of(watched.result.volume, dim);
  json["max_outside"] = proof.max_outside;
  if (fit::are_float(points.set)) {
    const fit::Rounded rounded = fit::rounded(watched.result, proof, points.set, points.given);
    json["rounded_by"] = rounded.by;
    json["max_outside_of_file"] = rounded.max_outside;
    json["certificate_of"] = "points rounded to float";
  }
  json["certificate"] = {{"contains", proof.contains},
                         {"on_boundary", proof.on_boundary},
                         {"optimal", proof.optimal ? Json(*proof.optimal) : Json()}};
  json["steps"] = watched.steps;
  for (std::size_t i = 0; i < kOperationNames.size(); ++i)
    json["operations"][std::string(kOperationNames[i])] = watched.counts[i];
  json["time_ns"] = {{"median", timing.median}, {"min", timing.min}, {"repeats", timing.repeats}};
  return json;
}

CommandResult run_fit(const FitOptions& given) {
  const auto whole = completed(given);
  if (!whole) return bad_input(whole.error());
  const FitOptions& options = *whole;
  const auto algorithm = algorithm_of(options);
  if (!algorithm) return bad_input(algorithm.error());
  const auto points = points_of(options, **algorithm);
  if (!points) return bad_input(points.error());

  const auto watched = watch(options, **algorithm, points->set);
  if (!watched) return bad_input(watched.error());
  const fit::Options chosen{.seed = options.seed};
  const cost::Timing timing = time_of([&] { (void)(*algorithm)->fit(points->set, chosen); }, options.repeat);
  return Printed{line_of(result_of(**algorithm, *points, *watched, timing)), watched->certificate.contains ? 0 : 1};
}

constexpr const char* kFitFooter = R"(Prints one JSON object:
  the volume                {"sphere":{"center":[x,y,z],"radius":r}}; in 2-D two numbers instead of three
  points, support           how many points there are, and the indices of the support set
  faces                     of a hull in space: triangles, each three indices into its points, counter-clockwise as seen
                            from outside
  measure                   its 3-D volume or 2-D area; null if that is too large for a double
  max_outside               the farthest any point lies outside; 0 if the volume contains all points
  certificate               {contains, on_boundary, optimal}; optimal is null if the algorithm does not guarantee it
  In float the points are rounded first. measure, max_outside, the certificate and the exit status are then about the
  rounded points, and three more fields say what that leaves out:
  rounded_by                how far rounding moved a point, at most
  max_outside_of_file       the farthest any point lies outside as it was read, in double; of a case, as it is written
  certificate_of            which points the certificate is about: "points rounded to float"
  steps, operations         the number of steps, and the operation counts by name
  time_ns                   {median, min, repeats} of a run without an observer

Point files, recognized by content and extension: .xyz .csv .txt (two or three numbers a line; # begins a comment),
.obj, .ply (ascii, binary little and big endian), .stl (ascii, binary), .off (ascii); - is xyz on standard input. More
columns, statements that OBJ lacks and the like are passed over with a warning that counts them; --strict refuses them.
A file may have up to 512 MiB.

Exit status: 0 done, 1 the volume does not contain all points, 2 bad input or usage.)";

}  // namespace

void add_fit(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("fit", "Fit a volume to the points of a file");
  command.footer(kFitFooter);
  const auto options = add_command<FitOptions>(commands, command, run_fit);
  command.add_option("--volume", options->volume, "Kind of volume: " + joined(known_names("")));
  command.add_option("--algorithm", options->algorithm, "Algorithm; `snug algorithms` lists all");
  command.add_option("--scalar", options->scalar, "Number type: double or float; by default double, or a case's own")
      ->check(CLI::IsMember({"double", "float"}));
  command.add_option("--dim", options->dim, "2 or 3; by default that of the file")->transform(whole_number(2, 3));
  command.add_option("--seed", options->seed, "Seed of the random order")
      ->transform(whole_number())
      ->capture_default_str();
  command.add_option("--repeat", options->repeat, "How many times to measure the time")
      ->transform(whole_number(1, 1'000'000))
      ->capture_default_str();
  command.add_option("--steps", options->steps, "File to write the trace to, one JSON object a line");
  command.add_option("--case", options->name, std::string(kCaseHelp) + ". Its own algorithm is the default");
  command.add_option("FILE", options->file, "Point file");
  add_reading(command, options->reading);
}

}  // namespace snug::desktop
