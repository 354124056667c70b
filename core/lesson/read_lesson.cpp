// Reads a lesson's TOML into a Lesson. check_lesson.cpp checks it as a whole.
#include <algorithm>

#include "geometry/generate.hpp"
#include "lesson/check_lesson.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_line.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {
namespace {

constexpr std::int64_t kVersion = 1;
constexpr std::int64_t kMostMinutes = 240;

/// The possible values of a lesson's "volume".
std::vector<std::string_view> volumes() {
  std::vector<std::string_view> names;
  for (const SubjectRow* row : subjects())
    if (row->chart.empty())
      for (const std::string_view volume : row->volumes()) names.push_back(volume);
  return names;
}

std::vector<std::string_view> charts() {
  std::vector<std::string_view> names;
  for (const SubjectRow* row : subjects())
    if (!row->chart.empty()) names.push_back(row->chart);
  return names;
}

std::vector<std::string_view> algorithm_names(const Lesson& lesson) {
  std::vector<std::string_view> names;
  for (const Method& method : lesson.subject->methods(lesson.volume)) names.push_back(method.name);
  return names;
}

std::string read_algorithm(TomlTable& table, std::string_view key, const Lesson& lesson) {
  std::string name = table.text(key);
  check_name(table, key, name, algorithm_names(lesson));
  return name;
}

std::vector<std::string_view> section_titles(const Lesson& lesson) {
  std::vector<std::string_view> titles;
  for (const Section& section : lesson.sections) titles.push_back(section.title);
  return titles;
}

/// Checks what can be checked of a link without running the lesson.
void check_link(const toml::table& section, const Link& link, const Lesson& lesson, Complaints& complaints) {
  const auto wrong = [&](const std::string& what) {
    complaints.add(line_in_text(section, "text", ':' + link.target + ')'), "\"text\" links to " + what);
  };
  const auto check = [&](std::string_view what, const auto& names) {
    if (!is_among(names, link.target))
      wrong(std::string(what) + " that is none of " + one_of(names) + ": " + link.target);
  };
  switch (link.kind) {
    case Link::Kind::kMesh: return check("a mesh", lesson.meshes);
    case Link::Kind::kAlgorithm: return check("an algorithm", lesson.algorithms);
    case Link::Kind::kStep:
      if (link.target.size() > 6 || link.target.find_first_not_of("0123456789") != std::string::npos)
        wrong("a step that is no number: " + link.target);
      break;
    case Link::Kind::kMark:  // a handle's name is known once the lesson runs
    case Link::Kind::kLesson: break;
  }
}

Section read_section(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[section]]", complaints);
  Section section;
  section.title = table.text("title");
  section.line = table.line_of("text");
  ProseFault fault;
  section.paragraphs = paragraphs_of(table.text("text"), fault);
  if (!fault.what.empty())
    complaints.add(line_in_text(toml, "text", fault.words, fault.paragraph), "\"text\" " + fault.what);
  section.facts = read_names(table, "facts", 0, lesson.subject->facts());
  if (table.has("algorithm")) section.algorithm = read_algorithm(table, "algorithm", lesson);
  for (const Paragraph& paragraph : section.paragraphs)
    for (const Stretch& stretch : paragraph)
      if (stretch.link) check_link(toml, *stretch.link, lesson, complaints);
  table.refuse_others();
  return section;
}

void read_choices(TomlTable& table, Question& question) {
  question.choices = table.texts("choices", 2);
  const std::string answer = table.text("answer");
  const auto found = std::find(question.choices.begin(), question.choices.end(), answer);
  if (found == question.choices.end() && !answer.empty()) table.wrong("answer", "is none of the choices: " + answer);
  question.answer = static_cast<int>(found - question.choices.begin());
}

