// The points of a session, their edits, and undo.
#include <algorithm>

#include "geometry/generate.hpp"
#include "lesson/frustum_box.hpp"
#include "lesson/own_points.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostUndo = 200;  // of a bunny, 10 MB

std::vector<Vector<double, 3>> all_points(const AnyPointSet& points) {
  std::vector<Vector<double, 3>> all;
  all.reserve(fit::size_of(points));
  for (Index i = 0; i < fit::size_of(points); ++i) all.push_back(fit::point_of(points, i));
  return all;
}

tl::expected<void, InputError> move_point(AnyPointSet& points, Index i, const Vector<double, 3>& to) {
  return std::visit(
      [&]<class Scalar, int Dim>(PointSet<Scalar, Dim>& set) {
        return set.move(i, to.template head<Dim>().template cast<Scalar>());
      },
      points);
}

tl::unexpected<InputError> fixed_boxes() {
  return tl::unexpected(InputError{.what = "this lesson has two volumes: no more and no fewer"});
}

tl::unexpected<InputError> no_point(Index i) {
  return tl::unexpected(InputError{.what = "there is no point " + std::to_string(i)});
}

}  // namespace

int Session::dim() const { return fit::dim_of(points()); }
Index Session::size() const { return fit::size_of(points()); }
Vector<double, 3> Session::point(Index i) const { return fit::point_of(points(), i); }

const std::vector<std::array<Index, 3>>& Session::triangles() const {
  static const Triangles none;
  return now_.triangles ? *now_.triangles : none;
}

std::string Session::name_of(Index i) const {
  return now_.boxes ? place_name(dim(), i, has_frustum(*now_.boxes)) : point_name(i);
}

/// The snapshot with other boxes.
tl::expected<Session::Snapshot, InputError> Session::placed(Snapshot snapshot, BoxPair pair) {
  auto set = places(pair);
  if (!set) return tl::unexpected(std::move(set.error()));
  snapshot.points = *std::move(set);
  snapshot.boxes = std::move(pair);
  return snapshot;
}

tl::expected<void, InputError> Session::move_in(Snapshot& snapshot, Index i, const Vector<double, 3>& to) const {
  if (!snapshot.boxes) return move_point(snapshot.points, i, to);
  auto next = moved(*snapshot.boxes, i, to).and_then([&](BoxPair pair) { return placed(snapshot, std::move(pair)); });
  if (!next) return tl::unexpected(std::move(next.error()));
  snapshot = *std::move(next);
  return {};
}

tl::expected<void, InputError> Session::set_boxes(const BoxPair& pair) {
  if (!now_.boxes || pair.dim != dim()) return tl::unexpected(InputError{.what = "there are no such boxes"});
  for (const auto& box : pair.boxes)
    if (!(box.half_extents.minCoeff() >= 0)) return tl::unexpected(InputError{.what = "a half extent is below 0"});
  auto next = placed(now_, pair);
  if (!next) return tl::unexpected(std::move(next.error()));
  next->edited = true;
  return become(*std::move(next));
}

tl::expected<void, InputError> Session::move(Index i, const Vector<double, 3>& to) {
  if (i < 0 || i >= size()) return no_point(i);
  if (drag_) {
    if (auto moved = move_in(now_, i, to); !moved) return moved;
    drag_moved_ = true;
  } else {
    Snapshot next = now_;
    if (auto moved = move_in(next, i, to); !moved) return moved;
    remember();
    now_ = std::move(next);
  }
  now_.edited = true;
  points_changed();
  return {};
}

tl::expected<void, InputError> Session::add(const Vector<double, 3>& at) {
  if (now_.boxes) return fixed_boxes();
  const fit::Algorithm& main = *slots_[0].algorithm;
  if (size() >= main.max_points)
    return tl::unexpected(
        InputError{.what = std::string(main.title) + " takes at most " + std::to_string(main.max_points) + " points"});
  std::vector<Vector<double, 3>> all = all_points(points());
  all.push_back(at);
  auto set = to_set(all, dim());
  if (!set) return tl::unexpected(std::move(set.error()));
  return become({*std::move(set), nullptr, seed(), now_.source, now_.generated, true});
}

tl::expected<void, InputError> Session::remove(Index i) {
  if (now_.boxes) return fixed_boxes();
  if (i < 0 || i >= size()) return no_point(i);
  if (size() == 1) return tl::unexpected(InputError{.what = "the last point cannot be deleted"});
  std::vector<Vector<double, 3>> all = all_points(points());
  all.erase(all.begin() + i);
  auto set = to_set(all, dim());
  if (!set) return tl::unexpected(std::move(set.error()));
  return become({*std::move(set), nullptr, seed(), now_.source, now_.generated, true});
}

