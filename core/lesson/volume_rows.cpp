#include "lesson/volume_rows.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/tolerance.hpp"
#include "lesson/rows.hpp"
#include "trace/fields.hpp"

namespace snug::lesson {
namespace {

bool is_hull(const HeldVolume& held) { return std::holds_alternative<ConvexHull<double, 3>>(held.volume); }

/// How many items of a field are in use: both edges, and only some bounds of a k-DOP.
template <class Item, std::size_t kMost>
constexpr std::size_t items_of(const std::array<Item, kMost>&, int k) {
  return std::is_same_v<Item, double> ? static_cast<std::size_t>(k) / 2 : kMost;
}

void see_field(auto& field, int k, auto& row) {
  if constexpr (requires { items_of(field, k); })
    for (std::size_t i = 0; i < items_of(field, k); ++i) row(field[i]);
  else row(field);
}

/// Visits the numbers in the order of a row. A hull's fields are computed from its points.
void see_row(auto& held, auto& row) {
  if (is_hull(held)) {
    for (auto& point : held.points) row(point);
    return;
  }
  std::visit(
      [&](auto& volume) {
        int k = 0;
        see_fields(volume, [&](std::string_view, auto& field) {
          using Field = std::remove_cvref_t<decltype(field)>;
          if constexpr (std::is_same_v<Field, int>) k = field;
          else if constexpr (!requires { field.capacity(); }) see_field(field, k, row);
        });
      },
      held.volume);
}

/// What is wrong with a radius or a lozenge's edges; a hand cannot make such an error, but a row can have one.
std::string_view fault_of_fields(const HeldVolume& held) {
  std::string_view fault;
  std::visit(
      [&](const auto& volume) {
        see_fields(volume, [&](std::string_view name, const auto& field) {
          using Field = std::remove_cvref_t<decltype(field)>;
          if constexpr (std::is_same_v<Field, double>)
            if (name == "radius" && !(field >= 0)) fault = "a radius is below 0";
          if constexpr (std::is_same_v<Field, std::array<Point3, 2>>)
            if (std::abs(field[0].dot(field[1])) > tolerance::kAxesAsGiven * field[0].norm() * field[1].norm())
              fault = "a lozenge's edges must be perpendicular";
        });
      },
      held.volume);
  return fault;
}

}  // namespace

std::vector<double> row_of(const HeldVolume& held) {
  RowWriter row(held.dim);
  see_row(held, row);
  return row.take();
}

tl::expected<HeldVolume, InputError> with_row(const HeldVolume& like, std::span<const double> numbers) {
  HeldVolume held = like;
  RowReader row(numbers, like.dim);
  see_row(held, row);
  if (!row.fits()) return tl::unexpected(InputError{.what = "these are not the numbers of such a volume"});
  if (const auto fault = fault_of_fields(held); !fault.empty())
    return tl::unexpected(InputError{.what = std::string(fault)});
  if (is_hull(held)) return moved(held, {Handle::Kind::kVertex, 0}, held.points.front());  // computes the hull
  if (const std::string fault = fault_of(held); !fault.empty()) return tl::unexpected(InputError{.what = fault});
  return held;
}

}  // namespace snug::lesson
