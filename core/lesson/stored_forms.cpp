// The representations of each kind of volume, after the structs of the lectures.
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "geometry/about_origin.hpp"
#include "geometry/convert.hpp"
#include "geometry/counted.hpp"
#include "geometry/sort.hpp"
#include "geometry/tolerance.hpp"
#include "lesson/figures.hpp"
#include "lesson/stored.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using Line = std::vector<Point3>;
using Lines = std::vector<Line>;

template <int Dim>
Point3 lifted(const Vector<double, Dim>& p) {
  Point3 at = Point3::Zero();
  at.head<Dim>() = p;
  return at;
}

/// "1.200, 0.400"
std::string text_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + coordinate_text(number);
  return text;
}

/// What an operation takes, in words and in operations; 0: it is not allowed as the volume is stored.
struct Cost {
  std::string says;
  int work = 0;
};

/// The representation of a volume, as it is written down.
template <int Dim>
class Written {
 public:
  using V = Vector<double, Dim>;
  explicit Written(std::string name) { form_.name = std::move(name); }

  void place(std::string declared, const V& at) { member("Point " + declared, numbers_of(at), {{lifted<Dim>(at)}}); }
  void vector(std::string declared, const V& way, const V& from) {
    member("Vector " + declared, numbers_of(way), {{lifted<Dim>(from), lifted<Dim>(V(from + way))}});
  }
  void number(std::string declared, double value, Lines lines) {
    member("float " + declared, {value}, std::move(lines));
  }
  void member(std::string declared, std::vector<double> numbers, Lines lines) {
    std::string text = text_of(numbers);
    form_.members.push_back({std::move(declared), std::move(numbers), std::move(text), std::move(lines)});
  }
  /// Moves, turns and grows what is stored as a program does, and writes down what that takes; test: what a test of two
  /// such volumes takes. stored: of numbers that count, whatever their values. no_turn, no_growth: what is said where
  /// the numbers alone do not tell the result.
  template <class Stored>
  void costs(Cost test, const Stored& stored, std::string_view no_turn, std::string_view no_growth);
  void ticks(std::size_t operation, bool least) { form_.operations[operation].least = least; }
  [[nodiscard]] StoredForm done() && { return std::move(form_); }
  /// What each of its operations takes; 0 for one that it does not allow as it is.
  [[nodiscard]] const std::array<int, 4>& work() const { return work_; }

  static std::vector<double> numbers_of(const V& v) { return {v.data(), v.data() + Dim}; }

 private:
  StoredForm form_;
  std::array<int, 4> work_{};  // of test, move, turn, grow
};

std::string counted(int n, const char* what) { return std::to_string(n) + ' ' + what + (n == 1 ? "" : "s"); }

Cost cost_of(const Work& work) {
  std::string says;
  if (work.multiplications > 0) says = counted(work.multiplications, "multiplication");
  if (work.additions > 0) says += (says.empty() ? "" : ", ") + counted(work.additions, "addition");
  return {says.empty() ? "nothing" : says, std::max(1, work.all())};
}

/// What an update of a form takes; `without` in words where the form has none.
Cost cost_of(auto update, const auto& stored, std::string_view without) {
  if constexpr (requires { update(stored); }) return cost_of(work_of([&] { return update(stored); }));
  else return {std::string(without), 0};
}

template <int Dim>
template <class Stored>
void Written<Dim>::costs(Cost test, const Stored& stored, std::string_view no_turn, std::string_view no_growth) {
  const Pose<Counted, Dim> pose;
  const auto move = [&](const auto& form) { return snug::moved(form, pose.translation); };
  // As a body's pose moves the body's volume.
  const auto turn = [&](const auto& form) requires requires { snug::turned_about_origin(form, pose.rotation); }
  { return move(snug::turned_about_origin(form, pose.rotation)); };
  const auto grow = [&](const auto& form) requires requires { snug::grown(form, Counted()); }
  { return snug::grown(form, Counted()); };
  constexpr std::array<const char*, 4> kNames{"test", "move", "turn", "grow"};
  std::array<Cost, 4> all{std::move(test), cost_of(move, stored, {}), cost_of(turn, stored, no_turn),
                          cost_of(grow, stored, no_growth)};
  for (std::size_t i = 0; i < all.size(); ++i) {
    work_[i] = all[i].work;
    form_.operations.push_back({kNames[i], std::move(all[i].says)});
  }
}

