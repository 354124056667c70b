// snug grade: replays the decisions of result files, and reports what they earn.
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>

#include "desktop/cli/command.hpp"
#include "desktop/cli/exercise_files.hpp"
#include "desktop/cli/grade_written.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/cli/machines.hpp"
#include "desktop/cli/progress.hpp"
#include "desktop/cli/result_file.hpp"
#include "desktop/cli/terminal.hpp"
#include "desktop/cli/words.hpp"
#include "desktop/window.hpp"
#include "io/text.hpp"
#include "lesson/exercise/sitting.hpp"
#include "lesson/figures.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

using Cells = std::vector<std::string>;

struct GradeOptions {
  std::string folder;
  std::vector<std::string> paths;
  bool csv = false, json = false, by_student = false, alike = false, watch = false, tables = false;
  std::string output = "-";  // of the tables
  int attempt = 1;           // the one to watch
};

/// A row of the report: an attempt, a lab sheet, or a file of which none could be read.
struct Row {
  std::string file, student, exercise;
  std::uint64_t seed = 0;
  int level = 0;
  double mark = 0;
  int of = 0;
  std::optional<double> claimed;
  std::string status = "ok", says;
  std::vector<std::string> decisions;  // without their times
  std::vector<std::string> timed;
  bool is_sheet = false;
  std::size_t place = 0;                                     // of a lab sheet among all; one that is unknown is last
  std::string missing;                                       // of a lab sheet: "3 of 4 parts are missing."
  SheetWork work;                                            // of a lab sheet
  std::vector<std::pair<std::string, std::string>> answers;  // its questions, and what was written
  std::vector<std::string> built;                            // what is said of each example
};

using Exercises = std::map<std::string, std::shared_ptr<const lesson::Exercise>>;
using Sheets = std::vector<std::shared_ptr<const lesson::Sheet>>;  // in the order of their course

/// What a result can be graded by.
struct Known {
  Exercises exercises;
  Sheets sheets;
  bool tries_code = true;  // which takes a compiler, and seconds
};

void grade_row(Row& row, const Claimed& claimed, const std::string& version, const Known& known) {
  const auto be = [&](const char* status, std::string says) { row.status = status, row.says = std::move(says); };
  const lesson::Attempt& attempt = claimed.attempt;
  row.exercise = attempt.exercise, row.seed = attempt.seed, row.level = attempt.level, row.claimed = claimed.mark;
  for (const lesson::Made& made : attempt.made) {
    row.timed.push_back(text_of(made));
    row.decisions.push_back(row.timed.back().substr(0, row.timed.back().find('@')));
  }
  if (claimed.code) {
    if (!known.tries_code) return;
    const GradedCode graded = grade_written(claimed, version);
    row.mark = graded.mark, row.of = graded.of;
    if (graded.status != "ok") return be(graded.status.c_str(), graded.says);
  } else {
    const auto exercise = known.exercises.find(attempt.exercise);
    if (exercise == known.exercises.end()) return be("foreign", "there is no such exercise here");
    if (exercise->second->hash != attempt.hash)
      return be(status_of_another(version), "the exercise was another when this was done");
    const auto graded = lesson::grade(exercise->second, attempt);
    if (!graded) return be("damaged", graded.error().what);
    row.mark = graded->mark, row.of = graded->of;
  }
  if (!claimed.mark) be("differs", "it claims no mark");
  else if (*claimed.mark != row.mark) be("differs", "it claims what it does not earn");
}

