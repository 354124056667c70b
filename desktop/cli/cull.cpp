#include <algorithm>
#include <cmath>

#include "desktop/cli/command.hpp"
#include "desktop/cli/in_float.hpp"
#include "desktop/cli/json_lines.hpp"
#include "desktop/cli/volume_json.hpp"
#include "query/classify.hpp"
#include "query/frustum_sat.hpp"

namespace snug::desktop {
namespace {

struct CullOptions {
  std::string scalar = "double";
  int dim = 0;
  std::string file = "-";
};

using Rows = std::vector<std::vector<double>>;

tl::unexpected<std::string> wrong(std::string what) { return tl::unexpected(std::move(what)); }

/// That an object has these fields and no others.
tl::expected<void, std::string> has_just(const Json& json, const std::string& self, const std::vector<std::string>& fields) {
  std::string listed;
  for (const std::string& field : fields) listed += (listed.empty() ? "" : ", ") + field;
  if (!json.is_object()) return wrong(self + " is not an object with " + listed);
  for (const auto& item : json.items())
    if (std::find(fields.begin(), fields.end(), item.key()) == fields.end())
      return wrong(self + " has an unknown field " + Json(item.key()).dump() + "; it takes " + listed);
  return {};
}

/// So many numbers that are all within what the scalar takes.
tl::expected<std::vector<double>, std::string> numbers_of(const Json& json, const std::string& self, std::size_t count, bool as_float) {
  if (!json.is_array()) return wrong(self + " is not a list of numbers");
  if (json.size() != count)
    return wrong(self + " has " + std::to_string(json.size()) + " numbers where " + std::to_string(count) + " belong");
  constexpr double kFloat = Frustum<float, 3>::kLargest, kDouble = Frustum<double, 3>::kLargest;
  const double largest = as_float ? 4 * kFloat * kFloat : 4 * kDouble * kDouble;
  std::vector<double> numbers;
  for (const Json& item : json) {
    const std::string place = self + "[" + std::to_string(numbers.size()) + "]";
    if (!item.is_number()) return wrong(place + " is not a number");
    numbers.push_back(item.get<double>());
    if (!(std::abs(numbers.back()) <= largest)) return wrong(place + " is larger than this program can take");
  }
  return numbers;
}

/// Planes in rows: 6 of 4 numbers, or in 2-D 4 of 3; or one row of a matrix's 16.
tl::expected<Rows, std::string> rows_of(const Json& frustum, const CullOptions& options) {
  const bool as_float = options.scalar == "float";
  if (const auto fields = has_just(frustum, "frustum", {"planes", "view_projection"}); !fields) return wrong(fields.error());
  if (frustum.size() != 1) return wrong("frustum has not just one of the fields planes, view_projection");
  if (frustum.contains("view_projection")) {
    if (options.dim == 2) return wrong("frustum.view_projection is of 3-D, and --dim is 2");
    return numbers_of(frustum["view_projection"], "frustum.view_projection", 16, as_float).map([](auto row) { return Rows{row}; });
  }
  const Json& planes = frustum["planes"];
  if (!planes.is_array()) return wrong("frustum.planes is not a list of planes");
  if (planes.size() != 6 && planes.size() != 4)
    return wrong("frustum.planes has " + std::to_string(planes.size()) + " rows where 6, in 2-D 4, belong");
  if (options.dim != 0 && static_cast<int>(planes.size()) != 2 * options.dim)
    return wrong("frustum.planes has " + std::to_string(planes.size()) + " rows where " + std::to_string(2 * options.dim) + " belong");
  Rows rows;
  for (const Json& plane : planes) {
    auto row = numbers_of(plane, "frustum.planes[" + std::to_string(rows.size()) + "]", planes.size() / 2 + 1, as_float);
    if (!row) return wrong(row.error());
    rows.push_back(std::move(*row));
  }
  return rows;
}

template <class Scalar, int Dim>
tl::expected<Frustum<Scalar, Dim>, InputError> frustum_of(const Rows& rows) {
  if constexpr (Dim == 3)
    if (rows.size() == 1) {
      const std::vector<Scalar> matrix(rows[0].begin(), rows[0].end());
      return frustum_of_matrix<Scalar>(std::span<const Scalar>(matrix));
    }
  typename Frustum<Scalar, Dim>::Planes planes;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (int k = 0; k < Dim; ++k) planes[i].normal[k] = static_cast<Scalar>(rows[i][static_cast<std::size_t>(k)]);
    planes[i].d = static_cast<Scalar>(rows[i][Dim]);
  }
  return Frustum<Scalar, Dim>::make(planes);
}

/// What is so, whatever the planes say one by one; null where this is not found out.
template <class Scalar, int Dim>
Json exact_class(const Frustum<Scalar, Dim>& frustum, const Volume<Scalar, Dim>& volume, query::Culling verdict) {
  const auto named = [](query::Culling culling) { return query::kCullingNames[static_cast<std::size_t>(culling)]; };
  if (verdict != query::Culling::kIntersecting) return named(verdict);
  return std::visit(
      [&](const auto& shape) -> Json {
        using Shape = std::remove_cvref_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, Aabb<Scalar, Dim>> || std::is_same_v<Shape, Obb<Scalar, Dim>>)
          if (const auto exact = query::FrustumSat<Scalar, Dim>::make(frustum))
            return named(exact->overlaps(shape) ? verdict : query::Culling::kOutside);
        return nullptr;
      },
      volume);
}

