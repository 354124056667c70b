// What is told of an open lesson, and when.
#include "app/told/view.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <concepts>
#include <nlohmann/json.hpp>
#include <set>

#include "../bench.hpp"
#include "../course_lessons.hpp"
#include "app/told/lesson.hpp"

namespace snug::app::told {
namespace {

using Json = nlohmann::json;

/// The numbers that are not finite, of which JSON knows nothing, and the words that are none of those that are named.
int faults(const auto& value);

template <Literal... kWords>
int faults_of(const Word<kWords...>& one) {
  return ((one.word == kWords.view()) || ...) ? 0 : 1;
}
template <class Value>
int faults_of(const std::optional<Value>& value) {
  return value ? faults(*value) : 0;
}
template <class Value>
int faults_of(const IfAny<Value>& value) {
  return value.any ? faults(value.value) : 0;
}
template <class Value>
int faults_of(const std::pair<std::string, Value>& value) {
  return faults(value.second);
}
int faults_of(const auto& value) {
  using Value = std::remove_cvref_t<decltype(value)>;
  if constexpr (Listed<Value>) {
    int all = 0;
    if constexpr (requires { typename Value::Base; }) all += faults(static_cast<const typename Value::Base&>(value));
    see_fields(value, [&](std::string_view, const auto& field) { all += faults(field); });
    return all;
  } else if constexpr (std::floating_point<Value>) {
    return std::isfinite(value) ? 0 : 1;
  } else if constexpr (std::integral<Value> || std::convertible_to<Value, std::string_view>) {
    return 0;
  } else {
    int all = 0;
    for (const auto& one : value) all += faults(one);
    return all;
  }
}
int faults(const auto& value) { return faults_of(value); }

TEST_CASE("of every lesson what is told is words that the page knows and numbers that JSON has, at begin and end") {
  for (lesson::Lesson& lesson : all_lessons()) {
    const std::string id = lesson.id;
    auto mesh = mesh_of(lesson.points.mesh);
    Bench bench(std::move(lesson), {.stage = {0, 0, 800, 440}, .timeline = {0, 440, 800, 160}}, std::move(mesh));
    CHECK_MESSAGE(faults(lesson_of(bench.session())) == 0, id);
    for (const bool at_end : {false, true}) {
      if (at_end) bench.session().jump(bench.session().player().steps());
      see_parts(bench.app, [&](From, const auto& part) { CHECK_MESSAGE(faults(part()) == 0, id); });
      CHECK_MESSAGE(Json::parse(view_text(bench.app), nullptr, false).is_object(), id);
    }
  }
}

TEST_CASE("no two parts tell a key of the same name") {
  Bench bench(course_lesson("sphere-ritter"));
  std::set<std::string> keys;
  see_parts(bench.app, [&](From, const auto& part) {
    const Json told = Json::parse(json_of(part()));
    for (const auto& [key, value] : told.items()) CHECK_MESSAGE(keys.insert(key).second, key);
  });
}

TEST_CASE("only parts that have changed are told, and put together they are all that there is to tell") {
  Bench bench(course_lesson("sphere-ritter"));
  Changes changes;
  Json view = Json::parse(changes.tell(bench.app));
  CHECK(view == Json::parse(view_text(bench.app)));
  CHECK(changes.tell(bench.app) == "{}");
  const auto tell = [&] {
    const Json changed = Json::parse(changes.tell(bench.app));
    view.update(changed);
    CHECK(view == Json::parse(view_text(bench.app)));
    return changed;
  };

  bench.frames(1);
  CHECK(tell() == Json{{"framesDrawn", bench.app.frames_drawn()}});

  bench.app.command("step");
  bench.frames(1);
  const Json stepped = tell();
  CHECK(stepped.at("step") == 1);
  CHECK_FALSE(stepped.contains("numbers"));  // of the points nothing has changed

  bench.session().jump(2);
  bench.frames(1);
  const Json asked = tell();
  CHECK(asked.at("asked").at("picked") == nullptr);
  CHECK_FALSE(asked.contains("numbers"));

  REQUIRE(bench.session().conversation().pick("P0"));
  const Json picked = tell();
  CHECK(picked.at("asked").at("picked") == Json{{"choices", Json::array()}, {"handle", "P0"}});
  CHECK_FALSE(picked.contains("outcomes"));

  REQUIRE(bench.session().stage().move(0, {0.25, -0.0, 0}).has_value());
  bench.frames(1);
  const Json moved = tell();
  CHECK(moved.at("edited") == true);
  bench.app.select(0);
  const Json selected = tell();
  CHECK(selected.at("coordinates") == Json{0.25, 0.0});
}

TEST_CASE("in every lesson what has changed is all that there is to tell, whatever is done") {
  for (lesson::Lesson& lesson : all_lessons()) {
    const std::string id = lesson.id;
    auto mesh = mesh_of(lesson.points.mesh);
    Bench bench(std::move(lesson), {.stage = {0, 0, 800, 440}, .timeline = {0, 440, 800, 160}}, std::move(mesh));
    Changes changes;
    Json view = Json::object();
    const auto check = [&](const char* after) {
      view.update(Json::parse(changes.tell(bench.app)));
      CHECK_MESSAGE(view == Json::parse(view_text(bench.app)), id, " after ", after);
    };
    check("it is opened");
    for (const char* const command : {"step", "step", "select_next", "move_up", "next_mark", "step", "undo", "last",
                                      "redo", "first", "pass_questions", "next_mark", "toggle_optimum"}) {
      bench.app.command(command);
      check(command);
    }
    if (bench.session().conversation().asked() != nullptr) {
      static_cast<void>(bench.session().conversation().pick(lesson::OneChoice{0}));
      check("a choice");
    }
    bench.session().stage().begin_drag();
    static_cast<void>(
        bench.session().stage().move(0, bench.session().stage().subject().at(0) + lesson::Point3(0.25, 0, 0)));
    check("a drag's move");
    static_cast<void>(bench.session().stage().end_drag());
    check("a drag");
    if (!bench.session().lesson().tasks.empty()) {
      bench.session().stage().start_task(0);
      check("a task's start");
      static_cast<void>(bench.session().solve_task(0, bench.session().lesson().tasks[0].model));
      check("a task");
    }
    bench.app.forget_answers();
    check("forgetting");
  }
}

TEST_CASE("in an exercise the pseudocode waits until all that is put in order is answered") {
  Bench bench(course_lesson("ritter-formula"));
  lesson::Session& session = bench.session();
  const auto told = [&] { return Json::parse(view_text(bench.app)); };
  const std::size_t all = told().at("code").size();
  REQUIRE(all > 1);
  session.conduct({.decides = true});
  CHECK(told().at("code").size() == 1);
  CHECK(told().at("line") == -1);
  bool ordered = false;
  while (const lesson::Asked* asked = session.conversation().asked()) {
    ordered = ordered || asked->ordered;
    REQUIRE(session.conversation().give(lesson::model_answer(*asked, session.player().run(0))));
    CHECK(told().at("code").size() == (ordered ? all : 1));
  }
  CHECK(ordered);
}

TEST_CASE("a seed of the address is told to its last digit") {
  Bench bench(course_lesson("sphere-ritter"));
  bench.session().stage().scatter(9007199254740991);
  CHECK(Json::parse(view_text(bench.app)).at("seed") == 9007199254740991);
}

}  // namespace
}  // namespace snug::app::told
