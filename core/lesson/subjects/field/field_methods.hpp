// The ways to cull a field that a lesson can show.
#pragma once

#include "hierarchy/field.hpp"
#include "lesson/subject.hpp"

namespace snug::lesson {

/// The volume of a lesson about a field.
inline constexpr std::string_view kFrustumField = "frustum_field";

/// In the order of hierarchy::FieldWay.
[[nodiscard]] std::span<const Method> field_methods();
[[nodiscard]] hierarchy::FieldWay way_of(const Method& method);

}  // namespace snug::lesson
