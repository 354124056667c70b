#include "query/overlaps.hpp"

#include <algorithm>
#include <set>

#include "desktop/cli/command.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/json.hpp"
#include "desktop/cli/volume_json.hpp"

namespace snug::desktop {
namespace {

struct OverlapOptions {
  std::string scalar = "double";
  int dim = 0;
  std::string file = "-";
};

/// One line's JSON. Errors: what is wrong with it as JSON, a key that is there twice included.
tl::expected<Json, std::string> json_line(const std::string& line) {
  std::vector<std::set<std::string>> open;
  std::string twice;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open.emplace_back();
    if (event == Json::parse_event_t::object_end) open.pop_back();
    if (event == Json::parse_event_t::key && !open.back().insert(parsed.get<std::string>()).second) twice = parsed.dump();
    return true;
  };
  try {
    Json json = Json::parse(line, watch);
    if (!twice.empty()) return tl::unexpected("the key " + twice + " is there twice");
    return json;
  } catch (const Json::exception& error) {
    const std::string what = error.what();
    const std::size_t from = what.find("] ");  // behind the library's own name for it
    return tl::unexpected("not JSON: " + (from == std::string::npos ? what : what.substr(from + 2)));
  }
}

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

  VolumeWanted wanted{.name = "a", .dim = options.dim};
  if (options.scalar == "float") wanted.largest = PointSet<float, 3>::kLargest, wanted.largest_said = "1.1e18 in float";
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

// ---- the volumes as float has them

template <class From>
auto in_float(const From& v) { return v.template cast<float>(); }

template <int Dim>
struct ToFloat {
  using Out = Volume<float, Dim>;
  Out operator()(const Sphere<double, Dim>& v) const { return Sphere<float, Dim>{in_float(v.center), static_cast<float>(v.radius)}; }
  Out operator()(const Aabb<double, Dim>& v) const { return Aabb<float, Dim>{in_float(v.min), in_float(v.max)}; }
  Out operator()(const Obb<double, Dim>& v) const {
    return Obb<float, Dim>{in_float(v.center), in_float(v.axes), in_float(v.half_extents)};
  }
  Out operator()(const Capsule<double, Dim>& v) const {
    return Capsule<float, Dim>{in_float(v.a), in_float(v.b), static_cast<float>(v.radius)};
  }
  Out operator()(const Lozenge<double, Dim>& v) const {
    return Lozenge<float, Dim>{in_float(v.origin), {in_float(v.edges[0]), in_float(v.edges[1])}, static_cast<float>(v.radius)};
  }
  Out operator()(const Kdop<double, Dim>& v) const {
    Kdop<float, Dim> kdop{.k = v.k};
    for (std::size_t i = 0; i < v.min.size(); ++i)
      kdop.min[i] = static_cast<float>(v.min[i]), kdop.max[i] = static_cast<float>(v.max[i]);
    return kdop;
  }
  Out operator()(const ConvexHull<double, Dim>& v) const {
    ConvexHull<float, Dim> hull{{}, v.indices, v.facets, v.affine_dim};
    for (const auto& vertex : v.vertices) hull.vertices.push_back(in_float(vertex));
    return hull;
  }
};

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
  return json_of(query::test_overlap<float, Dim>(std::visit(ToFloat<Dim>{}, a), std::visit(ToFloat<Dim>{}, b)));
}

CommandResult run_overlap(const OverlapOptions& options) {
  const auto bytes = read_file(options.file);
  if (!bytes) return bad_input(bytes.error());
  Printed printed;
  std::int64_t number = 0;
  for (std::size_t from = 0; from < bytes->size();) {
    const std::size_t end = std::min(bytes->find('\n', from), bytes->size());
    const std::string line = bytes->substr(from, end - from);
    from = end + 1;
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto pair = json_line(line).and_then([&](const Json& json) { return pair_of(json, options); });
    if (!pair) return bad_input(InputError{pair.error(), options.file, InputError::Unit::kLine, number});
    const bool as_float = options.scalar == "float";
    printed.text += line_of(dim_of(pair->a) == 2 ? answer(std::get<0>(pair->a), std::get<0>(pair->b), as_float)
                                                 : answer(std::get<1>(pair->a), std::get<1>(pair->b), as_float));
  }
  return printed;
}

constexpr const char* kOverlapFooter = R"(Reads JSON Lines, {"a":V,"b":V} on each, and prints one object for each; empty lines are passed over.
  V                {"sphere":{"center":[x,y,z],"radius":r}}
                   {"aabb":{"min":[..],"max":[..]}}, {"aabb":{"min":[..],"widths":[..]}} or
                   {"aabb":{"center":[..],"half_extents":[..]}}
                   {"obb":{"center":[..],"axes":[[..],[..],[..]],"half_extents":[..]}}; axes are unit rows, right-handed
                   {"capsule":{"a":[..],"b":[..],"radius":r}}
                   {"lozenge":{"origin":[..],"edges":[[..],[..]],"radius":r}}; the edges are perpendicular
                   {"kdop":{"k":14,"min":[..],"max":[..]}}; k is 6, 14, 18 or 26, in 2-D 4, 6 or 8
                   {"hull":{"points":[[..],..]}}
                   In 2-D two numbers stand where 3-D has three. A 6-DOP, which both have, is of the other volume's
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
  command.footer(kOverlapFooter);
  const auto options = add_command<OverlapOptions>(commands, command, run_overlap);
  command.add_option("--scalar", options->scalar, "Arithmetic: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", options->dim, "2 or 3; each line's own where none is given")->transform(whole_number(2, 3));
  command.add_option("FILE", options->file, "File of JSON Lines; - is standard input")->capture_default_str();
}

}  // namespace snug::desktop
