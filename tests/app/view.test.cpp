// What a lesson's [view] changes on the stage: the camera, the close-up, names, outlines.
#include <algorithm>
#include <cmath>

#include "app/look.hpp"
#include "bench.hpp"
#include "course_lessons.hpp"
#include "viewed_lessons.hpp"

namespace snug::app {
namespace {

using test::boxes_apart;
using test::flat_kdop;
using test::space_kdop;

const Layout kPhone{.stage = {0, 0, 390, 390}, .timeline = {0, 390, 390, 160}, .inspector = {}, .fingers = true};

double distance(const Handle& a, const Handle& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool says(Bench& bench, const std::string& words) {
  const auto all = bench.words();
  return std::find(all.begin(), all.end(), words) != all.end();
}

bool holds(const Rect& rect, float x, float y) {
  return x >= rect.x && y >= rect.y && x <= rect.x + rect.width && y <= rect.y + rect.height;
}

int handles_under(const Bench& bench, const Rect& panel) {
  int count = 0;
  for (const Handle& handle : bench.app.handles()) count += holds(panel, handle.x, handle.y) ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("the camera zooms and looks where the file says, and comes back there") {
  Bench plain(flat_kdop());
  const double usual = distance(plain.handle("P0"), plain.handle("P1"));
  Bench bench(flat_kdop("zoom = 2\nlook_at = \"P6\""));
  const Handle middle = bench.handle("P6");
  CHECK(distance(bench.handle("P0"), bench.handle("P1")) == doctest::Approx(2 * usual).epsilon(0.01));
  CHECK(middle.x == doctest::Approx(400).epsilon(0.01));
  bench.drag(300, 60, -90, 40);  // on the ground: it pans
  CHECK(std::abs(bench.handle("P6").x - middle.x) > 50);
  REQUIRE(bench.app.command("reset_view"));
  bench.frames(2);
  CHECK(bench.handle("P6").x == doctest::Approx(middle.x));
  CHECK(bench.handle("P6").y == doctest::Approx(middle.y));
  bench.session().jump(4);  // nor does a step take it away
  bench.frames(3);
  CHECK(bench.handle("P6").x == doctest::Approx(middle.x));
}

TEST_CASE("in space it turns to the angles of the file, and back to them") {
  // From straight above, what is far along z is below on the screen; from the front it is not.
  const auto y_of = [](Bench& bench, const char* id) { return bench.handle(id).y; };
  const std::string tables =
      "[points]\ndim = 3\nlist = [[0, 0, -1], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 0.2, 0], [0, -0.2, 0]]";
  const std::string keys = "volume = \"kdop\"\nalgorithms = [\"k6\"]";
  Bench above(test::viewed(keys, tables, "camera = [0, 80]"));
  Bench front(test::viewed(keys, tables, "camera = [0, 0]"));
  CHECK(y_of(above, "P1") > y_of(above, "P0") + 80);
  CHECK(std::abs(y_of(front, "P1") - y_of(front, "P0")) < 8);
  Bench side(test::viewed(keys, tables, "camera = [90, 0]"));
  const Handle before = side.handle("P0");
  CHECK(std::abs(side.handle("P0").x - side.handle("P1").x) > 100);
  REQUIRE(side.app.command("orbit_left"));
  side.frames(2);
  CHECK(std::abs(side.handle("P0").x - before.x) > 1);
  REQUIRE(side.app.command("reset_view"));
  side.frames(2);
  CHECK(side.handle("P0").x == doctest::Approx(before.x));
}

TEST_CASE("a gap of 0.003 is seen in the close-up, which says how many times larger it is") {
  for (const int dim : {2, 3})
    for (const bool phone : {false, true}) {
      CAPTURE(dim);
      CAPTURE(phone);
      const lesson::Lesson lesson = boxes_apart("0.997", "inset = { at = \"gap\" }", dim);
      Bench bench = phone ? Bench(lesson, kPhone) : Bench(lesson);
      const auto close_up = bench.app.close_up();
      REQUIRE(close_up);
      CHECK(close_up->at[0] == doctest::Approx(0.0015));
      CHECK(close_up->size == doctest::Approx(0.009));
      CHECK(close_up->times > 40);
      CHECK(handles_under(bench, close_up->panel) == 0);
      CHECK_FALSE(holds(close_up->panel, close_up->x, close_up->y));
      const auto words = bench.words();
      CHECK(std::any_of(words.begin(), words.end(), [&](const std::string& one) {
        return phone ? one.starts_with("×") : one.ends_with(" times larger");
      }));
      CHECK(says(bench, phone ? "0.002" : "0.001") != says(bench, phone ? "0.001" : "0.002"));
    }
  CHECK_FALSE(Bench(boxes_apart("0.5", "inset = { at = \"gap\" }")).app.close_up());  // seen as it is
  CHECK_FALSE(Bench(boxes_apart("0.997")).app.close_up());
}

TEST_CASE("on a phone the knobs of two volumes stand on the stage, though the difference takes its left half") {
  const Bench bench(
      test::viewed("volume = \"volume_pair\"\nalgorithms = [\"gjk\"]",
                   "[volumes]\ndim = 2\na = { capsule = { a = [-1.9, -0.7], b = [-0.7, 0.9], radius = 0.4 } }\n"
                   "b = { lozenge = { origin = [0.55, -0.95], edges = [[1.5, 0.4], [-0.24, 0.9]], radius = 0.3 } }"),
      kPhone);
  REQUIRE(bench.app.handles().size() == 11);
  for (const Handle& handle : bench.app.handles())
    CHECK_MESSAGE((handle.x > 10 && handle.x < kPhone.stage.width - 10), handle.id, " at ", handle.x);
}

TEST_CASE("a close-up says billions, whose zeros would be wider than it") {
  Bench bench(course_lesson("cases/shared-coordinate", false));
  bench.session().jump(bench.session().player().steps());
  bench.frames(2);
  const auto words = bench.words();
  CHECK(std::any_of(words.begin(), words.end(),
                    [](const std::string& one) { return one.ends_with(" billion times larger"); }));
}

TEST_CASE("the close-up of a point left outside covers no point, though all around the circle are marked") {
  const Layout page{.stage = {0, 0, 628, 565}, .timeline = {0, 565, 628, 160}};
  for (const Layout& layout : {page, kPhone}) {
    CAPTURE(layout.stage.width);
    Bench bench(course_lesson("cases/cocircular", false), layout);
    bench.session().jump(bench.session().player().steps());
    bench.frames(2);
    std::optional<Rect> panel;
    for (const DrawnWords& one : bench.drawn_words()) {
      if (one.words.starts_with("×") || one.words.ends_with(" times larger"))
        panel = Rect{one.low.x - 8, one.low.y, 0, 0};
      if (panel && panel->width == 0 && (one.words == "ulps" || one.words.starts_with("1 ulp = ")))
        panel->width = one.high.x + 6 - panel->x, panel->height = one.high.y - panel->y;
    }
    REQUIRE(panel);
    CHECK(panel->width > 100);
    CHECK(handles_under(bench, *panel) == 0);
  }
}

TEST_CASE("boxes that touch, and such as overlap a little, have a close-up of where") {
  Bench touching(boxes_apart("1", "inset = { at = \"gap\" }"));
  REQUIRE(touching.app.close_up());
  CHECK(std::abs(touching.app.close_up()->at[0]) < 1e-9);
  Bench overlapping(boxes_apart("1.002", "inset = { at = \"gap\" }"));
  REQUIRE(overlapping.app.close_up());
  CHECK(overlapping.app.close_up()->at[0] == doctest::Approx(-0.001));
}

TEST_CASE("a close-up follows what is dragged, and covers no handle") {
  Bench bench(flat_kdop("inset = { at = \"P4\", size = 0.4 }"));
  const auto before = bench.app.close_up();
  REQUIRE(before);
  CHECK(before->size == doctest::Approx(0.4));
  const Handle handle = bench.handle("P4");
  bench.press(handle.x, handle.y);
  for (const auto& [dx, dy] : {std::pair{-300.0f, -60.0f}, {-200, 120}, {250, 130}, {250, -60}, {0, 40}}) {
    bench.move(handle.x + dx, handle.y + dy);
    const auto now = bench.app.close_up();
    REQUIRE(now);
    CHECK(handles_under(bench, now->panel) == 0);
    CHECK(now->at == bench.session().stage().subject().at(4));
    CHECK(now->times == doctest::Approx(before->times));
  }
  bench.release();
}

TEST_CASE("a close-up fills circles and spheres, and shades a mesh, as the stage does") {
  // How many vertices of a colour, transparency aside, ImGui fills within the panel.
  const auto filled = [](const Bench& bench, auto is_color) {
    const auto close_up = bench.app.close_up();
    REQUIRE(close_up);
    int count = 0;
    for (const ImDrawList* list : ImGui::GetDrawData()->CmdLists)
      for (const ImDrawCmd& command : list->CmdBuffer)
        if (command.ClipRect.x == close_up->panel.x + 1)
          for (unsigned i = 0; i < command.ElemCount; ++i)
            count +=
                is_color(list->VtxBuffer[static_cast<int>(command.VtxOffset +
                                                          list->IdxBuffer[static_cast<int>(command.IdxOffset + i)])]
                             .col)
                    ? 1
                    : 0;
    return count;
  };
  const auto is_fill = [](Color color) { return color == with_alpha(kLight.current, kLight.fill); };
  for (const int dim : {2, 3}) {
    CAPTURE(dim);
    const std::string third = dim == 3 ? ", 0.3]" : "]";
    const std::string points = "[points]\ndim = " + std::to_string(dim) + "\nlist = [[-1, 0" + third + ", [1, 0" +
                               third + ", [0, 1" + third + ", [0, -0.9" + third + "]";
    const auto close = [&](const char* size) {
      return test::viewed("algorithms = [\"welzl\"]\nstart = \"end\"", points,
                          "inset = { at = \"P1\", size = " + std::string(size) + " }");
    };
    for (const char* size : {"0.4", "0.004", "0.0001"}) CHECK(filled(Bench(close(size)), is_fill) > 0);
  }
  const io::PointFile tent{
      3, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  const Bench mesh(test::viewed("algorithms = [\"ritter\"]", "[points]\ndim = 3\nmesh = \"bunny\"",
                                "inset = { at = \"P1\", size = 0.5 }"),
                   {.stage = {0, 0, 800, 440}, .timeline = {0, 440, 800, 160}}, tent);
  CHECK(filled(mesh, [](Color color) {
          return color != kLight.surface && color >> 24 == 0xff && (color & 0xff) > 0x60 &&
                 std::abs(static_cast<int>(color & 0xff) * static_cast<int>(kLight.surface >> 8 & 0xff) -
                          static_cast<int>(color >> 8 & 0xff) * static_cast<int>(kLight.surface & 0xff)) < 600;
        }) >= 3);
}

TEST_CASE("names that the file gives stand on the stage, or none that the step does not need") {
  Bench named(flat_kdop("names = [\"North\", \"South\"]"));
  CHECK(says(named, "North"));
  CHECK(says(named, "P2"));
  CHECK_FALSE(says(named, "P0"));
  Bench silent(flat_kdop("names = \"none\""));
  CHECK_FALSE(says(silent, "P2"));
  silent.session().jump(1);
  silent.frames(2);
  CHECK(says(silent, "P0 least"));
  CHECK_FALSE(says(silent, "P2"));
}

TEST_CASE("labels have the file's decimals") {
  Bench bench(flat_kdop("decimals = 1"));
  bench.session().jump(bench.session().player().steps());
  bench.frames(2);
  CHECK(says(bench, "area 7.8"));
  Bench usual(flat_kdop());
  usual.session().jump(usual.session().player().steps());
  usual.frames(2);
  CHECK(says(usual, "area 7.770"));
}

TEST_CASE("the slab that is found is drawn with its direction, and its two points are named") {
  Bench flat(flat_kdop());
  flat.session().jump(3);
  flat.frames(2);
  CHECK(says(flat, "slab 3: x+y"));
  CHECK(says(flat, "P5 least"));
  CHECK(says(flat, "P6 greatest"));
  flat.session().jump(flat.session().player().steps());
  flat.frames(2);
  CHECK_FALSE(says(flat, "slab 3: x+y"));
  Bench space(space_kdop());
  space.session().jump(5);
  space.frames(2);
  CHECK(says(space, "slab 5: x+y−z"));
}

TEST_CASE("a slab of a 26-DOP and its name keep clear of the sentence that a page has over the foot of a wide stage") {
  const Layout wide{.stage = {0, 0, 628, 564}, .timeline = {0, 564, 628, 160}};
  Bench bench(course_lesson("kdop-space", false), wide);
  REQUIRE(bench.session().player().choose(0, "k26"));
  for (const int step : {7, 9, 11}) {
    bench.session().jump(step);
    bench.frames(2);
    bool named = false;
    for (const DrawnWords& one : bench.drawn_words())
      if (one.low.y < wide.stage.height && one.high.x > 24 && one.low.x < wide.stage.width - 24) {
        CHECK_MESSAGE(one.high.y <= wide.stage.height - 12 - 40, one.words, " at step ", step);
        named = named || one.words.starts_with("slab " + std::to_string(step) + ":");
      }
    CHECK_MESSAGE(named, "at step ", step);
  }
}

TEST_CASE("nothing is called smallest that is compared with nothing") {
  Bench bench(flat_kdop());
  CHECK_FALSE(says(bench, "Smallest"));
  bench.session().jump(bench.session().player().steps());
  bench.frames(2);
  for (const std::string& words : bench.words()) CHECK(words.find("the ") != 0);
  Bench hull(
      test::viewed("algorithms = [\"kdop/k8\", \"obb/exact\"]\nreference = \"hull/quickhull\"", test::kEightPoints));
  CHECK(says(hull, "Hull"));
  Bench box(test::viewed("volume = \"obb\"\nalgorithms = [\"pca\", \"exact\"]", test::kEightPoints));
  CHECK(says(box, "Smallest"));
  REQUIRE(box.session().player().choose(0, "exact"));
  box.session().jump(box.session().player().steps());
  box.frames(2);
  CHECK(says(box, "the smallest box"));
  Bench titled(test::viewed("volume = \"obb\"\nalgorithms = [\"aabb\"]\nreference = \"obb/pca\"",
                            "[points]\nlist = [[-2, -1], [2, -1], [2, 1], [-2, 1]]"));
  titled.session().jump(titled.session().player().steps());
  titled.frames(2);
  CHECK(says(titled, "PCA of the points"));  // a title takes no article
  CHECK_FALSE(says(titled, "the PCA of the points"));
}

TEST_CASE("labels keep clear of a page's sentence on a wide stage") {
  Bench bench(course_lesson("cases/wide-box", false), {.stage = {0, 0, 628, 616}, .timeline = {0, 616, 628, 136}});
  bench.session().jump(bench.session().player().steps());
  bench.frames(2);
  const std::vector<DrawnWords> drawn = bench.drawn_words();
  const auto verdict =
      std::find_if(drawn.begin(), drawn.end(), [](const DrawnWords& one) { return one.words == "Box: outside"; });
  REQUIRE(verdict != drawn.end());
  CHECK(verdict->high.y <= 616 - 72);  // where two lines of the sentence begin
}

TEST_CASE("the lines of the window's sentence are about equally long") {
  Bench bench(course_lesson("cases/unit-of-length", false));
  bench.app.settings().prose_in_canvas = true;
  bench.session().jump(bench.session().player().steps());
  bench.frames(2);
  const std::vector<DrawnWords> drawn = bench.drawn_words();
  const auto width_of = [&](auto is_line) {
    const auto line =
        std::find_if(drawn.begin(), drawn.end(), [&](const DrawnWords& one) { return is_line(one.words); });
    REQUIRE(line != drawn.end());
    return line->high.x - line->low.x;
  };
  const float first = width_of([](const std::string& line) { return line.starts_with("This test says"); });
  const float last = width_of([](const std::string& line) { return line.ends_with("the boxes are apart."); });
  CHECK(last > 0.7f * first);
}

}  // namespace snug::app