/// The examples earn a mark each, judged anew. What was written and measured is for people to read.
void grade_sheet(Row& row, const ClaimedSheet& claimed, const std::string& version, const Sheets& sheets) {
  row.is_sheet = true, row.exercise = claimed.sheet, row.work = claimed.work;
  const auto known =
      std::find_if(sheets.begin(), sheets.end(), [&](const auto& one) { return one->lesson.id == claimed.sheet; });
  row.place = static_cast<std::size_t>(known - sheets.begin());
  if (known == sheets.end()) return static_cast<void>(row.status = "foreign", row.says = "there is no such sheet here");
  const lesson::Sheet& sheet = **known;
  for (const lesson::Written& written : sheet.written) {
    const auto answer = row.work.written.find(written.id);
    row.answers.emplace_back(written.prompt, answer != row.work.written.end() ? answer->second : "");
  }
  if (hex_of(sheet.hash) != claimed.hash)
    return static_cast<void>(row.status = status_of_another(version),
                             row.says = "the sheet was another when this was done");
  row.missing = missing_of(sheet, row.work);
  row.of = static_cast<int>(sheet.lesson.tasks.size());
  for (const auto& [task, rows] : row.work.built) {
    const auto judged = judge_built(sheet, task, rows);
    if (!judged) return static_cast<void>(row.status = "damaged", row.says = judged.error().what);
    row.mark += judged->met ? 1 : 0;
    row.built.push_back("Example of " + std::to_string(rows.size()) + (rows.size() == 1 ? " point: " : " points: ") +
                        judged->says);
    if (!judged->met) row.status = "differs", row.says = "an example is not what it is handed in as";
  }
}

std::vector<Row> grade_file(const std::string& path, const Known& known) {
  const auto bad = [&](const char* status, std::string says) {
    Row row{.file = path};
    row.status = status, row.says = std::move(says);
    return std::vector<Row>{row};
  };
  std::error_code error;
  if (path != "-" && !fs::exists(path, error) && !error) return bad("missing", "there is no such file");
  const auto text = read_file(path);
  if (!text) return bad("damaged", text.error().what);
  const auto file = read_result(*text);
  if (!file) return bad(file.error().foreign ? "foreign" : "damaged", file.error().what);
  if (file->format != kResultFormat)
    return bad(file->format > kResultFormat ? "newer" : "older", "its format is " + std::to_string(file->format));
  if (file->attempts.empty() && file->sheets.empty()) {
    std::vector<Row> one = bad("missing", "it has no attempt");
    one.front().student = file->student;
    return one;
  }
  std::vector<Row> rows;
  for (const auto& claimed : file->attempts) {
    Row row{.file = path, .student = file->student};
    if (claimed) grade_row(row, *claimed, file->version, known);
    else row.status = "damaged", row.says = claimed.error();
    rows.push_back(std::move(row));
  }
  for (const auto& claimed : file->sheets) {
    Row row{.file = path, .student = file->student};
    if (claimed) grade_sheet(row, *claimed, file->version, known.sheets);
    else row.status = "damaged", row.says = claimed.error();
    rows.push_back(std::move(row));
  }
  return rows;
}

/// What there is to grade: files, and rows in the place of what is none.
struct ToGrade {
  std::vector<std::string> files;
  std::vector<Row> rows;
};

/// Adds a folder's result files, and those of the folders in it, by name. What cannot be read is a row: it must not end
/// the grading of everything else.
void add_folder(const std::string& path, ToGrade& found) {
  const auto add_row = [&](const std::string& file, const char* status, std::string says) {
    Row row{.file = file};
    row.status = status, row.says = std::move(says);
    found.rows.push_back(std::move(row));
  };
  std::vector<std::string> inside;
  const std::size_t rows = found.rows.size();
  for (std::vector<fs::path> folders{path}; !folders.empty();) {
    const fs::path folder = folders.back();
    folders.pop_back();
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed)) {
      const std::string own = entry->path().string();
      std::error_code wrong;  // with a file: what it is is told when it is read
      if (entry->is_directory(wrong) && !entry->is_symlink(wrong)) folders.push_back(entry->path());
      else if (ending_of(own) == "json" && (entry->is_regular_file(wrong) || wrong)) inside.push_back(own);
    }
    if (failed) add_row(folder.string(), "damaged", "cannot be read: " + failed.message());
  }
  std::sort(inside.begin(), inside.end());
  if (inside.empty() && found.rows.size() == rows) add_row(path, "missing", "there is no result file (*.json) in it");
  found.files.insert(found.files.end(), inside.begin(), inside.end());
}

ToGrade find_files(const std::vector<std::string>& paths) {
  ToGrade found;
  for (const std::string& path : paths) {
    std::error_code error;
    if (fs::is_directory(path, error)) add_folder(path, found);
    else found.files.push_back(path);
  }
  return found;
}

