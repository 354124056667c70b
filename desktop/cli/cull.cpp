#include <algorithm>
#include <cmath>

#include "desktop/cli/cases.hpp"
#include "desktop/cli/command.hpp"
#include "desktop/cli/cull_tree.hpp"
#include "desktop/cli/fact_json.hpp"
#include "desktop/cli/in_float.hpp"
#include "desktop/cli/json_lines.hpp"
#include "desktop/cli/trace_file.hpp"
#include "desktop/cli/volume_json.hpp"
#include "desktop/cli/words.hpp"
#include "hierarchy/build.hpp"
#include "measure/frustum_meets.hpp"
#include "measure/sphere_survey.hpp"
#include "query/cull/classify.hpp"
#include "query/cull/classify_corners.hpp"
#include "query/exhibits/wrong_corners_outside.hpp"

namespace snug::desktop {
namespace {

struct CullOptions {
  std::string scalar = "double";
  int dim = 0;
  std::string test = "planes";
  std::string tree;
  std::int64_t leaf = hierarchy::Options().most_in_leaf;
  std::string steps;
  std::string file = "-", name;  // a file's path; a case's name, in place of it
  std::int64_t survey = 0;       // spheres; 0 for none
  std::uint64_t seed = 1;
  bool strict = false;
};

/// A frustum as it is written: a plane for each row (4 or 6; 3 or 5 where the far plane is null), or one row of a
/// matrix.
struct FrustumRows {
  std::vector<std::vector<double>> rows;
  ClipDepth clip = ClipDepth::kFromMinusOne;

