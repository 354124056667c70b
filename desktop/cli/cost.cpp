#include <algorithm>
#include <optional>

#include "desktop/cli/command.hpp"
#include "desktop/cli/cost_file.hpp"
#include "desktop/cli/cost_text.hpp"
#include "desktop/cli/did_you_mean.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/measured_points.hpp"
#include "desktop/cli/progress.hpp"
#include "desktop/cli/timing.hpp"
#include "measure/claim_runs.hpp"
#include "measure/cost_run.hpp"
#include "measure/growth.hpp"
#include "measure/sample.hpp"
#include "measure/trials.hpp"
#include "measure/turn_run.hpp"

namespace snug::desktop {
namespace {

/// Every frame of a turn is tested against every point.
constexpr Index kMostTurned = 100'000;
constexpr int kFrames = 72;
/// How many times as long a run with an observer and a proof may take as the timed one.
constexpr double kWatchedLonger = 10;
/// Once this much time has gone into an algorithm, three batches are enough, ns.
constexpr double kEnough = 2e9;

struct CostOptions {
  PointsChoice points;
  std::string volume;
  std::vector<std::string> algorithms;
  int repeat = 9;
  int longest = 1000;  // ms
  bool growth = false, turn = false, claims = false;
  std::string trials;  // a claim's name
  std::string against;
  TableOutput output;
};

/// The claims that can be tried.
std::string trial_names() {
  std::string list;
  for (const cost::Claim* claim : cost::tried_claims()) list.append(list.empty() ? "" : ", ").append(claim->name);
  return list;
}

using Wrong = tl::unexpected<InputError>;
Wrong wrong(std::string what) { return Wrong(InputError{.what = std::move(what)}); }

/// Whether a name, "pca" or "obb:pca", means this algorithm.
bool is_named(const fit::Algorithm& algorithm, const std::string& name) {
  return name == algorithm.name || name == std::string(algorithm.volume) + ":" + std::string(algorithm.name);
}

Wrong no_algorithm(const std::string& name) {
  std::vector<std::string> known;
  for (const fit::Algorithm& algorithm : fit::algorithms()) known.emplace_back(algorithm.name);
  return wrong("there is no algorithm \"" + name + "\"; `snug algorithms` lists all" + did_you_mean(name, known));
}

/// The chosen algorithms, in the catalogue's order, whatever the order of the names.
tl::expected<std::vector<const fit::Algorithm*>, InputError> algorithms_of(const CostOptions& options, int dim) {
  const bool known = std::find(kVolumeNames.begin(), kVolumeNames.end(), options.volume) != kVolumeNames.end();
  if (!options.volume.empty() && !known) return wrong("there is no volume \"" + options.volume + "\"");
  std::vector<const fit::Algorithm*> chosen;
  std::vector<bool> met(options.algorithms.size());
  for (const fit::Algorithm& algorithm :
       options.volume.empty() ? fit::algorithms() : fit::algorithms_of(options.volume)) {
    bool wanted = options.algorithms.empty() && !algorithm.naive;  // a result that may be wrong has no accuracy
    for (std::size_t i = 0; i < met.size(); ++i)
      if (is_named(algorithm, options.algorithms[i])) wanted = met[i] = true;
    if (wanted && fit::takes(algorithm, dim)) chosen.push_back(&algorithm);
  }
  for (std::size_t i = 0; i < met.size(); ++i)
    if (!met[i]) return no_algorithm(options.algorithms[i]);
  if (chosen.empty()) return wrong("none of these algorithms takes " + std::to_string(dim) + "-D points");
  return chosen;
}

std::string printed_costs(const CostOptions& options, const cost::Provenance& provenance,
                          const std::vector<cost::CostRow>& rows, const cost::Table<cost::CostRow>* then) {
  const std::span<const cost::CostRow> all(rows);
  if (options.output.csv) return cost::csv_of(provenance, all);
  if (!options.output.json) return text_of(provenance, all, then);
  std::string text = cost::json_of(provenance, all);
  if (then == nullptr) return text;
  std::string old = cost::json_of(then->provenance, std::span<const cost::CostRow>(then->rows));
  old.pop_back();  // the line feed
  return text.substr(0, text.size() - 2) + ",\"against\":" + old + "}\n";
}

struct Measured {
  std::string text;
  bool all_hold = true;
};

cost::TimingOptions timing_of(const CostOptions& options) {
  cost::TimingOptions timing = native_timing(options.repeat);
  timing.enough = kEnough;
  return timing;
}

tl::expected<Measured, InputError> costs(const CostOptions& options, const MeasuredPoints& subject,
                                         const std::vector<const fit::Algorithm*>& algorithms) {
  std::optional<cost::Table<cost::CostRow>> then;
  if (!options.against.empty()) {
    auto table = read_file(options.against).and_then([&](const std::string& text) {
      return read_table<cost::CostRow>(text, options.against);
    });
    if (!table) return Wrong(table.error());
    if (auto other = of_other_points(provenance_of(options.points, subject), table->provenance, options.against))
      return Wrong(std::move(*other));
    for (const cost::CostRow& row : table->rows)
      if (row.of != fit::count_of(subject.points))
        return Wrong(InputError{.what = "was measured on " + std::to_string(row.of) + " points, and here there are " +
                                        std::to_string(fit::count_of(subject.points)),
                                .file = options.against});
    then = std::move(*table);
  }
  const double longest = options.longest * 1e6;
  const cost::CostOptions chosen{
      {.seed = options.points.seed}, timing_of(options), {longest, kWatchedLonger * longest}};
  cost::CostRun run(subject.points, algorithms, chosen, native_clock());
  finish(run);
  std::vector<cost::CostRow> rows = run.rows();
  cost::mark_front(rows);
  Measured measured{printed_costs(options, provenance_of(options.points, subject), rows, then ? &*then : nullptr)};
  for (const cost::CostRow& row : rows) measured.all_hold = measured.all_hold && row.contains;
  return measured;
}

Measured growth(const CostOptions& options, const MeasuredPoints& subject,
                const std::vector<const fit::Algorithm*>& algorithms) {
  const int dim = fit::dim_of(subject.points);
  const auto points = subject.kind.empty()
                          ? std::make_shared<cost::PointStock>(subject.points, options.points.seed)
                          : std::make_shared<cost::PointStock>(subject.kind, dim, options.points.scalar == "float",
                                                               options.points.seed);
  std::vector<cost::Workload> loads;
  for (const fit::Algorithm* algorithm : algorithms)
    loads.push_back(
        cost::workload_of(*algorithm, dim, fit::count_of(subject.points), points, {.seed = options.points.seed}));
  cost::GrowthRun run(std::move(loads), timing_of(options), options.longest * 1e6, native_clock());
  finish(run);
  return {printed(options.output, provenance_of(options.points, subject), run.rows())};
}

Measured full_turn(const CostOptions& options, const MeasuredPoints& subject) {
  const int dim = fit::dim_of(subject.points);
  std::vector<const fit::UpdateStrategy*> strategies;
  for (const fit::UpdateStrategy& strategy : fit::update_strategies()) {
    const bool wanted = options.volume.empty() || strategy.volume == options.volume;
    if (wanted && (dim == 2 ? strategy.plane : strategy.space)) strategies.push_back(&strategy);
  }
  const AnyPointSet points = cost::sample(subject.points, kMostTurned, options.points.seed);
  cost::TurnRun run(points, strategies, kFrames, timing_of(options), native_clock());
  finish(run);
  Measured measured{printed(options.output, provenance_of(options.points, subject), run.rows())};
  for (const cost::TurnRow& row : run.rows()) measured.all_hold = measured.all_hold && row.contains;
  return measured;
}

Measured claims(const CostOptions& options, const MeasuredPoints& subject) {
  const auto all = cost::measured_claims();
  Progress bar("checking", static_cast<int>(all.size()));
  std::vector<cost::ClaimRow> rows;
  for (const cost::MeasuredClaim& claim : all) {
    rows.push_back(
        cost::run_claim(claim, {.points = subject.points, .seed = options.points.seed, .clock = native_clock()}));
    bar.advance();
  }
  return {printed(options.output, provenance_of(options.points, subject), rows)};
}

/// One claim on all of its clouds, which are generated: no points of the student's are measured.
tl::expected<Measured, InputError> trials(const CostOptions& options) {
  const cost::Claim* const claim = cost::find_trial(options.trials);
  if (claim == nullptr) return wrong("there is no claim \"" + options.trials + "\" to try; known: " + trial_names());
  if (!options.points.generate.empty() || !options.points.file.empty())
    return wrong("--trials generates its own clouds: give no points");
  cost::TrialRun run({claim});
  finish(run);
  cost::Provenance provenance = native_provenance();
  provenance.points = std::to_string(cost::kTrialSeeds) + " clouds of each kind";
  provenance.scalar = "double";
  return Measured{printed(options.output, provenance, run.rows())};
}

std::optional<std::string> wrong_with(const CostOptions& options) {
  const int tables = options.growth + options.turn + options.claims + (options.trials.empty() ? 0 : 1);
  if (tables > 1) return "give only one of --growth, --turn, --claims and --trials";
  const bool other = tables > 0;
  if (!options.against.empty() && other) return "--against goes with the table of costs only";
  if (!options.against.empty() && options.output.csv)
    return "--against cannot go into CSV, which has room for one table";
  if (other && !options.growth && !options.algorithms.empty()) return "--algorithms goes with costs and --growth only";
  return std::nullopt;
}

tl::expected<Measured, InputError> measured(const CostOptions& options) {
  if (const auto what = wrong_with(options)) return wrong(*what);
  if (!options.trials.empty()) return trials(options);
  const auto subject = points_of(options.points);
  if (!subject) return Wrong(subject.error());
  const int dim = fit::dim_of(subject->points);
  if (options.claims && dim == 2) return wrong("the claims are about 3-D: give 3-D points");
  if (options.claims) return claims(options, *subject);
  const auto algorithms = algorithms_of(options, dim);
  if (!algorithms) return Wrong(algorithms.error());
  if (options.turn) {
    if (!options.volume.empty() && options.volume != "sphere" && options.volume != "aabb" && options.volume != "obb" &&
        options.volume != "kdop")
      return wrong("there is no update of \"" + options.volume + "\"; known: sphere, aabb, obb, kdop");
    return full_turn(options, *subject);
  }
  if (options.growth) return growth(options, *subject, *algorithms);
  return costs(options, *subject, *algorithms);
}

CommandResult run_cost(const CostOptions& given) {
  return write_table(given.output, [&](const TableOutput& output) {
    CostOptions options = given;
    options.output = output;
    return measured(options).map([](const Measured& done) { return Printed{done.text, done.all_hold ? 0 : 1}; });
  });
}

constexpr const char* kCostFooter =
    R"(Prints a table. In JSON it is one object {"table","provenance","rows"}, in CSV the same as columns, with every figure:
  volume, algorithm         as `snug algorithms` lists them
  points, of, whole_ns      the number of points measured, and how many there are. If one run on all of them would
                            take longer than --longest, fewer are measured, and whole_ns is the estimate for all.
                            Where a limit of the algorithm's own would stop a longer run, whole_ns is null
  time_ns                   {median, min, spread, repeats, batch, trusted} of one fit without an observer, in the
                            processor's time of this thread. All algorithms are timed in rounds, a batch of each after
                            the other, so that a slow second falls on all alike; rounds that disagree are followed by
                            more, up to three times as many. spread is the distance between the quartiles over the
                            median. Above a third, or if the median is more than a fifth above min, the time is not
                            trusted: it could not be measured reliably. A single batch has no spread, null, and is
                            not trusted
  operations, steps         counts of a second run, with an observer; exact_decisions are comparisons that rounded
                            arithmetic left open, each as expensive as hundreds of the others
  size, measure             a sphere's radius, otherwise the measure; 3-D volume or 2-D area
  tightness                 size over that of the smallest volume of its kind around the same points; null if no
                            algorithm here guarantees the smallest, or if it is flat: no larger than rounding
  over_hull                 measure over that of the convex hull; null if that is flat
  bytes                     memory for the volume's numbers
  overlap_ns, overlap_pairs, overlapping
                            one overlap test with a copy of the volume, the verdict alone; half of the copies just
                            overlap and half are just apart, as a broad phase leaves them
  scene_overlap_ns          the same with copies anywhere around the volume, most of which are apart: early exits pay
  update, update_ns         the volume's tight update over a full turn of the body, and the time of one; null for
                            volumes that have none
  certificate               {contains, on_boundary, optimal}
  on_front                  whether no other algorithm is both faster and tighter; sizes that differ only by rounding
                            are equal, and so are times that differ by less than their spread or 5 %: such rows are tied

--against: beside each time the earlier one, and whether it is faster, slower or within noise: between two runs, times
          that differ by less than a quarter are not told apart.

--growth: time against the number of points, from 10 to N, with the power of n that it follows, and the theory's. If
          there are too few points to tell, there is no power.
--turn: how much larger than the tightest each update's volume is, over a full turn of the body; null if that is flat.
--claims: what two lectures say about time, storage and tightness, and what is measured here.
--trials: one claim, tried on 240 generated clouds: claim, kind, seed and points of each cloud, value (the ratio that
          the claim is about), and whether it holds there. The same on every machine. It takes no points.

-o FILE: the ending says the format, .csv, .json or .txt (the table printed here). At most 2,000,000 points; a file may
have up to 512 MiB.

Exit status: 0 done, 1 some volume does not contain all points, 2 bad input or usage.)";

}  // namespace

