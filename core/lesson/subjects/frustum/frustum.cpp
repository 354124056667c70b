#include "lesson/subjects/frustum/frustum.hpp"

#include "lesson/fact_run.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/frustum/entries.hpp"
#include "lesson/subjects/frustum/frustum_figures.hpp"
#include "lesson/subjects/frustum/matrix_planes.hpp"
#include "lesson/subjects/frustum/samples.hpp"

namespace snug::lesson {

template class FactRun<FrustumRun, FrustumStep>;

FrustumRun::FrustumRun(std::string_view test, const BoxPair& pair)
    : dim_(pair.dim), body_(body_word(pair)), box_(pair.form == Form::kBox), trace_(record_frustum(test, pair)),
      loses_(verdict_of(trace_) == query::Culling::kOutside && share_a_point(pair).value_or(false)),
      far_lost_(is_of_matrix(test) && far_plane_of(test, pair).lost) {}

std::vector<Index> FrustumRun::candidates(int) const { return box_ ? vertices_of(dim_, 0) : std::vector<Index>{}; }

namespace {

/// The goals: a box that this wrong test loses, although it shares a point with the frustum; a circle or sphere that
/// this one loses; a body that the right test keeps, although it shares none; a box that the planes of a matrix lose in
/// float, and keep in double.
constexpr std::string_view kFalsePositive = "false_positive";
constexpr std::string_view kNear = "near";  // what a slider drives: the near distance over the far one
constexpr std::array<std::string_view, 4> kFrustumGoals{"corners_outside", "wrong_sign", kFalsePositive,
                                                        kMatrixTests[1]};

std::vector<std::string_view> frustum_volumes() { return {kFrustumBox, kFrustumSphere, kFrustumPoint}; }

Form form_of(std::string_view volume) {
  return volume == kFrustumSphere ? Form::kBall : volume == kFrustumPoint ? Form::kPoint : Form::kBox;
}

Done check_frustum(const BoxPair& pair) {
  if (pair.dim == 2) {
    if (auto frustum = frustum_of<2>(pair); !frustum) return tl::unexpected(std::move(frustum.error()));
  } else if (auto frustum = frustum_of<3>(pair); !frustum) {
    return tl::unexpected(std::move(frustum.error()));
  }
  return check_places(pair);
}

/// like: with its dimension, taper and form.
BoxPair read_body_and_frustum(TomlTable& table, const BoxPair& like) {
  BoxPair pair = read_pair(table, like.dim, like.taper, like.form);
  if (!(pair.boxes[1].half_extents.head(like.dim).minCoeff() > 0))
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
  tables->boxes =
      read_body_and_frustum(own, {.dim = lesson.points.dim, .form = form_of(lesson.volume), .taper = taper});
  own.refuse_others();
  lesson.tables = std::move(tables);
}

Rows read_frustum_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  return read_box_model(task, lesson, complaints, &read_body_and_frustum);
}

tl::expected<std::unique_ptr<Subject>, InputError> open_frustum(const Lesson& lesson, std::optional<io::PointFile>,
                                                                Clock clock) {
  return std::make_unique<FrustumSubject>(static_cast<const BoxTables&>(*lesson.tables).boxes, lesson.seed, clock);
}

}  // namespace

const SubjectRow kFrustumRow{.name = "frustum",
                             .table = "boxes",
                             .volumes = &frustum_volumes,
                             .methods = &frustum_tests,
                             .facts = &FactList<FrustumStep::Fact>::names,
                             .question_kinds = &FactList<FrustumStep::Fact>::question_kinds,
                             .read = &read_frustum,
                             .read_model = &read_frustum_model,
                             .goals = kFrustumGoals,
                             .open = &open_frustum,
                             .samples = kFrustumSamples};

namespace {

/// "Box", "Circle"
std::string body_name(const BoxPair& pair) {
  std::string name = body_word(pair);
  name.front() = static_cast<char>(name.front() - 'a' + 'A');
  return name;
}

/// Words about a body: of a box, a circle, a sphere, a point.
struct BodyWords {
  std::string_view heading, name, stage, tools;
};
const BodyWords& words_for(const BoxPair& pair) {
  static constexpr BodyWords kBox{"Box", "the box", "a box and a view frustum", "Box and frustum"},
      kCircle{"Circle", "the circle", "a circle and a view frustum", "Circle and frustum"},
      kSphere{"Sphere", "the sphere", "a sphere and a view frustum", "Sphere and frustum"},
      kPoint{"Point", "the point", "a point and a view frustum", "Point and frustum"};
  if (pair.form == Form::kPoint) return kPoint;
  return pair.form == Form::kBox ? kBox : pair.dim == 2 ? kCircle : kSphere;
}

}  // namespace

std::string FrustumSubject::name_of(Index i) const {
  const BoxHandle place = place_of(boxes(), i);
  if (place.kind == BoxHandle::Kind::kCorner)
    return place.box == 0 ? sign_name(dim(), place.number) : "F" + std::to_string(place.number);
  const std::string body = place.box == 0 ? body_name(boxes()) : "Frustum";
  if (place.kind == BoxHandle::Kind::kRadius) return body + " radius";
  return place.kind == BoxHandle::Kind::kCenter ? body : body + (place.number == 0 ? " turn" : " roll");
}

std::string_view FrustumSubject::stage_says() const { return words_for(boxes()).stage; }

Tools FrustumSubject::tools() const {
  const BodyWords& words = words_for(boxes());
  return {boxes().form == Form::kBox ? "Boxes" : words.heading, words.tools};
}

BoxSubject::Words FrustumSubject::words_of(int box) const {
  if (box == 1)
    return {"Frustum", "the frustum",
            dim() == 2 ? "Half sizes: x depth, y far face" : "Half sizes: x depth, y and z far face"};
  const BodyWords& words = words_for(boxes());
  return {words.heading, words.name, boxes().form == Form::kBall ? "Radius" : "Half extents"};
}

