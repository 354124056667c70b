// At the steps of every lesson, in each situation, beside a second algorithm and at its questions, on screens of many
// sizes: no words over others, none cut off; and beside a question none that tell its answer.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/look.hpp"
#include "bench.hpp"
#include "course_lessons.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"
#include "viewed_lessons.hpp"

namespace snug::app {
namespace {

struct Screen {
  const char* name;
  Layout layout;
  float text_scale = 1;
  bool prose_in_canvas = false;
  Theme theme = Theme::kLight;
};

/// The page's and the window's parts, as their doors lay them out.
const std::vector<Screen>& screens() {
  static const std::vector<Screen> all{
      {"page 1280", {{0, 0, 628, 616}, {0, 616, 628, 136}, {628, 0, 280, 752}, false, 88}},
      {"page 1920", {{0, 0, 1162, 896}, {0, 896, 1162, 136}, {1162, 0, 336, 1032}, false, 88}},
      {"phone", {{0, 0, 390, 390}, {0, 446, 390, 158}, {}, true, 104}},
      {"phone, numbers", {{}, {}, {0, 0, 390, 604}, true}},
      {"phone, large text", {{0, 0, 390, 340}, {0, 340, 390, 190}, {}, true, 104}, 1.4f},
      {"phone on its side", {{0, 0, 506, 206}, {0, 246, 506, 96}, {}, true, 56}},
      {"window 1280", {{371, 48, 627, 600}, {371, 648, 627, 152}, {998, 48, 282, 752}}, 1, true},
      {"window 960", {{300, 48, 380, 816}, {300, 864, 380, 136}, {680, 48, 280, 952}}, 1, true},
      {"presentation", {{0, 0, 999, 664}, {0, 664, 999, 136}, {999, 80, 281, 720}, false, 120}, 1, true},
      {"window 1920", {{422, 48, 1162, 880}, {422, 928, 1162, 152}, {1584, 48, 336, 1032}}, 1, true},
      {"projector",
       {{0, 0, 1268, 896}, {0, 896, 1268, 160}, {1268, 0, 380, 1032}, false, 88},
       1,
       false,
       Theme::kProjector},
  };
  return all;
}

/// A halo and its words are one, and so are letters and their shadow.
bool same_words(const DrawnWords& a, const DrawnWords& b) {
  return a.words == b.words && std::abs(a.low.x - b.low.x) < 5 && std::abs(a.low.y - b.low.y) < 5;
}

/// What is left of it where its list was clipped; of no width where nothing is.
DrawnWords shown(DrawnWords drawn) {
  drawn.low = {std::max(drawn.low.x, drawn.clip_low.x), std::max(drawn.low.y, drawn.clip_low.y)};
  drawn.high = {std::min(drawn.high.x, drawn.clip_high.x), std::min(drawn.high.y, drawn.clip_high.y)};
  return drawn;
}
bool visible(const DrawnWords& drawn) { return drawn.low.x < drawn.high.x && drawn.low.y < drawn.high.y; }

bool covers(const DrawnWords& a, const DrawnWords& b) {
  constexpr float kTouch = 1;  // a pixel
  return std::min(a.high.x, b.high.x) - std::max(a.low.x, b.low.x) > kTouch &&
         std::min(a.high.y, b.high.y) - std::max(a.low.y, b.low.y) > kTouch;
}

const Rect& part_of(const Layout& layout, const DrawnWords& drawn) {
  const float x = (drawn.clip_low.x + drawn.clip_high.x) / 2, y = (drawn.clip_low.y + drawn.clip_high.y) / 2;
  for (const Rect* rect : {&layout.stage, &layout.timeline, &layout.inspector})
    if (x >= rect->x && x < rect->x + rect->width && y >= rect->y && y < rect->y + rect->height) return *rect;
  return layout.stage;
}

/// Each fault of a frame once, whatever the step.
class Faults {
 public:
  void look_at(const Screen& screen, const std::vector<DrawnWords>& frame, const std::string& where) {
    std::vector<DrawnWords> words;
    for (const DrawnWords& drawn : frame) {
      const bool known =
          std::any_of(words.begin(), words.end(), [&](const DrawnWords& other) { return same_words(drawn, other); });
      if (!known) words.push_back(drawn);
    }
    seen_ += words.size();
    for (std::size_t i = 0; i < words.size(); ++i) {
      const DrawnWords here = shown(words[i]);
      const Rect& part = part_of(screen.layout, words[i]);
      const bool scrolls = &part == &screen.layout.inspector;
      if (words[i].low.x < part.x - 1 || words[i].high.x > part.x + part.width + 1 ||
          (!scrolls && (words[i].low.y < part.y - 1 || words[i].high.y > part.y + part.height + 1)))
        add(words[i].words + " | runs off", where);
      const bool gap = words[i].words.starts_with("…");  // in lists, between what is shown of a long one
      if (words[i].words.ends_with("…") && !gap) add(words[i].words + " | is cut", where);
      if (!visible(here)) continue;
      for (std::size_t j = i + 1; j < words.size(); ++j)
        if (const DrawnWords there = shown(words[j]); visible(there) && covers(here, there))
          add(words[i].words + " | over | " + words[j].words, where);
    }
  }
  [[nodiscard]] std::size_t seen() const { return seen_; }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const auto& [fault, where] : first_) text += "\n  " + fault + "   (" + where + ")";
    return text;
  }

