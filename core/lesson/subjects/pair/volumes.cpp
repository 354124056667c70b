#include "lesson/subjects/pair/volumes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/pose.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/box_figures.hpp"
#include "lesson/subjects/pair/entries.hpp"
#include "lesson/subjects/pair/read_volumes.hpp"
#include "lesson/subjects/pair/samples.hpp"
#include "lesson/volume_rows.hpp"
#include "lesson/words.hpp"
#include "measure/cost_run.hpp"

namespace snug::lesson {
namespace {

std::vector<std::string_view> own_volumes() { return {kVolumePair}; }
std::span<const Method> own_methods(std::string_view) { return volume_tests(); }

tl::expected<std::unique_ptr<Subject>, InputError> open_volumes(const Lesson& lesson, std::optional<io::PointFile>,
                                                                Clock clock) {
  const auto& tables = static_cast<const VolumeTables&>(*lesson.tables);
  auto subject = std::make_unique<VolumesSubject>(tables.pair, lesson.seed, clock);
  if (Done set = subject->set_float(tables.in_float); !set) return tl::unexpected(std::move(set.error()));
  return subject;
}

/// The state of the test after some steps, from the last step of each fact.
struct SoFar {
  int tests = 0, simplices = 0;
  double radii = 0;
  std::optional<double> upper;  // bound on the cores' distance
  const query::SlabTested* slab = nullptr;
  std::optional<double> gap;  // once they are known to be apart

