// Where somebody stands: as an address, and how a session is led there and back.
#include "lesson/place.hpp"

#include "core/lesson/small_lesson.hpp"
#include "lesson/demo.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_change.hpp"

using namespace snug;
using namespace snug::lesson;
using snug::test::open_small;

namespace {

const MeshOf kNoMesh = [](const std::string& name) -> tl::expected<io::PointFile, InputError> {
  return tl::unexpected(InputError{.what = "no mesh " + name});
};

/// Whether a session that the place's own address leads to stands where this one does, and one that a demo's file leads
/// to as well.
void check_leads_back(const Session& stands) {
  const auto place = place_now(stands, kNoMesh);
  REQUIRE(place);
  const PlaceRead by_address = read_place(address_of(*place));
  CHECK(by_address.problems.empty());
  const DemoDraft draft =
      read_demo("version = 1\ntitle = \"T\"\nlecture = \"L\"\n" + state_text(*place, "A title", 0x12), "d.toml");
  REQUIRE(draft.mistakes.empty());
  const Place& by_file = draft.demo.states.front();
  for (const Place& led_by : {by_address.place, by_file}) {
    CHECK(led_by == *place);
    Session led = open_small();
    REQUIRE(go_to(led_by, led, kNoMesh));
    CHECK(led.player().trace_hash() == stands.player().trace_hash());
    CHECK(led.player().step() == stands.player().step());
    CHECK(led.stage().subject().rows() == stands.stage().subject().rows());
  }
}

std::string refusal(const Place& at) {
  Session session = open_small();
  const auto gone = go_in_run(at, session);
  return gone ? "" : gone.error().what;
}

}  // namespace

TEST_CASE("a step is one of the algorithm that is named") {
  Session session = open_small();
  REQUIRE(go_in_run({.algorithm = "welzl", .step = 3}, session));
  CHECK(session.player().step() == 3);
  CHECK(name_in(session.lesson(), *session.player().method(0)) == "welzl");
  REQUIRE(go_in_run({.algorithm = "sphere/ritter", .step = 2}, session));  // with its volume, as other lessons say it
  CHECK(name_in(session.lesson(), *session.player().method(0)) == "ritter");
  REQUIRE(go_in_run({.step = Place::kLastStep}, session));
  CHECK(session.player().step() == session.player().steps());
  CHECK(refusal({.algorithm = "wezl"}) ==
        "the lesson's algorithm is none of ritter, welzl or brute_force: wezl; did you mean welzl?");
  CHECK(refusal({.step = 12}) == "there is no step 12: ritter has 11");
}

TEST_CASE("a question stands open where it is asked, or with the outcome of its model answer") {
  for (const char* const id : {"pair", "growth", "again", "number"}) {
    CAPTURE(id);
    Session session = open_small();
    REQUIRE(go_in_run({.question = id}, session));
    REQUIRE(session.conversation().asked() != nullptr);
    CHECK(session.conversation().asked()->question->id == id);
    REQUIRE(go_in_run({.question = id, .answered = true}, session));
    REQUIRE(session.conversation().outcome() != nullptr);
    CHECK(session.conversation().outcome()->question == id);
    CHECK(session.conversation().outcome()->right);
  }
}

TEST_CASE("a question that cannot stand is refused with the reason") {
  CHECK(refusal({.question = "gowth"}) ==
        "the question is none of pair, growth, again or number: gowth; did you mean growth?");
  CHECK(refusal({.algorithm = "welzl", .question = "growth"}) ==
        "the question growth is about ritter, not about welzl");
  CHECK(refusal({.algorithm = "sphere/ritter", .question = "growth"}).empty());
  Session scattered = open_small();
  scattered.stage().scatter(6);
  const auto gone = go_in_run({.question = "number"}, scattered);  // asked on the lesson's own points alone
  REQUIRE_FALSE(gone);
  CHECK(gone.error().what == "the question number does not come on what is on the stage");
}

TEST_CASE("where a session stands is a place that leads back there: steps, methods, and whatever was edited") {
  Session session = open_small();
  check_leads_back(session);
  session.jump(4);
  REQUIRE(session.player().choose(0, "welzl"));
  REQUIRE(session.player().choose(1, "ritter"));
  check_leads_back(session);
  REQUIRE(session.stage().move(2, {0.1, 1.0 / 3, 0}));
  check_leads_back(session);
  CHECK(place_now(session, kNoMesh)->moved.size() == 1);
  REQUIRE(session.stage().add({1, 1, 0}));
  check_leads_back(session);
  CHECK(place_now(session, kNoMesh)->rows.size() == 7);
  REQUIRE(session.stage().set_generator("gaussian", 200, 2, 9));
  check_leads_back(session);
  REQUIRE(session.stage().move(150, {3, 3, 0}));
  check_leads_back(session);
}

