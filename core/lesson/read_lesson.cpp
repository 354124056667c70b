// Reads a lesson's TOML into a Lesson. core/check checks it as a whole.
#include <algorithm>
#include <map>

#include "geometry/generate.hpp"
#include "lesson/beside.hpp"
#include "lesson/grade.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/read_situations.hpp"
#include "lesson/read_view.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_place.hpp"
#include "lesson/texts.hpp"
#include "lesson/toml_file.hpp"
#include "lesson/version.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
namespace {

constexpr std::int64_t kMostMinutes = 240;

/// The possible values of a lesson's "volume".
std::vector<std::string_view> volumes() {
  std::vector<std::string_view> names;
  for (const SubjectRow* row : subjects())
    if (row->experiment == nullptr)
      for (const std::string_view volume : row->volumes()) names.push_back(volume);
  return names;
}

std::vector<std::string_view> charts() {
  std::vector<std::string_view> names;
  for (const SubjectRow* row : subjects())
    if (row->experiment != nullptr) names.push_back(row->experiment->chart);
  return names;
}

std::vector<std::string_view> algorithm_names(const Lesson& lesson, std::string_view volume) {
  std::vector<std::string_view> names;
  for (const Method& method : lesson.subject->methods(volume)) names.push_back(method.name);
  return names;
}

/// The name that was probably meant, after a complaint; empty if that cannot be told. Reading goes on with it, so that
/// what follows from the mistake is not told as another.
std::string meant_name(TomlTable& table, std::string_view key, const std::string& name, const auto& names) {
  check_name(table, key, name.empty() ? " " : name, names);
  return is_among(names, name) ? name : std::string(nearest(names, name));
}

/// The lesson's name of an algorithm, "k8" or "kdop/k8". Complains if there is none.
std::string known_algorithm(TomlTable& table, std::string_view key, const std::string& name, const Lesson& lesson) {
  if (const Method* method = find_method(lesson, name)) return name_in(lesson, *method);
  const std::size_t slash = name.find('/');
  if (slash == std::string::npos) return meant_name(table, key, name, algorithm_names(lesson, lesson.volume));
  std::string volume = name.substr(0, slash), own = name.substr(slash + 1);
  const auto all = lesson.subject->volumes();
  const bool known = is_among(all, volume);
  if (!known) volume = meant_name(table, key, volume, all);
  if (volume.empty()) return {};
  const auto names = algorithm_names(lesson, volume);
  if (known) own = meant_name(table, key, own, names);
  const Method* method = is_among(names, own) ? find_method(lesson, volume + '/' + own) : nullptr;
  return method != nullptr ? name_in(lesson, *method) : std::string();
}

/// Reads one of the algorithms that the lesson offers.
std::string read_algorithm(TomlTable& table, std::string_view key, const Lesson& lesson) {
  const std::string name = table.text(key);
  const Method* method = find_method(lesson, name);
  if (!name.empty() && !lesson.algorithms.empty() && offered(lesson, name).empty()) {
    if (method != nullptr) table.wrong(key, "names an algorithm that the lesson does not offer: " + name);
    else check_name(table, key, name, lesson.algorithms);
  }
  return method != nullptr ? name_in(lesson, *method) : name;
}

/// Reads the volume: the file's own, or else that in the first algorithm's name.
void read_volume(TomlTable& table, Lesson& lesson) {
  const std::vector<std::string> names = table.texts("algorithms", 1);
  const std::size_t slash = names.empty() ? std::string::npos : names.front().find('/');
  if (slash != std::string::npos) lesson.volume = names.front().substr(0, slash);
  lesson.volume = table.text_or("volume", lesson.volume);
  const std::string_view key = table.has("volume") ? "volume" : "algorithms";
  if (!lesson.volume.empty()) lesson.volume = meant_name(table, key, lesson.volume, volumes());
}

void read_algorithms(TomlTable& table, Lesson& lesson) {
  for (const std::string& name : table.texts("algorithms", 0)) {
    std::string own = known_algorithm(table, "algorithms", name, lesson);
    if (is_among(lesson.algorithms, own)) table.wrong("algorithms", "names " + own + " twice");
    else if (!own.empty()) lesson.algorithms.push_back(std::move(own));
  }
  if (table.has("compare")) lesson.compare = read_algorithm(table, "compare", lesson);
  if (!lesson.compare.empty() && !lesson.algorithms.empty() && lesson.compare == lesson.algorithms.front())
    table.wrong("compare", "is the first algorithm itself");
  if (!table.has("reference")) return;
  lesson.reference = known_algorithm(table, "reference", table.text("reference"), lesson);
  if (!lesson.subject->compares) table.wrong("reference", "is for volumes fitted round points");
}

std::vector<std::string_view> section_titles(const Lesson& lesson) {
  std::vector<std::string_view> titles;
  for (const Section& section : lesson.sections)
    if (!section.title.empty()) titles.push_back(section.title);
  return titles;
}

/// Checks what can be checked of a link without running the lesson. Returns whether it can be followed.
bool check_link(const toml::table& section, const Stretch& stretch, const Lesson& lesson, Complaints& complaints) {
  const Link& link = *stretch.link;
  const auto wrong = [&](const std::string& what) {
    complaints.add(place_in_text(section, "text", stretch.at), "\"text\" links to " + what);
    return false;
  };
  const auto check = [&](std::string_view what, const auto& names) {
    if (lesson.algorithms.empty() || is_among(names, link.target)) return true;
    if (names.empty()) return wrong(std::string(what) + ", and the lesson offers none");
    return wrong(std::string(what) + " that " + none_of_text(link.target, names));
  };
  switch (link.kind) {
    case Link::Kind::kMesh: return check("a mesh", lesson.meshes);
    case Link::Kind::kAlgorithm:
      return !offered(lesson, link.target).empty() || check("an algorithm", lesson.algorithms);
    case Link::Kind::kStep: return is_step_number(link.target) || wrong("a step that is not a number: " + link.target);
    case Link::Kind::kSituation: return check("a situation", situation_names(lesson));
    case Link::Kind::kMark:  // a handle's name is known once the lesson runs
    case Link::Kind::kLesson: break;
  }
  return true;
}

Section read_section(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[section]]", complaints);
  Section section;
  section.title = table.text("title");
  section.place = table.place_of("text");
  std::vector<ProseFault> faults;
  if (!table.text("text").empty()) section.blocks = blocks_of(text_of(toml, "text"), faults);
  for (const ProseFault& fault : faults)
    complaints.add(place_in_text(toml, "text", fault.at), "\"text\" " + fault.what);
  section.facts = read_names(table, "facts", 0, lesson.subject->facts());
  if (table.has("algorithm")) section.algorithm = read_algorithm(table, "algorithm", lesson);
  section.situation = read_situation(table, lesson, "");
  for (Block& block : section.blocks)
    for (std::vector<Paragraph>& row : block.rows)
      for (Paragraph& cell : row)
        for (Stretch& stretch : cell)
          if (stretch.link && !check_link(toml, stretch, lesson, complaints)) stretch.link.reset();
  table.refuse_others();
  return section;
}

