#include "lesson/subjects/field/field.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "lesson/fact_run.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/field/entries.hpp"
#include "lesson/subjects/field/samples.hpp"

namespace snug::lesson {

template class FactRun<FieldRun, FieldStep>;

namespace {

constexpr std::string_view kObjectsDrive = "Objects";

std::vector<std::string_view> field_volumes() { return {kFrustumField}; }
std::span<const Method> methods_on_field(std::string_view) { return field_methods(); }

tl::expected<std::unique_ptr<Subject>, InputError> open_field(const Lesson& lesson, std::optional<io::PointFile>,
                                                              Clock clock) {
  const auto& tables = static_cast<const FieldTables&>(*lesson.tables);
  if (const Done fine = check_stage(tables.stage); !fine) return tl::unexpected(fine.error());
  return std::make_unique<FieldSubject>(tables, lesson.seed, clock);
}

Figure counted_figure(std::string name, std::string key, std::int64_t value, std::string unit = "") {
  std::string text = count_text(value) + (unit.empty() ? "" : ' ' + unit);
  return {std::move(name), std::move(key), std::move(text), static_cast<double>(value), std::move(unit)};
}

/// A share in per cent, known at the end.
Figure share_figure(std::string name, std::string key, double share, bool known) {
  return {std::move(name), std::move(key), known ? number_text(share, 3) + " %" : "—", share, "%", known};
}

}  // namespace

const SubjectRow kFieldRow{.name = "field",
                           .table = "field",
                           .volumes = &field_volumes,
                           .methods = &methods_on_field,
                           .facts = &FactList<FieldStep::Fact>::names,
                           .question_kinds = &FactList<FieldStep::Fact>::question_kinds,
                           .read = &read_field,
                           .read_model = &read_field_model,
                           .open = &open_field,
                           .samples = kFieldSamples};

FieldSubject::FieldSubject(const FieldTables& tables, std::uint64_t seed, Clock clock)
    : clock_(clock), stage_(tables.stage), field_(field_by(stage_.recipe, seed)) {
  origin_.seed = seed;
}

FieldMeasured FieldSubject::measured(const Method& method) const {
  FieldMeasuring measuring = this->measuring(method);
  while (!measuring.done()) measuring.work(HUGE_VAL);
  return measuring.result();
}

Rows FieldSubject::planes() const {
  Rows rows;
  const auto frustum = frustum_of(stage_.recipe, stage_.now);
  for (const auto& [normal, d] : frustum->planes()) rows.push_back({normal[0], normal[1], normal[2], d});
  return rows;
}

std::vector<NumberGroup> FieldSubject::numbers() const {
  const std::vector<std::string_view> axes{"x", "y", "z"};
  const auto of = [](const Point3& p) { return std::vector<double>{p[0], p[1], p[2]}; };
  NumberRow objects{.words = "Objects", .names = {}, .values = {static_cast<double>(stage_.recipe.objects)}};
  objects.unit = "objects";
  return {{"Camera", "the camera", {{"Place", axes, of(stage_.now.position)}}, "Camera"},
          {"Aim", "the aim", {{"Place", axes, of(stage_.now.aim)}}, "Aim"},
          {"Field", "the field", {std::move(objects)}, std::string(kObjectsDrive)}};
}

std::vector<Drive> FieldSubject::drives() const {
  std::vector<Drive> all = Subject::drives();
  for (Drive& drive : all) drive.whole = drive.name == kObjectsDrive;
  return all;
}

Done FieldSubject::set_numbers(std::size_t group, std::size_t row, std::span<const double> values) {
  if (group > 2 || row > 0 || values.size() != (group == 2 ? 1U : 3U)) return Subject::set_numbers(group, row, values);
  if (group < 2) return move(static_cast<Index>(group), {values[0], values[1], values[2]});
  FieldStage next = stage_;
  next.recipe.objects = static_cast<int>(std::clamp(std::round(values[0]), 0.0, kMostObjects + 1.0));
  return become(next);
}

Done FieldSubject::set_rows(const Rows& rows) {
  auto next = with_rows(stage_, rows);
  if (!next) return tl::unexpected(std::move(next.error()));
  return become(*next);
}

Done FieldSubject::move(Index i, const Point3& to) {
  FieldStage next = stage_;
  next.before = stage_.now;
  (i == 0 ? next.now.position : next.now.aim) = to;
  return become(next);
}

Done FieldSubject::become(const FieldStage& next) {
  if (Done fine = check_stage(next); !fine) return fine;
  if (next.recipe.objects != stage_.recipe.objects) field_ = field_by(next.recipe, origin_.seed);
  stage_ = next;
  origin_.edited = true;
  return {};
}

void FieldSubject::scatter(std::uint64_t seed, const Subject& own) {
  *this = *as<FieldSubject>(own);
  if (seed != origin_.seed) field_ = field_by(stage_.recipe, seed);
  origin_.seed = seed;
}

void FieldSubject::begin_task(const Lesson&, const Task&, const Subject& own) { *this = *as<FieldSubject>(own); }

std::unique_ptr<Run> FieldSubject::run(const Method& method, std::unique_ptr<Run>) const {
  return std::make_unique<FieldRun>(field_, stage_, way_of(method));
}

std::string FieldSubject::opening(const Method& method) const {
  return std::string(method.title) + ", " + objects_text(stage_.recipe.objects) +
         ": nothing is known yet. Take the first step.";
}

std::vector<Figure> FieldSubject::figures(const View& view) const {
  const FieldRun& run = field_run(view.run());
  const FieldTally& tally = run.tally(view.step);
  const bool done = view.at_end();
  const auto all = static_cast<double>(run.objects());
  std::vector<Figure> figures{counted_figure("Objects", "objects", run.objects()),
                              counted_figure("Inside", "inside", tally.known[0]),
                              counted_figure("Intersecting", "intersecting", tally.known[1]),
                              counted_figure("Drawn", "drawn", tally.known[0] + tally.known[1]),
                              counted_figure("Outside", "outside", tally.known[2]),
                              counted_figure("Plane tests", "planes", tally.planes),
                              counted_figure("Dot products", "products", tally.products)};
  if (run.way() == hierarchy::FieldWay::kTree)
    figures.push_back(counted_figure("Planes skipped", "skipped", tally.skipped));
  figures.push_back(
      share_figure("Plane tests saved", "saved", 100 * (1 - static_cast<double>(tally.planes) / (6 * all)), done));
  figures.push_back(share_figure("Dot products saved", "products_saved",
                                 100 * (1 - static_cast<double>(tally.products) / (48 * all)), done));
  return figures;
}

std::vector<Proof> FieldSubject::proofs(const View& view) const {
  if (!view.at_end()) return {};
  const FieldRun& run = field_run(view.run());
  const bool at_once = run.way() == hierarchy::FieldWay::kAtOnce;
  const std::string other_way = at_once ? "one by one" : "eight at once";
  const Proof exact{"decided in exact arithmetic wherever rounding could matter", true, true};
  if (view.in_hand) return {{"compared with " + other_way + " when you let go", false, false}, exact};
  const auto frustum = *frustum_of(stage_.recipe, stage_.now);
  std::vector<query::Culling> other(run.verdicts().size());
  hierarchy::cull_field(run.field(), frustum, at_once ? hierarchy::FieldWay::kPnVertex : hierarchy::FieldWay::kAtOnce,
                        {}, other);
  const auto same = static_cast<std::int64_t>(std::inner_product(other.begin(), other.end(), run.verdicts().begin(),
                                                                 std::size_t{0}, std::plus<>(), std::equal_to<>()));
  return {{"the same answer as " + other_way + " for " + count_text(same) + " of " + objects_text(run.objects()),
           same == run.objects(), true},
          exact};
}

}  // namespace snug::lesson
