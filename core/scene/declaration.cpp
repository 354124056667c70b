#include "scene/declaration.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>

#include "geometry/tolerance.hpp"
#include "query/distance/support_function.hpp"
#include "scene/effect.hpp"
#include "scene/shape.hpp"
#include "trace/fields.hpp"

namespace snug::scene {
namespace {

/// Beyond it, products of coordinates, masses and steps would soon overflow.
constexpr double kLargest = 1e12;
/// Below it, squares of lengths and what divides by masses and steps would vanish or overflow. A length may be 0.
constexpr double kSmallest = 1e-12, kShortestStep = 1e-9;

bool is_sound(double number) { return std::abs(number) <= kLargest; }  // false for a NaN
bool is_sound(const V3& v) { return is_sound(v[0]) && is_sound(v[1]) && is_sound(v[2]); }
/// Whether every number of a volume is sound, and no length or half extent is below 0.
template <template <class, int> class Kind>
bool has_sound_fields(const Kind<double, 3>& volume) {
  bool sound = true;
  see_fields(volume, [&](std::string_view name, const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr (std::is_same_v<Field, double>) sound = sound && is_sound(field) && field >= 0;
    if constexpr (std::is_same_v<Field, V3>)
      sound = sound && is_sound(field) && (name != "half_extents" || field.minCoeff() >= 0);
  });
  return sound;
}
template <template <class, int> class Kind>
bool is_sound(const Kind<double, 3>& volume) {
  return has_sound_fields(volume);
}
bool is_sound(const Lozenge<double, 3>& lozenge) {
  return has_sound_fields(lozenge) && is_sound(lozenge.edges[0]) && is_sound(lozenge.edges[1]);
}
bool is_sound(const Aabb<double, 3>& box) { return has_sound_fields(box) && (box.max - box.min).minCoeff() >= 0; }
bool is_sound(const Obb<double, 3>& box) {
  return has_sound_fields(box) &&
         (box.axes.transpose() * box.axes - Matrix<double, 3>::Identity()).cwiseAbs().maxCoeff() <=
             tolerance::kAxesAsGiven;
}
bool is_sound(const Kdop<double, 3>& kdop) {
  const std::size_t slabs = kdop_axes<3>(kdop.k).size();
  for (std::size_t i = 0; i < slabs; ++i)
    if (!is_sound(kdop.min[i]) || !is_sound(kdop.max[i]) || kdop.min[i] > kdop.max[i]) return false;
  return slabs > 0;
}
bool is_sound(const Cloud& points) {
  for (const V3& p : points)
    if (!is_sound(p)) return false;
  return !points.empty();
}
bool is_sound(const ConvexHull<double, 3>& hull) { return is_sound(hull.vertices); }

bool has_sound_shape(const Body& body) {
  if (const auto* cloud = std::get_if<Cloud>(&body.shape)) return is_sound(*cloud);
  return std::visit([](const auto& volume) { return is_sound(volume); }, *std::get_if<Volume3>(&body.shape));
}

bool has_smooth_shape(const Body& body) {
  const auto is_smooth = []<class Kind>(const Kind&) { return !query::HasCorners<Kind>; };
  const auto* volume = std::get_if<Volume3>(&body.shape);
  return volume != nullptr && std::visit(is_smooth, *volume);
}

bool has_tiny_lengths(const Body& body) {
  if (std::holds_alternative<Cloud>(body.shape)) return false;
  const Shape shape = centered(body.shape).shape;
  const auto tiny = [](double length) { return length > 0 && length < kSmallest; };
  return tiny(shape.radius) || (shape.half_extents.array() > 0 && shape.half_extents.array() < kSmallest).any();
}

/// What is wrong with a mass, if anything.
const char* fault_of_mass(double mass, bool fixed) {
  if (std::isnan(mass)) return "its mass is not a number";
  if (fixed && (mass == 0 || std::isinf(mass))) return "its mass is 0 or infinite: a body that is fixed needs none";
  if (std::isinf(mass)) return "its mass is infinite: call it fixed instead";
  if (mass == 0) return "its mass is 0: call it fixed instead";
  if (mass < 0) return "its mass is negative";
  if (mass < kSmallest) return "its mass is too small";
  return mass > kLargest ? "its mass is too large" : nullptr;
}

const char* fault_of(const Body& body) {
  const Quaternion& q = body.orientation;
  if (!is_sound(body.position)) return "its position is not finite, or too large";
  if (!is_sound(V3(q.x, q.y, q.z)) || !is_sound(q.w)) return "its orientation is not finite";
  if (q.w == 0 && q.x == 0 && q.y == 0 && q.z == 0) return "its orientation is not a rotation";
  if (!is_sound(body.velocity) || !is_sound(body.angular_velocity)) return "its velocity is not finite, or too large";
  if (has_smooth_shape(body)) return "its shape is smooth: a scene takes polytopes, and spheres swept over them";
  if (!has_sound_shape(body)) return "its shape is empty, not finite, or too large";
  if (has_tiny_lengths(body)) return "its shape is too small";
  return fault_of_mass(body.mass, body.fixed);
}

std::string name_of(const Declaration& declaration, std::size_t i) {
  const std::string& name = declaration.bodies[i].name;
  return name.empty() ? "body " + std::to_string(i) : name;
}

/// The part of a pose that an effect drives; nothing for an unknown effect, which is refused when effects are planned.
PosePart driven_by(const EffectCall& call) {
  const EffectKind* kind = find_effect(catalogue(), call.name);
  return kind != nullptr ? kind->drives : 0;
}

/// The body that both calls act on, if any. A call without a body acts on all unfixed ones.
std::optional<std::string> common_body(const EffectCall& a, const EffectCall& b) {
  if (a.body.empty() && b.body.empty()) return "every body";
  if (a.body.empty() || b.body.empty() || a.body == b.body) return a.body.empty() ? b.body : a.body;
  return std::nullopt;
}

void add_drivers(const std::vector<EffectCall>& effects, std::vector<InputError>& faults) {
  for (auto later = effects.begin(); later != effects.end(); ++later)
    for (auto first = effects.begin(); first != later; ++first) {
      const auto whom = common_body(*first, *later);
      if (whom && (driven_by(*first) & driven_by(*later)) != 0)
        faults.push_back(error_at(later->line, first->name + " and " + later->name + " would both drive " + *whom +
                                                   ": one undoes the other"));
    }
}

const char* fault_of_step(double step) {
  if (std::isnan(step)) return "the scene's step is not a number";
  if (!(step > 0)) return "the scene's step must be above 0";
  if (step < kShortestStep) return "the scene's step must be at least 1e-9 seconds";
  return step > 1 ? "the scene's step must be at most 1 second" : nullptr;
}

}  // namespace

InputError error_at(int line, std::string what) {
  return {
      .what = std::move(what), .unit = line > 0 ? InputError::Unit::kLine : InputError::Unit::kNone, .position = line};
}

std::vector<InputError> declaration_faults(const Declaration& declaration) {
  std::vector<InputError> faults;
  if (declaration.bodies.empty()) faults.push_back(error_at(0, "the scene has no body"));
  if (const char* fault = fault_of_step(declaration.step)) faults.push_back(error_at(0, fault));
  for (std::size_t i = 0; i < declaration.bodies.size(); ++i) {
    const Body& body = declaration.bodies[i];
    if (const char* fault = fault_of(body))
      faults.push_back(error_at(body.line, name_of(declaration, i) + ": " + fault));
    const auto twin = [&](const Body& other) { return other.name == body.name; };
    const auto here = declaration.bodies.begin() + static_cast<std::ptrdiff_t>(i);
    if (!body.name.empty() && std::any_of(declaration.bodies.begin(), here, twin))
      faults.push_back(error_at(body.line, "there is another body called " + body.name));
  }
  add_drivers(declaration.effects, faults);
  return faults;
}

tl::expected<void, InputError> check(const Declaration& declaration) {
  std::vector<InputError> faults = declaration_faults(declaration);
  if (!faults.empty()) return tl::unexpected(std::move(faults.front()));
  return {};
}

Declaration with_sound_bodies(Declaration declaration) {
  constexpr double kApart = 1e6, kRadius = 0.5;
  for (std::size_t i = 0; i < declaration.bodies.size(); ++i) {
    Body& body = declaration.bodies[i];
    if (fault_of(body) == nullptr) continue;
    Body sound{.name = body.name, .shape = Volume3(Sphere<double, 3>{V3::Zero(), kRadius}), .fixed = body.fixed};
    sound.position = V3::Constant(kApart * static_cast<double>(i + 1));
    body = std::move(sound);
  }
  if (fault_of_step(declaration.step) != nullptr) declaration.step = Declaration().step;
  return declaration;
}

}  // namespace snug::scene