/// What people read of a lab sheet, under the table.
std::string sheet_text(const Row& row) {
  const std::string who = (row.student.empty() ? "" : row.student + ", ") + row.file + ": " + row.exercise;
  std::string text = '\n' + without_controls(who) + '\n';
  for (const auto& [part, measured] : row.work.measured) {
    const Json& about = measured.table["provenance"];
    text += "  Measured on " + measured.date + ": " + std::to_string(measured.table["rows"].size()) + " rows on " +
            about["points"].get<std::string>() + ", " + about["processor"].get<std::string>() + ", " +
            about["build"].get<std::string>() + '\n';
  }
  if (!row.missing.empty()) text += "  " + row.missing + '\n';
  for (const std::string& says : row.built) text += "  " + says + '\n';
  for (const auto& [prompt, answer] : row.answers)
    text +=
        "  " + prompt + "\n      " + (answer.empty() ? "(nothing written)" : replaced(answer, "\n", "\n      ")) + '\n';
  return without_controls(text, true);
}

Json json_of(const Row& row) {
  if (row.is_sheet) {
    Json json{{"file", row.file}, {"student", row.student}, {"sheet", row.exercise},
              {"mark", row.mark}, {"of", row.of},           {"status", row.status}};
    if (!row.says.empty()) json["says"] = row.says;
    const Json work = json_of(row.exercise, 0, row.work);
    for (const char* key : {"written", "measured", "built"}) json[key] = work[key];
    json["examples"] = row.built;
    return json;
  }
  Json json{{"file", row.file},
            {"student", row.student},
            {"exercise", row.exercise},
            {"seed", row.seed},
            {"mark", row.mark},
            {"of", row.of},
            {"claimed", row.claimed ? Json(*row.claimed) : Json()},
            {"status", row.status}};
  if (row.level > 0) json["level"] = row.level;
  if (!row.says.empty()) json["says"] = row.says;
  return json;
}

/// The minus sign is a hyphen, which spreadsheets read.
std::string number(double value) { return replaced(lesson::plain_number(value), "−", "-"); }

Cells cells_of(const Row& row) {
  return {row.file,
          row.student,
          row.exercise,
          row.exercise.empty() || row.is_sheet ? "" : std::to_string(row.seed),
          number(row.mark),
          std::to_string(row.of),
          row.claimed ? number(*row.claimed) : "",
          row.status};
}

/// One row a student: the best attempt at each exercise counts.
std::vector<Cells> by_student(const std::vector<Row>& rows) {
  std::map<std::string, std::map<std::string, const Row*>> best;
  std::map<std::string, std::string> status;
  std::vector<std::string> order;
  for (const Row& row : rows) {
    const std::string who = row.student.empty() ? row.file : row.student;
    if (best.find(who) == best.end()) order.push_back(who), status[who] = "ok";
    const Row*& own = best[who][row.exercise];
    if (row.status != "ok") status[who] = row.status;
    if (row.of > 0 && (own == nullptr || row.mark * own->of > own->mark * row.of)) own = &row;
  }
  std::vector<Cells> table;
  for (const std::string& who : order) {
    double mark = 0;
    int of = 0, exercises = 0;
    for (const auto& [exercise, row] : best[who])
      if (row != nullptr) mark += row->mark, of += row->of, ++exercises;
    table.push_back({who, std::to_string(exercises), number(mark), std::to_string(of), status[who]});
  }
  return table;
}

/// Whether a spreadsheet takes a cell for a formula: a number is none, and neither is -, as standard input is called.
bool is_formula(const std::string& cell) {
  if (cell.empty() || cell == "-" || std::string_view("=+-@\t\r").find(cell.front()) == std::string_view::npos)
    return false;
  const auto number = io::parse_number(cell);
  return !number || !std::isfinite(*number);
}