TEST_CASE("800 points of one's own survive in an address, after a # that no server is told") {
  Session session = open_small();
  REQUIRE(session.stage().set_generator("cube", 800, 2, 3));
  Rows rows = session.stage().subject().rows();
  for (std::vector<double>& row : rows) row[0] *= 1.0 / 3;
  REQUIRE(session.stage().set_rows(rows));
  check_leads_back(session);
  const std::string address = address_of(*place_now(session, kNoMesh));
  const std::size_t at = address.find("#packed=");
  REQUIRE(at != std::string::npos);
  CHECK(at < 200);
  CHECK(address.size() < 20'000);
  CHECK(unpacked_rows(std::string_view(address).substr(at + 8)) == rows);
}

TEST_CASE("a place names its situation, unless it is the lesson's own") {
  const std::string text = test::small_lesson_with("seed = 5", "seed = 5\nsituation_title = \"Six points\"") +
                           "[[situation]]\nname = \"three\"\ntitle = \"Three\"\n"
                           "[situation.points]\ndim = 2\nlist = [[0, 0], [1, 0], [0, 1]]\n";
  Session session = test::open(text);
  CHECK(place_now(session, kNoMesh)->situation.empty());
  REQUIRE(session.stage().show_situation("three"));
  const auto place = place_now(session, kNoMesh);
  CHECK(place->situation == "three");
  CHECK(place->rows.empty());
}

TEST_CASE("of a wrong address the mistake is left out and told") {
  const std::pair<const char*, const char*> wrong[] = {{"step=abc", "step \"abc\", which must be a whole number"},
                                                       {"seed=-4", "seed \"-4\", which must be a whole number"},
                                                       {"step=9007199254740993", "which must be a whole number"},
                                                       {"rows=1,2;x,4", "which must be rows of numbers"},
                                                       {"moved=1,,2", "which must be rows of numbers"},
                                                       {"slide=1;2", "which must be numbers"},
                                                       {"camera=1,2", "which must be \"height,x,y\" in the plane"},
                                                       {"from=%3Cb%3E", "which must be a name"},
                                                       {"from=cube:0", "which must be a name"},
                                                       {"packed=?", "which is not as an address has it"},
                                                       {"scalar=half", "which must be float or double"}};
  for (const auto& one : wrong) {
    const std::string query = one.first, says = one.second;
    CAPTURE(query);
    const PlaceRead read = read_place("?lesson=a&" + query);
    REQUIRE(read.problems.size() == 1);
    CHECK(read.problems.front().find(says) != std::string::npos);
    CHECK(read.place == Place{.lesson = "a"});
  }
}

TEST_CASE("what is no place's is passed over, and links of old are read") {
  CHECK(read_place("").place.is_bare());
  CHECK(read_place("?lesson=a&embed=1&mark=ABCD").place.is_bare());
  CHECK_FALSE(read_place("?lesson=a&step=0").place.is_bare());
  for (const char* const name : {"rows", "points", "boxes"})
    CHECK(read_place("?" + std::string(name) + "=0,0;4.125,-1e-3").place.rows == Rows{{0, 0}, {4.125, -0.001}});
  CHECK(read_place("?lesson=a%20lesson&situation=b+c").place.situation == "b c");
  CHECK(read_place("?step=end").place.step == Place::kLastStep);
  CHECK(address_of({.lesson = "a", .step = Place::kLastStep}) == "?lesson=a&step=end");
}

TEST_CASE("texts of any letters survive in an address") {
  const Place place{.lesson = "a&b", .situation = "drei Würfel + 1 #2", .file = "3-0-x = 1 & \"ö\"\n"};
  CHECK(read_place(address_of(place)).place == place);
}

TEST_CASE("a part of the way that is refused is told by its key, and the others are gone") {
  Session session = open_small();
  WayTo way({.algorithm = "wezl", .from = "bunny", .step = 4}, kNoMesh);
  std::vector<std::string> faults;
  while (!way.done())
    if (const auto gone = way.go_on(session); !gone) faults.push_back(gone.error().key);
  CHECK(faults == std::vector<std::string>{"from", "algorithm"});
  CHECK(session.player().step() == 4);
}

TEST_CASE("rows that no address has room for are left out, and that is known") {
  Place place{.lesson = "a"};
  place.rows.assign(6001, {0.5});
  CHECK_FALSE(fits_address(place));
  CHECK(address_of(place) == "?lesson=a");
  place.rows.resize(6000);
  CHECK(fits_address(place));
}

TEST_CASE("a change of a text leads from one to the other; of another text it is refused") {
  const std::pair<const char*, const char*> texts[] = {
      {"", "abc"}, {"abc", ""}, {"aaa", "aa"}, {"abcabc", "abcXabc"}, {"ä\nb", "ä\nc"}, {"aä", "aö"}, {"x😀y", "x😁y"}};
  for (const auto& [from, to] : texts) CHECK(changed(from, change_of(from, to)) == to);
  CHECK(change_of("same", "same").empty());
  CHECK(change_of("ä😀x", "ä😀y") == "3-1-y");  // as scripts count letters
  CHECK_FALSE(changed("short", "4-3-x"));
  for (const char* const wrong : {"", "x", "1-2", "-1-2-x"}) CHECK_FALSE(changed("text", wrong));
}
