#include "measure/axis_counts.hpp"
#include "measure/pair_cost.hpp"
#include "measure/signed_distance.hpp"
#include "query/overlap/overlaps_any.hpp"
#include "query/overlap/touching.hpp"

#include "desktop/cli/cases.hpp"
#include "desktop/cli/command.hpp"
#include "desktop/cli/fact_json.hpp"
#include "desktop/cli/in_float.hpp"
#include "desktop/cli/json_lines.hpp"
#include "desktop/cli/timing.hpp"
#include "desktop/cli/trace_file.hpp"
#include "desktop/cli/volume_json.hpp"

namespace snug::desktop {
namespace {

constexpr int kCostRepeats = 9;

struct OverlapOptions {
  std::string scalar = "double";
  int dim = 0;
  std::string steps;
  std::string file = "-", name;  // a file's path; a case's name, in place of it
  int random = 0;
  bool costs = false, exact = false, strict = false;
  std::uint64_t seed = 1;
};

struct VolumePair {
  AnyVolume a, b;
};

tl::expected<VolumePair, std::string> pair_of(const Json& json, const OverlapOptions& options, RoughAxes& rough) {
  if (!json.is_object()) return tl::unexpected(std::string("the line is not an object with the fields a and b"));
  for (const char* name : {"a", "b"})
    if (!json.contains(name)) return tl::unexpected(std::string(name) + " is missing");

  VolumeWanted wanted = volume_wanted("a", options.dim, options.scalar, options.strict ? nullptr : &rough);
  const bool b_first = may_have_either_dim(json["a"]) && !may_have_either_dim(json["b"]);
  const auto read = [&](const char* name, int dim) {
    wanted.name = name;
    wanted.dim = dim;
    return read_volume(json[name], wanted);
  };
  const char* first_name = b_first ? "b" : "a";
  const char* second_name = b_first ? "a" : "b";
  auto first = read(first_name, options.dim);
  if (!first) return tl::unexpected(first.error());
  auto second = read(second_name, may_have_either_dim(json[second_name]) ? dim_of(*first) : options.dim);
  if (!second) return tl::unexpected(second.error());
  if (dim_of(*first) != dim_of(*second))
    return tl::unexpected("a is " + std::to_string(dim_of(*first)) + "-D and b is " + std::to_string(dim_of(*second)) +
                          "-D");
  return b_first ? VolumePair{std::move(*second), std::move(*first)}
                 : VolumePair{std::move(*first), std::move(*second)};
}

// ---- the answer

template <class Scalar, int Dim>
Json json_of_result(const query::OverlapResult<Scalar, Dim>& result, query::PairTest test) {
  Json json{{"overlap", result.overlap},
            {"distance", nullptr},
            {"separating_axis", nullptr},
            {"tests", result.tests},
            {"test", query::name_of(test)}};
  if (result.distance) json["distance"] = static_cast<double>(*result.distance);
  if (result.separating_axis)
    json["separating_axis"] = {{"kind", result.separating_axis->kind},
                               {"direction", json_of_point<Scalar, Dim>(result.separating_axis->direction)},
                               {"gap", static_cast<double>(result.separating_axis->gap)}};
  return json;
}

/// Adds how near or how deep the volumes lie. The test's own answer stands: where rounding would turn a distance or a
/// depth against it, that is 0.
template <class Scalar, int Dim>
void add_distance(Json& json, const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, bool conservative) {
  const bool overlap = json["overlap"];
  const auto found = proximity::signed_distance<Scalar, Dim>(a, b);
  if (!found) return;
  const bool apart = !overlap || (conservative && found->distance > 0);
  const Json ends{{"a", json_of_point<double, Dim>(found->on_a)}, {"b", json_of_point<double, Dim>(found->on_b)}};
  if (json["distance"].is_null()) json["distance"] = apart ? std::max(found->distance, 0.0) : 0.0;
  const auto touching = overlap ? query::touch<Scalar, Dim>(a, b) : std::optional(false);
  json["touching"] = touching ? Json(*touching) : Json();
  json["nearest"] = apart ? ends : Json();
  json["penetration"] = nullptr;
  if (apart) return;
  json["penetration"] = {{"depth", touching.value_or(false) ? 0.0 : std::max(-found->distance, 0.0)},
                         {"direction", json_of_point<double, Dim>(found->direction)}};
  json["penetration"].update(ends);
}

/// Writes the steps of a pair's test. pair: the line of its answer, counted from 1.
class Trace {
 public:
  Trace(NewFile& file, std::int64_t pair, int dim) : file_(file), pair_(pair), dim_(dim) {}