/// Expects a kind that exists, and a count and dimension in range.
Session::Snapshot Session::generated(std::string_view kind, int count, int dim, std::uint64_t seed, bool edited) const {
  const auto points = generate(kind, count, dim, seed);
  return {*to_set(*points, dim), nullptr, seed, std::string(kind), count, edited};
}

/// How the lesson's points are scattered: by its own generator, or as many of another kind as it has points.
Session::Recipe Session::recipe() const {
  const Points& own = lesson_.points;
  if (!own.generate.empty()) return {own.generate, own.count, own.dim};
  const std::string_view kind = lesson_.generators.empty() ? "gaussian" : std::string_view(lesson_.generators.front());
  return {kind, std::min(fit::size_of(own_.points), Index{kMostGenerated}), fit::dim_of(own_.points)};
}

void Session::scatter(std::uint64_t seed) {
  if (now_.boxes) {
    if (seed == lesson_.seed) return reset();
    auto next = placed(own_, scattered(*own_.boxes, seed));
    if (!next) return;
    next->seed = seed;
    static_cast<void>(become(*std::move(next)));
    return;
  }
  const Recipe own = recipe();
  const Recipe now{now_.source, now_.generated, dim()};
  if (now_.generated > 0 && now != own) static_cast<void>(become(generated(now.kind, now.count, now.dim, seed, true)));
  else if (seed == lesson_.seed) reset();
  else static_cast<void>(become(generated(own.kind, own.count, own.dim, seed, false)));
}

tl::expected<void, InputError> Session::set_generator(std::string_view kind, int count, int dim, std::uint64_t seed) {
  if (now_.boxes) return fixed_boxes();
  const auto kinds = generator_kinds();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    return tl::unexpected(InputError{.what = "there is no generator " + std::string(kind)});
  if (count < 1 || count > kMostGenerated)
    return tl::unexpected(InputError{.what = "a set has 1 to " + std::to_string(kMostGenerated) + " points"});
  if (dim != 2 && dim != 3) return tl::unexpected(InputError{.what = "the dimension is 2 or 3"});
  // At the lesson's seed an address means the lesson's own points, which a list of them would not be.
  const bool own = Recipe{kind, count, dim} == recipe() && (seed != lesson_.seed || !lesson_.points.generate.empty());
  return become(generated(kind, count, dim, seed, !own));
}

void Session::reset() { static_cast<void>(become(own_)); }

tl::expected<void, InputError> Session::load(const io::PointFile& file, std::string_view name) {
  if (now_.boxes) return fixed_boxes();
  auto set = io::to_point_set(file, name, 0, false);
  if (!set) return tl::unexpected(std::move(set.error()));
  const bool own = name == lesson_.points.mesh;
  return become(
      {*std::move(set), std::make_shared<const Triangles>(file.triangles), seed(), std::string(name), 0, !own});
}

void Session::start_task() {
  if (!lesson_.task) return;
  found_.clear();
  if (lesson_.measures) {
    const std::string_view kind =
        lesson_.generators.empty() ? "gaussian" : std::string_view(lesson_.generators.front());
    static_cast<void>(become(generated(kind, lesson_.task->points, dim(), lesson_.seed, true)));
  } else {
    static_cast<void>(
        become(now_.boxes ? own_ : Snapshot{start_of_task(lesson_, own_.points), nullptr, own_.seed, "task", 0, true}));
  }
  static_cast<void>(choose(0, lesson_.task->algorithm));
  // Who builds an example looks at results, and was asked nothing yet. Bodies are placed where they begin.
  step_ = lesson_.scene ? 0 : steps();
  previewing_ = !lesson_.scene;
  ++revision_;
}

/// One entry of undo. Where no algorithm takes so many points, nothing changes.
tl::expected<void, InputError> Session::become(Snapshot next) {
  if (auto made = make_room_for(fit::size_of(next.points)); !made) return made;
  end_drag();
  remember();
  now_ = std::move(next);
  points_changed();
  return {};
}

void Session::remember() {
  if (past_.size() == kMostUndo) past_.erase(past_.begin());
  past_.push_back(now_);
  future_.clear();
}

void Session::begin_drag() {
  end_drag();
  drag_ = now_;
}

void Session::end_drag() {
  if (drag_ && drag_moved_) {
    std::swap(now_, *drag_);
    remember();
    std::swap(now_, *drag_);
    ++revision_;
  }
  drag_.reset();
  drag_moved_ = false;
}

void Session::restore(std::vector<Snapshot>& from, std::vector<Snapshot>& to) {
  if (from.empty()) return;
  // Each was accepted once, when the lesson's algorithms could take it.
  static_cast<void>(make_room_for(fit::size_of(from.back().points)));
  to.push_back(std::move(now_));
  now_ = std::move(from.back());
  from.pop_back();
  points_changed();
}

void Session::undo() {
  end_drag();
  restore(past_, future_);
}

void Session::redo() {
  end_drag();
  restore(future_, past_);
}

}  // namespace snug::lesson
