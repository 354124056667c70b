// How volumes are stored: each representation is the volume, has its bytes, and follows the hand.
#include "lesson/stored.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "check/check_lesson.hpp"
#include "geometry/random.hpp"
#include "geometry/turn.hpp"
#include "geometry/volume_bytes.hpp"
#include "lesson/session.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

using V = Vector<double, 3>;
constexpr double kClose = 1e-12;

/// The numbers of a form, one after the other.
std::vector<double> numbers_of(const StoredForm& form) {
  std::vector<double> all;
  for (const StoredMember& member : form.members) all.insert(all.end(), member.numbers.begin(), member.numbers.end());
  return all;
}

V at(const std::vector<double>& numbers, std::size_t i) { return {numbers[i], numbers[i + 1], numbers[i + 2]}; }

Obb<double, 3> any_box(Random& random) {
  const auto any = [&] { return V(random.between(-2, 2), random.between(-2, 2), random.between(-2, 2)); };
  return {any(), turn(any(), random.between(-3, 3)), any().cwiseAbs() + V::Constant(0.1)};
}

void check_same(const Obb<double, 3>& made, const Obb<double, 3>& due) {
  CHECK((made.center - due.center).norm() < kClose);
  CHECK((made.axes - due.axes).norm() < kClose);
  CHECK((made.half_extents - due.half_extents).norm() < kClose);
}

/// The box between the planes or slabs n . p = low and n . p = high of three perpendicular directions.
Obb<double, 3> between(const std::array<V, 3>& normals, const V& low, const V& high) {
  Obb<double, 3> box;
  for (int i = 0; i < 3; ++i) {
    box.axes.col(i) = normals[i];
    box.half_extents[i] = (high[i] - low[i]) / 2;
    box.center += (low[i] + high[i]) / 2 * normals[i];
  }
  return box;
}

Obb<double, 3> from_vertices(const std::vector<double>& numbers) {
  Obb<double, 3> box;
  const V first = at(numbers, 0);
  for (int i = 0; i < 3; ++i) {
    const V edge = at(numbers, 3 * (std::size_t{1} << i)) - first;
    box.half_extents[i] = edge.norm() / 2, box.axes.col(i) = edge.normalized();
  }
  box.center = (first + at(numbers, 21)) / 2;
  return box;
}

Session stored_session(const std::string& stored) {
  auto lesson = check::checked_lesson(
      "version = 2\ntitle = \"Two\"\nsummary = \"Two.\"\nminutes = 1\nvolume = \"volume_pair\"\n"
      "algorithms = [\"min_max\"]\n[volumes]\n" +
          stored +
          "a = { aabb = { min = [-1, -2], max = [3, 4] } }\nb = { aabb = { min = [5, 5], max = [6, 7] } }\n"
          "[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n",
      "two.toml");
  REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
  auto session = Session::open(*std::move(lesson));
  REQUIRE(session.has_value());
  return *std::move(session);
}

}  // namespace

TEST_CASE("an oriented box can be made again of each of its four representations") {
  Random random(11);
  for (int round = 0; round < 50; ++round) {
    const Obb<double, 3> box = any_box(random);
    const auto forms = stored_forms(box, 3);
    REQUIRE(forms.size() == 4);
    const auto vertices = numbers_of(forms[0]), planes = numbers_of(forms[1]), slabs = numbers_of(forms[2]),
               own = numbers_of(forms[3]);
    check_same(from_vertices(vertices), box);
    const auto plane = [&](std::size_t i) { return at(planes, 8 * i); };
    check_same(between({plane(0), plane(1), plane(2)}, V(planes[7], planes[15], planes[23]),
                       -V(planes[3], planes[11], planes[19])),
               box);
    const auto slab = [&](std::size_t i) { return at(slabs, 5 * i); };
    check_same(between({slab(0), slab(1), slab(2)}, V(slabs[3], slabs[8], slabs[13]), V(slabs[4], slabs[9], slabs[14])),
               box);
    Obb<double, 3> again{at(own, 0), {}, at(own, 12)};
    for (int i = 0; i < 3; ++i) again.axes.col(i) = at(own, 3 + 3 * static_cast<std::size_t>(i));
    check_same(again, box);
  }
}

TEST_CASE(
    "an axis-aligned box can be made again of each of its three representations, to the last bit where none is lost") {
  const auto forms = stored_forms(Aabb<double, 3>{{-1.5, 0.25, 2}, {0.5, 1, 8}}, 3);
  REQUIRE(forms.size() == 3);
  const auto min_max = numbers_of(forms[0]), widths = numbers_of(forms[1]), centered = numbers_of(forms[2]);
  CHECK(V(at(widths, 0) + at(widths, 3)) == at(min_max, 3));
  CHECK(at(widths, 0) == at(min_max, 0));
  CHECK(V(at(centered, 0) - at(centered, 3)) == at(min_max, 0));
  CHECK(V(at(centered, 0) + at(centered, 3)) == at(min_max, 3));
}

