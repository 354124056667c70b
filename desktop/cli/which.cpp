#include "desktop/cli/command.hpp"
#include "desktop/cli/measured_points.hpp"
#include "desktop/cli/timing.hpp"
#include "fit/catalogue.hpp"
#include "measure/load.hpp"

namespace snug::desktop {
namespace {

/// One of each kind: those of the lesson "Choosing a bounding volume".
constexpr std::array<std::array<std::string_view, 2>, 7> kCompared{{{"sphere", "welzl"},
                                                                    {"aabb", "min_max"},
                                                                    {"obb", "dito"},
                                                                    {"kdop", "k14"},
                                                                    {"capsule", "pca"},
                                                                    {"lozenge", "pca"},
                                                                    {"hull", "quickhull"}}};
constexpr double kMostOfLoad = 1e9;

struct WhichOptions {
  PointsChoice points;
  cost::Load load;
  double hit_rate = 10;  // per cent
  int repeat = 9;
  TableOutput output;
};

/// All of them take points of either dimension, but for the 14-DOP: in the plane an 8-DOP is in its place.
std::vector<const fit::Algorithm*> compared_in(int dim) {
  std::vector<const fit::Algorithm*> algorithms;
  for (const auto& [volume, name] : kCompared)
    algorithms.push_back(fit::find_algorithm(volume, dim == 2 && volume == "kdop" ? "k8" : name));
  return algorithms;
}

CommandResult run_which(const WhichOptions& options) {
  return write_table(options.output, [&](const TableOutput& output) -> tl::expected<Printed, InputError> {
    const auto points = points_of(options.points);
    if (!points) return tl::unexpected(points.error());
    cost::Load load = options.load;
    load.hit_rate = options.hit_rate / 100;
    const cost::CostOptions how{{.seed = options.points.seed}, native_timing(options.repeat), {}};
    cost::CriteriaRun run(points->points, compared_in(fit::dim_of(points->points)), load.still(), how, native_clock());
    finish(run);
    return Printed{printed(output, provenance_of(options.points, *points), cost::which_rows(run.rows(), load))};
  });
}

constexpr const char* kWhichFooter =
    R"(Which volume when: one of each kind around the points, its five criteria measured here, and T, what it would cost in
all. The same table as the lesson "Choosing a bounding volume" saves; in JSON and CSV with every figure:
  volume, algorithm         as `snug algorithms` lists them
  points, of, whole_ns      the number of points measured, and how many there are, as of `snug cost`
  test_ns, build_ns, update_ns
                            {median, min, spread, repeats, batch, trusted} of one overlap test with a near copy, of one
                            fit, and of one update after a rotation
  over_hull                 looseness: the measure over that of the convex hull; null if that is flat
  bytes                     memory for the volume's numbers
  pairs_apart, passed, false_positives
                            pairs of such bodies near each other that are apart; how many of them the volume does not
                            reject, and their share f
  load                      {bodies, frames, updates, pairs, hit_rate, deforms}, as the options say
  total_ns                  {build, updates, tests, false_positives, total}: where T goes, where C_b is the time of a fit,
                            C_u of an update, C_v of a test and C_x of the hull's test, which is exact:
                            T = bodies C_b + frames (updates C_u + pairs C_v + pairs (1 - hit rate) f C_x)

-o FILE: the ending says the format, .csv, .json or .txt (the table printed here). Exit status: 0 done, 2 bad input or
usage.)";

}  // namespace

void add_which(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("which", "Which volume when: the five criteria, and the total cost");
  command.footer(kWhichFooter);
  const auto options = add_command<WhichOptions>(commands, command, run_which);
  add_points(command, options->points);
  const auto add_count = [&](const char* name, double& count, const char* says) {
    command.add_option(name, count, says)->check(number_in(0, kMostOfLoad))->capture_default_str();
  };
  add_count("--bodies", options->load.bodies, "How many volumes are computed, once");
  add_count("--frames", options->load.frames, "How many frames there are; in each:");
  add_count("--updates", options->load.updates, "how many volumes are updated; 0: bodies keep their orientation");
  add_count("--pairs", options->load.pairs, "how many pairs of volumes are tested");
  command.add_option("--hit-rate", options->hit_rate, "Per cent of these pairs whose bodies do overlap")
      ->check(number_in(0, 100))
      ->capture_default_str();
  command.add_flag("--deforms", options->load.deforms, "Bodies change their shape: an update is a new fit");
  command.add_option("--repeat", options->repeat, "Number of timed batches")
      ->transform(whole_number(1, 1'000'000))
      ->capture_default_str();
  add_output(command, options->output);
}

}  // namespace snug::desktop
