#include "query/overlaps.hpp"

#include "desktop/cli/command.hpp"
#include "desktop/cli/in_float.hpp"
#include "desktop/cli/json_lines.hpp"
#include "desktop/cli/volume_json.hpp"

namespace snug::desktop {
namespace {

struct OverlapOptions {
  std::string scalar = "double";
  int dim = 0;
  std::string file = "-";
};

struct VolumePair {
  AnyVolume a, b;
};

tl::expected<VolumePair, std::string> pair_of(const Json& json, const OverlapOptions& options) {
  if (!json.is_object()) return tl::unexpected(std::string("the line is not an object with the fields a and b"));
  for (const auto& item : json.items())
    if (item.key() != "a" && item.key() != "b")
      return tl::unexpected("the line has an unknown field " + Json(item.key()).dump() + "; it takes a, b");
  for (const char* name : {"a", "b"})
    if (!json.contains(name)) return tl::unexpected(std::string(name) + " is missing");

  VolumeWanted wanted = volume_wanted("a", options.dim, options.scalar);
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
    return tl::unexpected("a is " + std::to_string(dim_of(*first)) + "-D and b is " + std::to_string(dim_of(*second)) + "-D");
  return b_first ? VolumePair{std::move(*second), std::move(*first)} : VolumePair{std::move(*first), std::move(*second)};
}

// ---- the answer

template <class Scalar, int Dim>
Json json_of(const query::OverlapResult<Scalar, Dim>& result) {
  Json json{{"overlap", result.overlap}, {"distance", nullptr}, {"separating_axis", nullptr}, {"tests", result.tests}};
  if (result.distance) json["distance"] = static_cast<double>(*result.distance);
  if (!result.separating_axis) return json;
  Json direction = Json::array();
  for (int i = 0; i < Dim; ++i) direction.push_back(static_cast<double>(result.separating_axis->direction[i]));
  json["separating_axis"] = {{"kind", result.separating_axis->kind},
                             {"direction", direction},
                             {"gap", static_cast<double>(result.separating_axis->gap)}};
  return json;
}

template <int Dim>
Json answer(const Volume<double, Dim>& a, const Volume<double, Dim>& b, bool as_float) {
  if (!as_float) return json_of(query::test_overlap<double, Dim>(a, b));
  return json_of(query::test_overlap<float, Dim>(in_float<Dim>(a), in_float<Dim>(b)));
}

CommandResult run_overlap(const OverlapOptions& options) {
  return answer_lines(options.file, [&](const Json& json) -> tl::expected<Json, std::string> {
    const auto pair = pair_of(json, options);
    if (!pair) return tl::unexpected(pair.error());
    const bool as_float = options.scalar == "float";
    return dim_of(pair->a) == 2 ? answer(std::get<0>(pair->a), std::get<0>(pair->b), as_float)
                                : answer(std::get<1>(pair->a), std::get<1>(pair->b), as_float);
  });
}

constexpr const char* kOverlapFooter = R"(Reads JSON Lines, {"a":V,"b":V} on each, and prints one object for each; empty lines are passed over.
)";
constexpr const char* kOverlapFooterEnd = R"(A 6-DOP, which both have, is of the other volume's
                   dimension, or of --dim, or 3-D.
  overlap          whether they share a point; touching volumes do
  distance         0 where they overlap; null where the pair's test finds none (boxes and k-DOPs among themselves)
  separating_axis  {kind, direction, gap}: a unit direction from a to b, and the gap along it; null where they overlap.
                   kind: centers, closest_points, slab, face_a, face_b, edge_edge
  tests            how many axes, pairs of features or simplices were looked at

Exit status: 0 done, 2 bad input or usage: one line on stderr that names the field, and nothing on stdout.)";

}  // namespace

void add_overlap(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("overlap", "Test pairs of volumes for overlap");
  command.footer(std::string(kOverlapFooter) + kVolumesInJson + kOverlapFooterEnd);
  const auto options = add_command<OverlapOptions>(commands, command, run_overlap);
  command.add_option("--scalar", options->scalar, "Arithmetic: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", options->dim, "2 or 3; each line's own where none is given")->transform(whole_number(2, 3));
  command.add_option("FILE", options->file, "File of JSON Lines; - is standard input")->capture_default_str();
}

}  // namespace snug::desktop