 private:
  void add(const std::string& fault, const std::string& where) {
    std::string kind = fault;  // numbers differ from step to step
    for (char& c : kind)
      if (c >= '0' && c <= '9') c = '#';
    if (kinds_.insert(where.substr(0, where.find(',')) + kind).second) first_.emplace_back(fault, where);
  }
  std::set<std::string> kinds_;
  std::vector<std::pair<std::string, std::string>> first_;
  std::size_t seen_ = 0;
};

}  // namespace

namespace {

constexpr int kMostSteps = 24;  // of an algorithm, on one screen

/// A bench whose drawn words are looked at.
class Watched {
 public:
  Watched(const lesson::Lesson& lesson, const Screen& screen, Faults& faults)
      : bench_(lesson, screen.layout, mesh_of(lesson.points.mesh)), screen_(screen), faults_(faults) {
    bench_.app.settings().text_scale = screen.text_scale;
    bench_.app.settings().theme = screen.theme;
    bench_.app.settings().prose_in_canvas = screen.prose_in_canvas;
    bench_.app.note_words(&drawn_);
  }
  ~Watched() { bench_.app.note_words(nullptr); }
  Watched(const Watched&) = delete;
  Watched& operator=(const Watched&) = delete;
  [[nodiscard]] lesson::Session& session() { return bench_.session(); }
  [[nodiscard]] App& app() { return bench_.app; }

  void look(const std::string& where) {
    bench_.frames(2);
    faults_.look_at(screen_, drawn_, where);
  }
  /// The run's steps, the first, the last and so many between; each screen has others of a long run.
  void walk(const std::string& name, int most = kMostSteps) {
    const int steps = session().player().steps(), stride = std::max(1, (steps + most - 1) / most);
    const int first = static_cast<int>(std::string_view(screen_.name).size()) % stride;
    see(0, name);
    for (int step = first; step < steps; step += stride)
      if (step > 0) see(step, name);
    see(steps, name);
  }
  void walk_all(const std::vector<std::string>& algorithms, const std::string& name, int most = kMostSteps) {
    for (const std::string& algorithm : algorithms)
      if (session().player().choose(0, algorithm)) walk(name + ", " + algorithm, most);
  }

 private:
  void see(int step, const std::string& name) {
    session().jump(step);
    look(name + " " + screen_.name + ", step " + std::to_string(step));
  }

  std::vector<DrawnWords> drawn_;
  Bench bench_;
  const Screen& screen_;
  Faults& faults_;
};

/// Every third screen, another third for each number.
std::vector<const Screen*> some_screens(std::size_t number) {
  std::vector<const Screen*> some;
  for (std::size_t i = number % 3; i < screens().size(); i += 3) some.push_back(&screens()[i]);
  return some;
}

const Screen& screen_named(std::string_view name) {
  for (const Screen& screen : screens())
    if (screen.name == name) return screen;
  FAIL("no screen ", name);
  return screens().front();
}

}  // namespace