  [[nodiscard]] bool is_matrix() const { return rows.size() == 1; }
  [[nodiscard]] int dim() const { return rows.size() == 3 || rows.size() == 4 ? 2 : 3; }
  friend bool operator==(const FrustumRows& a, const FrustumRows& b) = default;
};

tl::unexpected<std::string> fault(std::string what) { return tl::unexpected(std::move(what)); }

/// Checks that an object has exactly these fields.
tl::expected<void, std::string> has_just(const Json& json, const std::string& self,
                                         const std::vector<std::string>& fields) {
  const std::string listed = joined(fields);
  if (!json.is_object()) return fault(self + " is not an object with " + listed);
  for (const auto& item : json.items())
    if (std::find(fields.begin(), fields.end(), item.key()) == fields.end())
      return fault(self + " has an unknown field " + Json(item.key()).dump() + "; it takes " + listed);
  return {};
}

/// Reads a number of numbers, all in the range of the scalar.
tl::expected<std::vector<double>, std::string> numbers_of(const Json& json, const std::string& self, std::size_t count,
                                                          bool as_float) {
  if (!json.is_array()) return fault(self + " is not a list of numbers");
  if (json.size() != count)
    return fault(self + " has " + std::to_string(json.size()) + " numbers instead of " + std::to_string(count));
  constexpr double kFloat = Frustum<float, 3>::kLargest, kDouble = Frustum<double, 3>::kLargest;
  const double largest = as_float ? 4 * kFloat * kFloat : 4 * kDouble * kDouble;
  std::vector<double> numbers;
  for (const Json& item : json) {
    const std::string place = self + "[" + std::to_string(numbers.size()) + "]";
    if (!item.is_number()) return fault(place + " is not a number");
    numbers.push_back(item.get<double>());
    if (!(std::abs(numbers.back()) <= largest)) return fault(place + " is larger than this program can take");
  }
  return numbers;
}

/// Reads the clip space of a matrix. Errors: another value.
tl::expected<ClipDepth, std::string> clip_of(const Json& frustum) {
  if (!frustum.contains("clip") || frustum["clip"] == "-1..1") return ClipDepth::kFromMinusOne;
  if (frustum["clip"] == "0..1") return ClipDepth::kFromZero;
  return fault("frustum.clip is neither \"-1..1\" nor \"0..1\"");
}

tl::expected<FrustumRows, std::string> read_matrix(const Json& frustum, const CullOptions& options) {
  if (options.dim == 2) return fault("frustum.view_projection is 3-D, and --dim is 2");
  const auto clip = clip_of(frustum);
  if (!clip) return fault(clip.error());
  auto row = numbers_of(frustum["view_projection"], "frustum.view_projection", 16, options.scalar == "float");
  if (!row) return fault(row.error());
  return FrustumRows{{std::move(*row)}, *clip};
}

tl::expected<FrustumRows, std::string> read_planes(const Json& planes, const CullOptions& options) {
  if (!planes.is_array()) return fault("frustum.planes is not a list of planes");
  const auto has = "frustum.planes has " + std::to_string(planes.size()) + " rows instead of ";
  if (planes.size() != 6 && planes.size() != 4) return fault(has + "6 (in 2-D 4)");
  const std::size_t dim = planes.size() / 2;
  if (options.dim != 0 && dim != static_cast<std::size_t>(options.dim))
    return fault(has + std::to_string(2 * options.dim));
  FrustumRows frustum;
  frustum.rows.resize(planes.back().is_null() ? planes.size() - 1 : planes.size());
  for (std::size_t i = 0; i < frustum.rows.size(); ++i) {
    auto row = numbers_of(planes[i], "frustum.planes[" + std::to_string(i) + "]", dim + 1, options.scalar == "float");
    if (!row) return fault(row.error());
    frustum.rows[i] = std::move(*row);
  }
  return frustum;
}

tl::expected<FrustumRows, std::string> read_frustum(const Json& frustum, const CullOptions& options) {
  if (const auto fields = has_just(frustum, "frustum", {"planes", "view_projection", "clip"}); !fields)
    return fault(fields.error());
  if (frustum.contains("planes") == frustum.contains("view_projection"))
    return fault("frustum must have exactly one of the fields planes, view_projection");
  if (frustum.contains("view_projection")) return read_matrix(frustum, options);
  if (frustum.contains("clip")) return fault("frustum.clip goes with view_projection only");
  return read_planes(frustum["planes"], options);
}

/// The planes, as far as they are given: a far plane at infinity is zero.
template <class Scalar, int Dim>
tl::expected<typename Frustum<Scalar, Dim>::Planes, InputError> planes_of(const FrustumRows& frustum) {
  if constexpr (Dim == 3)
    if (frustum.is_matrix()) {
      const std::vector<Scalar> matrix(frustum.rows[0].begin(), frustum.rows[0].end());
      return planes_of_matrix<Scalar>(std::span<const Scalar>(matrix), frustum.clip);
    }
  typename Frustum<Scalar, Dim>::Planes planes;
  for (std::size_t i = 0; i < frustum.rows.size(); ++i) {
    for (int k = 0; k < Dim; ++k) planes[i].normal[k] = static_cast<Scalar>(frustum.rows[i][k]);
    planes[i].d = static_cast<Scalar>(frustum.rows[i][Dim]);
  }
  return planes;
}

/// The frustum, ended beyond volumes of coordinates up to a size where it has no end; then has_end is false.
template <class Scalar, int Dim>
struct GivenFrustum {
  Frustum<Scalar, Dim> frustum;
  bool has_end = true;
};
template <class Scalar, int Dim>
tl::expected<GivenFrustum<Scalar, Dim>, InputError> frustum_of(const FrustumRows& rows, Scalar size) {
  const auto planes = planes_of<Scalar, Dim>(rows);
  if (!planes) return tl::unexpected(planes.error());
  const bool has_end = rows.is_matrix() ? !is_endless(*planes) : rows.rows.size() == planes->size();
  return Frustum<Scalar, Dim>::make(has_end ? *planes : ended_beyond(*planes, size)).map([&](const auto& frustum) {
    return GivenFrustum<Scalar, Dim>{frustum, has_end};
  });
}

/// No coordinate of the volume is larger.
template <class Scalar, int Dim>
Scalar size_of_volume(const Volume<Scalar, Dim>& volume) {
  return std::visit([](const auto& shape) { return query::span_size(shape) + query::radius_of(shape); }, volume);
}

/// The true class, whatever the single planes say; null if it is unknown.
template <class Scalar, int Dim>
Json exact_class(const Frustum<Scalar, Dim>& frustum, const Volume<Scalar, Dim>& volume, query::Culling verdict) {
  const auto named = [](query::Culling culling) { return query::kCullingNames[static_cast<std::size_t>(culling)]; };
  if (verdict != query::Culling::kIntersecting) return named(verdict);
  const auto meet = proximity::meets<Scalar, Dim>(frustum, volume);
  return meet ? Json(named(*meet ? verdict : query::Culling::kOutside)) : Json();
}

template <class Scalar, int Dim>
Json plane_json(const query::PlaneTested<Scalar, Dim>& fact) {
  return {{"plane", fact.plane},
          {"p_vertex", json_of_point<Scalar, Dim>(fact.p_point)},
          {"n_vertex", json_of_point<Scalar, Dim>(fact.n_point)},
          {"side", query::kCullingNames[static_cast<std::size_t>(fact.side)]},
          {"p_distance", static_cast<double>(fact.p_distance)},
          {"n_distance", static_cast<double>(fact.n_distance)}};
}

/// Tests the box's vertices, as --test says. Errors: it is not a box.
template <class Scalar, int Dim>
tl::expected<query::CullResult, std::string> by_corners(const std::string& test, const Frustum<Scalar, Dim>& frustum,
                                                        const Volume<Scalar, Dim>& volume,
                                                        query::ClassifyRecorder<Scalar, Dim>& steps) {
  const auto test_box = [&](const auto& box) {
    return test == "corners" ? query::classify_corners(frustum, box, steps)
                             : query::corners_outside(frustum, box, steps);
  };
  if (const auto* box = std::get_if<Aabb<Scalar, Dim>>(&volume)) return test_box(*box);
  if (const auto* box = std::get_if<Obb<Scalar, Dim>>(&volume)) return test_box(*box);
  return fault("volume is neither aabb nor obb, which --test " + test + " needs");
}

/// How a line is tested.
struct Asked {
  const std::string& test;
  NewFile* trace;       // null without --steps
  std::int64_t number;  // that of the answer, counted from 1
};

template <class Scalar, int Dim>
tl::expected<Json, std::string> answer(const FrustumRows& rows, const Volume<Scalar, Dim>& volume, const Asked& asked) {
  const auto given = frustum_of<Scalar, Dim>(rows, size_of_volume<Scalar, Dim>(volume));
  if (!given) return fault("frustum: " + given.error().what);
  const auto& [frustum, has_end] = *given;
  query::ClassifyRecorder<Scalar, Dim> of_planes, of_corners;
  const PlaneSet planes_given = has_end ? kAllPlanes<Dim> : kAllPlanes<Dim> >> 1;
  const auto result =
      query::classify_volume(frustum, volume, {.planes = planes_given, .extent = query::CullExtent::kAll}, of_planes);
  query::Culling verdict = result.verdict;
  if (asked.test != "planes") {
    const auto chosen = by_corners(asked.test, frustum, volume, of_corners);
    if (!chosen) return fault(chosen.error());
    verdict = chosen->verdict;
  }
  if (asked.trace != nullptr)
    for (const auto& entry : (asked.test == "planes" ? of_planes : of_corners).entries)
      asked.trace->write(trace_line({{"volume", asked.number}, {"test", asked.test}}, entry.step, Dim));

  Json planes = Json::array();
  for (const auto& entry : of_planes.entries)
    if (const auto* fact = std::get_if<query::PlaneTested<Scalar, Dim>>(&entry.step.fact); fact && !fact->skipped)
      planes.push_back(plane_json(*fact));
  return Json{{"class", query::kCullingNames[static_cast<std::size_t>(verdict)]},
              {"planes", planes},
              {"exact", exact_class(frustum, volume, result.verdict)}};
}

template <int Dim>
tl::expected<Json, std::string> answer(const FrustumRows& rows, const Volume<double, Dim>& volume, bool as_float,
                                       const Asked& asked) {
  return as_float ? answer<float, Dim>(rows, in_float<Dim>(volume), asked) : answer<double, Dim>(rows, volume, asked);
}

struct CullLine {
  FrustumRows frustum;
  int dim = 3;
  AnyVolume volume;
};

/// Other fields, such as a name, are passed over.
tl::expected<CullLine, std::string> line_from(const Json& line, const CullOptions& options, RoughAxes& rough) {
  if (!line.is_object()) return fault("the line is not an object with frustum, volume");
  for (const char* name : {"frustum", "volume"})
    if (!line.contains(name)) return fault(std::string(name) + " is missing");
  auto frustum = read_frustum(line["frustum"], options);
  if (!frustum) return fault(frustum.error());
  const int dim = frustum->dim();
  auto volume =
      read_volume(line["volume"], volume_wanted("volume", dim, options.scalar, options.strict ? nullptr : &rough));
  if (!volume) return fault(volume.error());
  return CullLine{std::move(*frustum), dim, std::move(*volume)};
}

tl::expected<Json, std::string> answer_line(const Json& json, const CullOptions& options, const Asked& asked,
                                            RoughAxes& rough) {
  const auto line = line_from(json, options, rough);
  if (!line) return fault(line.error());
  const bool as_float = options.scalar == "float";
  return line->dim == 2 ? answer<2>(line->frustum, std::get<0>(line->volume), as_float, asked)
                        : answer<3>(line->frustum, std::get<1>(line->volume), as_float, asked);
}

// ---- by a tree

/// The index of a volume's kind in kVolumeNames.
std::size_t kind_of(const AnyVolume& volume) {
  return std::visit([](const auto& v) { return v.index(); }, volume);
}

template <int Dim>
tl::expected<void, InputError> takes_frustum(const FrustumRows& rows, bool as_float) {
  const auto nothing = [](const auto&) {};
  return as_float ? frustum_of<float, Dim>(rows, 1).map(nothing) : frustum_of<double, Dim>(rows, 1).map(nothing);
}

/// Checks that the line's planes make a frustum in the requested arithmetic.
tl::expected<void, InputError> takes_frustum(const CullLine& line, bool as_float) {
  return line.dim == 2 ? takes_frustum<2>(line.frustum, as_float) : takes_frustum<3>(line.frustum, as_float);
}

/// Reads all lines as one scene, with one frustum and one kind of volume.
tl::expected<std::vector<CullLine>, std::vector<InputError>> scene_of(const CullOptions& options,
                                                                      std::vector<InputError>& warnings) {
  RoughAxes rough;
  std::vector<CullLine> scene;
  const auto add_line = [&](const Json& json) -> tl::expected<Json, std::string> {
    auto line = line_from(json, options, rough);
    if (!line) return fault(line.error());
    if (!scene.empty() && !(scene[0].frustum == line->frustum))
      return fault("frustum differs from the first line's; a tree is tested against one");
    if (!scene.empty() && kind_of(scene[0].volume) != kind_of(line->volume))
      return fault("volume is of another kind than the first line's; a tree takes one kind");
    if (scene.empty())
      if (const auto taken = takes_frustum(*line, options.scalar == "float"); !taken)
        return fault("frustum: " + taken.error().what);
    scene.push_back(std::move(*line));
    return Json();
  };
  const auto read = answer_given(options.file, options.name, cull_case, add_line, rough);
  if (!read) return tl::unexpected(read.error());
  warnings = read->warnings;
  return scene;
}

Json json_of_cost(const CullCost& cost) {
  return {{"volume_tests", cost.volume_tests}, {"planes_tested", cost.planes_tested}};
}

template <class Scalar, int Dim>
CommandResult cull_scene(const std::vector<CullLine>& scene, const TreeRule& rule, TraceFile& trace) {
  std::vector<Volume<Scalar, Dim>> volumes;
  Scalar size = 0;
  for (const CullLine& line : scene) {
    const Volume<double, Dim>& volume = std::get<static_cast<std::size_t>(Dim - 2)>(line.volume);
    if constexpr (std::is_same_v<Scalar, float>) volumes.push_back(in_float<Dim>(volume));
    else volumes.push_back(volume);
    size = std::max(size, size_of_volume<Scalar, Dim>(volumes.back()));
  }
  const auto given = frustum_of<Scalar, Dim>(scene[0].frustum, size);
  if (!given) return bad_input("frustum: " + given.error().what);
  const auto& frustum = given->frustum;
  const auto culled = cull_by_tree<Scalar, Dim>(rule, frustum, volumes, trace);
  if (!culled)
    return bad_input("--tree takes no volume of the kind " + std::string(kVolumeNames[kind_of(scene[0].volume)]) +
                     ": two of them do not merge into one");
  Printed printed;
  for (const query::Culling culling : culled->classes)
    printed.text += line_of({{"class", query::kCullingNames[static_cast<std::size_t>(culling)]}});
  printed.text += line_of({{"tree", rule.name},
                           {"nodes", culled->nodes},
                           {"depth", culled->depth},
                           {"cost", culled->cost},
                           {"nodes_visited", culled->nodes_visited},
                           {"by_tree", json_of_cost(culled->by_tree)},
                           {"without_masks", json_of_cost(culled->without_masks)},
                           {"one_by_one", json_of_cost(culled->one_by_one)}});
  return printed;
}

CommandResult run_tree(const CullOptions& options, TraceFile& trace) {
  if (options.test != "planes") return bad_input("--tree goes with --test planes only");
  std::vector<InputError> warnings;
  const auto scene = scene_of(options, warnings);
  if (!scene) return tl::unexpected(scene.error());
  if (scene->empty()) return Printed{};
  const bool as_float = options.scalar == "float";
  const TreeRule rule{options.tree, options.leaf};
  auto culled =
      (*scene)[0].dim == 2
          ? (as_float ? cull_scene<float, 2>(*scene, rule, trace) : cull_scene<double, 2>(*scene, rule, trace))
          : (as_float ? cull_scene<float, 3>(*scene, rule, trace) : cull_scene<double, 3>(*scene, rule, trace));
  if (culled) culled->warnings = std::move(warnings);
  return culled;
}

// ---- a survey

/// The counts over random spheres of the line's radius around its frustum. Errors: it has no sphere; a frustum that
/// cannot be made, or that has no vertices.
template <int Dim>
tl::expected<Json, std::string> surveyed(const CullLine& line, const CullOptions& options) {
  const auto given = frustum_of<double, Dim>(line.frustum, 1);
  if (!given) return fault("frustum: " + given.error().what);
  if (!given->has_end) return fault("frustum: its far plane lies at infinity, and --survey needs vertices");
  const auto* sphere = std::get_if<Sphere<double, Dim>>(&std::get<static_cast<std::size_t>(Dim - 2)>(line.volume));
  if (sphere == nullptr) return fault("volume is not a sphere, which --survey needs");
  auto survey = cost::SphereSurvey<Dim>::make(given->frustum, sphere->radius, options.seed);
  if (!survey) return fault("frustum: its planes do not meet in vertices, which --survey needs");
  survey->run(options.survey);
  const cost::SurveyCounts& counts = survey->counts();
  Json answer{{"spheres", counts.spheres},
              {"seed", options.seed},
              {"radius", sphere->radius},
              {"inside", counts.inside},
              {"intersecting", counts.intersecting},
              {"outside", counts.outside},
              {"false_positives", counts.false_positives()}};
  if (Dim == 3) answer["near_edges"] = counts.false_at_two;
  answer["near_vertices"] = Dim == 3 ? counts.false_at_more : counts.false_positives();
  return answer;
}

CommandResult run_survey(const CullOptions& options) {
  if (!options.tree.empty() || options.test != "planes" || options.scalar != "double" || !options.steps.empty())
    return bad_input("--survey goes with --seed and --dim only");
  RoughAxes rough;
  const auto answer = [&](const Json& json) -> tl::expected<Json, std::string> {
    const auto line = line_from(json, options, rough);
    if (!line) return fault(line.error());
    return line->dim == 2 ? surveyed<2>(*line, options) : surveyed<3>(*line, options);
  };
  return answer_given(options.file, options.name, cull_case, answer, rough);
}

CommandResult run_cull(const CullOptions& options) {
  if (options.survey > 0) return run_survey(options);
  auto trace = trace_file(options.steps, options.name.empty() ? options.file : "");
  if (!trace) return bad_input(trace.error());
  if (!options.tree.empty()) return with_trace(run_tree(options, *trace), *trace);
  std::int64_t number = 0;
  RoughAxes rough;
  const auto answer = [&](const Json& line) {
    return answer_line(line, options, {options.test, *trace ? &**trace : nullptr, ++number}, rough);
  };
  return with_trace(answer_given(options.file, options.name, cull_case, answer, rough), *trace);
}

constexpr const char* kCullFooter =
    R"(Reads JSON Lines, {"frustum":F,"volume":V} on each, and prints one object for each; empty lines are skipped.
  F                {"planes":[[nx,ny,nz,d], ..]}: left, right, bottom, top, near, far; normals point outward and may
                   have any length; a point p is inside a plane if n . p + d <= 0. In 2-D four lines [nx,ny,d]: left,
                   right, near, far.
                   null in the place of far is a frustum without end
                   {"view_projection":[16 numbers]}: column-major, world to OpenGL's clip space; 3-D. With "clip":"0..1"
                   to 0 <= z <= w, as of Direct3D, Metal, Vulkan and WebGPU. Depth may be reversed (1 near, 0 far), and
                   the far plane may lie at infinity; it is then not among the planes
)";
constexpr const char* kCullFooterEnd = R"(It has the frustum's dimension.
  class            inside, intersecting or outside. Outside: wholly in the positive half-space of one plane. Inside:
                   wholly in the negative half-space of every plane. A volume that touches the frustum is never called
                   outside, and one that sticks out is never called inside, even in float. Some volumes outside, near
                   the frustum's edges and vertices, are called intersecting: false positives
  planes           for each: plane (its index), p_vertex and n_vertex (the volume's points farthest along the normal and
                   against it), side (the class for this plane), p_distance and n_distance (signed, positive outside)
  exact            the true class; null if it is unknown: if the planes do not bound a frustum with eight vertices (in
                   2-D four; a far plane at infinity may be missing), and for capsule, lozenge, k-DOP and hull where
                   they touch it within rounding

--test corners classifies by the box's vertices: outside if all are outside one plane. corners_outside says outside if
all are outside the frustum, which is wrong for boxes wider than the frustum: class then differs from exact.
--tree RULE builds a tree over the volumes of all lines, which must be of one kind with one frustum, by median,
surface_area (both with up to --leaf volumes in a leaf), bottom_up or insertion, and culls with it. It prints
{"class":..} for each, the same as without a tree, and then one more object:
  tree, nodes      the rule, and the number of nodes; nodes_visited: how many the frustum was tested against
  depth, cost      the largest number of nodes on a path from the root to a leaf; the tests that a line is expected to
                   take once it meets the root, by the surface-area heuristic
  by_tree          volume_tests (nodes and bodies) and planes_tested; without_masks: the same if children are also
                   tested against planes that their parent is inside; one_by_one: without the tree

--survey N tests N random spheres instead, of the radius of each line's sphere, their centres spread evenly over the box
around its frustum and whatever touches it:
  spheres, seed, radius; inside, intersecting, outside: how many the test calls so; false_positives: how many of the
                   intersecting ones touch nothing, by their distance from the frustum; near_edges: how many
                   of these cross two planes; near_vertices: how many cross more. In 2-D there are no edges

--steps writes what the test did, one JSON object a line: volume (which line of the answers), test, step (its name),
line (of the test's pseudocode, counted from 0) and the step's own fields. In side, so_far and verdict 0 is inside, 1
intersecting, 2 outside. For a tree there is doing (build or cull) instead of volume.

Exit status: 0 done, 2 bad input or usage: one line on stderr that names the field, and nothing on stdout.)";

}  // namespace

