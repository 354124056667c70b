// From a lesson's TOML to a Lesson. What its numbers and names mean together is checked in check_lesson.cpp.
#include <algorithm>
#include <numbers>

#include "fit/catalogue.hpp"
#include "geometry/generate.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/check_lesson.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/methods.hpp"
#include "lesson/own_points.hpp"
#include "lesson/prose.hpp"
#include "lesson/read_scene.hpp"
#include "lesson/toml_table.hpp"

namespace snug::lesson {
namespace {

using Asks = Question::Asks;

constexpr std::int64_t kVersion = 1;

constexpr std::array<std::pair<std::string_view, Asks>, 17> kAsks{{{"point", Asks::kPoint},
                                                                   {"axis", Asks::kAxis},
                                                                   {"grows", Asks::kGrows},
                                                                   {"leaves", Asks::kLeaves},
                                                                   {"choice", Asks::kChoice},
                                                                   {"better", Asks::kBetter},
                                                                   {"holds", Asks::kHolds},
                                                                   {"separates", Asks::kSeparates},
                                                                   {"which_axis", Asks::kWhichAxis},
                                                                   {"p_vertex", Asks::kPVertex},
                                                                   {"n_vertex", Asks::kNVertex},
                                                                   {"plane_side", Asks::kPlaneSide},
                                                                   {"verdict", Asks::kVerdict},
                                                                   {"figure", Asks::kFigure},
                                                                   {"on_front", Asks::kOnFront},
                                                                   {"slowest", Asks::kSlowest},
                                                                   {"times_slower", Asks::kTimesSlower}}};
constexpr std::array kOfCharts{Asks::kChoice, Asks::kOnFront, Asks::kSlowest, Asks::kTimesSlower};

/// "bunny, teapot or dragon"
std::string one_of(const auto& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

bool among(const auto& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void check_name(TomlTable& table, std::string_view key, std::string_view name, const auto& names) {
  if (!name.empty() && !among(names, name)) table.wrong(key, "is none of " + one_of(names) + ": " + std::string(name));
}

/// Those that there are algorithms for.
std::vector<std::string_view> volumes() {
  std::vector<std::string_view> names;
  for (const fit::Algorithm& algorithm : fit::algorithms())
    if (!among(names, algorithm.volume)) names.push_back(algorithm.volume);
  names.insert(names.end(), {kBoxPair, kFrustumBox, kScene});
  return names;
}

std::vector<std::string_view> algorithm_names(std::string_view volume) {
  std::vector<std::string_view> names;
  for (const fit::Algorithm& method : methods_of(volume)) names.push_back(method.name);
  return names;
}

std::string read_algorithm(TomlTable& table, std::string_view key, std::string_view volume) {
  std::string name = table.text(key);
  check_name(table, key, name, algorithm_names(volume));
  return name;
}

std::vector<std::string> read_names(TomlTable& table, std::string_view key, std::size_t least, const auto& names) {
  std::vector<std::string> all = table.texts(key, least);
  for (const std::string& name : all) check_name(table, key, name.empty() ? " " : name, names);
  for (auto name = all.begin(); name != all.end(); ++name)
    if (std::find(all.begin(), name, *name) != name) table.wrong(key, "names " + *name + " twice");
  return all;
}

Section read_section(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[section]]", complaints);
  Section section;
  section.title = table.text("title");
  bool closed = true;
  section.paragraphs = paragraphs_of(table.text("text"), closed);
  if (!closed) table.wrong("text", "has a ** without a partner");
  table.refuse_others();
  return section;
}

Points read_points(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[points]", complaints);
  Points points;
  points.dim = static_cast<int>(table.integer_or("dim", 2, 3, 2));
  const int ways = int{table.has("generate")} + int{table.has("mesh")} + int{table.has("list")};
  if (ways != 1) complaints.add(table.line(), "[points] needs exactly one of \"generate\", \"mesh\" and \"list\"");
  if (table.has("generate")) {
    points.generate = table.text("generate");
    check_name(table, "generate", points.generate, generator_kinds());
    points.count = static_cast<int>(table.integer("count", 1, kMostGenerated));
  }
  if (table.has("mesh")) {
    points.mesh = table.text("mesh");
    check_name(table, "mesh", points.mesh, mesh_names());
    if (table.has("dim") && points.dim != 3) table.wrong("dim", "of a mesh is 3");
    points.dim = 3;
  }
  if (table.has("list")) points.list = table.points("list", points.dim);
  table.refuse_others();
  return points;
}

void read_choices(TomlTable& table, Question& question) {
  question.choices = table.texts("choices", 2);
  const std::string answer = table.text("answer");
  const auto found = std::find(question.choices.begin(), question.choices.end(), answer);
  if (found == question.choices.end() && !answer.empty()) table.wrong("answer", "is none of the choices: " + answer);
  question.answer = static_cast<int>(found - question.choices.begin());
}

/// Which step it speaks of.
Gate read_gate(TomlTable& table, std::string_view volume) {
  Gate gate;
  gate.algorithm = read_algorithm(table, "algorithm", volume);
  gate.fact = table.text("before");
  check_name(table, "before", gate.fact, fit::fact_names());
  gate.occurrence = static_cast<int>(table.integer_or("nth", 1, 100000, 1));
  gate.after = table.text_or("after", "");
  if (gate.after != Gate::kStart) check_name(table, "after", gate.after, fit::fact_names());
  gate.after_nth = static_cast<int>(table.integer_or("after_nth", 1, 100'000, 0));
  if (gate.after_nth > 0 && (gate.after.empty() || gate.after == Gate::kStart))
    table.wrong("after_nth", "counts the steps that \"after\" names");
  return gate;
}

Question read_question(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[question]]", complaints);
  Question question;
  question.line = table.line();
  question.id = table.text("id");
  if (!lesson.measures) question.gate = read_gate(table, lesson.volume);
  const std::string asks = table.text("asks");
  const auto* kind = std::find_if(kAsks.begin(), kAsks.end(), [&](const auto& row) { return row.first == asks; });
  if (kind != kAsks.end()) question.asks = kind->second;
  if (kind == kAsks.end())
    table.wrong("asks", "is none of point, axis, grows, leaves, choice, better, holds, separates, which_axis, "
                        "p_vertex, n_vertex, plane_side, verdict, figure, on_front, slowest or times_slower: " +
                            asks);
  else if (lesson.measures && std::find(kOfCharts.begin(), kOfCharts.end(), question.asks) == kOfCharts.end())
    table.wrong("asks", "is of a step, and this lesson's questions are of its chart: " + asks);
  question.prompt = table.text("prompt");
  if (question.asks == Asks::kChoice) read_choices(table, question);
  if (question.asks == Asks::kFigure) read_ranges(table, question);
  question.own_points = table.flag_or("own_points", false);
  question.because = table.text("because");
  question.prompt_here = table.text_or("prompt_here", "");
  question.because_here = table.text_or("because_here", "");
  table.refuse_others();
  return question;
}

/// Two boxes: each key has a list of two. turn: degrees, in 3-D about x, then y, then z. taper: 1 of two boxes.
BoxPair read_pair(TomlTable& table, int dim, double taper) {
  BoxPair pair{.dim = dim, .taper = taper};
  const auto two = [&](std::string_view key, int numbers) {
    auto list = table.points(key, numbers);
    if (list.size() != 2) table.wrong(key, "must be two, for A and for B");
    list.resize(2, Vector<double, 3>::Zero());
    return list;
  };
  const auto centers = two("center", dim), halves = two("half_extents", dim), turns = two("turn", dim == 2 ? 1 : 3);
  double largest = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    if (halves[i].minCoeff() < 0) table.wrong("half_extents", "must not be negative");
    Obb<double, 3> box{centers[i], Matrix<double, 3>::Identity(), halves[i]};
    for (int axis = 0; axis < (dim == 2 ? 1 : 3); ++axis)
      box = turned_by(box, dim == 2 ? 2 : axis, turns[i][axis] * std::numbers::pi / 180);
    pair.boxes[i] = box;
    largest = std::max(largest, halves[i].maxCoeff());
  }
  pair.knob = 0.4 * largest;
  if (has_frustum(pair) && !(halves[1].head(dim).minCoeff() > 0))
    table.wrong("half_extents", "of a frustum must be above 0");
  if (auto set = places(pair); !set) table.wrong("center", set.error().what);
  table.refuse_others();
  return pair;
}

std::span<const std::string_view> goals_of(std::string_view volume) {
  static constexpr std::array<std::string_view, 4> kPair{"extents_only", "corners_only", "only_edges", "last_axis"};
  static constexpr std::array<std::string_view, 1> kFrustum{"corners_outside"};
  if (volume == kFrustumBox) return kFrustum;
  return kPair;
}

Task read_box_task(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[task]", complaints);
  Task task;
  task.volume = lesson.volume;
  task.prompt = table.text("prompt");
  task.goals = read_names(table, "goals", 1, goals_of(lesson.volume));
  task.algorithm = read_algorithm(table, "algorithm", lesson.volume);
  task.hint = table.text("hint");
  for (const toml::table* model : table.tables("model")) {
    TomlTable own(*model, "[[task.model]]", complaints);
    task.models.push_back(read_pair(own, lesson.boxes->dim, lesson.boxes->taper));
  }
  if (task.models.size() != task.goals.size())
    complaints.add(table.line(), "[task] needs a [[task.model]] for each of its goals");
  table.refuse_others();
  return task;
}

Task read_task(const toml::table& toml, std::string_view volume, int dim, Complaints& complaints) {
  TomlTable table(toml, "[task]", complaints);
  Task task;
  task.volume = volume;
  task.prompt = table.text("prompt");
  task.points = static_cast<int>(table.integer("points", 1, 1000));
  task.algorithm = read_algorithm(table, "algorithm", volume);
  if (fit::exact_algorithm(volume) == nullptr)
    complaints.add(table.line(), "[task] cannot be graded: no algorithm finds the smallest " + std::string(volume));
  if (!table.has("excess_at_least") && !table.has("support_size"))
    complaints.add(table.line(), "[task] needs \"excess_at_least\" or \"support_size\"");
  if (table.has("excess_at_least")) task.excess_at_least = table.number("excess_at_least", 1);
  if (table.has("support_size")) task.support_size = static_cast<int>(table.integer("support_size", 1, dim + 1));
  task.hint = table.text("hint");
  task.model = table.points("model", dim);
  table.refuse_others();
  return task;
}

/// "So much smaller than that, for how much time?"
Task read_cost_task(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[task]", complaints);
  Task task;
  task.volume = lesson.volume;
  task.prompt = table.text("prompt");
  task.algorithm = read_algorithm(table, "algorithm", lesson.volume);
  task.tighter_by = table.number("tighter_by", 1);
  task.points = static_cast<int>(table.integer("points", 1, kMostGenerated));
  task.hint = table.text("hint");
  task.model = table.points("model", lesson.points.dim);
  table.refuse_others();
  return task;
}

void read_pseudocode(const toml::table& toml, Complaints& complaints, Lesson& lesson) {
  for (const auto& [key, node] : toml) {
    const auto line = static_cast<int>(key.source().begin.line);
    const fit::Algorithm* algorithm = find_method(lesson.volume, key.str());
    if (algorithm == nullptr) complaints.add(line, "[pseudocode] of no algorithm: " + std::string(key.str()));
    if (!node.is_table()) complaints.add(line, "[pseudocode] has a table for each algorithm: [pseudocode.ritter]");
    if (complaints.first()) return;
    TomlTable table(*node.as_table(), "[pseudocode." + std::string(key.str()) + "]", complaints);
    Pseudocode words{std::string(key.str()), table.texts("lines", 1)};
    const std::size_t due = algorithm->pseudocode.size();
    if (words.lines.size() != due)
      table.wrong("lines", "must be " + std::to_string(due) + ", as many as the program's, and not " +
                               std::to_string(words.lines.size()));
    table.refuse_others();
    lesson.pseudocode.push_back(std::move(words));
  }
}

void read_head(TomlTable& table, Lesson& lesson) {
  if (table.integer("version", 1, 1000000) != kVersion)
    table.wrong("version", "is not one that this program reads: it reads 1");
  lesson.group = table.text("group");
  lesson.title = table.text("title");
  lesson.summary = table.text("summary");
  lesson.order = static_cast<int>(table.integer("order", 1, 1000));
  lesson.covers = table.texts("covers", 0);
  lesson.seed = static_cast<std::uint64_t>(table.integer_or("seed", 0, 1LL << 53, 1));
  const std::string start = table.text_or("start", "begin");
  check_name(table, "start", start, std::array<std::string_view, 2>{"begin", "end"});
  lesson.start = start == "end" ? Lesson::Start::kEnd : Lesson::Start::kBegin;
  lesson.volume = table.text_or("volume", lesson.volume);
  check_name(table, "volume", lesson.volume, volumes());
  const std::string chart = table.text_or("chart", "");
  check_name(table, "chart", chart, std::array<std::string_view, 1>{"cost"});
  lesson.measures = !chart.empty();
  if (lesson.measures && fit::exact_algorithm(lesson.volume) == nullptr)
    table.wrong("chart", "is of volumes that points are fitted with, of which one is the smallest");
  lesson.algorithms = read_names(table, "algorithms", 1, algorithm_names(lesson.volume));
  if (table.has("compare")) lesson.compare = read_algorithm(table, "compare", lesson.volume);
  lesson.meshes = read_names(table, "meshes", 0, mesh_names());
  lesson.generators = read_names(table, "generators", 0, generator_kinds());
}

/// What stands on the stage: points, or two boxes.
void read_subject(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  const bool pair = has_boxes(lesson.volume);
  const char* due = pair ? "boxes" : "points";
  const toml::table* subject = table.table(due);
  if (subject == nullptr) return complaints.add(1, std::string("the lesson lacks [") + due + "]");
  if (!pair) {
    lesson.points = read_points(*subject, complaints);
    if (lesson.volume == kScene) lesson.scene = read_scene_of(table, lesson.points.dim, complaints);
    return;
  }
  TomlTable own(*subject, "[boxes]", complaints);
  lesson.points.dim = static_cast<int>(own.integer_or("dim", 2, 3, 2));
  double taper = 1;
  if (lesson.volume == kFrustumBox) {
    taper = own.number("taper", 1);
    if (taper == 1) own.wrong("taper", "must be above 0 and below 1");
  }
  lesson.boxes = read_pair(own, lesson.points.dim, taper);
}

Lesson read(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "the lesson", complaints);
  Lesson lesson;
  read_head(table, lesson);
  for (const toml::table* section : table.tables("section"))
    lesson.sections.push_back(read_section(*section, complaints));
  if (lesson.sections.empty()) complaints.add(1, "the lesson has no [[section]]");
  read_subject(table, lesson, complaints);
  if (const toml::table* words = table.table("pseudocode")) read_pseudocode(*words, complaints, lesson);
  for (const toml::table* question : table.tables("question"))
    lesson.questions.push_back(read_question(*question, lesson, complaints));
  if (const toml::table* task = table.table("task"))
    lesson.task = lesson.boxes      ? read_box_task(*task, lesson, complaints)
                  : lesson.measures ? read_cost_task(*task, lesson, complaints)
                  : lesson.scene    ? read_scene_task(*task, lesson.algorithms, complaints)
                                    : read_task(*task, lesson.volume, lesson.points.dim, complaints);
  table.refuse_others();
  return lesson;
}

/// The file's name without folders and .toml.
std::string id_of(std::string_view name) {
  name.remove_prefix(std::min(name.find_last_of("/\\") + 1, name.size()));
  if (name.size() > 5 && name.substr(name.size() - 5) == ".toml") name.remove_suffix(5);
  return std::string(name);
}

}  // namespace

tl::expected<Lesson, InputError> read_lesson(std::string_view text, std::string_view name, Checked checked) {
  Complaints complaints(name);
  if (text.size() > kMostLessonBytes) {
    complaints.add(1, "the file is too long: a lesson has at most " + std::to_string(kMostLessonBytes) + " bytes");
    return tl::unexpected(*complaints.first());
  }
  const toml::parse_result parsed = toml::parse(text);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    complaints.add(static_cast<int>(error.source().begin.line), std::string(error.description()));
    return tl::unexpected(*complaints.first());
  }
  Lesson lesson = read(parsed.table(), complaints);
  lesson.id = id_of(name);
  if (!complaints.first() && checked == Checked::kAsRun) check_lesson(lesson, parsed.table(), complaints);
  if (complaints.first()) return tl::unexpected(*complaints.first());
  return lesson;
}

}  // namespace snug::lesson