template <class Scalar, int Dim>
Json json_of(const Vector<Scalar, Dim>& point) {
  Json list = Json::array();
  for (int i = 0; i < Dim; ++i) list.push_back(static_cast<double>(point[i]));
  return list;
}

template <class Scalar, int Dim>
tl::expected<Json, std::string> answer(const Rows& rows, const Volume<Scalar, Dim>& volume) {
  const auto frustum = frustum_of<Scalar, Dim>(rows);
  if (!frustum) return wrong("frustum: " + frustum.error().what);
  query::ClassifyRecorder<Scalar, Dim> steps;
  const auto result = query::classify_volume(*frustum, volume, {.extent = query::CullExtent::kAll}, steps);
  Json planes = Json::array();
  for (const auto& entry : steps.entries)
    if (const auto* fact = std::get_if<query::PlaneTested<Scalar, Dim>>(&entry.step.fact))
      planes.push_back({{"plane", fact->plane},
                        {"p_vertex", json_of<Scalar, Dim>(fact->p_point)},
                        {"n_vertex", json_of<Scalar, Dim>(fact->n_point)},
                        {"side", query::kCullingNames[static_cast<std::size_t>(fact->side)]},
                        {"p_distance", static_cast<double>(fact->p_distance)},
                        {"n_distance", static_cast<double>(fact->n_distance)}});
  return Json{{"class", query::kCullingNames[static_cast<std::size_t>(result.verdict)]},
              {"planes", planes},
              {"exact", exact_class(*frustum, volume, result.verdict)}};
}

template <int Dim>
tl::expected<Json, std::string> answer(const Rows& rows, const Volume<double, Dim>& volume, bool as_float) {
  return as_float ? answer<float, Dim>(rows, in_float<Dim>(volume)) : answer<double, Dim>(rows, volume);
}

tl::expected<Json, std::string> answer_line(const Json& line, const CullOptions& options) {
  if (const auto fields = has_just(line, "the line", {"frustum", "volume"}); !fields) return wrong(fields.error());
  for (const char* name : {"frustum", "volume"})
    if (!line.contains(name)) return wrong(std::string(name) + " is missing");
  const auto rows = rows_of(line["frustum"], options);
  if (!rows) return wrong(rows.error());
  const int dim = rows->size() == 4 ? 2 : 3;
  const auto volume = read_volume(line["volume"], volume_wanted("volume", dim, options.scalar));
  if (!volume) return wrong(volume.error());
  const bool as_float = options.scalar == "float";
  return dim == 2 ? answer<2>(*rows, std::get<0>(*volume), as_float) : answer<3>(*rows, std::get<1>(*volume), as_float);
}

constexpr const char* kCullFooter = R"(Reads JSON Lines, {"frustum":F,"volume":V} on each, and prints one object for each; empty lines are passed over.
  F                {"planes":[[nx,ny,nz,d], ..]}: left, right, bottom, top, near, far; normals point out and may be of any
                   length; inside of a plane is n . p + d <= 0. In 2-D four lines [nx,ny,d]: left, right, near, far.
                   {"view_projection":[16 numbers]}: column-major, world to OpenGL's clip space; 3-D
)";
constexpr const char* kCullFooterEnd = R"(It is of the frustum's dimension.
  class            inside, intersecting or outside. Outside is what is all on the outer side of one plane, inside what
                   is outside of none. What touches the frustum is never outside, what sticks out never inside, in float
                   too. Some volumes outside near the frustum's edges are called intersecting
  planes           for each: plane (its place), p_vertex and n_vertex (the volume's points farthest along the normal and
                   against it), side (the class as of this plane), p_distance and n_distance (signed, positive outside)
  exact            the class that is true; null where it is not found out: of what the planes call intersecting, it is
                   found of aabb and obb, against planes that bound a frustum with eight corners (in 2-D four)

Exit status: 0 done, 2 bad input or usage: one line on stderr that names the field, and nothing on stdout.)";

}  // namespace

void add_cull(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("cull", "Classify volumes against view frusta");
  command.footer(std::string(kCullFooter) + kVolumesInJson + kCullFooterEnd);
  const auto options = add_command<CullOptions>(commands, command, [](const CullOptions& chosen) {
    return answer_lines(chosen.file, [&](const Json& line) { return answer_line(line, chosen); });
  });
  command.add_option("--scalar", options->scalar, "Arithmetic: double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command.add_option("--dim", options->dim, "2 or 3; each line's own where none is given")->transform(whole_number(2, 3));
  command.add_option("FILE", options->file, "File of JSON Lines; - is standard input")->capture_default_str();
}

}  // namespace snug::desktop
