// A subject with two boxes: its edits by hand, by number fields and by rows.
#include <numbers>

#include "lesson/boxes.hpp"
#include "lesson/rows.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {
namespace {

using Box = Obb<double, 3>;

constexpr double kDegree = std::numbers::pi / 180;

/// Visits the numbers in the order of a row.
void see_numbers(auto& box, auto&& see) { see(box.center), see(box.half_extents), see(box.axes); }

}  // namespace

std::vector<std::vector<Index>> BoxSubject::things() const {
  std::vector<std::vector<Index>> things(2);
  for (Index i = 0; i < size(); ++i)
    if (const BoxHandle place = place_of(pair_, i); place.kind == BoxHandle::Kind::kCorner)
      things[place.box].push_back(i);
  if (pair_.form != Form::kBox) things[0] = {0};
  return things;
}

std::vector<NumberGroup> BoxSubject::numbers() const {
  constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
  const std::vector<std::string_view> names(kAxes.begin(), kAxes.begin() + dim());
  std::vector<NumberGroup> groups;
  for (const int i : {0, 1}) {
    const Box& box = pair_.boxes[i];
    const auto [heading, name, sizes] = words_of(i);
    const auto of = [&](const Point3& v) { return std::vector<double>(v.data(), v.data() + dim()); };
    NumberRow turn{.words = "Turn", .names = {}, .values = {}, .unit = "degrees", .drive = "turn"};
    if (dim() == 2) turn.values = {angle_of(box) / kDegree};
    else turn.names = names, turn.values = {0, 0, 0}, turn.turn = 15;
    NumberRow half{.words = sizes, .names = names, .values = of(box.half_extents), .drive = "half"};
    std::vector<NumberRow> rows{{"Centre", names, of(box.center)}};
    if (i == 1 || pair_.form == Form::kBox) rows.push_back(std::move(half)), rows.push_back(std::move(turn));
    else if (pair_.form == Form::kBall)
      rows.push_back({.words = sizes, .names = {}, .values = {box.half_extents[0]}, .drive = "radius"});
    groups.push_back({heading, name, std::move(rows), name_of(index_of(pair_, {BoxHandle::Kind::kCenter, i, 0}))});
  }
  return groups;
}

Done BoxSubject::set_numbers(std::size_t group, std::size_t row, std::span<const double> values) {
  const Form form = group == 0 ? pair_.form : Form::kBox;
  const std::size_t rows = form == Form::kBox ? 3 : form == Form::kBall ? 2 : 1;
  const bool radius = form == Form::kBall && row == 1;
  const std::size_t due = !radius && (row < 2 || dim() == 3) ? dim() : 1;
  if (group > 1 || row >= rows || values.size() != due) return Subject::set_numbers(group, row, values);
  BoxPair next = unrounded();
  Box& box = next.boxes[group];
  if (radius) {
    box.half_extents.head(dim()).setConstant(values[0]);
    return set_boxes(next);
  }
  for (int axis = 0; axis < static_cast<int>(due); ++axis)
    if (row < 2) (row == 0 ? box.center : box.half_extents)[axis] = values[axis];
    else if (dim() == 3 && values[axis] != 0) box = turned_by(box, axis, values[axis] * kDegree);
  if (row == 2 && dim() == 2) box.axes = Matrix<double, 3>::Identity(), box = turned_by(box, 2, values[0] * kDegree);
  return set_boxes(next);
}

Rows rows_of(const BoxPair& pair) {
  Rows rows;
  for (const Box& box : pair.boxes) {
    RowWriter writer(pair.dim);
    see_numbers(box, writer);
    rows.push_back(writer.take());
  }
  return rows;
}

Rows read_box_model(TomlTable& task, const Lesson& lesson, Complaints& complaints,
                    BoxPair (*read)(TomlTable& table, const BoxPair& like)) {
  const toml::table* model = task.table("model");
  if (model == nullptr) return task.lack("model", "the task lacks [task.model]"), Rows();
  TomlTable own(*model, "[task.model]", complaints);
  const BoxPair& like = static_cast<const BoxTables&>(*lesson.tables).boxes;
  const BoxPair boxes = read(own, like);
  own.refuse_others();
  return rows_of(boxes);
}

Rows BoxSubject::rows() const { return rows_of(unrounded()); }

Done BoxSubject::set_rows(const Rows& rows) {
  if (rows.size() != 2) return tl::unexpected(InputError{.what = "there must be two boxes"});
  BoxPair next = unrounded();
  for (const std::size_t i : {0, 1}) {
    RowReader reader(rows[i], dim());
    see_numbers(next.boxes[i], reader);
    if (!reader.fits()) return tl::unexpected(InputError{.what = "these are not the numbers of a box"});
  }
  return set_boxes(next);
}

Done BoxSubject::move(Index i, const Point3& to) {
  auto next = moved(unrounded(), i, to);
  if (!next) return tl::unexpected(std::move(next.error()));
  if (Done held = hold(*next, in_float()); !held) return held;
  origin_.edited = true;
  return {};
}

Done BoxSubject::hold(BoxPair pair, bool in_float) {
  if (Done fine = check(pair); !fine) return fine;
  if (!in_float) {
    pair_ = std::move(pair);
    unrounded_.reset();
    return {};
  }
  BoxPair rounded = rounded_to_float(pair);
  if (Done fine = check(rounded); !fine) return fine;
  pair_ = std::move(rounded);
  unrounded_ = std::move(pair);
  return {};
}

Done BoxSubject::set_float(bool in_float) {
  if (Done held = hold(unrounded(), in_float); !held) return held;
  origin_.in_float = in_float;
  return {};
}

Done BoxSubject::set_boxes(const BoxPair& pair) {
  if (pair.dim != pair_.dim) return tl::unexpected(InputError{.what = "there are no such boxes"});
  for (const Box& box : pair.boxes)
    if (!(box.half_extents.minCoeff() >= 0))
      return tl::unexpected(InputError{.what = pair.form == Form::kBall ? "a radius or half extent is below 0"
                                                                        : "a half extent is below 0"});
  if (Done held = hold(pair, in_float()); !held) return held;
  origin_.edited = true;
  return {};
}

Done set_boxes(Session& session, const BoxPair& pair) {
  auto next = session.stage().subject().clone();
  if (Done set = static_cast<BoxSubject&>(*next).set_boxes(pair); !set) return set;
  return session.stage().become(std::move(next));
}

void BoxSubject::scatter(std::uint64_t seed, const Subject& own) {
  const BoxPair& first = static_cast<const BoxSubject&>(own).unrounded();
  const bool in_float = this->in_float();
  if (!hold(seed == lesson_seed_ ? first : scattered(first, seed), in_float)) return;
  origin_ = own.origin();
  origin_.seed = seed;
  origin_.in_float = in_float;
}

void BoxSubject::begin_task(const Lesson&, const Task&, const Subject& own) {
  // What the lesson opens with was accepted in double; where float cannot hold it, the task is in double.
  const BoxPair& first = static_cast<const BoxSubject&>(own).unrounded();
  const bool in_float = this->in_float() && hold(first, true);
  if (!in_float) static_cast<void>(hold(first, false));
  origin_ = own.origin();
  origin_.in_float = in_float;
}

}  // namespace snug::lesson