TEST_CASE("no words stand over others, run off or are cut, at the steps of every lesson") {
  Faults faults;
  for (const lesson::Lesson& lesson : all_lessons(false))
    for (const Screen& screen : screens()) Watched(lesson, screen, faults).walk_all(lesson.algorithms, lesson.id);
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(faults.seen() > 10'000);
}

TEST_CASE("nor in any situation of a lesson") {
  Faults faults;
  std::size_t number = 0;
  for (const lesson::Lesson& lesson : all_lessons(false))
    for (const lesson::Situation& situation : lesson.situations)
      for (const Screen* screen : some_screens(number++)) {
        Watched watched(lesson, *screen, faults);
        REQUIRE(watched.session().stage().show_situation(situation.name));
        watched.walk_all(lesson.algorithms, lesson.id + " " + situation.name, 12);
      }
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(number > 40);
}

TEST_CASE("nor beside a second algorithm") {
  Faults faults;
  std::size_t number = 0;
  for (const lesson::Lesson& lesson : all_lessons(false))
    for (std::size_t i = 1; i < lesson.algorithms.size(); ++i)
      for (const Screen* screen : some_screens(number++)) {
        Watched watched(lesson, *screen, faults);
        if (watched.session().player().choose(1, lesson.algorithms[i]))
          watched.walk(lesson.id + " beside " + lesson.algorithms[i], 8);
      }
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(number > 50);
}

TEST_CASE("nor on k-DOPs, in close-ups or about a pile of bodies") {
  Faults faults;
  const std::vector<lesson::Lesson> lessons{
      test::flat_kdop("inset = { at = \"P6\", size = 0.3 }\noutline = true"),
      test::space_kdop("camera = [20, 15]\ninset = { at = \"P1\", size = 0.5 }"),
      test::boxes_apart("0.997", "inset = { at = \"gap\" }"),
      test::boxes_apart("0.9997", "inset = { at = \"gap\" }", 3),
      test::falling("zoom = 2\nlook_at = \"P0\"", "color = \"blue\"", "color = \"grey\"")};
  for (const lesson::Lesson& lesson : lessons)
    for (const Screen& screen : screens()) Watched(lesson, screen, faults).walk_all(lesson.algorithms, lesson.volume);
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(faults.seen() > 1'000);
}

TEST_CASE("nor among the points of a mesh, or of any scatter") {
  Faults faults;
  std::size_t number = 0;
  for (const lesson::Lesson& lesson : all_lessons(false))
    for (int seed = 1; seed <= 6; ++seed)
      for (const Screen* screen : some_screens(number++)) {
        Watched watched(lesson, *screen, faults);
        watched.session().stage().scatter(static_cast<std::uint64_t>(seed));
        watched.walk(lesson.id + " scattered", 12);
        if (lesson.meshes.empty() || seed > 3) continue;
        REQUIRE(watched.app().load(*mesh_of("bunny"), "Bunny"));
        watched.walk(lesson.id + " bunny", 12);
      }
  INFO(faults.text());
  CHECK(faults.text().empty());
}

namespace {

/// Each question of the run as it stands, with an answer chosen, and told. name: of what is on the stage.
int look_at_standing(Watched& watched, const std::string& name) {
  int seen = 0;
  lesson::Session& session = watched.session();
  for (session.go(0);
       session.player().step() < session.player().steps() || session.conversation().asked() != nullptr;) {
    const lesson::Asked* asked = session.conversation().asked();
    if (asked == nullptr) {
      session.forward();
      continue;
    }
    const std::string where = name + ", asked " + asked->question->id;
    watched.look(where);
    const lesson::Answer answer = lesson::model_answer(*asked, session.player().run(0));
    if (session.conversation().pick(answer)) watched.look(where + ", chosen");
    if (asked->step == lesson::Asked::kAnytime) return ++seen;  // of a chart, before anything is measured
    REQUIRE(session.conversation().give(answer));
    watched.look(where + ", told");
    session.conversation().acknowledge();
    ++seen;
  }
  return seen;
}

}  // namespace

TEST_CASE("nor while a question stands over the foot of the stage, or beside it") {
  Faults faults;
  int seen = 0;
  Screen page = screen_named("page 1280");
  page.layout.foot = 230;
  for (const lesson::Lesson& lesson : all_lessons())
    for (const Screen* screen : {const_cast<const Screen*>(&page), &screen_named("phone")}) {
      Watched watched(lesson, *screen, faults);
      for (const std::string_view situation : lesson::situation_names(lesson)) {
        if (!watched.session().stage().show_situation(situation)) continue;
        for (const std::string& algorithm : lesson.algorithms)
          if (watched.session().player().choose(0, algorithm))
            seen += look_at_standing(watched, lesson.id + " " + std::string(situation) + " " + screen->name);
      }
    }
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(seen > 300);
}

namespace {

/// The numbers of a text that stand for nothing else: those with a fraction, and counts of three digits or more.
std::set<std::string> telling_numbers(const std::string& text) {
  std::set<std::string> numbers;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && (std::isdigit(static_cast<unsigned char>(text[end])) != 0 ||
                                 (end > i && (text[end] == '.' || text[end] == ','))))
      ++end;
    std::string number = text.substr(i, end - i);
    while (!number.empty() && (number.back() == '.' || number.back() == ',')) number.pop_back();
    if (number.size() > 2) numbers.insert(number);
    i = std::max(end, i + 1);
  }
  return numbers;
}

/// What would tell the answer to a question: the figures of what happened that the question itself does not name, and
/// the right choice's words, where they name no handle.
std::set<std::string> secrets_of(const lesson::Asked& asked, const lesson::Session& session) {
  const lesson::Truth truth = asked.kind->truth(asked, session.player().run(0));
  std::string told = asked.prompt;
  for (const std::string& choice : asked.choices) told += " " + choice;
  std::set<std::string> secrets = telling_numbers(truth.happened + " " + truth.sentence);
  told += " " + lesson::count_text(session.stage().subject().size());  // how many points there are is no answer
  for (const std::string& number : telling_numbers(told)) secrets.erase(number);
  // How it stands so far may be known; what the question is about is no figure then.
  for (const lesson::Figure& figure : session.telling().figures())
    for (const std::string& number : telling_numbers(figure.text)) secrets.erase(number);
  for (const int choice : asked.on_axes ? std::vector<int>() : truth.choices)  // the axes stand in their table
    if (const auto i = static_cast<std::size_t>(choice);
        i < asked.choices.size() && (i >= asked.choice_handles.size() || asked.choice_handles[i].empty()) &&
        asked.choices[i].size() > 4)
      secrets.insert(asked.choices[i]);
  for (const std::string& name : session.lesson().algorithms)  // each is named in the list of results, which are hidden
    secrets.erase(lesson::title_in(session.lesson(), *lesson::find_method(session.lesson(), name)));
  for (const lesson::Switch& one :
       session.player().switches())  // each is named in the table of effects, whatever it does
    secrets.erase(lesson::effect_words(one.name));
  return secrets;
}

bool tells(const std::string& words, const std::string& secret) {
  return words == secret || telling_numbers(words).contains(secret);
}

/// Every question of an algorithm's run, as it stands; how many there were.
int look_at_questions(Bench& bench, std::vector<DrawnWords>& drawn, const std::string& name) {
  int seen = 0;
  lesson::Session& session = bench.session();
  for (session.go(0);
       session.player().step() < session.player().steps() || session.conversation().asked() != nullptr;) {
    const lesson::Asked* asked = session.conversation().asked();
    if (asked == nullptr) {
      session.forward();
      continue;
    }
    if (asked->step == lesson::Asked::kAnytime) return seen;  // of a chart, before anything is measured
    bench.frames(2);
    ++seen;
    for (const lesson::Rival& rival : session.player().rivals())
      CHECK_MESSAGE(session.telling().hides_result(*rival.method), name, asked->question->id);
    for (const DrawnWords& words : drawn)
      CHECK_MESSAGE(!words.words.starts_with("smallest"), name, asked->question->id, ": ", words.words);
    for (const std::string& secret : secrets_of(*asked, session))
      for (const DrawnWords& words : drawn)
        CHECK_MESSAGE(!tells(words.words, secret), name, asked->question->id, ": ", words.words);
    REQUIRE(session.conversation().give(lesson::model_answer(*asked, session.player().run(0))));
    session.conversation().acknowledge();
  }
  return seen;
}

}  // namespace

TEST_CASE("while a question stands, no words on the stage or beside it tell the answer") {
  int seen = 0;
  for (const lesson::Lesson& lesson : all_lessons()) {
    const Layout tall{{0, 0, 900, 700}, {0, 700, 900, 136}, {900, 0, 380, 4000}, false, 88};
    Bench bench(lesson, tall, mesh_of(lesson.points.mesh));
    std::vector<DrawnWords> drawn;
    bench.app.note_words(&drawn);
    bench.app.settings().show_optimum = true;
    for (const std::string_view situation : lesson::situation_names(lesson)) {
      REQUIRE(bench.session().stage().show_situation(situation));
      for (const std::string& algorithm : lesson.algorithms)
        if (bench.session().player().choose(0, algorithm))
          seen += look_at_questions(bench, drawn, lesson.id + ", " + std::string(situation) + ", " + algorithm + ": ");
    }
    bench.app.note_words(nullptr);
  }
  CHECK(seen > 150);
}

}  // namespace snug::app