TEST_CASE("each representation has the bytes of its struct") {
  Random random(2);
  const auto forms = stored_forms(any_box(random), 3);
  CHECK(forms[0].numbers() * sizeof(float) == bytes_of(ObbVertices<float, 3>{}));
  CHECK(forms[1].numbers() * sizeof(float) == bytes_of(ObbPlanes<float, 3>{}));
  CHECK(forms[2].numbers() * sizeof(float) == bytes_of(ObbSlabs<float, 3>{}));
  CHECK(forms[3].numbers() * sizeof(float) == bytes_of(Obb<float, 3>{}));
  CHECK(forms[0].bytes() == "96 bytes in float, 192 in double");
  for (const int dim : {2, 3})
    for (const std::string_view kind : kVolumeNames) {
      CAPTURE(kind);
      const fit::Volume3 volume = volume_of_kind(kind);
      for (const StoredForm& form : stored_forms(volume, dim)) {
        CHECK(form.numbers() > 0);
        CHECK(form.operations.size() == 4);
      }
      CHECK(stored_forms(volume, dim).empty() == (kind == "hull"));
    }
  const auto sphere = stored_forms(Sphere<double, 3>{{1, 2, 3}, 4}, 3);
  CHECK(sphere.front().numbers() == 4);
}

TEST_CASE("the least of each operation is ticked, where another takes more") {
  const auto least = [](const std::vector<StoredForm>& forms, std::size_t operation) {
    std::string names;
    for (const StoredForm& form : forms)
      if (form.operations[operation].least) names += form.name + "; ";
    return names;
  };
  const auto upright = stored_forms(Aabb<double, 3>{{0, 0, 0}, {1, 2, 3}}, 3);
  CHECK(least(upright, 0) == "min-max; ");
  CHECK(least(upright, 1) == "min-widths; centre-radius; ");
  CHECK(least(upright, 2).empty());
  CHECK(least(upright, 3) == "centre-radius; ");
  const auto turned = stored_forms(Obb<double, 3>{{0, 0, 0}, Matrix<double, 3>::Identity(), {1, 2, 3}}, 3);
  CHECK(least(turned, 0) == "centre, axes, half extents; ");
  CHECK(least(turned, 1) == "centre, axes, half extents; ");
  CHECK(least(turned, 3) == "centre, axes, half extents; ");
  CHECK(least(stored_forms(Sphere<double, 3>{{0, 0, 0}, 1}, 3), 1).empty());
}

TEST_CASE("what a member is on the stage lies on its volume") {
  Random random(7);
  const Obb<double, 3> box = any_box(random);
  for (const StoredForm& form : stored_forms(box, 3))
    for (const StoredMember& member : form.members) {
      CAPTURE(member.declared);
      CHECK_FALSE(member.lines.empty());
      if (member.declared.starts_with("Vector")) continue;  // a unit axis may reach out of a small box
      for (const auto& line : member.lines)
        for (const Point3& p : line) {
          const V local = box.axes.transpose() * (p - box.center);
          CHECK((local.cwiseAbs() - box.half_extents).maxCoeff() < kClose);
        }
    }
  Kdop<double, 3> kdop{.k = 14};
  for (std::size_t i = 0; i < 7; ++i) kdop.min[i] = i < 3 ? -1 : -1.75, kdop.max[i] = i < 3 ? 1 : 1.5;
  const auto bounds = stored_forms(kdop, 3).front();
  CHECK(bounds.members.size() == 14);
  for (const StoredMember& member : bounds.members) CHECK(member.lines.front().size() > 3);  // a face
}

TEST_CASE("a lesson shows how a volume is stored if it asks for that, and the numbers follow the hand") {
  CHECK(stored_of(stored_session("")).empty());
  CHECK(stored_of(stored_session("stored = [\"a\", \"b\"]\n")).size() == 2);
  Session session = stored_session("stored = [\"a\"]\n");
  const auto before = stored_of(session);
  REQUIRE(before.size() == 1);
  CHECK(before[0].title == "A: AABB");
  std::set<std::string> marks;
  for (const StoredForm& form : before[0].forms)
    for (const StoredMember& member : form.members) {
      CHECK(marks.insert(member.mark).second);
      CHECK(stored_lines(session, member.mark) == member.lines);
    }
  CHECK(stored_lines(session, "A").empty());
  CHECK(stored_lines(session, "stored:A/9/9").empty());
  CHECK(before[0].forms[0].members[1].text == "3.000, 4.000");
  REQUIRE(session.stage().move(0, session.stage().subject().at(0) + Point3(0.5, 0, 0)));
  const auto after = stored_of(session);
  CHECK(after[0].forms[0].members[1].text == "3.500, 4.000");
  CHECK(after[0].forms[1].members[1].text == before[0].forms[1].members[1].text);  // a width
  CHECK_FALSE(after[0].forms[2].members[0].text == before[0].forms[2].members[0].text);
}

TEST_CASE("a lesson that stores no volume of its own says so") {
  const auto lesson = check::checked_lesson(
      "version = 2\ntitle = \"Two\"\nsummary = \"Two.\"\nminutes = 1\nvolume = \"volume_pair\"\n"
      "algorithms = [\"min_max\"]\n[volumes]\nstored = [\"c\"]\n"
      "a = { aabb = { min = [-1, -2], max = [3, 4] } }\nb = { aabb = { min = [5, 5], max = [6, 7] } }\n"
      "[[section]]\ntitle = \"One\"\ntext = \"A text.\"\n",
      "two.toml");
  REQUIRE_FALSE(lesson.has_value());
  CHECK(lesson.error().message().find("is none of a or b: c") != std::string::npos);
}