void add_cost(Commands& commands) {
  CLI::App& command =
      *commands.app.add_subcommand("cost", "Measure what accuracy costs: time, operations, tightness, memory");
  command.footer(kCostFooter);
  const auto options = add_command<CostOptions>(commands, command, run_cost);
  add_points(command, options->points);
  command.add_option("--volume", options->volume, "Only this kind of volume");
  command
      .add_option("--algorithms", options->algorithms,
                  "Only these, separated by commas: pca, or obb:pca for one volume only")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--repeat", options->repeat, "Number of timed batches")
      ->transform(whole_number(1, 1'000'000))
      ->capture_default_str();
  command
      .add_option("--longest", options->longest,
                  "Milliseconds that one run may take; if it would take longer, fewer points are measured")
      ->transform(whole_number(1, 1'000'000))
      ->capture_default_str();
  command.add_flag("--growth", options->growth, "Measure time against the number of points instead");
  command.add_flag("--turn", options->turn, "Measure looseness over a full turn of the body instead");
  command.add_flag("--claims", options->claims, "Measure the lectures' claims instead");
  command.add_option("--trials", options->trials,
                     "Try one of the claims on 240 clouds instead; one of " + trial_names());
  command.add_option("--against", options->against,
                     "Earlier result in CSV or JSON, on the same points, to compare with");
  add_output(command, options->output);
}

}  // namespace snug::desktop