/// A cell as CSV has it. What a spreadsheet would take for a formula is a text.
std::string csv_cell(std::string cell) {
  if (is_formula(cell)) cell.insert(0, "'");
  if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string as_csv(const std::vector<Cells>& table) {
  std::string text;
  for (const Cells& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i) text += csv_cell(cells[i]) + (i + 1 < cells.size() ? ',' : '\n');
  return text;
}

std::string as_table(std::vector<Cells> table) {
  for (Cells& cells : table)
    for (std::string& cell : cells) cell = without_controls(std::move(cell));
  std::vector<std::size_t> widths(table.front().size());
  for (const Cells& cells : table)
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], letters_of(cells[i]));
  std::string text;
  for (const Cells& cells : table) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i)
      line += i + 1 < cells.size() ? padded(cells[i], widths[i] + 2) : cells[i];
    text += line + '\n';
  }
  return text;
}

/// A table for people: nobody earns 0 of 0.
std::string as_table_of_marks(std::vector<Cells> table) {
  const auto of = static_cast<std::size_t>(std::find(table[0].begin(), table[0].end(), "of") - table[0].begin());
  for (Cells& cells : table)
    if (cells[of] == "0") cells[of].clear(), cells[of - 1].clear();
  return as_table(std::move(table));
}

/// A pair of attempts that a teacher may want to look at.
struct Alike {
  const Row* a;
  const Row* b;
  const char* why;
};

constexpr std::size_t kTelling = 3;  // fewer equal decisions are chance

/// How much an attempt tells: its decisions; of what was built, its numbers.
std::size_t tells(const Row& row) {
  if (row.decisions.size() != 1) return row.decisions.size();
  return static_cast<std::size_t>(std::count(row.decisions[0].begin(), row.decisions[0].end(), ','));
}

std::vector<Alike> alike(const std::vector<Row>& rows) {
  std::vector<Alike> pairs;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = i + 1; k < rows.size(); ++k) {
      const Row &a = rows[i], &b = rows[k];
      if (a.exercise.empty() || a.exercise != b.exercise || tells(a) < kTelling) continue;
      if (a.seed == b.seed && a.timed == b.timed) pairs.push_back({&a, &b, "the same attempt, times included"});
      else if (a.seed != b.seed && a.decisions == b.decisions)
        pairs.push_back({&a, &b, "equal decisions on different instances"});
    }
  return pairs;
}

/// Opens an attempt of a file in the window.
CommandResult watch(const GradeOptions& options, OpenWindow open_window) {
  const auto text = read_file(options.paths.front());
  if (!text) return bad_input(text.error());
  const auto file = read_result(*text);
  if (!file) return bad_input(InputError{.what = file.error().what, .file = options.paths.front()});
  const auto count = static_cast<int>(file->attempts.size());
  if (options.attempt > count)
    return bad_input(InputError{.what = count == 0
                                            ? std::string("has no attempt: of a lab sheet there is none to watch")
                                        : count == 1 ? std::string("has only one attempt")
                                                     : "has only " + std::to_string(count) + " attempts",
                                .file = options.paths.front()});
  const auto& claimed = file->attempts[options.attempt - 1];
  if (!claimed) return bad_input(InputError{.what = claimed.error(), .file = options.paths.front()});
  if (file->format != kResultFormat)
    return bad_input(
        InputError{.what = "its format is " + std::to_string(file->format), .file = options.paths.front()});
  if (is_path(claimed->attempt.exercise))
    return bad_input(InputError{.what = "names no exercise", .file = options.paths.front()});
  const auto known = find_exercise(options.folder, claimed->attempt.exercise);
  if (!known) return bad_input(known.error());
  if (known->exercise->hash != claimed->attempt.hash)
    return bad_input(InputError{.what = "the exercise was another when this was done", .file = options.paths.front()});
  WindowOptions window{.folder = options.folder};
  window.attempt = claimed->attempt;
  return Printed{"", open_window(window)};
}

tl::expected<Known, InputError> read_known(const std::string& folder) {
  Known known;
  const auto exercises = read_exercises(folder);
  const auto sheets = read_sheets(folder);
  if (!exercises) return tl::unexpected(exercises.error());
  if (!sheets) return tl::unexpected(sheets.error());
  for (const ExerciseFile& file : *exercises) known.exercises[file.exercise->id] = file.exercise;
  for (const LessonFile& file : *sheets) known.sheets.push_back(file.sheet);
  return known;
}

