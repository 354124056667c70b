// At every step of every lesson, on screens of three sizes: no words over others, none cut off; and beside a question
// none that tell its answer.
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/look.hpp"
#include "bench.hpp"
#include "io/point_file.hpp"
#include "lesson/say.hpp"
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
      {"page 1920", {{0, 0, 1268, 896}, {0, 896, 1268, 136}, {1268, 0, 280, 1032}, false, 88}},
      {"phone", {{0, 0, 390, 390}, {0, 446, 390, 158}, {}, true, 104}},
      {"phone, numbers", {{}, {}, {0, 0, 390, 604}, true}},
      {"phone, large text", {{0, 0, 390, 340}, {0, 340, 390, 190}, {}, true, 104}, 1.4f},
      {"window 1280", {{371, 48, 627, 600}, {371, 648, 627, 152}, {998, 48, 282, 752}}, 1, true},
      {"window 1920", {{380, 48, 1250, 880}, {380, 928, 1250, 152}, {1630, 48, 290, 1032}}, 1, true},
      {"projector",
       {{0, 0, 1268, 896}, {0, 896, 1268, 160}, {1268, 0, 380, 1032}, false, 88},
       1,
       false,
       Theme::kProjector},
  };
  return all;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// None of no name.
std::optional<io::PointFile> mesh_of(const std::string& mesh) {
  if (mesh.empty()) return std::nullopt;
  const std::string name = mesh + ".ply";
  auto read = io::read_points(bytes_of(SNUG_ASSETS_DIR "/meshes/" + name), name);
  REQUIRE(read.has_value());
  return *std::move(read);
}

std::vector<lesson::Lesson> all_lessons() {
  std::vector<lesson::Lesson> lessons;
  for (const auto& entry : std::filesystem::directory_iterator(SNUG_SOURCE_DIR "/lessons")) {
    if (entry.path().extension() != ".toml" || entry.path().filename() == "course.toml") continue;
    auto lesson =
        lesson::read_lesson(bytes_of(entry.path()), entry.path().filename().string(), lesson::Checked::kAsWritten);
    REQUIRE_MESSAGE(lesson.has_value(), (lesson ? "" : lesson.error().message()));
    lessons.push_back(*std::move(lesson));
  }
  return lessons;
}

std::vector<lesson::Lesson> without_questions() {
  std::vector<lesson::Lesson> lessons = all_lessons();
  for (lesson::Lesson& lesson : lessons) lesson.questions.clear();
  return lessons;
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
      const bool gap = words[i].words == "…";  // in Welzl's list, between what is shown of a long one
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

/// The chosen algorithms' steps, forty of each at most.
void walk(Bench& bench, const Screen& screen, const std::vector<std::string>& algorithms, const std::string& name,
          Faults& faults) {
  bench.app.settings().text_scale = screen.text_scale;
  bench.app.settings().theme = screen.theme;
  bench.app.settings().prose_in_canvas = screen.prose_in_canvas;
  std::vector<DrawnWords> drawn;
  bench.app.note_words(&drawn);
  for (const std::string& algorithm : algorithms) {
    if (!bench.session().choose(0, algorithm)) continue;
    const int steps = bench.session().steps(), stride = std::max(1, steps / 40);
    for (int step = 0; step <= steps; step = step == steps ? steps + 1 : std::min(step + stride, steps)) {
      bench.session().jump(step);
      bench.frames(2);
      faults.look_at(screen, drawn, name + " " + screen.name + ", " + algorithm + " step " + std::to_string(step));
    }
  }
  bench.app.note_words(nullptr);
}

}  // namespace

TEST_CASE("no words stand over others, run off or are cut, at any step of any lesson") {
  Faults faults;
  for (const lesson::Lesson& lesson : without_questions())
    for (const Screen& screen : screens()) {
      Bench bench(lesson, screen.layout, mesh_of(lesson.points.mesh));
      walk(bench, screen, lesson.algorithms, lesson.id, faults);
    }
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(faults.seen() > 10'000);
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
    for (const Screen& screen : screens()) {
      Bench bench(lesson, screen.layout);
      walk(bench, screen, lesson.algorithms, lesson.volume, faults);
    }
  INFO(faults.text());
  CHECK(faults.text().empty());
  CHECK(faults.seen() > 1'000);
}

TEST_CASE("nor among the points of a mesh, or of any scatter") {
  Faults faults;
  for (const lesson::Lesson& lesson : without_questions())
    for (const Screen& screen : screens()) {
      Bench bench(lesson, screen.layout, mesh_of(lesson.points.mesh));
      const std::vector<std::string> first{lesson.algorithms.front()};
      for (int seed = 1; seed <= 3; ++seed) {
        bench.session().scatter(static_cast<std::uint64_t>(seed));
        walk(bench, screen, first, lesson.id + " scattered", faults);
      }
      if (lesson.meshes.empty()) continue;
      REQUIRE(bench.app.load(*mesh_of("bunny"), "Bunny"));
      walk(bench, screen, first, lesson.id + " bunny", faults);
    }
  INFO(faults.text());
  CHECK(faults.text().empty());
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
  const lesson::Truth truth = asked.asking->truth(asked, session.run(0));
  std::string told = asked.prompt;
  for (const std::string& choice : asked.choices) told += " " + choice;
  std::set<std::string> secrets = telling_numbers(truth.happened + " " + truth.sentence);
  for (const std::string& number : telling_numbers(told)) secrets.erase(number);
  // How it stands so far may be known; what the question is about is no figure then.
  for (const lesson::Figure& figure : session.figures())
    for (const std::string& number : telling_numbers(figure.text)) secrets.erase(number);
  for (const int choice : asked.on_axes ? std::vector<int>() : truth.choices)  // the axes stand in their table
    if (const auto i = static_cast<std::size_t>(choice);
        i < asked.choices.size() && (i >= asked.choice_handles.size() || asked.choice_handles[i].empty()) &&
        asked.choices[i].size() > 4)
      secrets.insert(asked.choices[i]);
  for (const std::string& name : session.lesson().algorithms)  // each is named in the list of results, which are hidden
    secrets.erase(lesson::title_in(session.lesson(), *lesson::find_method(session.lesson(), name)));
  for (const lesson::Switch& one : session.switches())  // each is named in the table of effects, whatever it does
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
  for (session.first(); session.step() < session.steps() || session.asked() != nullptr;) {
    const lesson::Asked* asked = session.asked();
    if (asked == nullptr) {
      session.forward();
      continue;
    }
    if (asked->step == lesson::Asked::kAnytime) return seen;  // of a chart, before anything is measured
    bench.frames(2);
    ++seen;
    for (const lesson::Rival& rival : session.rivals())
      CHECK_MESSAGE(session.hides_result(*rival.method), name, asked->question->id);
    for (const DrawnWords& words : drawn)
      CHECK_MESSAGE(!words.words.starts_with("smallest"), name, asked->question->id, ": ", words.words);
    for (const std::string& secret : secrets_of(*asked, session))
      for (const DrawnWords& words : drawn)
        CHECK_MESSAGE(!tells(words.words, secret), name, asked->question->id, ": ", words.words);
    REQUIRE(session.answer(lesson::model_answer(*asked, session.run(0))));
    session.acknowledge();
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
    for (const std::string& algorithm : lesson.algorithms)
      if (bench.session().choose(0, algorithm))
        seen += look_at_questions(bench, drawn, lesson.id + ", " + algorithm + ": ");
    bench.app.note_words(nullptr);
  }
  CHECK(seen > 40);
}

}  // namespace snug::app