/// Marks of each operation the representations that take least, if some take more.
template <int Dim>
std::vector<StoredForm> compared(std::vector<Written<Dim>> forms) {
  std::vector<StoredForm> done;
  for (std::size_t operation = 0; operation < 4; ++operation) {
    constexpr int kNotAllowed = std::numeric_limits<int>::max();
    std::vector<int> work;
    for (const Written<Dim>& form : forms)
      work.push_back(form.work()[operation] > 0 ? form.work()[operation] : kNotAllowed);
    const auto [least, most] = std::minmax_element(work.begin(), work.end());
    for (std::size_t i = 0; i < forms.size(); ++i) forms[i].ticks(operation, *least < *most && work[i] == *least);
  }
  for (Written<Dim>& form : forms) done.push_back(std::move(form).done());
  return done;
}

// ---- what they are on the stage ---------------------------------------------------------------------------------

/// The face of a box on one side of an axis, as a closed line; in 2-D its edge.
template <int Dim>
Line face_of(const Obb<double, Dim>& box, int axis, double side) {
  const Vector<double, Dim> middle = box.center + side * box.half_extents[axis] * box.axes.col(axis);
  if constexpr (Dim == 2) {
    const Vector<double, 2> arm = box.half_extents[1 - axis] * box.axes.col(1 - axis);
    return {lifted<2>(Vector<double, 2>(middle - arm)), lifted<2>(Vector<double, 2>(middle + arm))};
  } else {
    const int j = (axis + 1) % 3, k = (axis + 2) % 3;
    const Vector<double, 3> u = box.half_extents[j] * box.axes.col(j), v = box.half_extents[k] * box.axes.col(k);
    return {middle - u - v, middle + u - v, middle + u + v, middle - u + v, middle - u - v};
  }
}

template <int Dim>
Line half_extent_of(const Obb<double, Dim>& box, int axis) {
  return {lifted<Dim>(box.center),
          lifted<Dim>(Vector<double, Dim>(box.center + box.half_extents[axis] * box.axes.col(axis)))};
}

/// The points where a k-DOP meets one of its planes, in order around them.
template <int Dim>
Line bound_of(const Kdop<double, Dim>& kdop, const KdopAxis<Dim>& axis, double bound) {
  using V = Vector<double, Dim>;
  V normal;
  double most = 0;
  for (int i = 0; i < Dim; ++i) normal[i] = axis[i];
  for (int i = 0; i < kdop.k / 2; ++i) most = std::max({most, std::abs(kdop.min[i]), std::abs(kdop.max[i])});
  std::vector<V> there;
  V middle = V::Zero();
  for (const V& vertex : kdop_vertices(kdop))
    if (std::abs(normal.dot(vertex) - bound) <= 2 * tolerance::kKdopCorner<double> * most)
      there.push_back(vertex), middle += vertex;
  if (there.empty()) return {};
  middle /= static_cast<double>(there.size());
  if constexpr (Dim == 3) {
    const V u = (there.front() - middle).norm() > 0 ? V((there.front() - middle).normalized()) : V(V::UnitX());
    const V n = normal.normalized(), v(n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]);
    sort_stably(there, [&](const V& p, const V& q) {
      return std::atan2(v.dot(p - middle), u.dot(p - middle)) < std::atan2(v.dot(q - middle), u.dot(q - middle));
    });
    if (there.size() > 2) there.push_back(there.front());
  }
  Line line;
  for (const V& vertex : there) line.push_back(lifted<Dim>(vertex));
  return line;
}

std::string entry(const char* name, int i) { return std::string(name) + '[' + std::to_string(i) + ']'; }

// ---- each kind --------------------------------------------------------------------------------------------------

constexpr std::string_view kRefit = "a new fit";