  void operator()(const query::OverlapStep& step) {
    write(std::holds_alternative<query::SlabTested>(step.fact) ? "slabs" : "distance", step);
  }
  void operator()(const query::GjkStep& step) { write("gjk", step); }
  template <class Scalar, int Dim>
  void operator()(const query::SatStep<Scalar, Dim>& step) {
    write("separating_axes", step);
  }
  void count(Operation, std::int64_t) {}

  bool turned = false;  // whether the steps call the pair's second volume a

 private:
  template <class Step>
  void write(std::string_view test, const Step& step) {
    file_.write(trace_line({{"pair", pair_}, {"test", test}, {"first", turned ? "b" : "a"}}, step, dim_));
  }

  NewFile& file_;
  std::int64_t pair_;
  int dim_;
};

/// exact: whether a pair whose own test is conservative is tested by slabs, then GJK.
template <class Scalar, int Dim, class Observer>
Json answer(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, bool exact, Observer& observe) {
  const bool conservative = query::is_conservative(a.index(), b.index());
  Json json = exact && conservative
                  ? json_of_result(query::test_slabs_then_gjk(a, b, observe), query::PairTest::kSlabsThenGjk)
                  : json_of_result(query::test_any_overlap(a, b, observe), query::kPairTests[a.index()][b.index()]);
  add_distance<Scalar, Dim>(json, a, b, conservative && !exact);
  return json;
}

template <class Scalar, int Dim>
Json answer(const Volume<Scalar, Dim>& a, const Volume<Scalar, Dim>& b, bool exact, Trace* trace) {
  Ignore ignore;
  if (trace == nullptr) return answer<Scalar, Dim>(a, b, exact, ignore);
  trace->turned = query::swapped<Scalar, Dim>(a, b);
  return answer<Scalar, Dim>(a, b, exact, *trace);
}

template <int Dim>
Json answer(const Volume<double, Dim>& a, const Volume<double, Dim>& b, const OverlapOptions& options, Trace* trace) {
  return options.scalar == "float" ? answer<float, Dim>(in_float<Dim>(a), in_float<Dim>(b), options.exact, trace)
                                   : answer<double, Dim>(a, b, options.exact, trace);
}

// ---- random pairs

template <int Dim>
Json json_of_counts(const cost::AxisCounts& counts, std::uint64_t seed) {
  constexpr std::size_t kRows = query::kSatAxes<Dim>;
  const auto name = [](std::size_t row) {
    const std::string_view axes = "xyz";
    if (row < Dim) return std::string("A ") + axes[row];
    if (row < 2 * Dim) return std::string("B ") + axes[row - Dim];
    return std::string("A ") + axes[(row - 2 * Dim) / Dim] + " x B " + axes[row % Dim];
  };
  Json rows = Json::array();
  for (std::size_t row = 0; row < kRows; ++row)
    rows.push_back({{"axis", name(row)}, {"first", counts.first[row]}, {"separates", counts.separates[row]}});
  return {{"pairs", counts.pairs},
          {"seed", seed},
          {"dim", Dim},
          {"overlap", counts.overlap},
          {"apart", counts.pairs - counts.overlap},
          {"edges_alone", counts.edges_alone<Dim>()},
          {"tests_first_gap", counts.tests},
          {"tests_all", static_cast<std::int64_t>(kRows) * counts.pairs},
          {"rows", rows}};
}

CommandResult run_random(const OverlapOptions& options) {
  const Json counts = options.dim == 2
                          ? json_of_counts<2>(cost::count_axes<2>(options.random, options.seed), options.seed)
                          : json_of_counts<3>(cost::count_axes<3>(options.random, options.seed), options.seed);
  return Printed{counts.dump() + '\n'};
}

// ---- what each pair costs

CommandResult run_costs(const OverlapOptions& options) {
  cost::PairCostRun run(options.dim == 2 ? 2 : 3, options.seed, native_timing(kCostRepeats), native_clock());
  while (!run.done()) run.step();
  Printed printed;
  const auto times = [](const cost::Timing& timing) {
    return Json{{"median", timing.median}, {"min", timing.min}, {"repeats", timing.repeats}};
  };
  for (const cost::PairCost& row : run.rows()) {
    const query::PairTest test = query::kPairTests[row.a][row.b];
    printed.text += Json{{"a", kVolumeNames[row.a]},
                         {"b", kVolumeNames[row.b]},
                         {"test", query::name_of(test)},
                         {"source", query::source_of(test)},
                         {"conservative", query::is_conservative(row.a, row.b)},
                         {"apart", row.apart},
                         {"time_ns", times(row.time)},
                         {"scene_ns", times(row.scene)},
                         {"gjk_ns", times(row.gjk)}}
                        .dump() +
                    '\n';
  }
  return printed;
}

CommandResult run_overlap(const OverlapOptions& options) {
  if (options.random > 0) return run_random(options);
  if (options.costs) return run_costs(options);
  auto file = trace_file(options.steps, options.name.empty() ? options.file : "");
  if (!file) return bad_input(file.error());
  std::int64_t number = 0;
  RoughAxes rough;
  const auto answer_line = [&](const Json& json) -> tl::expected<Json, std::string> {
    const auto pair = pair_of(json, options, rough);
    if (!pair) return tl::unexpected(pair.error());
    const bool in_plane = dim_of(pair->a) == 2;
    std::optional<Trace> trace;
    if (*file) trace.emplace(**file, ++number, in_plane ? 2 : 3);
    Trace* const watch = trace ? &*trace : nullptr;
    return in_plane ? answer<2>(std::get<0>(pair->a), std::get<0>(pair->b), options, watch)
                    : answer<3>(std::get<1>(pair->a), std::get<1>(pair->b), options, watch);
  };
  return with_trace(answer_given(options.file, options.name, overlap_case, answer_line, rough), *file);
}

constexpr const char* kOverlapFooter =
    R"(Reads JSON Lines, {"a":V,"b":V} on each, and prints one object for each; empty lines are skipped.
A V may be what `snug fit` prints: other fields, such as a name, are passed over.
)";
constexpr const char* kOverlapFooterEnd = R"(A 6-DOP exists in 2-D and 3-D: it takes the
                   dimension of the other volume, or of --dim, or is 3-D.
  overlap          whether they share a point; touching volumes do. Of k-DOPs: whether they may, for a program compares
                   only their intervals, and these may overlap though the volumes are apart (see --exact)
  distance         0 if they overlap. Of k-DOPs that may: that of the bodies, which may be apart
  separating_axis  {kind, direction, gap}: a unit direction from a to b, and the separation along it; null if they
                   overlap. kind: centers, closest_points, slab, face_a, face_b, edge_edge
  touching         whether they share points, but some move, however short, parts them; decided without rounding. null
                   for pairs that only rounded numbers know: all but those of spheres, AABBs and OBBs among themselves
                   (without sphere and OBB)
  nearest          {a, b}: the nearest points of volumes that are apart; null if they overlap
  penetration      {depth, direction, a, b} of volumes that overlap, else null: the shortest move that parts them is b's,
                   by depth along direction, a unit vector; it brings the points a and b together. GJK's expanding
                   polytope finds it, within some roundings of the volumes' size
  tests            the number of axes, pairs of features or simplices tested
  test             what a program tests such a pair by: spheres, sphere_box, swept_spheres, slabs, separating_axes, gjk;
                   slabs_then_gjk with --exact

--steps writes what each test did, one JSON object a line: pair (which line of the answers), test (slabs, distance,
separating_axes, gjk), first (which of the two volumes the step calls a), step (its name), line (of the test's
pseudocode, counted from 0) and the step's own fields. The kind of an axis is 1 face_a, 2 face_b, 3 edge_edge.

Exit status: 0 done, 2 bad input or usage: one line on stderr that names the field, and nothing on stdout.)";

}  // namespace

