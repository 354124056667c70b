#include "lesson/subjects/cloud/hand.hpp"

#include <algorithm>

#include "fit/catalogue.hpp"
#include "lesson/subjects/cloud/by_hand.hpp"
#include "lesson/volume_rows.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kSlabsVolume = "kdop";  // whose directions are set, and which has no handles of its own
constexpr double kKnobAway = 0.12;                 // how far a knob is from its volume, over the points' largest extent

/// The axis-aligned box around the points.
struct Extents {
  Point3 center = Point3::Zero(), lengths = Point3::Zero();
  explicit Extents(const AnyPointSet& points) {
    Point3 least = fit::point_of(points, 0), greatest = least;
    for (Index i = 1; i < fit::count_of(points); ++i) {
      least = least.cwiseMin(fit::point_of(points, i));
      greatest = greatest.cwiseMax(fit::point_of(points, i));
    }
    lengths = greatest - least;
    center = least + lengths / 2;
  }
};

/// What a volume is before a hand has set it: it lies along the coordinate axes, and its core is half as long as the
/// points' extents.
struct Start {
  Extents extents;
  void operator()(auto&) const {}
  void operator()(Capsule<double, 3>& capsule) const {
    const Point3 quarter = Point3::UnitX() * (extents.lengths[0] / 4);
    capsule.a = extents.center - quarter, capsule.b = extents.center + quarter;
  }
  void operator()(Lozenge<double, 3>& lozenge) const {
    for (int i = 0; i < 2; ++i) lozenge.edges[i] = Point3::Unit(i) * (extents.lengths[i] / 2);
    lozenge.origin = extents.center - (lozenge.edges[0] + lozenge.edges[1]) / 2;
  }
};

/// The rest of a volume follows from the points; what the hand has set keeps all its digits.
struct Follow {
  const fit::Volume3& fitted;
  void operator()(auto&) const {}
  void operator()(Obb<double, 3>& box) const {
    const auto& own = *std::get_if<Obb<double, 3>>(&fitted);
    box.center = own.center, box.half_extents = own.half_extents;
  }
  void operator()(Capsule<double, 3>& capsule) const {
    capsule.radius = std::get_if<Capsule<double, 3>>(&fitted)->radius;
  }
  void operator()(Lozenge<double, 3>& lozenge) const {
    lozenge.radius = std::get_if<Lozenge<double, 3>>(&fitted)->radius;
  }
};

void fit_to(HeldVolume& held, const AnyPointSet& points) {
  const fit::Volume3 fitted = fit_by_hand(held.volume, points);
  std::visit(Follow{fitted}, held.volume);
}

/// A box is set by its knobs alone; no volume by its radius.
bool sets(const HeldVolume& held, const Handle& handle) {
  if (std::holds_alternative<Obb<double, 3>>(held.volume)) return handle.kind == Handle::Kind::kTurn;
  return handle.kind != Handle::Kind::kRadius;
}

std::string title_of(std::string_view volume) {
  return volume == "obb" ? "Box" : volume == "capsule" ? "Capsule" : "Lozenge";
}

}  // namespace

Hand::Hand(std::span<const std::string_view> volumes, const AnyPointSet& points) {
  for (const std::string_view volume : volumes)
    if (volume == kSlabsVolume) axes_.emplace(points);
    else parts_.push_back({volume, {}});
  begin(points);
}

void Hand::begin(const AnyPointSet& points) {
  if (axes_) axes_->begin(points);
  grips_.clear();
  if (parts_.empty()) return;
  const Start start{Extents(points)};
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    HeldVolume& held = parts_[i].held;
    held = {.volume = volume_of_kind(parts_[i].volume), .dim = fit::dim_of(points)};
    held.knob = kKnobAway * start.extents.lengths.maxCoeff();
    std::visit(start, held.volume);
    fit_to(held, points);
    for (const Handle& handle : handles_of(held))
      if (sets(held, handle)) grips_.push_back({i, handle});
  }
}

void Hand::follow(const AnyPointSet& points) {
  if (axes_) axes_->follow(points);
  if (!parts_.empty() && parts_.front().held.dim != fit::dim_of(points)) return begin(points);
  for (Part& part : parts_) fit_to(part.held, points);
}

Point3 Hand::at(Index i) const {
  if (i >= held_handles()) return axes_->at(axis_of(i));
  return at_handle(parts_[grips_[i].part].held, grips_[i].handle);
}

std::string_view Hand::volume_of(Index i) const {
  return i >= held_handles() ? kSlabsVolume : parts_[grips_[i].part].volume;
}

std::string Hand::name_of(Index i) const {
  if (i >= held_handles()) return "Axis " + std::to_string(axis_of(i) + 1);
  const auto& [part, handle] = grips_[i];
  const std::string title = title_of(parts_[part].volume);
  if (handle.kind != Handle::Kind::kVertex) return title + handle_name(parts_[part].held, handle);
  if (parts_[part].volume == "capsule") return title + (handle.number == 0 ? " a" : " b");
  return title + " " + std::to_string(handle.number);
}

Done Hand::move(Index i, const Point3& to, const AnyPointSet& points) {
  if (i >= held_handles()) return axes_->move(axis_of(i), to);
  HeldVolume& held = parts_[grips_[i].part].held;
  auto next = moved(held, grips_[i].handle, to);
  if (!next) return tl::unexpected(std::move(next.error()));
  held = *std::move(next);
  fit_to(held, points);
  return {};
}

Done Hand::remove(Index i) {
  if (i >= held_handles()) return axes_->remove(axis_of(i));
  return tl::unexpected(InputError{.what = name_of(i) + " cannot be deleted"});
}

fit::Recording Hand::record(const Method& method, const AnyPointSet& points, fit::Recording room) const {
  if (method.volume == kSlabsVolume) return record_slabs(axes_->axes(), points, std::move(room));
  return record_by_hand(method, held(method.volume)->volume, points, std::move(room));
}

fit::Volume3 Hand::fitted(const Method& method, const AnyPointSet& points) const {
  if (method.volume == kSlabsVolume) return fit_slabs(axes_->axes(), points);
  return fit_by_hand(held(method.volume)->volume, points);
}

const HeldVolume* Hand::held(std::string_view volume) const {
  const auto found =
      std::find_if(parts_.begin(), parts_.end(), [&](const Part& part) { return part.volume == volume; });
  return found != parts_.end() ? &found->held : nullptr;
}

Rows Hand::rows() const {
  Rows rows;
  for (const Part& part : parts_) rows.push_back(row_of(part.held));
  if (axes_) rows.push_back(axes_->row());
  return rows;
}

Done Hand::set_rows(std::span<const std::vector<double>> rows, const AnyPointSet& points) {
  if (rows.empty()) return {};
  if (rows.size() != parts_.size() + (axes_ ? 1 : 0))
    return tl::unexpected(InputError{.what = "the number of volumes set by hand must be the lesson's"});
  std::vector<HeldVolume> next;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    auto held = with_row(parts_[i].held, rows[i]);
    if (!held) return tl::unexpected(std::move(held.error()));
    next.push_back(*std::move(held));
  }
  if (axes_)
    if (Done set = axes_->set_row(rows.back()); !set) return set;
  for (std::size_t i = 0; i < next.size(); ++i) {
    parts_[i].held = std::move(next[i]);
    fit_to(parts_[i].held, points);
  }
  return {};
}

}  // namespace snug::lesson