  void operator()(const query::SlabTested& fact) { ++tests, slab = &fact; }
  void operator()(const query::AxisTested<double, 3>&) { ++tests; }
  void operator()(const query::CoresCompared& fact) { tests += fact.tests, upper = fact.distance; }
  void operator()(const query::NearestFound& fact) { ++simplices, upper = fact.distance; }
  void operator()(const query::Verdict<double, 3>& fact) {
    if (!fact.result.overlap) gap = fact.result.axis.gap;
  }
  void operator()(const OverlapDecided& fact) {
    if (!fact.overlap) gap = fact.gap;
  }
  void operator()(const auto&) {}
};

/// How many operations the test took so far.
Figure operations_figure(PairSteps steps) {
  const std::int64_t count = operations_in(steps);
  return {"Operations so far", "operations", count_text(count), static_cast<double>(count), ""};
}

constexpr std::string_view kSlabsThenGjk = "slabs_then_gjk";

/// What a test counts, as `snug overlap` counts it: "Simplices so far".
std::string_view counted_by(std::string_view test, bool of_cores, bool of_slabs) {
  if (test == "gjk") return "Simplices so far";
  if (test == kSlabsThenGjk) return "Slabs and simplices so far";
  if (of_slabs) return "Slabs so far";
  return of_cores ? "Pairs of features so far" : "Tests so far";
}

Figure length(std::string name, std::string key, std::optional<double> value) {
  return {std::move(name),   std::move(key), value ? number_text(*value) + " units" : "—",
          value.value_or(0), "units",        value.has_value()};
}

/// What a test of two axis-aligned boxes compares along its last axis, as its representation has it.
std::vector<Figure> compared_along(const query::SlabTested& fact, std::string_view test) {
  const std::string axis = axis_name(fact.direction);
  const auto figure = [&](std::string name, std::string key, double value) {
    return length(std::move(name) + '.' + axis, std::move(key), value);
  };
  if (test == "min_max")
    return {figure("a.max", "a_max", fact.greatest_a), figure("b.min", "b_min", fact.least_b),
            figure("b.max", "b_max", fact.greatest_b), figure("a.min", "a_min", fact.least_a)};
  if (test == "min_widths")
    return {length("t = a.min − b.min, along " + axis, "t", fact.least_a - fact.least_b),
            figure("b.d", "b_width", fact.greatest_b - fact.least_b),
            figure("a.d", "a_width", fact.greatest_a - fact.least_a)};
  const double center_a = (fact.least_a + fact.greatest_a) / 2, center_b = (fact.least_b + fact.greatest_b) / 2;
  return {length("|a.c − b.c|, along " + axis, "centres", std::abs(center_a - center_b)),
          length("a.r + b.r, along " + axis, "extents",
                 (fact.greatest_a - fact.least_a + fact.greatest_b - fact.least_b) / 2)};
}

/// The squares that the test of two spheres compares.
std::vector<Figure> squares_of(const VolumePair& pair, double radii, bool known) {
  const double distance = (at_handle(pair.held[1], {}) - at_handle(pair.held[0], {})).squaredNorm();
  const auto square = [&](const char* name, const char* key, double value) {
    return Figure{name, key, known ? number_text(value) + " units²" : "—", value, "units²", known};
  };
  return {square("Squared distance", "distance_squared", distance),
          square("Squared sum of the radii", "radii_squared", radii * radii)};
}

/// What GJK says of the cylinders, once the test of the capsules is at its end.
void add_cylinders(std::vector<Figure>& figures, const VolumePair& pair, bool at_end) {
  const auto found = at_end ? as_cylinders(pair) : std::nullopt;
  const bool apart = found && !found->overlap;
  figures.push_back(
      length("Separation of the cylinders", "cylinder_gap", apart ? std::optional(found->gap) : std::nullopt));
  const int simplices = found ? found->simplices : 0;
  figures.push_back({"Simplices for the cylinders", "cylinder_simplices", found ? std::to_string(simplices) : "—",
                     static_cast<double>(simplices), "", found.has_value()});
}

Point3 random_place(Random& random, double reach, int dim) {
  Point3 place = Point3::Zero();
  for (int i = 0; i < dim; ++i) place[i] = random.between(-reach, reach);
  return place;
}

Matrix<double, 3> random_turn(Random& random, int dim) {
  Quaternion spin{1, 0, 0, random.between(-1, 1)};
  if (dim == 3) spin = {random.between(0.2, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
  return matrix_of(normalized(spin));
}

/// A turn about a coordinate axis, or in the plane, where it has none.
struct Turned {
  std::string_view word = " turn";
  int axis = -1;
};

/// The turns of a volume whose kind can rotate.
std::vector<Turned> turned_of(const HeldVolume& held) {
  const HeldVolume turned = placed(held, snug::turn(Point3::UnitZ(), 1), Point3::Zero());
  if (row_of(turned) == row_of(held)) return {};
  if (held.dim == 2) return {{}};
  return {{" turn", 0}, {" turn", 1}, {" turn", 2}};
}

/// The angle of a box's first axis in the plane, degrees; none of what has no first axis, or in space.
std::optional<double> angle_of(const HeldVolume& held) {
  const auto* box = std::get_if<Obb<double, 3>>(&held.volume);
  if (box == nullptr || held.dim == 3) return std::nullopt;
  return std::atan2(box->axes(1, 0), box->axes(0, 0)) * 180 / std::numbers::pi;
}

/// The pair rounded to float. Errors: numbers that are too large for it, or bounds between which nothing is left.
tl::expected<VolumePair, InputError> pair_in_float(const VolumePair& pair) {
  VolumePair next = pair;
  next.in_float = true;
  std::vector<Vector<float, 3>> places;
  for (HeldVolume& held : next.held) {
    for (const Handle& handle : handles_of(held)) places.push_back(at_handle(held, handle).cast<float>());
    held = rounded_to_float(held);
  }
  if (auto set = PointSet<float, 3>::make(std::move(places)); !set) return tl::unexpected(std::move(set.error()));
  for (const HeldVolume& held : next.held)
    if (std::string fault = fault_of(held); !fault.empty()) return tl::unexpected(InputError{.what = std::move(fault)});
  return next;
}

/// Moves both volumes to random places, and rotates those that can rotate. reach: how far the places are apart.
void scatter_by(VolumePair& pair, std::uint64_t seed) {
  double reach = 0;
  for (const HeldVolume& held : pair.held)
    for (const Handle& handle : handles_of(held))
      reach = std::max(reach, (at_handle(held, handle) - at_handle(held, {})).norm());
  Random random(seed);
  for (HeldVolume& held : pair.held) {
    const Matrix<double, 3> rotation = random_turn(random, pair.dim);
    held = placed(held, rotation, random_place(random, 1.2 * reach, pair.dim) - at_handle(held, {}));
  }
}

/// Puts the centre of a box exactly at `center`. Each earlier drag rounded both bounds separately: if the half extent
/// is within that rounding of a short binary fraction, it becomes that fraction. Otherwise a bound that is shown as
/// 0.250 might not equal 0.25.
void center_exactly(Aabb<double, 3>& box, int axis, double center) {
  constexpr int kShort = 20, kDrags = 40;  // bits of the fraction, and those that hundreds of drags leave right
  const double half = (box.max[axis] - box.min[axis]) / 2;
  const double size = std::max({std::abs(box.min[axis]), std::abs(box.max[axis]), half});
  if (size == 0) return;
  const double unit = std::ldexp(1.0, std::ilogb(size) - kShort), fraction = std::round(half / unit) * unit;
  if (fraction == 0 || std::abs(fraction - half) > std::ldexp(size, -kDrags)) return;
  box.min[axis] = center - fraction;
  box.max[axis] = center + fraction;
}

/// "A turn", "A turn x", and for the centre "A x".
std::string name_of_drive(int side, const Turned& one) {
  constexpr std::array<std::string_view, 3> kAxes{" x", " y", " z"};
  std::string name = (side == 0 ? "A" : "B") + std::string(one.word);
  return one.axis < 0 ? name : name.append(kAxes[one.axis]);
}

}  // namespace

const SubjectRow kVolumesRow{.name = "volumes",
                             .table = "volumes",
                             .volumes = &own_volumes,
                             .methods = &own_methods,
                             .facts = &pair_facts,
                             .question_kinds = &pair_question_kinds,
                             .read = &read_volumes,
                             .read_model = &read_volume_model,
                             .goals = kVolumeGoals,
                             .check_first = &check_volume_tests,
                             .open = &open_volumes,
                             .samples = kVolumesSamples};

VolumesSubject::VolumesSubject(VolumePair pair, std::uint64_t seed, Clock clock) : lesson_seed_(seed), clock_(clock) {
  origin_.seed = seed;
  show(std::move(pair));
}

Done VolumesSubject::hold(VolumePair pair, bool in_float) {
  pair.in_float = false;
  if (!in_float) {
    show(std::move(pair));
    unrounded_.reset();
    return {};
  }
  auto shown = pair_in_float(pair);
  if (!shown) return tl::unexpected(std::move(shown.error()));
  show(*std::move(shown));
  unrounded_ = std::move(pair);
  return {};
}

Done VolumesSubject::become(VolumePair pair) {
  if (Done held = hold(std::move(pair), in_float()); !held) return held;
  origin_.edited = true;
  return {};
}

bool VolumesSubject::hold_in_float_if_possible(VolumePair pair, bool in_float) {
  if (in_float && hold(pair, true)) return true;
  static_cast<void>(hold(std::move(pair), false));
  return false;
}

Done VolumesSubject::set_float(bool in_float) {
  if (Done held = hold(unrounded(), in_float); !held) return held;
  origin_.in_float = in_float;
  return {};
}

void VolumesSubject::show(VolumePair pair) {
  pair_ = std::move(pair);
  handles_.clear();
  for (const int side : {0, 1})
    for (const Handle& handle : handles_of(pair_.held[side])) handles_.push_back({side, handle});
}

void VolumesSubject::measure_costs() {
  constexpr cost::TimingOptions kTiming{.repeats = 5, .batch = 5e5};
  if (can_measure()) costs_ = std::make_shared<cost::PairCostRun>(dim(), lesson_seed_, kTiming, clock_);
}

void VolumesSubject::work_on_costs(double budget) {
  if (costs_ != nullptr) cost::advance(*costs_, clock_, budget);
}

void VolumesSubject::choose_kinds(const Kinds& kinds) {
  origin_.in_float = hold_in_float_if_possible(with_kinds(unrounded(), kinds), in_float());
  origin_.edited = true;
}

Point3 VolumesSubject::at(Index i) const { return at_handle(pair_.held[side(i)], handle(i)); }

std::string VolumesSubject::name_of(Index i) const {
  return (side(i) == 0 ? "A" : "B") + handle_name(pair_.held[side(i)], handle(i));
}

Done VolumesSubject::move(Index i, const Point3& to) {
  VolumePair next = unrounded();
  auto held = moved(next.held[side(i)], handle(i), to);
  if (!held) return tl::unexpected(std::move(held.error()));
  next.held[side(i)] = *std::move(held);
  return become(std::move(next));
}

std::vector<Drive> VolumesSubject::drives() const {
  std::vector<Drive> all;
  for (const int side : {0, 1}) {
    const HeldVolume& held = unrounded().held[side];
    for (const Turned& one : turned_of(held))
      all.push_back({.name = name_of_drive(side, one), .unit = "degrees", .now = angle_of(held)});
    for (int axis = 0; axis < dim(); ++axis)
      all.push_back({.name = name_of_drive(side, {"", axis}), .now = at_handle(held, {})[axis]});
  }
  return all;
}

Done VolumesSubject::drive(std::string_view name, double from, double to) {
  VolumePair pair = unrounded();
  for (const int side : {0, 1}) {
    HeldVolume& held = pair.held[side];
    for (const Turned& one : turned_of(held)) {
      if (name != name_of_drive(side, one)) continue;
      const Point3 axis = Point3::Unit(one.axis < 0 ? 2 : one.axis);
      held = placed(held, snug::turn(axis, (to - from) * std::numbers::pi / 180), Point3::Zero());
      return become(std::move(pair));
    }
    for (int axis = 0; axis < dim(); ++axis) {
      if (name != name_of_drive(side, {"", axis})) continue;
      Point3 center = at_handle(held, {});
      center[axis] = to;
      auto next = moved(held, {}, center);
      if (!next) return tl::unexpected(std::move(next.error()));
      held = *std::move(next);
      if (auto* box = std::get_if<Aabb<double, 3>>(&held.volume)) center_exactly(*box, axis, to);
      return become(std::move(pair));
    }
  }
  return Subject::drive(name, from, to);
}

/// The handles of each volume, without its knobs.
std::vector<std::vector<Index>> VolumesSubject::things() const {
  std::vector<std::vector<Index>> both(2);
  for (Index i = 0; i < size(); ++i)
    if (handle(i).kind != Handle::Kind::kTurn) both[side(i)].push_back(i);
  return both;
}

Rows VolumesSubject::rows() const { return rows_of(unrounded()); }

Done VolumesSubject::set_rows(const Rows& rows) {
  auto next = with_rows(unrounded(), rows);
  if (!next) return tl::unexpected(std::move(next.error()));
  return become(*std::move(next));
}

/// Scatters the lesson's own volumes, or those of the kinds that were chosen: random positions and, if their kind can
/// rotate, random orientations.
void VolumesSubject::scatter(std::uint64_t seed, const Subject& own) {
  const VolumePair& theirs = as<VolumesSubject>(own)->unrounded();
  VolumePair next = pair_.any && seed != lesson_seed_ ? with_kinds(theirs, kinds_of(pair_)) : theirs;
  if (seed != lesson_seed_) scatter_by(next, seed);
  const bool in_float = hold_in_float_if_possible(std::move(next), this->in_float());
  origin_ = own.origin();
  origin_.seed = seed;
  origin_.in_float = in_float;
}

void VolumesSubject::begin_task(const Lesson&, const Task&, const Subject& own) {
  const bool in_float = hold_in_float_if_possible(as<VolumesSubject>(own)->unrounded(), this->in_float());
  origin_ = own.origin();
  origin_.in_float = in_float;
}

std::string_view compared_in(const VolumePair& pair) {
  const auto is_sphere = [](const HeldVolume& held) { return std::holds_alternative<Sphere<double, 3>>(held.volume); };
  if (is_sphere(pair.held[0]) && is_sphere(pair.held[1])) return "centres";
  return radius_of(pair.held[0]) + radius_of(pair.held[1]) > 0 ? "cores" : "volumes";
}

/// The vertices of both cores, with their handles. A hull's vertices are some of its points, and have their handles; a
/// k-DOP's have none.
PairRun::Vertices VolumesSubject::vertices() const {
  PairRun::Vertices all;
  for (const int side : {0, 1}) {
    const HeldVolume& held = pair_.held[side];
    const std::string letter = side == 0 ? "A" : "B";
    const auto* hull = std::get_if<ConvexHull<double, 3>>(&held.volume);
    const auto count = static_cast<int>(core_of(held).size());
    for (int i = 0; i < count; ++i) {
      const Handle handle =
          count == 1 ? Handle{}
                     : Handle{Handle::Kind::kVertex, hull != nullptr ? static_cast<int>(hull->indices[i]) : i};
      CoreVertex vertex{letter + (count == 1 ? "" : std::to_string(handle.number))};
      for (Index k = 0; k < size(); ++k)
        if (this->side(k) == side && this->handle(k) == handle) vertex.handle = k;
      all[side].push_back(std::move(vertex));
    }
  }
  return all;
}

std::string VolumesSubject::refusal(const Method& method) const {
  if (is_among(tests_of(pair_), method.name)) return {};
  return std::string(method.title) + " is not a test of these two volumes";
}

std::optional<double> proved_distance(PairSteps steps) {
  std::optional<double> most;
  for (const auto& entry : steps) {
    if (const auto* found = std::get_if<query::SupportFound>(&entry.step.fact))
      most = std::max(most.value_or(0), found->gap);
    if (const auto* compared = std::get_if<query::CoresCompared>(&entry.step.fact)) most = compared->distance;
  }
  return most;
}

std::unique_ptr<Run> VolumesSubject::run(const Method& method, std::unique_ptr<Run>) const {
  return std::make_unique<PairRun>(dim(), record(method.name, pair_), vertices(), compared_in(pair_));
}

std::string VolumesSubject::opening(const Method& method) const {
  return std::string(method.title) + ", volumes A and B: nothing is known yet. Take the first step.";
}

std::vector<Figure> VolumesSubject::figures(const View& view) const {
  const PairSteps steps = pair_run(view.run()).trace();
  SoFar standing;
  for (int i = 0; i < view.step; ++i) {
    const auto& fact = steps[i].step.fact;
    std::visit(standing, fact);
    // Such a simplex is at distance 0, whatever rounding makes of it.
    if (std::holds_alternative<query::NearestFound>(fact) && contains_origin(steps, i)) standing.upper = 0;
  }
  const auto count = [](std::string_view name, std::string_view key, int number) {
    return Figure{std::string(name), std::string(key), std::to_string(number), static_cast<double>(number), ""};
  };
  if (!axes_seen(steps).empty()) {  // the table of axes says the rest
    std::vector<Figure> few{length("Separation", "gap", standing.gap), count("Axes so far", "tests", standing.tests)};
    if (pair_.any) few.push_back(operations_figure(steps.first(view.step)));
    return few;
  }
  std::vector<Figure> figures;
  const bool gjk = view.method().name == "gjk";
  const std::string compared(compared_in(pair_));
  const double radii = radius_of(pair_.held[0]) + radius_of(pair_.held[1]);
  const bool cores = std::any_of(steps.begin(), steps.end(), [](const auto& entry) {
    return std::holds_alternative<query::NearestFound>(entry.step.fact) ||
           std::holds_alternative<query::CoresCompared>(entry.step.fact);
  });
  if (cores) {
    if (gjk) {
      figures.push_back(
          length(capital(compared) + " apart, at least", "lower", proved_distance(steps.first(view.step))));
      figures.push_back(length(capital(compared) + " apart, at most", "upper", standing.upper));
    } else {
      figures.push_back(length("Distance between the " + compared, "cores", standing.upper));
    }
    if (radii > 0 || pair_.any) figures.push_back(length("Sum of the radii", "radii", radii));
    if (view.method().name == "spheres")
      for (Figure& figure : squares_of(pair_, radii, standing.tests > 0)) figures.push_back(std::move(figure));
  }
  if (standing.slab != nullptr && is_of_boxes(view.method().name))
    figures = compared_along(*standing.slab, view.method().name);
  figures.push_back(length("Separation", "gap", standing.gap));
  const bool slabs = std::any_of(steps.begin(), steps.end(), [](const auto& entry) {
    return std::holds_alternative<query::SlabTested>(entry.step.fact);
  });
  const std::string_view test = view.method().name;
  figures.push_back(count(is_of_boxes(test) ? "Axes so far" : counted_by(test, cores, slabs), "tests",
                          standing.tests + standing.simplices));
  if (test == kSlabsThenGjk) figures.push_back(count("Slabs so far", "slabs", standing.tests));
  if (pair_.cylinders) add_cylinders(figures, pair_, view.at_end());
  if (pair_.any) figures.push_back(operations_figure(steps.first(view.step)));
  return figures;
}

std::vector<Proof> VolumesSubject::proofs(const View& view) const {
  if (!view.at_end()) return {};
  const auto apart = separation_of(pair_);
  if (!apart)
    return {{"GJK finds a point that both volumes have in common, or that is within rounding of both", true, true}};
  const double end_of_a = reach_along(pair_.held[0], apart->direction);
  const double end_of_b = -reach_along(pair_.held[1], -apart->direction);
  const std::string separating = dim() == 2 ? "a line" : "a plane";
  return {{separating + " that passes between the nearest points has A on one side and B on the other",
           end_of_a < end_of_b, true}};
}

}  // namespace snug::lesson
