// snug lesson table: what lessons/README.md lists of the subjects, made from the code.
#include <algorithm>
#include <string>
#include <vector>

#include "desktop/cli/lesson_commands.hpp"
#include "geometry/kdop.hpp"
#include "lesson/ask.hpp"
#include "lesson/names.hpp"
#include "lesson/playable.hpp"
#include "lesson/subjects.hpp"
#include "lesson/words.hpp"

namespace snug::desktop {
namespace {

struct TableOptions {};

/// "`pair`, `frustum`"; a dash for none.
std::string in_code(const auto& names) {
  std::string text;
  for (const auto& name : names) ((text += text.empty() ? "`" : ", `") += name) += '`';
  return text.empty() ? "–" : text;
}

std::string step_rows(const lesson::SubjectRow& row) {
  std::string text;
  for (const std::string_view fact : row.facts()) {
    std::vector<std::string_view> own;
    for (const auto& [of, kind] : row.question_kinds())
      if (of == fact) own.push_back(kind->name);
    text += "| `" + std::string(row.name) + "` | `" + std::string(fact) + "` | " + in_code(own) + " |\n";
  }
  return text;
}

/// The keys of the figures that the results of a volume's algorithms have.
struct VolumeFigures {
  const lesson::SubjectRow* subject;
  std::string_view volume;
  std::vector<std::string> keys;
};

/// All algorithms of a sample's volume, as a lesson's file lists them.
std::string all_algorithms(const lesson::SubjectRow& subject, const lesson::StageSample& sample) {
  std::string list;
  for (const lesson::Method& method : subject.methods(sample.volume))
    ((list += list.empty() ? "\"" : ", \"") += method.name) += '"';
  return list;
}

/// The sample as a whole lesson.
std::string lesson_on(const lesson::SubjectRow& subject, const lesson::StageSample& sample) {
  std::string text = "version = 2\ntitle = \"Sample\"\nsummary = \"Sample.\"\nminutes = 1\nvolume = \"";
  ((text += sample.volume) += "\"\nalgorithms = [") +=
      sample.algorithms.empty() ? all_algorithms(subject, sample) : std::string(sample.algorithms);
  text += "]\n";
  if (subject.experiment != nullptr) ((text += "chart = \"") += subject.experiment->chart) += "\"\n";
  return (text += sample.tables) += "\n[[section]]\ntitle = \"Sample\"\ntext = \"Sample.\"\n";
}

VolumeFigures& figures_for(std::vector<VolumeFigures>& all, const lesson::SubjectRow* subject,
                           std::string_view volume) {
  for (VolumeFigures& one : all)
    if (one.subject == subject && one.volume == volume) return one;
  return all.emplace_back(VolumeFigures{subject, volume, {}});
}

/// Adds what the results on a sample have. Those of algorithms of another volume count where the sample names them all.
tl::expected<void, InputError> add_figures(std::vector<VolumeFigures>& all, const lesson::SubjectRow& subject,
                                           const lesson::StageSample& sample) {
  auto read = lesson::read_lesson(lesson_on(subject, sample), "sample.toml");
  if (!read) return tl::unexpected(std::move(read.error()));
  auto session = lesson::Session::open(*std::move(read));
  if (!session) return tl::unexpected(std::move(session.error()));
  const lesson::Lesson& own = session->lesson();
  for (const std::string& name : lesson::playable(*session)) {
    const lesson::Method& method = *lesson::find_method(own, name);
    const std::string_view volume = method.volume.empty() ? sample.volume : method.volume;
    std::vector<std::string>& keys = figures_for(all, own.subject, volume).keys;
    for (const lesson::Figure& figure : session->stage().subject().results(method, session->player().view()))
      if (!lesson::is_among(keys, figure.key)) keys.push_back(figure.key);
  }
  return {};
}

/// What tasks and conditions may require: a row for each subject and volume, one for volumes that are alike.
std::string figure_rows(const std::vector<VolumeFigures>& all, const lesson::SubjectRow& row) {
  std::string text;
  std::vector<std::vector<std::string>> told;
  for (const VolumeFigures& one : all) {
    if (one.subject != &row || std::find(told.begin(), told.end(), one.keys) != told.end()) continue;
    told.push_back(one.keys);
    std::vector<std::string_view> alike;
    for (const VolumeFigures& other : all)
      if (other.subject == &row && other.keys == one.keys) alike.push_back(other.volume);
    text += "| `" + std::string(row.name) + "` | " + in_code(alike) + " | " + in_code(one.keys) + " |\n";
  }
  return text;
}

template <int Dim>
void add_directions(std::string& text, int k) {
  std::string names;
  for (const auto& axis : kdop_axes<Dim>(k)) {
    Vector<double, 3> direction = Vector<double, 3>::Zero();
    for (int i = 0; i < Dim; ++i) direction[i] = axis[i];
    names += (names.empty() ? "" : ", ") + lesson::axis_name(direction);
  }
  text += "| " + std::to_string(Dim) + "-D | `k" + std::to_string(k) + "` | " + names + " |\n";
}

std::string direction_rows() {
  std::string text = "\n| points | k-DOP | the directions of its slabs, in their order |\n|---|---|---|\n";
  for (const int k : {4, 6, 8}) add_directions<2>(text, k);
  for (const int k : {6, 14, 18, 26}) add_directions<3>(text, k);
  return text;
}

CommandResult run_table(const TableOptions&) {
  std::vector<VolumeFigures> figures;
  for (const lesson::SubjectRow* row : lesson::subjects())
    for (const lesson::StageSample& sample : row->samples)
      if (const auto added = add_figures(figures, *row, sample); !added) return bad_input(added.error());
  Printed printed{"| subject | asked of every step | asked without a step | goals |\n|---|---|---|---|\n"};
  for (const lesson::SubjectRow* row : lesson::subjects()) {
    std::vector<std::string_view> alone;
    for (const auto& [of, kind] : row->question_kinds())
      if (of.empty()) alone.push_back(kind->name);
    printed.text += "| `" + std::string(row->name) + "` | " + in_code(lesson::general_question_kinds(*row)) + " | " +
                    in_code(alone) + " | " + in_code(row->goals) + " |\n";
  }
  printed.text += "\n| subject | of | figures that a task may require |\n|---|---|---|\n";
  for (const lesson::SubjectRow* row : lesson::subjects())
    printed.text += row->task_figures.empty()
                        ? figure_rows(figures, *row)
                        : "| `" + std::string(row->name) + "` | – | " + in_code(row->task_figures) + " |\n";
  printed.text += "\n| subject | step | what it can be asked besides |\n|---|---|---|\n";
  for (const lesson::SubjectRow* row : lesson::subjects()) printed.text += step_rows(*row);
  printed.text += direction_rows();
  return printed;
}

}  // namespace

void add_lesson_table(Commands& commands, CLI::App& group) {
  CLI::App& table = *group.add_subcommand("table", "Print what lessons can ask and require");
  table.footer(
      "Four tables in Markdown, as lessons/README.md has them: for each subject what can be asked of every step and\n"
      "the goals that a task may name; the figures that a task may require of each volume's results; for each step\n"
      "what else it can be asked; and the directions of each k-DOP's slabs.");
  add_command<TableOptions>(commands, table, run_table);
}

}  // namespace snug::desktop