template <int Dim>
std::vector<StoredForm> forms_of(const Aabb<double, Dim>& box) {
  using V = Vector<double, Dim>;
  const auto widths = min_widths_of(box);
  const auto centered = center_extents_of(box);
  const Obb<double, Dim> upright{centered.center, Matrix<double, Dim>::Identity(), centered.half_extents};
  std::vector<Written<Dim>> forms{Written<Dim>("min-max"), Written<Dim>("min-widths"), Written<Dim>("centre-radius")};
  forms[0].place("min", box.min);
  forms[0].place("max", box.max);
  forms[0].costs({"up to " + counted(2 * Dim, "comparison"), 2 * Dim}, Aabb<Counted, Dim>{}, kRefit, {});
  forms[1].place("min", widths.min);
  for (int i = 0; i < Dim; ++i)
    forms[1].number(entry("d", i), widths.widths[i],
                    {{lifted<Dim>(box.min), lifted<Dim>(V(box.min + widths.widths[i] * V::Unit(i)))}});
  forms[1].costs({"up to " + counted(Dim, "subtraction") + ", " + counted(2 * Dim, "comparison"), 3 * Dim},
                 AabbMinWidths<Counted, Dim>{}, kRefit, {});
  forms[2].place("c", centered.center);
  for (int i = 0; i < Dim; ++i)
    forms[2].number(entry("r", i), centered.half_extents[i], {half_extent_of<Dim>(upright, i)});
  forms[2].costs({"up to " + counted(2 * Dim, "addition") + ", " + counted(Dim, "comparison"), 3 * Dim},
                 AabbCenterExtents<Counted, Dim>{}, kRefit, {});
  return compared(std::move(forms));
}

template <int Dim>
std::vector<StoredForm> forms_of(const Obb<double, Dim>& box) {
  using V = Vector<double, Dim>;
  const bool plane = Dim == 2;
  const auto vertices = vertices_of(box);
  const auto planes = planes_of(box);
  const auto slabs = slabs_of(box);
  const auto with = [](const V& normal, std::initializer_list<double> rest) {
    std::vector<double> numbers = Written<Dim>::numbers_of(normal);
    numbers.insert(numbers.end(), rest);
    return numbers;
  };
  std::vector<Written<Dim>> forms{
      Written<Dim>(plane ? "four vertices" : "eight vertices"), Written<Dim>(plane ? "four planes" : "six planes"),
      Written<Dim>(plane ? "two slabs" : "three slabs"), Written<Dim>("centre, axes, half extents")};
  for (std::size_t i = 0; i < vertices.size(); ++i) forms[0].place(entry("v", static_cast<int>(i)), vertices[i]);
  forms[0].costs({"find its axes first"}, ObbVertices<Counted, Dim>{}, {}, "find its axes first");
  for (std::size_t i = 0; i < planes.size(); ++i)
    forms[1].member("Plane " + entry("p", static_cast<int>(i)), with(planes[i].normal, {planes[i].d}),
                    {face_of<Dim>(box, static_cast<int>(i / 2), i % 2 == 0 ? 1 : -1)});
  forms[1].costs({"of a point: " + counted(2 * Dim, "dot product")}, ObbPlanes<Counted, Dim>{}, {}, {});
  for (int i = 0; i < Dim; ++i) {
    const auto& slab = slabs[i];
    forms[2].member("Slab " + entry("s", i), with(slab.normal, {slab.min, slab.max}),
                    {face_of<Dim>(box, i, -1), face_of<Dim>(box, i, 1)});
  }
  forms[2].costs({"of a point or a ray: " + counted(Dim, "dot product")}, ObbSlabs<Counted, Dim>{}, {}, {});
  forms[3].place("c", box.center);
  for (int i = 0; i < Dim; ++i) forms[3].vector(entry("u", i), V(box.axes.col(i)), box.center);
  for (int i = 0; i < Dim; ++i) forms[3].number(entry("e", i), box.half_extents[i], {half_extent_of<Dim>(box, i)});
  forms[3].costs({"separating axes, as it is", 1}, Obb<Counted, Dim>{}, {}, {});
  return compared(std::move(forms));
}