/// The error if the tables cannot be written so; none if they can.
std::optional<InputError> wrong_output(const GradeOptions& options) {
  const std::string ending = is_standard_output(options.output) ? "" : ending_of(options.output);
  const auto wrong = [&](std::string what) { return InputError{.what = std::move(what), .file = options.output}; };
  constexpr std::array<std::string_view, 5> kEndings{"", "txt", "svg", "csv", "json"};
  const auto* const known = std::find(kEndings.begin(), kEndings.end(), ending);
  if (known == kEndings.end()) return wrong("has none of the endings .svg, .csv, .json and .txt, which say the format");
  const bool other = (options.csv && ending != "csv") || (options.json && ending != "json");
  if (other && known - kEndings.begin() > 1) return wrong("ends in ." + ending + ", and another format was asked for");
  return std::nullopt;
}

/// What is wrong with the rows that are not ok, each with its file.
std::vector<InputError> faults_of(const std::vector<Row>& rows) {
  std::vector<InputError> faults;
  for (const Row& row : rows)
    if (!row.says.empty())
      faults.push_back(
          {row.status + ": " + row.says + (row.exercise.empty() ? "" : " (" + row.exercise + ')'), row.file});
  return faults;
}

/// What is printed of rows that may not all be ok.
Printed printed_of(const std::vector<Row>& rows) {
  Printed printed{.warnings = faults_of(rows)};
  if (std::any_of(rows.begin(), rows.end(), [](const Row& row) { return row.status != "ok"; })) printed.status = 1;
  return printed;
}

CommandResult report_alike(const std::vector<Row>& rows, const GradeOptions& options) {
  std::vector<Row> unread;  // what could not be compared, or not wholly; one that claims too much was
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(unread),
               [](const Row& row) { return row.status != "ok" && row.status != "differs"; });
  Printed printed = printed_of(unread);
  std::vector<Cells> table{{"file", "other", "exercise", "why"}};
  for (const auto& [a, b, why] : alike(rows)) {
    printed.text += line_of({{"file", a->file}, {"other", b->file}, {"exercise", a->exercise}, {"why", why}});
    table.push_back({a->file, b->file, a->exercise, why});
  }
  if (options.csv) printed.text = as_csv(table);
  else if (!options.json)
    printed.text = (table.size() > 1 ? as_table(std::move(table)) : "No two attempts are alike.\n") +
                   std::string("This is a hint for a teacher, and no verdict: students may work together, or hand in a "
                               "file twice.\n");
  return printed;
}

/// The tables of all sheets side by side, as a chart or in the format that is asked for.
CommandResult report_tables(std::vector<Row> rows, const GradeOptions& options) {
  std::vector<MachineTime> times;
  for (Row& row : rows)
    for (const auto& [part, measured] : row.work.measured) {
      std::vector<MachineTime> own = times_of(row.file, row.student, measured);
      if (own.empty()) row.status = "damaged", row.says = "the table \"" + part + "\" has no time above 0";
      std::move(own.begin(), own.end(), std::back_inserter(times));
    }
  Printed printed = printed_of(rows);
  if (times.empty() && !printed.warnings.empty()) return tl::unexpected(std::move(printed.warnings));
  if (times.empty()) return bad_input("no file has a measured table: those of the lab sheets have");
  const std::string ending = options.csv ? "csv" : options.json ? "json" : ending_of(options.output);
  const bool file = !is_standard_output(options.output);
  std::string text;
  if (ending == "svg") text = machines_svg(times);
  else if (ending == "csv") text = as_csv(machines_table(times));
  else if (ending == "json" || (!file && !is_terminal())) text = machines_json(times);
  else text = machines_text(times, !file && has_color());
  if (!file) printed.text = std::move(text);
  else if (const auto written = write_file(options.output, text); !written) return bad_input(written.error());
  return printed;
}

