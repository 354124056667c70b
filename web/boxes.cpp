#include "web/boxes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "lesson/boxes.hpp"
#include "web/view.hpp"

namespace snug::web {
namespace {

using emscripten::val;
using Box = Obb<double, 3>;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kUnitWithin = 1e-9;  // an address has every digit, so a larger error is a typing mistake

std::string sentence(const tl::expected<void, InputError>& result) { return result ? "" : result.error().message(); }

void push_all(val& row, const Vector<double, 3>& v, int dim) {
  for (int axis = 0; axis < dim; ++axis) row.call<void>("push", v[axis]);
}

Vector<double, 3> taken(const val& row, int& at, int dim) {
  Vector<double, 3> v = Vector<double, 3>::Zero();
  for (int axis = 0; axis < dim; ++axis) v[axis] = row[at++].as<double>();
  return v;
}

/// Whether these are the axes of a box: unit and perpendicular.
bool are_axes(const Matrix<double, 3>& axes) {
  return (axes.transpose() * axes - Matrix<double, 3>::Identity()).cwiseAbs().maxCoeff() < kUnitWithin &&
         axes.col(0).cross(axes.col(1)).dot(axes.col(2)) > 0;
}

const Box* box_at(const lesson::Session& session, int box) {
  return session.subject().boxes() == nullptr || box < 0 || box > 1 ? nullptr : &session.subject().boxes()->boxes[box];
}

std::string replace(lesson::Session& session, int box, const Box& by) {
  lesson::BoxPair pair = *session.subject().boxes();
  pair.boxes[box] = by;
  return sentence(session.set_boxes(pair));
}

}  // namespace

val boxes_object(const lesson::Session& session) {
  if (session.subject().boxes() == nullptr) return val::null();
  val both = val::array();
  for (const Box& box : session.subject().boxes()->boxes) {
    val object = val::object();
    object.set("center", coordinates(box.center, session.dim()));
    object.set("half_extents", coordinates(box.half_extents, session.dim()));
    if (session.dim() == 2) object.set("degrees", lesson::angle_of(box) / kDegree);
    both.call<void>("push", object);
  }
  return both;
}

val box_rows(const lesson::Session& session) {
  val rows = val::array();
  const int dim = session.dim();
  for (const Box& box : session.subject().boxes()->boxes) {
    val row = val::array();
    push_all(row, box.center, dim), push_all(row, box.half_extents, dim);
    for (int axis = 0; axis < (dim == 2 ? 1 : 3); ++axis) push_all(row, box.axes.col(axis), dim);
    rows.call<void>("push", row);
  }
  return rows;
}

std::string set_box_rows(lesson::Session& session, const val& rows) {
  if (session.subject().boxes() == nullptr) return "this lesson has no boxes";
  lesson::BoxPair pair = *session.subject().boxes();
  const int dim = session.dim(), due = dim == 2 ? 6 : 15;
  if (rows["length"].as<int>() != 2) return "there are two boxes";
  for (int i = 0; i < 2; ++i) {
    const val row = rows[i];
    if (row["length"].as<int>() != due) return "a box has " + std::to_string(due) + " numbers";
    Box box;
    int at = 0;
    box.center = taken(row, at, dim), box.half_extents = taken(row, at, dim);
    for (int axis = 0; axis < (dim == 2 ? 1 : 3); ++axis) box.axes.col(axis) = taken(row, at, dim);
    if (dim == 2) box.axes.col(1) = Vector<double, 3>(-box.axes(1, 0), box.axes(0, 0), 0);
    if (!are_axes(box.axes)) return "the axes of a box are unit and perpendicular";
    pair.boxes[i] = box;
  }
  return sentence(session.set_boxes(pair));
}

std::string set_box(lesson::Session& session, int box, const std::string& what, const val& values) {
  const Box* own = box_at(session, box);
  if (own == nullptr) return "there is no such box";
  Box next = *own;
  int at = 0;
  (what == "center" ? next.center : next.half_extents) = taken(values, at, session.dim());
  return replace(session, box, next);
}

std::string turn_box(lesson::Session& session, int box, int axis, double degrees, bool to) {
  const Box* own = box_at(session, box);
  if (own == nullptr || axis < 0 || axis > 2 || !std::isfinite(degrees)) return "that is no turn";
  Box upright = *own;
  if (to) upright.axes = Matrix<double, 3>::Identity();
  return replace(session, box, lesson::turned_by(upright, axis, degrees * kDegree));
}

}  // namespace snug::web
