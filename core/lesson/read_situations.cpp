#include "lesson/read_situations.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/names.hpp"
#include "lesson/subjects.hpp"

namespace snug::lesson {
namespace {

constexpr int kMostSteps = 10'000, kMostDecimalsGiven = 9;

/// Reads a number that the key must have; `otherwise` if it has none.
double read_number(TomlTable& table, std::string_view key, double otherwise) {
  const std::vector<double> numbers = table.numbers(key);
  if (numbers.size() == 1 && std::isfinite(numbers.front())) return numbers.front();
  if (table.has(key)) table.wrong(key, "must be a finite number");
  return otherwise;
}

void check_mesh(TomlTable& table, const Lesson& lesson, const Situation& situation) {
  const std::string& mesh = situation.points.mesh;
  if (!mesh.empty() && mesh != lesson.points.mesh)
    table.wrong(lesson.subject->table, "of a situation has no mesh but that of the lesson's own: " + mesh);
}

Situation read_situation_table(const toml::table& toml, const Lesson& lesson, std::vector<std::string>& unread,
                               Complaints& complaints) {
  TomlTable table(toml, "[[situation]]", complaints);
  Situation situation;
  situation.place = table.place();
  situation.name = table.text("name");
  situation.title = table.text("title");
  const std::string_view own = lesson.subject->table;
  Lesson there = lesson;
  there.situations.clear();
  const std::size_t before = complaints.count();
  if (table.table(own) != nullptr) lesson.subject->read(table, there, complaints);
  else if (!table.has(own)) table.lack(own, "[[situation]] lacks [situation." + std::string(own) + "]");
  situation.points = std::move(there.points), situation.tables = std::move(there.tables);
  check_mesh(table, lesson, situation);
  if (!table.has(own) || situation.name.empty() || complaints.count() > before) unread.push_back(situation.name);
  table.refuse_others();
  return situation;
}

/// Complains of a name that another situation has. Returns whether none has.
bool check_twin(const Lesson& lesson, const Situation& situation, const toml::table& toml, Complaints& complaints) {
  const toml::node* name = toml.get("name");
  const FilePlace place = name != nullptr ? file_place(*name) : situation.place;
  if (situation.name == kOwnSituation)
    return complaints.add(place, "the name own is that of the lesson's own situation"), false;
  for (const Situation& other : lesson.situations) {
    if (situation.name.empty() || other.name != situation.name) continue;
    complaints.add(place, "there is another situation with the name " + situation.name + ", in line " +
                              std::to_string(other.place.line));
    return false;
  }
  return true;
}

void read_ends(TomlTable& table, Slider& slider) {
  slider.from = read_number(table, "from", 0), slider.to = read_number(table, "to", slider.from + 1);
  if (!(slider.to > slider.from)) table.wrong("to", "must be above \"from\"");
  slider.logarithmic = table.flag_or("logarithmic", false);
  if (slider.logarithmic && !(slider.from > 0)) table.wrong("from", "of a logarithmic slider must be above 0");
  if (!table.has("start")) return static_cast<void>(table.any_number("start", 0));
  slider.start = read_number(table, "start", slider.from);
  if (*slider.start < slider.from || *slider.start > slider.to)
    table.wrong("start", "must lie from \"from\" to \"to\"");
}

Slider read_slider(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[slider]]", complaints);
  Slider slider;
  slider.place = table.place();
  slider.title = table.text("title");
  slider.drives = table.text("drives");
  slider.drives_place = table.place_of("drives");
  read_ends(table, slider);
  slider.steps = static_cast<int>(table.integer_or("steps", 1, kMostSteps, 0));
  const auto decimals = table.integer_or("decimals", 0, kMostDecimalsGiven, -1);
  if (decimals >= 0) slider.decimals = static_cast<int>(decimals);
  if (table.has("unit")) slider.unit = table.text("unit");
  slider.situation = read_situation(table, lesson, "");
  slider.must_move = table.flag_or("must_move", false);
  table.refuse_others();
  return slider;
}

}  // namespace

void read_situations(TomlTable& table, Lesson& lesson, std::vector<std::string>& unread, Complaints& complaints) {
  lesson.own_title = table.text_or("situation_title", lesson.own_title);
  for (const toml::table* one : table.tables("situation")) {
    Situation situation = read_situation_table(*one, lesson, unread, complaints);
    if (check_twin(lesson, situation, *one, complaints)) lesson.situations.push_back(std::move(situation));
  }
  if (table.has("situation_title") && lesson.situations.empty())
    table.wrong("situation_title", "needs a [[situation]] besides the lesson's own");
}

void read_sliders(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  for (const toml::table* one : table.tables("slider")) {
    const std::size_t before = complaints.count();
    Slider slider = read_slider(*one, lesson, complaints);
    slider.sound = complaints.count() == before;
    lesson.sliders.push_back(std::move(slider));
  }
}

std::string read_situation(TomlTable& table, const Lesson& lesson, std::string_view otherwise) {
  std::string name = table.text_or("situation", otherwise);
  if (!table.has("situation")) return name;
  check_name(table, "situation", name, situation_names(lesson));
  return is_among(situation_names(lesson), name) ? name : std::string(otherwise);
}

}  // namespace snug::lesson