CommandResult run_grade(const GradeOptions& options) {
  if (auto wrong = wrong_output(options)) return bad_input(std::move(*wrong));
  auto known = read_known(options.folder);
  if (!known) return bad_input(known.error());
  known->tries_code = !options.tables && !options.alike;
  ToGrade found = find_files(options.paths);
  std::vector<Row> rows = std::move(found.rows);
  if (found.files.empty()) return tl::unexpected(faults_of(rows));
  Progress progress("Grading", static_cast<int>(found.files.size()));
  for (const std::string& path : found.files) {
    for (Row& row : grade_file(path, *known)) rows.push_back(std::move(row));
    progress.advance();
  }
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return std::pair(a.is_sheet, a.place) < std::pair(b.is_sheet, b.place);
  });
  if (options.alike) return report_alike(rows, options);
  if (options.tables) return report_tables(std::move(rows), options);
  Printed printed = printed_of(rows);
  std::vector<Cells> table{{"file", "student", "exercise", "seed", "mark", "of", "claimed", "status"}};
  for (const Row& row : rows) table.push_back(cells_of(row));
  if (options.by_student) {
    table = by_student(rows);
    table.insert(table.begin(), {"student", "exercises", "mark", "of", "status"});
  }
  if (options.json && options.by_student)
    for (std::size_t i = 1; i < table.size(); ++i)
      printed.text += line_of({{"student", table[i][0]},
                               {"exercises", std::stoi(table[i][1])},
                               {"mark", std::stod(table[i][2])},
                               {"of", std::stoi(table[i][3])},
                               {"status", table[i][4]}});
  else if (options.json)
    for (const Row& row : rows) printed.text += line_of(json_of(row));
  else printed.text = options.csv ? as_csv(table) : as_table_of_marks(table);
  if (!options.csv && !options.json && !options.by_student)
    for (const Row& row : rows)
      if (row.is_sheet) printed.text += sheet_text(row);
  return printed;
}

}  // namespace

void add_grade(Commands& commands) {
  CLI::App& command = *commands.app.add_subcommand("grade", "Grade the result files of exercises");
  command.footer(
      "Replays every decision of each file on the instance of its seed: a row an exercise, with file, student,\n"
      "exercise, seed, mark, of, claimed and status. Status is ok; differs, if it claims what it does not earn;\n"
      "damaged; missing, if there is no such file, or no attempt in it; foreign, if it is no result file or of no\n"
      "exercise here; older or newer, if the exercise was another then. Every other file is graded all the same; exit\n"
      "status 1 if any is not ok, with the reason on standard error. Code that was written is tried again: JavaScript\n"
      "in the page's engine, which Node runs, C++ as snug lab "
      "check does. A result file is no signature: it proves that these decisions earn this mark on this instance.\n\n"
      "A lab sheet has a row as well: its examples are judged anew, and earn a mark each. What was written, and how\n"
      "many parts are missing, is printed below the table, for people to read; with --json it is in \"written\",\n"
      "\"measured\" and \"built\".\n\n"
      "--tables puts what all machines measured side by side: in a terminal as a chart with a line for each algorithm\n"
      "and a mark for each measurement; in a pipe and with --json as JSON Lines, with --csv as CSV, with a row for "
      "each\n"
      "time; -o FILE.svg draws the chart. Times of one chart are of as many points of one name.");
  const auto options =
      add_command<GradeOptions>(commands, command, [open_window = commands.open_window](const GradeOptions& given) {
        return given.watch ? watch(given, open_window) : run_grade(given);
      });
  command.add_option("FILE", options->paths, "Result files, or folders of them (*.json)")->required();
  const auto csv = command.add_flag("--csv", options->csv, "Comma-separated values");
  command.add_flag("--json", options->json, "JSON Lines")->excludes(csv);
  command.add_flag("--by-student", options->by_student,
                   "A row a student: the sum of the best attempts at each exercise");
  const auto watch =
      command.add_flag("--watch", options->watch, "Open an attempt in the window, with all its decisions");
  command.add_option("--attempt", options->attempt, "Which of the file's, counted from 1")
      ->needs(watch)
      ->transform(whole_number(1, 100'000));
  const auto tables = command.add_flag("--tables", options->tables,
                                       "The times that the machines of all lab sheets measured, side by side");
  command.add_option("-o", options->output, "With --tables: .svg, .csv, .json or .txt; by default standard output")
      ->needs(tables);
  command.add_flag("--alike", options->alike, "List attempts that are alike: a hint for a teacher, never a verdict");
  add_lessons_folder(command, options->folder);
}

}  // namespace snug::desktop