/// Reads which step a question is about. Whether there are such steps is checked on the run (core/check).
Gate read_gate(TomlTable& table, const Lesson& lesson) {
  Gate gate;
  gate.algorithm = read_algorithm(table, "algorithm", lesson);
  gate.fact = table.text("before");
  gate.fact_place = table.place_of("before");
  gate.occurrence = static_cast<int>(table.integer_or("nth", 1, 100000, 1));
  gate.after = table.text_or("after", "");
  gate.after_place = table.place_of("after");
  gate.after_nth = static_cast<int>(table.integer_or("after_nth", 1, 100'000, 0));
  if (gate.after_nth > 0 && (gate.after.empty() || gate.after == Gate::kStart))
    table.wrong("after_nth", "needs \"after\", whose steps it counts");
  return gate;
}

/// Reads what is asked, with the keys for that kind of question.
void read_asking(TomlTable& table, const Lesson& lesson, Question& question) {
  question.asks = table.text("asks");
  std::vector<std::string_view> names = general_question_kinds(*lesson.subject);
  const QuestionKind* const general = general_question_kind(question.asks, *lesson.subject);
  const QuestionKind* kind = general;
  const bool known = is_among(lesson.subject->facts(), question.gate.fact);
  for (const auto& [fact, one] : lesson.subject->question_kinds()) {
    if (one->name == question.asks) kind = one;
    const bool fits = !known || fact.empty() || fact == question.gate.fact;
    if (fits && !is_among(names, one->name)) names.push_back(one->name);
  }
  if (kind != nullptr) names.push_back(kind->name);  // of another fact: what it asks of is told on the run
  check_name(table, "asks", question.asks, names);
  if (kind != nullptr && kind->read != nullptr) return kind->read(table, question);
  if (general != nullptr && general->read != nullptr) return general->read(table, question);  // decided in another way
  if (kind != nullptr) return;
  for (const std::string_view key : {"choices", "answer", "figure", "bounds", "tolerance"}) table.allow(key);
}

/// Reads what wrong answers mean: a table from answers to sentences.
void read_meanings(TomlTable& table, Question& question) {
  const toml::table* wrong = table.table("wrong");
  if (wrong == nullptr) return;
  for (const auto& [key, node] : *wrong) {
    const auto* text = node.as_string();
    if (text == nullptr || text->get().empty()) return table.wrong("wrong", "must give each answer a text in quotes");
    question.meanings.push_back({std::string(key.str()), text->get(), file_place(key.source())});
  }
}

/// Reads of which runs the answer is true.
void read_truth(TomlTable& table, const Lesson& lesson, Question& question, Complaints& complaints) {
  question.conditions = read_requirements(table, lesson, complaints);
  const std::string holds = table.text_or("holds", "always");
  check_name(table, "holds", holds, std::array<std::string_view, 2>{"always", "here"});
  question.holds = holds == "here" ? Holds::kHere : Holds::kAlways;
  if (question.asks == "choice" && !table.has("require") && !table.has("holds"))
    table.lack("holds",
               "a choice needs \"holds\": \"always\", or \"here\" if its answer is true only of the lesson's own "
               "stage; or a [[question.require]]");
}

/// Whether reading some keys of a table finds no mistake.
template <class Read>
bool reads_soundly(const TomlTable& table, const Complaints& complaints, Read read) {
  const std::size_t mistakes = complaints.count(), missing = table.missing();
  read();
  return complaints.count() == mistakes && table.missing() == missing;
}

Question read_question(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[question]]", complaints);
  const std::size_t before = complaints.count();
  Question question;
  question.place = table.place();
  question.figure_place = table.place_of("figure");
  question.id = table.text("id");
  question.predicts = lesson.subject->experiment != nullptr;
  if (!question.predicts) question.gate = read_gate(table, lesson);
  question.prompt = table.text("prompt");
  question.can_be_asked = reads_soundly(table, complaints, [&] { read_asking(table, lesson, question); });
  read_truth(table, lesson, question, complaints);
  read_meanings(table, question);
  question.situation = read_situation(table, lesson, kOwnSituation);
  question.because = table.text("because");
  question.prompt_here = table.text_or("prompt_here", "");
  question.because_here = table.text_or("because_here", "");
  question.section = table.text_or("section", "");
  if (!question.section.empty()) check_name(table, "section", question.section, section_titles(lesson));
  question.sound = complaints.count() == before;
  question.sound = table.refuse_others() && question.sound;
  return question;
}

Task read_task(const toml::table& toml, const Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "[[task]]", complaints);
  const std::size_t before = complaints.count();
  Task task;
  task.place = table.place();
  task.prompt = table.text("prompt");
  task.algorithm = table.has("algorithm") || lesson.algorithms.empty() ? read_algorithm(table, "algorithm", lesson)
                                                                       : lesson.algorithms.front();
  task.points = static_cast<int>(table.integer_or("points", 1, 100'000, 0));
  if (table.has("only")) task.only = table.texts("only", 1);
  task.only_place = table.place_of("only");
  task.hint = table.text("hint");
  task.situation = read_situation(table, lesson, kOwnSituation);
  task.model_place = table.place_of("model");
  task.can_be_solved = reads_soundly(table, complaints, [&] {
    const std::size_t so_far = complaints.count();
    task.conditions = read_requirements(table, lesson, complaints);
    if (task.conditions.empty() && complaints.count() == so_far)
      table.lack("require", "the task has no [[task.require]]");
    task.searched = table.is("model", kSearch);
    if (!task.searched) task.model = lesson.subject->read_model(table, lesson_in(lesson, task.situation), complaints);
  });
  task.sound = complaints.count() == before;
  task.sound = table.refuse_others() && task.sound;
  return task;
}

void read_tasks(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  for (const toml::table* one : table.tables("task")) lesson.tasks.push_back(read_task(*one, lesson, complaints));
}

void read_pseudocode(const toml::table& toml, Complaints& complaints, Lesson& lesson) {
  for (const auto& [key, node] : toml) {
    const FilePlace place = file_place(key.source());
    const Method* algorithm = find_method(lesson, key.str());
    if (algorithm == nullptr) complaints.add(place, "[pseudocode] " + none_of_text(key.str(), lesson.algorithms));
    else if (!node.is_table())
      complaints.add(place, "[pseudocode] has a table for each algorithm: [pseudocode.ritter]");
    if (algorithm == nullptr || !node.is_table()) continue;
    TomlTable table(*node.as_table(), "[pseudocode." + std::string(key.str()) + "]", complaints);
    Pseudocode words{std::string(key.str()), table.texts("lines", 1)};
    const std::size_t due = algorithm->pseudocode.size();
    if (words.lines.size() != due)
      table.wrong("lines", "must be " + std::to_string(due) + ", as many as the program's, and not " +
                               std::to_string(words.lines.size()));
    table.refuse_others();
    if (words.lines.size() == due) lesson.pseudocode.push_back(std::move(words));
  }
}

/// Reads what the stage is about, and the methods. Returns whether that has no mistakes.
bool read_subject(TomlTable& table, Lesson& lesson, const Complaints& complaints) {
  const std::size_t before = complaints.count();
  read_volume(table, lesson);
  const std::string chart = table.text_or("chart", "");
  check_name(table, "chart", chart, charts());
  lesson.subject = find_subject(lesson.volume, chart);
  if (lesson.subject == nullptr) {
    if (complaints.count() == before) table.wrong("chart", "is not of that volume");
    lesson.subject = subjects().front();  // so that reading can go on; the algorithms are of an unknown volume
    for (const std::string_view key : {"compare", "reference"}) table.text_or(key, "");
    return false;
  }
  read_algorithms(table, lesson);
  return !lesson.algorithms.empty();  // those that there are can be shown
}

void read_head(TomlTable& table, Lesson& lesson) {
  lesson.title = table.text("title");
  lesson.summary = table.text("summary");
  lesson.minutes = static_cast<int>(table.integer("minutes", 1, kMostMinutes));
  lesson.covers = table.texts("covers", 0);
  lesson.source = table.text_or("source", "");
  lesson.seed = static_cast<std::uint64_t>(table.integer_or("seed", 0, 1LL << 53, 1));
  const std::string start = table.text_or("start", "begin");
  check_name(table, "start", start, std::array<std::string_view, 2>{"begin", "end"});
  lesson.start = start == "end" ? Lesson::Start::kEnd : Lesson::Start::kBegin;
  lesson.meshes = read_names(table, "meshes", 0, mesh_names());
  lesson.generators = read_names(table, "generators", 0, generator_kinds());
}

void read_questions(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  std::map<std::string, int> lines;  // of the ids so far
  for (const toml::table* one : table.tables("question")) {
    Question question = read_question(*one, lesson, complaints);
    const auto [other, is_new] = lines.emplace(question.id, question.place.line);
    if (!is_new && !question.id.empty()) {
      complaints.add(question.place, "there is another question with the id " + question.id + ", in line " +
                                         std::to_string(other->second));
      question.sound = false;
    }
    lesson.questions.push_back(std::move(question));
  }
}

/// Reads the lesson's own table and its situations.
Stages read_stages(TomlTable& table, Lesson& lesson, bool known, Complaints& complaints) {
  Stages stages;
  const std::string own(lesson.subject->table);
  const std::size_t before = complaints.count();
  if (table.table(own) != nullptr) lesson.subject->read(table, lesson, complaints);
  else if (known && !table.has(own)) table.lack(own, "the lesson lacks [" + own + "]");
  if (!table.has(own) || complaints.count() > before) stages.unread.emplace_back(kOwnSituation);
  read_situations(table, lesson, stages.unread, complaints);
  stages.sound = table.has(own) && complaints.count() == before;
  return stages;
}

/// Reads the lesson. What has mistakes is read as well, as far as it can be checked further. None if the stage cannot
/// be known.
std::optional<Stages> read(const toml::table& toml, Lesson& lesson, Complaints& complaints) {
  TomlTable table(toml, "the lesson", complaints);
  const std::int64_t version = table.integer("version", 1, 1000000);
  if (version != kLessonVersion && table.has("version")) {  // then its keys are no mistakes
    if (version == 1 && toml["version"].is_integer()) return tell_changes(toml, complaints), std::nullopt;
    return table.wrong("version", "is not one that this program reads: it reads 2"), std::nullopt;
  }
  read_head(table, lesson);
  const bool sound = read_subject(table, lesson, complaints);
  Stages stages = read_stages(table, lesson, sound || !lesson.algorithms.empty(), complaints);
  read_sliders(table, lesson, complaints);
  for (const toml::table* section : table.tables("section"))
    lesson.sections.push_back(read_section(*section, lesson, complaints));
  if (lesson.sections.empty()) table.lack("section", "the lesson has no [[section]]");
  lesson.view = read_view(table, complaints);
  lesson.beside = read_beside(table, lesson.points.dim, complaints);
  if (const toml::table* words = table.table("pseudocode")) read_pseudocode(*words, complaints, lesson);
  read_questions(table, lesson, complaints);
  if (table.has(lesson.subject->table)) read_tasks(table, lesson, complaints);
  else table.allow("task");  // its model is read as what stands on the stage is
  read_texts(toml, lesson, complaints);
  table.refuse_others();
  return sound ? std::optional(std::move(stages)) : std::nullopt;
}

/// The lessons that a file links to, and the ideas that it covers.
std::vector<NameBeside> names_beside(const toml::table& toml, const Lesson& lesson) {
  std::vector<NameBeside> names;
  const toml::array* sections = toml["section"].as_array();
  for (std::size_t i = 0; i < lesson.sections.size(); ++i)
    for (const Stretch* stretch : stretches_of(lesson.sections[i]))
      if (stretch->link && stretch->link->kind == Link::Kind::kLesson)
        names.push_back(
            {stretch->link->target, false, place_in_text(*sections->get(i)->as_table(), "text", stretch->at)});
  if (const toml::array* covers = toml["covers"].as_array())
    for (const toml::node& idea : *covers)
      if (const auto* text = idea.as_string()) names.push_back({text->get(), true, file_place(idea)});
  return names;
}

Block plain_block(const std::string& words) { return {.rows = {{{{.text = words}}}}}; }

/// A case's sentence is its first paragraph, and its source a section of its own. Neither is text of the file's
/// sections, which the checks go through.
void add_case_words(Lesson& lesson) {
  if (lesson.source.empty()) return;
  if (!lesson.sections.empty()) {  // a file without any is refused, but not before this
    auto& first = lesson.sections.front().blocks;
    first.insert(first.begin(), plain_block(lesson.summary));
  }
  const std::string words = lesson.source.substr(0, lesson.source.find(" https:"));  // a column is too narrow for more
  lesson.sections.push_back({.title = "Where it was seen", .blocks = {plain_block(words)}});
}

}  // namespace

std::uint64_t hash_of_text(std::string_view text) {
  Fnv1a hash;
  for (const char c : text) hash.add_bits(static_cast<unsigned char>(c));
  return hash.value();
}

std::string id_of(std::string_view name) {
  name.remove_prefix(std::min(name.find_last_of("/\\") + 1, name.size()));
  if (name.size() > 5 && name.substr(name.size() - 5) == ".toml") name.remove_suffix(5);
  return std::string(name);
}

Reading read_file(std::string_view text, std::string_view name, Complaints& complaints) {
  Reading reading;
  reading.toml = parse_file(text, "a lesson", complaints);
  if (!reading.toml) return reading;
  reading.lesson.id = id_of(name);
  reading.stages = read(*reading.toml, reading.lesson, complaints);
  reading.names_beside = names_beside(*reading.toml, reading.lesson);
  return reading;
}

bool check_gate(const Gate& gate, const SubjectRow& subject, const std::vector<std::string_view>& fits,
                Complaints& complaints) {
  const std::size_t before = complaints.count();
  const auto check = [&](std::string_view key, const std::string& fact, FilePlace place) {
    const std::string of = gate.algorithm.empty() ? "" : " of " + gate.algorithm;
    if (!fact.empty() && !is_among(subject.facts(), fact))
      complaints.add(place, '"' + std::string(key) + '"' + of + " " + none_of_text(fact, fits));
  };
  check("before", gate.fact, gate.fact_place);
  if (!gate.after.empty() && gate.after != Gate::kStart) check("after", gate.after, gate.after_place);
  return complaints.count() == before;
}

void check_gates(Lesson& lesson, Complaints& complaints) {
  std::erase_if(lesson.questions, [&](const Question& question) {
    return !question.predicts && !check_gate(question.gate, *lesson.subject, lesson.subject->facts(), complaints);
  });
}

void keep_sound(Lesson& lesson) {
  const auto is_unsound = [](const auto& one) { return !one.sound; };
  std::erase_if(lesson.sliders, is_unsound);
  std::erase_if(lesson.tasks, is_unsound);
  std::erase_if(lesson.questions, is_unsound);
}

std::optional<Lesson> read_as_written(const toml::table& toml, std::string_view name, Complaints& complaints) {
  Lesson lesson;
  lesson.id = id_of(name);
  const auto stages = read(toml, lesson, complaints);
  if (!stages) return std::nullopt;
  check_gates(lesson, complaints);
  keep_sound(lesson);
  if (!stages->sound) return std::nullopt;
  return lesson;
}

Draft finished(Reading reading, bool draws, const Complaints& complaints) {
  Draft draft{{}, complaints.mistakes(), complaints.warnings(), std::move(reading.names_beside)};
  if (draws) add_case_words(reading.lesson), draft.lesson = std::move(reading.lesson);
  return draft;
}

Draft read_draft(std::string_view text, std::string_view name) {
  Complaints complaints(name);
  Reading reading = read_file(text, name, complaints);
  const bool draws = reading.stages && reading.stages->sound;
  if (reading.stages) check_gates(reading.lesson, complaints), keep_sound(reading.lesson);
  return finished(std::move(reading), draws, complaints);
}

tl::expected<Lesson, InputError> read_lesson(std::string_view text, std::string_view name) {
  Draft draft = read_draft(text, name);
  if (!draft.mistakes.empty()) return tl::unexpected(draft.mistakes.front().error());
  return *std::move(draft.lesson);
}

}  // namespace snug::lesson
