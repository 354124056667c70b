#include "lesson/subjects/frustum/frustum.hpp"

#include "lesson/fact_run.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/frustum/entries.hpp"
#include "lesson/subjects/frustum/frustum_figures.hpp"

namespace snug::lesson {

template class FactRun<FrustumRun, FrustumStep>;

namespace {

/// The goals: a box that this wrong test loses, although it shares a point with the frustum.
constexpr std::array<std::string_view, 1> kFrustumGoals{"corners_outside"};

std::vector<std::string_view> frustum_volumes() { return {kFrustumBox}; }
std::span<const Method> frustum_methods(std::string_view) { return frustum_tests(); }

Done check_frustum(const BoxPair& pair) {
  if (pair.dim == 2) {
    if (auto frustum = frustum_of<2>(pair); !frustum) return tl::unexpected(std::move(frustum.error()));
  } else if (auto frustum = frustum_of<3>(pair); !frustum) {
    return tl::unexpected(std::move(frustum.error()));
  }
  return check_places(pair);
}

BoxPair read_box_and_frustum(TomlTable& table, int dim, double taper) {
  BoxPair pair = read_pair(table, dim, taper);
  if (!(pair.boxes[1].half_extents.head(dim).minCoeff() > 0))
    table.wrong("half_extents", "of a frustum must be above 0");
  else if (const Done fine = check_frustum(pair); !fine) table.wrong("center", fine.error().what);
  return pair;
}

void read_frustum(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  auto tables = std::make_shared<BoxTables>();
  TomlTable own(*table.table("boxes"), "[boxes]", complaints);
  lesson.points.dim = static_cast<int>(own.integer_or("dim", 2, 3, 2));
  const std::size_t before = complaints.count();
  const double taper = own.number("taper", 1);
  if (taper == 1 && own.has("taper") && complaints.count() == before) own.wrong("taper", "must be above 0 and below 1");
  tables->boxes = read_box_and_frustum(own, lesson.points.dim, taper);
  own.refuse_others();
  lesson.tables = std::move(tables);
}

Rows read_frustum_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  return read_box_model(task, lesson, complaints, &read_box_and_frustum);
}

tl::expected<std::unique_ptr<Subject>, InputError> open_frustum(const Lesson& lesson, std::optional<io::PointFile>,
                                                                Clock) {
  return std::make_unique<FrustumSubject>(static_cast<const BoxTables&>(*lesson.tables).boxes, lesson.seed);
}

}  // namespace

const SubjectRow kFrustumRow{.name = "frustum",
                             .table = "boxes",
                             .volumes = &frustum_volumes,
                             .methods = &frustum_methods,
                             .facts = &FactList<FrustumStep::Fact>::names,
                             .askings = &FactList<FrustumStep::Fact>::askings,
                             .read = &read_frustum,
                             .read_model = &read_frustum_model,
                             .goals = kFrustumGoals,
                             .open = &open_frustum};

std::string FrustumSubject::name_of(Index i) const {
  const BoxHandle place = place_of(dim(), i);
  if (place.kind == BoxHandle::Kind::kCorner)
    return place.box == 0 ? sign_name(dim(), place.number) : "F" + std::to_string(place.number);
  const std::string box = place.box == 0 ? "Box" : "Frustum";
  return place.kind == BoxHandle::Kind::kCenter ? box : box + (place.number == 0 ? " turn" : " roll");
}

Done FrustumSubject::check(const BoxPair& pair) const { return check_frustum(pair); }

std::unique_ptr<Run> FrustumSubject::run(const Method& method, std::unique_ptr<Run>) const {
  return std::make_unique<FrustumRun>(dim(), record_frustum(method.name, boxes()));
}

std::string FrustumSubject::opening(const Method& method) const {
  return std::string(method.title) + ", box and frustum: nothing is known yet. Take the first step.";
}

std::vector<Figure> FrustumSubject::figures(const View& view) const { return frustum_figures(view, boxes()); }
std::vector<Proof> FrustumSubject::proofs(const View& view) const { return frustum_proofs(view, boxes()); }

/// Whether the wrong test calls the box outside, which it is not.
bool FrustumSubject::reaches(std::string_view) const {
  return says_of_box("corners_outside", boxes()) == query::Culling::kOutside && share_a_point(boxes()).value_or(false);
}

std::string FrustumSubject::goal_says(std::string_view goal) const {
  if (reaches(goal)) return "This box is lost: the wrong test says outside, yet the box reaches into the frustum.";
  if (says_of_box("corners_outside", boxes()) != query::Culling::kOutside)
    return "The wrong test keeps this box: a vertex of it lies in the frustum.";
  return "The wrong test says outside, and it is right here: the box does not touch the frustum.";
}

}  // namespace snug::lesson
