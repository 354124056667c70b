// Two boxes seen from A's frame: the picture moves, and nothing else.
#include "../every_step.hpp"
#include "app/subjects/pair/seen_from.hpp"
#include "app/subjects/pair/view.hpp"

namespace snug::app {
namespace {

const lesson::BoxPair& boxes_on(const lesson::Session& session) { return lesson::boxes_of(session.stage().subject()); }

/// What the view shows of a box's handles: where they are.
std::vector<Point3> places_of(const SubjectView& view, const lesson::Session& session, int box) {
  std::vector<Point3> places;
  for (Index i = 0; i < session.stage().subject().size(); ++i)
    if (lesson::place_of(session.stage().subject().dim(), i).box == box) places.push_back(view.place_of(session, i));
  return places;
}

}  // namespace

TEST_CASE("in A's frame A is axis-aligned around the origin, and the run is the same") {
  for (const char* const id : {"obb-sat", "obb-axes"}) {
    lesson::Session session = lesson_session(id, false);
    session.stage().scatter(3);
    const std::uint64_t trace = session.player().trace_hash();
    const std::string caption = session.telling().caption();
    const auto view = pair_view();
    view->refresh(session, false);
    LocalFrame* const frame = view->local_frame(session);
    REQUIRE(frame != nullptr);
    frame->show(true);
    view->refresh(session, false);
    REQUIRE(frame->is_shown());
    const Obb<double, 3>& a = boxes_on(session).boxes[0];
    for (int bits = 0; bits < 1 << session.stage().subject().dim(); ++bits) {
      const Point3 shown = frame->place_shown(session, lesson::corner_of(a, bits));
      for (int axis = 0; axis < session.stage().subject().dim(); ++axis)
        CHECK(shown[axis] == doctest::Approx((bits >> axis & 1) != 0 ? a.half_extents[axis] : -a.half_extents[axis]));
    }
    CHECK(session.player().trace_hash() == trace);
    CHECK(session.telling().caption() == caption);
    frame->show(false);
    for (Index i = 0; i < session.stage().subject().size(); ++i)
      CHECK(view->place_of(session, i) == session.stage().subject().at(i));
  }
}

TEST_CASE("what is dragged in A's frame lands where the hand is") {
  lesson::Session session = lesson_session("obb-axes", false);
  session.stage().scatter(5);
  const auto view = pair_view();
  LocalFrame* const frame = view->local_frame(session);
  REQUIRE(frame != nullptr);
  frame->show(true);
  view->refresh(session, false);
  const std::vector<Point3> of_a = places_of(*view, session, 0);
  Index center = kNoIndex;
  for (Index i = 0; i < session.stage().subject().size(); ++i) {
    const lesson::BoxHandle place = lesson::place_of(session.stage().subject().dim(), i);
    CHECK(view->shows(session, i) == (place.box == 1));  // A stands still
    if (place.box == 1 && place.kind == lesson::BoxHandle::Kind::kCenter) center = i;
  }
  REQUIRE(center != kNoIndex);
  const Point3 hand = view->place_of(session, center) + Point3(0.3, -0.2, 0.1);
  CHECK((frame->place_shown(session, frame->place_meant(session, hand)) - hand).norm() < 1e-12);
  REQUIRE(session.stage().move(center, frame->place_meant(session, hand)).has_value());
  view->refresh(session, false);
  CHECK((view->place_of(session, center) - hand).norm() < 1e-12);
  const std::vector<Point3> now = places_of(*view, session, 0);
  for (std::size_t i = 0; i < now.size(); ++i) CHECK(now[i] == of_a[i]);
}

TEST_CASE("seen from A's frame, B's axes are the entries of R") {
  const lesson::Session session = lesson_session("obb-axes", false);
  const lesson::BoxPair& pair = boxes_on(session);
  const SeenFrom frame{pair.boxes[0].axes, pair.boxes[0].center};
  const lesson::BoxPair seen = frame.boxes(pair);
  CHECK((seen.boxes[0].axes - Matrix<double, 3>::Identity()).norm() < 1e-12);
  CHECK(seen.boxes[0].center.norm() < 1e-12);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      CHECK(seen.boxes[1].axes(i, j) == doctest::Approx(pair.boxes[0].axes.col(i).dot(pair.boxes[1].axes.col(j))));
}

}  // namespace snug::app