void add_cull(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("cull", "Classify volumes against view frusta");
  command.footer(std::string(kCullFooter) + volumes_in_json() + kCullFooterEnd);
  const auto options = add_command<CullOptions>(commands, command, run_cull);
  command.add_option("--scalar", options->scalar, "Number type: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", options->dim, "2 or 3; by default that of each line")->transform(whole_number(2, 3));
  command
      .add_option("--test", options->test,
                  "The test: planes; for boxes also corners, or corners_outside, which is wrong")
      ->check(CLI::IsMember({"planes", "corners", "corners_outside"}))
      ->capture_default_str();
  command.add_flag("--strict", options->strict, "Refuse axes of four digits, which are taken with a warning otherwise");
  command.add_option("--tree", options->tree, "Cull with a tree built by median, surface_area, bottom_up or insertion")
      ->check(CLI::IsMember(kTreeRules));
  command
      .add_option("--leaf", options->leaf, "The most volumes in a leaf, if the tree is built by median or surface_area")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000}))
      ->capture_default_str();
  command.add_option("--steps", options->steps, "File to write the trace of all tests to, one JSON object a line");
  command
      .add_option("--survey", options->survey, "Test this many random spheres instead, and count the false positives")
      ->check(CLI::Range(std::int64_t{1}, std::int64_t{1'000'000'000}));
  command.add_option("--seed", options->seed, "Seed of the random spheres")
      ->transform(whole_number())
      ->capture_default_str();
  command.add_option("--case", options->name, kCaseHelp);
  command.add_option("FILE", options->file, "JSON Lines file; - is standard input")->capture_default_str();
}

}  // namespace snug::desktop