/// Reads which step a question is about.
Gate read_gate(TomlTable& table, const Lesson& lesson) {
  const auto facts = lesson.subject->facts();
  Gate gate;
  gate.algorithm = read_algorithm(table, "algorithm", lesson);
  gate.fact = table.text("before");
  check_name(table, "before", gate.fact, facts);
  gate.occurrence = static_cast<int>(table.integer_or("nth", 1, 100000, 1));
  gate.after = table.text_or("after", "");
  if (gate.after != Gate::kStart) check_name(table, "after", gate.after, facts);
  gate.after_nth = static_cast<int>(table.integer_or("after_nth", 1, 100'000, 0));
  if (gate.after_nth > 0 && (gate.after.empty() || gate.after == Gate::kStart))
    table.wrong("after_nth", "counts the steps that \"after\" names");
  return gate;
}

/// Reads what is asked, with the keys for that kind of question.
void read_asking(TomlTable& table, const Lesson& lesson, Question& question) {
  question.asks = table.text("asks");
  std::vector<std::string_view> names{"choice"};
  if (lesson.subject->asks_of_steps) names.insert(names.begin(), "point");
  const Asking* asking = nullptr;
  for (const auto& [fact, one] : lesson.subject->askings()) {
    if (!is_among(names, one->name)) names.push_back(one->name);
    if (one->name == question.asks) asking = one;
  }
  check_name(table, "asks", question.asks, names);
  if (question.asks == "choice") read_choices(table, question);
  if (asking != nullptr && asking->read != nullptr) asking->read(table, question);
}

Question read_question(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[question]]", complaints);
  Question question;
  question.line = table.line();
  question.id = table.text("id");
  if (lesson.subject->asks_of_steps) question.gate = read_gate(table, lesson);
  question.prompt = table.text("prompt");
  read_asking(table, lesson, question);
  question.own_points = table.flag_or("own_points", false);
  question.because = table.text("because");
  question.prompt_here = table.text_or("prompt_here", "");
  question.because_here = table.text_or("because_here", "");
  question.section = table.text_or("section", "");
  if (!question.section.empty()) check_name(table, "section", question.section, section_titles(lesson));
  table.refuse_others();
  return question;
}

void read_task(const toml::table& toml, Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[task]", complaints);
  Task& task = lesson.task.emplace();
  task.prompt = table.text("prompt");
  task.algorithm = read_algorithm(table, "algorithm", lesson);
  task.hint = table.text("hint");
  lesson.subject->read_task(table, lesson, complaints);
  table.refuse_others();
}

void read_pseudocode(const toml::table& toml, Complaints& complaints, Lesson& lesson) {
  for (const auto& [key, node] : toml) {
    const auto line = static_cast<int>(key.source().begin.line);
    const Method* algorithm = find_method(lesson, key.str());
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
  lesson.title = table.text("title");
  lesson.summary = table.text("summary");
  lesson.minutes = static_cast<int>(table.integer("minutes", 1, kMostMinutes));
  lesson.covers = table.texts("covers", 0);
  lesson.seed = static_cast<std::uint64_t>(table.integer_or("seed", 0, 1LL << 53, 1));
  const std::string start = table.text_or("start", "begin");
  check_name(table, "start", start, std::array<std::string_view, 2>{"begin", "end"});
  lesson.start = start == "end" ? Lesson::Start::kEnd : Lesson::Start::kBegin;
  lesson.volume = table.text_or("volume", lesson.volume);
  check_name(table, "volume", lesson.volume, volumes());
  const std::string chart = table.text_or("chart", "");
  check_name(table, "chart", chart, charts());
  lesson.subject = find_subject(lesson.volume, chart);
  if (lesson.subject == nullptr) {
    table.wrong("chart", "is not of that volume");
    lesson.subject = subjects().front();  // so that reading can go on
  }
  lesson.algorithms = read_names(table, "algorithms", 1, algorithm_names(lesson));
  if (table.has("compare")) lesson.compare = read_algorithm(table, "compare", lesson);
  lesson.meshes = read_names(table, "meshes", 0, mesh_names());
  lesson.generators = read_names(table, "generators", 0, generator_kinds());
}

Lesson read(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "the lesson", complaints);
  Lesson lesson;
  read_head(table, lesson);
  for (const toml::table* section : table.tables("section"))
    lesson.sections.push_back(read_section(*section, lesson, complaints));
  if (lesson.sections.empty()) complaints.add(1, "the lesson has no [[section]]");
  if (table.table(lesson.subject->table) != nullptr) lesson.subject->read(table, lesson, complaints);
  else complaints.add(1, "the lesson lacks [" + std::string(lesson.subject->table) + "]");
  if (const toml::table* words = table.table("pseudocode")) read_pseudocode(*words, complaints, lesson);
  for (const toml::table* question : table.tables("question"))
    lesson.questions.push_back(read_question(*question, lesson, complaints));
  if (const toml::table* task = table.table("task")) read_task(*task, lesson, complaints);
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
  const auto toml = parse_file(text, "a lesson", complaints);
  if (!toml) return tl::unexpected(*complaints.first());
  Lesson lesson = read(*toml, complaints);
  lesson.id = id_of(name);
  if (!complaints.first() && checked == Checked::kAsRun) check_lesson(lesson, *toml, complaints);
  if (complaints.first()) return tl::unexpected(*complaints.first());
  return lesson;
}

}  // namespace snug::lesson