template <int Dim>
std::vector<StoredForm> forms_of(const Sphere<double, Dim>& ball) {
  Written<Dim> form(std::string("centre and radius"));
  form.place("c", ball.center);
  form.number("r", ball.radius,
              {{lifted<Dim>(ball.center),
                lifted<Dim>(Vector<double, Dim>(ball.center + ball.radius * Vector<double, Dim>::Unit(0)))}});
  form.costs({counted(Dim + 1, "multiplication") + ", " + counted(2 * Dim, "addition") + ", 1 comparison", 1},
             Sphere<Counted, Dim>{}, {}, {});
  return {std::move(form).done()};
}

/// A radius around a core, from a point of it.
template <int Dim>
Lines radius_from(const Vector<double, Dim>& point, const Vector<double, Dim>& along, double radius) {
  using V = Vector<double, Dim>;
  V across = V::Unit(0);
  if (along.norm() > 0) {
    if constexpr (Dim == 2) {
      across = V(-along[1], along[0]).normalized();
    } else {
      int least = 0;
      along.cwiseAbs().minCoeff(&least);
      across = (V::Unit(least) - along * (along[least] / along.squaredNorm())).normalized();
    }
  }
  return {{lifted<Dim>(point), lifted<Dim>(V(point + radius * across))}};
}

template <int Dim>
std::vector<StoredForm> forms_of(const Capsule<double, Dim>& capsule) {
  using V = Vector<double, Dim>;
  Written<Dim> form("segment and radius");
  form.place("a", capsule.a);
  form.place("b", capsule.b);
  form.number("r", capsule.radius, radius_from<Dim>(capsule.a, V(capsule.b - capsule.a), capsule.radius));
  form.costs({"the distance between two segments", 1}, Capsule<Counted, Dim>{}, {}, {});
  return {std::move(form).done()};
}

template <int Dim>
std::vector<StoredForm> forms_of(const Lozenge<double, Dim>& lozenge) {
  Written<Dim> form("rectangle and radius");
  form.place("a", lozenge.origin);
  for (int i = 0; i < 2; ++i) form.vector(entry("u", i), lozenge.edges[i], lozenge.origin);
  form.number("r", lozenge.radius, radius_from<Dim>(lozenge.origin, lozenge.edges[0], lozenge.radius));
  form.costs({"the distance between two rectangles", 1}, Lozenge<Counted, Dim>{}, {}, {});
  return {std::move(form).done()};
}

template <int Dim>
std::vector<StoredForm> forms_of(const Kdop<double, Dim>& kdop) {
  Written<Dim> form("bounds of " + std::to_string(kdop.k / 2) + " slabs");
  const auto axes = kdop_axes<Dim>(kdop.k);
  for (const bool greatest : {false, true})
    for (std::size_t i = 0; i < axes.size(); ++i) {
      Point3 direction = Point3::Zero();
      for (int j = 0; j < Dim; ++j) direction[j] = axes[i][j];
      const double bound = greatest ? kdop.max[i] : kdop.min[i];
      form.number(entry(greatest ? "max" : "min", static_cast<int>(i)) + ": " + axis_name(direction), bound,
                  {bound_of<Dim>(kdop, axes[i], bound)});
    }
  form.costs({"up to " + counted(kdop.k, "comparison"), 1}, Kdop<Counted, Dim>{.k = kdop.k}, kRefit, {});
  return {std::move(form).done()};
}

/// Those of a volume in its own dimension, if its kind has any here.
template <int Dim>
std::vector<StoredForm> forms_in(const auto& kind) {
  const auto own = converted<double, Dim>(kind);
  if constexpr (requires { forms_of<Dim>(own); }) return forms_of<Dim>(own);
  else return {};
}

}  // namespace

std::vector<StoredForm> stored_forms(const fit::Volume3& volume, int dim) {
  return std::visit([&](const auto& kind) { return dim == 2 ? forms_in<2>(kind) : forms_in<3>(kind); }, volume);
}

}  // namespace snug::lesson
