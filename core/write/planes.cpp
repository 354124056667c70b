// The p- and n-vertex of a box from the signs of a normal, and a box against a frustum.
#include <algorithm>

#include "query/cull/classify.hpp"
#include "query/cull/vertices_along.hpp"
#include "write/inputs.hpp"
#include "write/make.hpp"

namespace snug::write {
namespace planes {
namespace {

Aabb<double, 3> whole_box(Cases& cases, int reach, int least) {
  Aabb<double, 3> box;
  box.min = whole_point(cases, reach);
  for (int i = 0; i < 3; ++i) box.max[i] = box.min[i] + cases.whole(least, 6);
  return box;
}

bool is_box(const Aabb<double, 3>& box) { return (box.max - box.min).minCoeff() >= 0; }

Aabb<double, 3> take_box(Take& take) {
  Aabb<double, 3> box;
  box.min = take.vector();
  box.max = take.vector();
  return box;
}

// ---- p- and n-vertex ---------------------------------------------------------------------------------------------

enum VertexKind { kRandom, kAxes, kFlat, kTiny, kFar };
constexpr std::array kVertexKinds{
    Kind{"random", "random normals"},
    Kind{"axes", "normals along an axis, with zeros of either sign"},
    Kind{"flat", "boxes without a width, down to single points"},
    Kind{"tiny", "very short normals"},
    Kind{"far", "boxes far from the origin"},
};

void make_vertices(Cases& cases) {
  each_kind(kVertexKinds, [&](int kind, int) {
    const Scale scale = kind == kFar ? kFarScale : kPlain;
    const Aabb<double, 3> box = whole_box(cases, 8, kind == kFlat ? 0 : 1);
    Vector3 normal;
    for (int i = 0; i < 3; ++i) normal[i] = cases.whole(1, 9) * (cases.coin() ? 1 : -1);
    if (kind == kAxes) {
      const int axis = static_cast<int>(cases.random.below(3));
      for (int i = 0; i < 3; ++i)
        if (i != axis) normal[i] = std::copysign(0.0, normal[i]);
    }
    if (kind == kTiny) normal *= 0x1p-200;
    cases.add(kind, numbers_of(scale(box.min), scale(box.max), normal));
  });
}

Numbers vertices(const Numbers& input) {
  Take take(input);
  const Aabb<double, 3> box = take_box(take);
  const Vector3 normal = take.vector();
  int bits = 0;  // of the p-vertex; the n-vertex is opposite
  for (int i = 0; i < 3; ++i) bits |= normal[i] >= 0 ? 1 << i : 0;
  return numbers_of(query::corner_of(box, bits), query::corner_of(box, ~bits));
}

/// Along an axis where the normal is zero, both ends are equally far.
bool are_vertices(const Numbers& input, const Numbers& answer) {
  const Numbers right = vertices(input);
  for (std::size_t i = 0; i < 3; ++i) {
    const bool either = input[6 + i] == 0;
    for (const std::size_t at : {i, i + 3})
      if (answer[at] != right[at] && !(either && (answer[at] == input[i] || answer[at] == input[i + 3]))) return false;
  }
  return true;
}

bool is_vertex_input(const Numbers& input) {
  Take take(input);
  return is_box(take_box(take)) && !take.vector().isZero(0);
}

// ---- a box against a frustum -------------------------------------------------------------------------------------

enum CullKind { kAnyBoxes, kTouching, kLast, kAround, kCullTiny, kCullFar };
constexpr std::array kCullKinds{
    Kind{"random", "random boxes"},
    Kind{"touching", "boxes that only touch a plane, from inside or outside, or almost"},
    Kind{"last", "boxes that one plane alone rejects, whichever it is"},
    Kind{"around", "boxes whose vertices are all outside, though they intersect the frustum"},
    Kind{"tiny", "a very small frustum"},
    Kind{"far", "a frustum far from the origin"},
};

constexpr int kPlanes = kFrustumPlanes<3>;

/// A camera at the origin that sees 90 degrees along one of the axes, from 2 to 12. No coordinate of a normal rounds.
Planes whole_frustum(Cases& cases) {
  constexpr double kNearPlane = 2, kFarPlane = 12;
  const int axis = static_cast<int>(cases.random.below(3));
  const double sign = cases.coin() ? 1 : -1;
  const Vector3 view = sign * Vector3::Unit(axis);
  Planes planes;
  std::size_t at = 0;
  for (int i = 1; i < 3; ++i)
    for (const double side : {-1.0, 1.0}) planes[at++] = {side * Vector3::Unit((axis + i) % 3) - view, 0};
  planes[at++] = {-view, kNearPlane};
  planes[at++] = {view, -kFarPlane};
  for (int i = kPlanes - 1; i > 0; --i)  // in any order
    std::swap(planes[i], planes[cases.random.below(static_cast<std::uint32_t>(i + 1))]);
  return planes;
}

query::Culling verdict(const Planes& planes, const Aabb<double, 3>& box, PlaneSet only = ~PlaneSet{0}) {
  return query::classify(*Frustum<double, 3>::make(planes), box, {.planes = only}).verdict;
}

bool all_vertices_outside(const Planes& planes, const Aabb<double, 3>& box) {
  const auto is_outside = [&](const Vector3& p) {
    return std::any_of(planes.begin(), planes.end(), [&](const auto& plane) { return signed_distance(plane, p) > 0; });
  };
  const Corners<3> corners = core_corners<double, 3>(box, Vector3::Zero());
  return std::all_of(corners.begin(), corners.end(), is_outside);
}

/// How many planes have the whole box outside.
int rejecting(const Planes& planes, const Aabb<double, 3>& box) {
  int count = 0;
  for (int i = 0; i < kPlanes; ++i) count += verdict(planes, box, PlaneSet{1} << i) == query::Culling::kOutside ? 1 : 0;
  return count;
}

/// Moved along one coordinate until the box touches a plane with its n-vertex or its p-vertex, and perhaps by a little
/// more.
Aabb<double, 3> touching(Cases& cases, const Planes& planes, Aabb<double, 3> box) {
  const auto& plane = planes[cases.random.below(kPlanes)];
  int axis = 0;
  plane.normal.cwiseAbs().maxCoeff(&axis);
  const bool with_p = cases.coin();
  int bits = 0;
  for (int i = 0; i < 3; ++i) bits |= (plane.normal[i] >= 0) == with_p ? 1 << i : 0;
  const Vector3 vertex = query::corner_of(box, bits);
  double by = -signed_distance(plane, vertex) / plane.normal[axis];
  if (cases.coin()) by += plane.normal[axis] * kAlmost;
  box.min[axis] += by, box.max[axis] += by;
  return box;
}

Aabb<double, 3> box_for(Cases& cases, int kind, const Planes& planes) {
  for (;;) {
    Aabb<double, 3> box = whole_box(cases, 12, kind == kAround ? 6 : 1);
    if (kind == kAround) box.max += whole_point(cases, 6).cwiseAbs() * 3;
    if (kind == kTouching) box = touching(cases, planes, box);
    if (kind == kTouching && rejecting(planes, box) + (verdict(planes, box) != query::Culling::kOutside ? 1 : 0) != 1)
      continue;
    if (kind == kLast && (verdict(planes, box) != query::Culling::kOutside || rejecting(planes, box) != 1)) continue;
    if (kind == kAround &&
        (verdict(planes, box) != query::Culling::kIntersecting || !all_vertices_outside(planes, box)))
      continue;
    return box;
  }
}

/// Each of the three answers is right for a third of the cases, where the kind allows all three.
void make_culling(Cases& cases) {
  each_kind(kCullKinds, [&](int kind, int i) {
    const Scale scale = kind == kCullTiny ? kTinyScale : kind == kCullFar ? kFarScale : kPlain;
    const Planes planes = whole_frustum(cases);
    const bool open = kind != kLast && kind != kAround && kind != kTouching;
    Aabb<double, 3> box;
    do box = box_for(cases, kind, planes);
    while (open && static_cast<int>(verdict(planes, box)) != i % 3);
    Numbers input{kPlanes};
    for (const auto& [normal, d] : planes) {
      put(input, normal);
      put(input, d * scale.factor - normal.sum() * scale.offset);
    }
    put(input, scale(box.min));
    put(input, scale(box.max));
    cases.add(kind, std::move(input));
  });
}

/// What a plane's test gives, in the order of the shape's words.
Numbers culled(const Numbers& input) {
  const auto [planes, box] = cull_input_of(input);
  return {static_cast<double>(verdict(planes, box))};
}

/// A frustum stays one, so that each case can be drawn.
bool is_cull_input(const Numbers& input) {
  if (input[0] != kPlanes) return false;
  const auto [planes, box] = cull_input_of(input);
  return is_box(box) && camera_of(planes).has_value();
}

static_assert(static_cast<int>(query::Culling::kInside) == 0 && static_cast<int>(query::Culling::kIntersecting) == 1 &&
              static_cast<int>(query::Culling::kOutside) == 2);

constexpr std::array kFunctions{
    Function{"p-and-n-vertex", "vertices", "{box:{min:3n,max:3n},normal:3n}", "{p:3n,n:3n}", "frustum_box/p_n_vertex",
             kVertexKinds, make_vertices, vertices, are_vertices, is_vertex_input},
    Function{"cull-box", "cull", "{planes:*{normal:3n,d:n},box:{min:3n,max:3n}}", "inside|intersecting|outside",
             "frustum_box/p_n_vertex", kCullKinds, make_culling, culled, nullptr, is_cull_input},
};

}  // namespace
}  // namespace planes

CullInput cull_input_of(const Numbers& input) {
  Take take(input);
  take.number();  // how many planes
  CullInput own;
  for (auto& [normal, d] : own.planes) normal = take.vector(), d = take.number();
  own.box = planes::take_box(take);
  return own;
}

std::optional<Camera> camera_of(const Planes& planes) {
  Camera camera;
  const auto far = std::find_if(planes.begin(), planes.end(), [](const auto& plane) {
    return plane.normal.squaredNorm() == 1 && (plane.normal.array() != 0).count() == 1;
  });
  if (far == planes.end()) return std::nullopt;
  // One of two opposite planes was found: the camera looks along the one that is farther along its normal.
  const auto d_of = [&](const Vector3& normal) -> std::optional<double> {
    for (const auto& plane : planes)
      if (plane.normal == normal) return plane.d;
    return std::nullopt;
  };
  for (const double sign : {1.0, -1.0}) {
    camera.view = sign * far->normal;
    const auto near_d = d_of(-camera.view), far_d = d_of(camera.view);
    if (!near_d || !far_d) return std::nullopt;
    double along[2]{};
    int sides = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (camera.view[axis] != 0) continue;
      const auto low = d_of(-Vector3::Unit(axis) - camera.view), high = d_of(Vector3::Unit(axis) - camera.view);
      if (!low || !high) break;
      along[sides++] = (*low + *high) / 2;
      camera.apex[axis] = (*low - *high) / 2;
    }
    if (sides != 2) continue;
    if (along[0] != along[1]) return std::nullopt;
    int axis = 0;
    camera.view.cwiseAbs().maxCoeff(&axis);
    camera.apex[axis] = camera.view[axis] * along[0];
    camera.near = *near_d - along[0], camera.far = -*far_d - along[0];
    if (camera.near > 0 && camera.far > camera.near) return camera;
    return std::nullopt;
  }
  return std::nullopt;
}

std::span<const Function> plane_functions() { return planes::kFunctions; }

}  // namespace snug::write
