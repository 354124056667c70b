#include <algorithm>
#include <array>
#include <optional>

#include "io/formats.hpp"
#include "io/ply_body.hpp"
#include "io/ply_header.hpp"

namespace snug::io {
namespace {

constexpr int kNoAxis = -1;

int axis_of(const PlyProperty& property) {
  for (int axis = 0; axis < 3; ++axis)
    if (property.name == std::string_view("xyz").substr(axis, 1)) return axis;
  return kNoAxis;
}
bool is_vertices(const PlyElement& element) { return element.name == "vertex"; }
bool is_faces(const PlyElement& element) { return element.name == "face"; }
bool is_polygon(const PlyProperty& property) {
  return property.name == "vertex_indices" || property.name == "vertex_index";
}

/// The dimension, from the vertices' properties. Errors: no vertices, no x and y, a coordinate that is a list.
Read<int> dim_of(const PlyHeader& header) {
  for (const PlyElement& element : header.elements) {
    if (!is_vertices(element)) continue;
    std::array<bool, 3> has{};
    for (const PlyProperty& property : element.properties) {
      if (axis_of(property) == kNoAxis) continue;
      if (property.count_type) return at_line(element.line, "a coordinate of the vertices is a list");
      has[axis_of(property)] = true;
    }
    if (element.count == 0) return at_line(element.line, "there are no points");
    if (!has[0] || !has[1]) return at_line(element.line, "the vertices have no x and y");
    if (element.count > static_cast<std::int64_t>(kMostPoints))
      return at_line(element.line, std::string(kTooManyPoints));
    return has[2] ? 3 : 2;
  }
  return at_line(header.lines, "the header has no element \"vertex\"");
}

/// The error of a property whose type is not PLY's, if its data is needed, or if bytes that are needed come after it.
std::optional<InputError> unknown_type(const PlyHeader& header, const Wanted& wanted) {
  const bool ascii = header.form == PlyForm::kAscii;
  std::optional<InputError> error;
  for (const PlyElement& element : header.elements) {
    if (element.count == 0) continue;
    const auto is_needed = [&](const PlyProperty& property) {
      return is_vertices(element) ? axis_of(property) != kNoAxis
                                  : wanted.faces && is_faces(element) && is_polygon(property);
    };
    for (const PlyProperty& property : element.properties)
      if (!error && !property.unknown.empty() && (!ascii || is_needed(property)))
        error = at_line(property.line, quoted(property.unknown) + " is not a type of PLY").value();
    const auto& all = element.properties;
    if (error && std::any_of(all.begin(), all.end(), is_needed)) return error;
  }
  return std::nullopt;
}

/// Whether a reader of bytes must stop before the element, because its size is unknown.
bool has_no_size(const PlyHeader& header, const PlyElement& element) {
  const auto& all = element.properties;
  return header.form != PlyForm::kAscii &&
         std::any_of(all.begin(), all.end(), [](const PlyProperty& property) { return !property.unknown.empty(); });
}

/// Reads the elements in the header's order from a PlyText or PlyBytes.
template <class Body>
class PlyReader {
 public:
  PlyReader(const PlyHeader& header, std::string_view whole, int dim, const Wanted& wanted)
      : header_(header), body_(header, whole, wanted), wanted_(wanted) {
    file_.dim = dim;
    for (const PlyElement& element : header.elements)
      if (is_vertices(element)) vertices_ = element.count;
  }

  Read<PointFile> read() {
    for (const PlyElement& element : header_.elements) {
      if (element.count > 0 && has_no_size(header_, element)) break;
      // The claimed count is compared with the bytes that are there before any memory is allocated.
      if (element.count > 0 && element.count > body_.left() / Body::smallest(element))
        return at_line(element.line, "the header claims " + std::to_string(element.count) + " of " +
                                         quoted(element.name) + ", and the file is too short for that");
      if (is_vertices(element)) file_.points.reserve(static_cast<std::size_t>(element.count));
      if (!read_element(element)) return tl::unexpected(body_.error());
    }
    if (!wanted_.faces) file_.triangles.clear();
    body_.finish(file_);
    return std::move(file_);
  }

 private:
  bool read_element(const PlyElement& element) {
    for (std::int64_t i = 0; i < element.count; ++i) {
      if (!body_.begin(element, i)) return false;
      if (is_vertices(element)) file_.points.push_back(Vector<double, 3>::Zero());
      for (const PlyProperty& property : element.properties)
        if (!read_property(element, property)) return false;
      if (!body_.end()) return false;
    }
    return true;
  }

  bool read_property(const PlyElement& element, const PlyProperty& property) {
    if (is_vertices(element) && axis_of(property) != kNoAxis)
      return body_.number(property.type, file_.points.back()[axis_of(property)]);
    if (!property.count_type) return body_.skip(property.type, 1);
    std::optional<std::int64_t> count;
    if (!body_.whole(*property.count_type, count)) return false;
    if (!count) return body_.fail(body_.not_integer());
    if (*count < 0) return body_.fail("a list has " + std::to_string(*count) + " items");
    if (is_faces(element) && is_polygon(property)) return read_polygon(property.type, *count);
    return body_.skip(property.type, *count);
  }

  /// Adds the face as a fan of triangles around its first vertex.
  bool read_polygon(PlyType type, std::int64_t count) {
    if (count < 3) {
      pass_over(file_, Passed::kFaces);
      return body_.skip(type, count);
    }
    bool damaged = !is_integer(type);
    if (damaged && wanted_.faces) return body_.fail("the faces name vertices by numbers that are not integers");
    std::array<Index, 3> corners{};
    for (std::int64_t i = 0; i < count; ++i) {
      std::optional<std::int64_t> index;
      if (!body_.whole(type, index)) return false;
      damaged = damaged || !index || *index < 0 || *index >= vertices_;
      if (damaged && wanted_.faces) return body_.fail(index ? out_of_range(*index) : body_.not_integer());
      if (damaged) continue;
      corners[static_cast<std::size_t>(i < 2 ? i : 2)] = static_cast<Index>(*index);
      if (i < 2) continue;
      file_.triangles.push_back(corners);
      corners[1] = corners[2];
    }
    if (damaged) pass_over(file_, Passed::kDamaged);
    return true;
  }

  [[nodiscard]] std::string out_of_range(std::int64_t index) const {
    return "the face names vertex " + std::to_string(index) + ", counted from 0, and there " +
           (vertices_ == 1 ? "is " : "are ") + std::to_string(vertices_);
  }

  const PlyHeader& header_;
  Body body_;
  Wanted wanted_;
  PointFile file_;
  std::int64_t vertices_ = 0;
};

}  // namespace

Read<PointFile> read_ply(std::string_view bytes, const Wanted& wanted) {
  auto header = read_ply_header(bytes);
  if (!header) return tl::unexpected(header.error());
  const auto dim = dim_of(*header);
  if (!dim) return tl::unexpected(dim.error());
  if (auto error = unknown_type(*header, wanted)) return tl::unexpected(std::move(*error));
  if (header->form != PlyForm::kAscii) return PlyReader<PlyBytes>(*header, bytes, *dim, wanted).read();
  const std::int64_t padding = take_padding(header->body);
  auto file = PlyReader<PlyText>(*header, bytes, *dim, wanted).read();
  if (file) pass_over(*file, Passed::kBytes, padding);
  return file;
}

}  // namespace snug::io