Done FrustumSubject::check(const BoxPair& pair) const { return check_frustum(pair); }

std::unique_ptr<Run> FrustumSubject::run(const Method& method, std::unique_ptr<Run>) const {
  return std::make_unique<FrustumRun>(method.name, boxes());
}

void FrustumSubject::start_survey() {
  auto survey = FrustumSurvey::make(boxes(), origin_.seed);
  survey_ = survey ? std::make_shared<FrustumSurvey>(*std::move(survey)) : nullptr;
}

void FrustumSubject::work_on_survey(double budget) {
  const double end = clock_ != nullptr ? clock_() + budget : 0;
  while (survey_ != nullptr && !survey_->done()) {
    survey_->step();
    if (clock_ != nullptr && clock_() >= end) return;
  }
}

const FrustumSurvey* FrustumSubject::survey() const {
  return survey_ != nullptr && survey_->is_of(boxes()) ? survey_.get() : nullptr;
}

std::string FrustumSubject::opening(const Method& method) const {
  return std::string(method.title) + ", " + body_word(boxes()) +
         " and frustum: nothing is known yet. Take the first step.";
}

std::vector<Figure> FrustumSubject::figures(const View& view) const { return frustum_figures(view, boxes()); }
std::vector<Proof> FrustumSubject::proofs(const View& view) const { return frustum_proofs(view, boxes()); }

std::vector<Drive> FrustumSubject::drives() const {
  std::vector<Drive> all = BoxSubject::drives();
  all.push_back({.name = std::string(kNear), .unit = "", .now = boxes().taper});
  return all;
}

Done FrustumSubject::drive(std::string_view name, double from, double to) {
  if (name != kNear) return BoxSubject::drive(name, from, to);
  BoxPair next = boxes();
  next.taper = to;
  return set_boxes(next);
}

std::vector<fit::Volume3> FrustumSubject::volumes() const {
  const Obb<double, 3>& box = boxes().boxes[0];
  if (boxes().form == Form::kBox) return {box};
  return {Sphere<double, 3>{box.center, box.half_extents[0]}};
}

Rows FrustumSubject::planes() const {
  const auto rows_in = [](const auto& frustum) {
    Rows rows;
    if (!frustum) return rows;
    for (const auto& [normal, d] : frustum->planes()) {
      rows.emplace_back(normal.begin(), normal.end());
      rows.back().push_back(d);
    }
    return rows;
  };
  return dim() == 2 ? rows_in(frustum_of<2>(boxes())) : rows_in(frustum_of<3>(boxes()));
}

namespace {

/// The right test of the body.
std::string_view right_test(const BoxPair& pair) {
  return pair.form == Form::kBox ? "p_n_vertex" : pair.form == Form::kBall ? "grown_planes" : "half_spaces";
}

bool loses(std::string_view test, const BoxPair& pair) {
  return verdict_of(test, pair) == query::Culling::kOutside && share_a_point(pair).value_or(false);
}

/// What the planes of the matrix say in both scalars.
std::string matrix_says(const BoxPair& pair) {
  if (!share_a_point(pair).value_or(true)) return "This box does not touch the frustum.";
  const auto kept = [&](std::string_view test) { return verdict_of(test, pair) != query::Culling::kOutside; };
  const bool in_float = kept(kMatrixTests[1]), in_double = kept(kMatrixTests[0]);
  const auto word = [](bool is_kept) { return std::string(is_kept ? "kept" : "lost"); };
  return "This box reaches into the frustum. With the planes of the matrix it is " + word(in_float) + " in float" +
         (in_float == in_double ? " and in double." : ", and " + word(in_double) + " in double.");
}

bool fits(std::string_view goal, const BoxPair& pair) {
  if (goal == "corners_outside") return pair.form == Form::kBox;
  if (is_of_matrix(goal)) return pair.form == Form::kBox && pair.dim == 3;
  return goal != "wrong_sign" || pair.form == Form::kBall;
}

}  // namespace

bool FrustumSubject::reaches(std::string_view goal) const {
  if (!fits(goal, boxes())) return false;
  if (goal == kFalsePositive)
    return verdict_of(right_test(boxes()), boxes()) == query::Culling::kIntersecting &&
           !share_a_point(boxes()).value_or(true);
  if (goal == kMatrixTests[1])
    return loses(goal, unrounded()) && verdict_of(kMatrixTests[0], unrounded()) != query::Culling::kOutside;
  return loses(goal, boxes());
}

std::string FrustumSubject::goal_says(std::string_view goal) const {
  const std::string body = body_word(boxes());
  if (goal == kFalsePositive) {
    if (reaches(goal)) return "A false positive: the test says intersecting, yet the " + body + " touches nothing.";
    const query::Culling says = verdict_of(right_test(boxes()), boxes());
    if (says != query::Culling::kIntersecting) return "The test says " + culling_name(says) + ".";
    return "The test says intersecting, and it is right here: the " + body + " reaches into the frustum.";
  }
  if (goal == kMatrixTests[1] && fits(goal, boxes())) return matrix_says(unrounded());
  if (reaches(goal))
    return "This " + body + " is lost: the wrong test says outside, yet the " + body + " reaches into the frustum.";
  if (fits(goal, boxes()) && verdict_of(goal, boxes()) == query::Culling::kOutside)
    return "The wrong test says outside, and it is right here: the " + body + " does not touch the frustum.";
  return boxes().form == Form::kBox ? "The wrong test keeps this box: a vertex of it lies in the frustum."
                                    : "The wrong test keeps this " + body + ": all of it lies in the frustum.";
}

}  // namespace snug::lesson