void add_overlap(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("overlap", "Test pairs of volumes for overlap");
  command.footer(std::string(kOverlapFooter) + volumes_in_json() + kOverlapFooterEnd);
  const auto options = add_command<OverlapOptions>(commands, command, run_overlap);
  command.add_option("--scalar", options->scalar, "Number type: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", options->dim, "2 or 3; by default that of each line")->transform(whole_number(2, 3));
  command.add_option("--steps", options->steps, "File to write the trace of all tests to, one JSON object a line");
  command.add_option("--case", options->name, kCaseHelp);
  command
      .add_option(
          "--random", options->random,
          "Test this many random pairs of oriented boxes instead, by separating axes. Counts for each axis how often "
          "the test ends there (first), and how often it separates the boxes (separates)")
      ->transform(whole_number(1, 1000000));
  command.add_flag("--strict", options->strict, "Refuse axes of four digits, which are taken with a warning otherwise");
  command.add_flag("--exact", options->exact,
                   "Test k-DOPs, and k-DOPs with AABBs, by GJK too if no interval separates them: is the body apart?");
  command.add_flag(
      "--costs", options->costs,
      "Instead, measure what the test of each pair of kinds costs: a line for each of the 28 pairs, in the lesson's "
      "order, with its test and its source. time_ns: near bodies, about half of which overlap; scene_ns: bodies of a "
      "scene, most of which are apart; gjk_ns: GJK on the near ones");
  command.add_option("--seed", options->seed, "Seed of the random pairs or bodies")
      ->transform(whole_number())
      ->capture_default_str();
  command.add_option("FILE", options->file, "JSON Lines file; - is standard input")->capture_default_str();
}

}  // namespace snug::desktop
