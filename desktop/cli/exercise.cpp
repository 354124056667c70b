// snug exercise list, make, play, answer, print and check.
#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <memory>
#include <numeric>

#include "desktop/cli/command.hpp"
#include "desktop/cli/exercise_files.hpp"
#include "desktop/cli/exercise_sheet.hpp"
#include "desktop/cli/progress.hpp"
#include "desktop/cli/result_file.hpp"
#include "desktop/cli/write_js.hpp"
#include "desktop/cli/written_files.hpp"
#include "geometry/random.hpp"
#include "lesson/exercise/sitting.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
namespace {

struct ExerciseOptions {
  std::string folder;
  std::string id;
  std::vector<std::string> ids;
  std::uint64_t seed = 1;
  int level = 0;
  int seeds = 10'000;
  std::string wrong;  // "K" or "K=RULE"
  std::string student, output = "-";
};

CommandResult run_list(const ExerciseOptions& options) {
  const auto files = read_exercises(options.folder);
  if (!files) return bad_input(files.error());
  const auto sets = read_sets_of(options.folder);
  if (!sets) return bad_input(sets.error());
  Printed printed;
  const auto sets_with = [&](const std::string& id) {
    Json in = Json::array();
    for (const lesson::ExerciseSet& set : *sets)
      if (std::find(set.exercises.begin(), set.exercises.end(), id) != set.exercises.end()) in.push_back(set.id);
    return in;
  };
  for (const ExerciseFile& file : *files) {
    const lesson::Exercise& exercise = *file.exercise;
    const Json in = sets_with(exercise.id);
    printed.text += line_of({{"exercise", exercise.id},
                             {"kind", exercise.kind()},
                             {"title", exercise.stage.title},
                             {"minutes", exercise.stage.minutes},
                             {"set", in.empty() ? Json() : in.front()},
                             {"sets", in},
                             {"lesson", exercise.lesson},
                             {"file", file.path},
                             {"levels", exercise.harder.size() + 1}});
  }
  const auto written = read_written(options.folder);
  if (!written) return bad_input(written.error());
  for (const WrittenExercise& exercise : *written) printed.text += line_of(listed(exercise, sets_with(exercise.id)));
  return printed;
}

/// The exercise of an id, or of a file, at the level that is asked for.
tl::expected<ExerciseFile, InputError> exercise_at_level(const ExerciseOptions& options, const std::string& id) {
  auto file = find_exercise(options.folder, id);
  if (file && options.level > 0)
    file->exercise = std::make_shared<const lesson::Exercise>(at_level(*file->exercise, options.level));
  return file;
}

CommandResult run_make(const ExerciseOptions& options) {
  if (is_written(options.id)) {
    const auto written = find_written(options.folder, options.id);
    if (!written) return bad_input(written.error());
    return Printed{line_of(instance_of(*written, options.seed))};
  }
  const auto file = exercise_at_level(options, options.id);
  if (!file) return bad_input(file.error());
  const auto instance = make_instance(*file->exercise, options.seed);
  if (!instance) return bad_input(instance.error());
  const auto session = open_instance(*file->exercise, *instance);
  if (!session) return bad_input(session.error());
  Json handles = Json::array();
  for (Index i = 0; i < session->stage().subject().size(); ++i)
    handles.push_back({{"id", session->stage().subject().name_of(i)},
                       {"at", json_of(session->stage().subject().at(i), session->stage().subject().dim())}});
  const lesson::Sitting sitting(file->exercise, options.seed, *session);
  const auto decisions = file->exercise->build ? 1 : sitting.of();
  return Printed{line_of({{"exercise", file->exercise->id},
                          {"hash", hex_of(file->exercise->hash)},
                          {"seed", options.seed},
                          {"instance",
                           {{"dim", session->stage().subject().dim()},
                            {"algorithm", instance->lesson.algorithms.front()},
                            {"handles", std::move(handles)},
                            {"rows", session->stage().subject().rows()},
                            {"trace", hex_of(session->player().trace_hash())}}},
                          {"decisions", decisions},
                          {"of", sitting.of()}})};
}

tl::expected<Json, InputError> written_attempt(const ExerciseOptions& options, int wrong) {
  return find_written(options.folder, options.id).and_then([&](const WrittenExercise& exercise) {
    return answered(exercise, options.seed, wrong);
  });
}

tl::expected<Json, InputError> decided_attempt(const ExerciseOptions& options, int wrong, const std::string& rule) {
  const auto file = exercise_at_level(options, options.id);
  if (!file) return tl::unexpected(file.error());
  const auto attempt = model_attempt(*file->exercise, options.seed, wrong, rule);
  if (!attempt) return tl::unexpected(attempt.error());
  const auto graded = grade(file->exercise, *attempt);
  if (!graded) return tl::unexpected(graded.error());
  return json_of(*attempt, graded->mark, graded->of);
}

CommandResult run_answer(const ExerciseOptions& options) {
  const std::size_t equals = options.wrong.find('=');
  const std::string number = options.wrong.substr(0, equals);
  const std::string rule = equals == std::string::npos ? "" : options.wrong.substr(equals + 1);
  int wrong = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), wrong);
  if (!options.wrong.empty() && (error != std::errc() || end != number.data() + number.size() || wrong < 1))
    return bad_input("--wrong takes the number of a decision, counted from 1, and perhaps =RULE: \"" + options.wrong +
                     '"');
  const auto attempt = is_written(options.id) ? written_attempt(options, wrong) : decided_attempt(options, wrong, rule);
  if (!attempt) return bad_input(attempt.error());
  const std::string result = result_text(options.student, {*attempt});
  if (is_standard_output(options.output)) return Printed{result};
  if (const auto written = write_file(options.output, result); !written) return bad_input(written.error());
  return Printed{};
}

/// The exercises of a set, or the one of that id. In a set, those in which code is written are passed over with a
/// warning.
tl::expected<std::vector<ExerciseFile>, InputError> exercises_of(const ExerciseOptions& options, Printed& printed) {
  const auto sets = read_sets_of(options.folder);
  if (!sets) return tl::unexpected(sets.error());
  std::vector<std::string> ids{options.id};
  for (const lesson::ExerciseSet& set : *sets)
    if (set.id == options.id) ids = set.exercises;
  std::vector<ExerciseFile> files;
  for (const std::string& id : ids) {
    if (ids.size() > 1 && is_written(id)) {
      printed.warnings.push_back({.what = id + " is left out: it is written on the page alone"});
      continue;
    }
    auto file = find_exercise(options.folder, id);
    if (!file) return tl::unexpected(std::move(file.error()));
    files.push_back(*std::move(file));
  }
  return files;
}

/// One sheet a seed, and its solution. What paper cannot show is left out, with a warning.
CommandResult run_print(const ExerciseOptions& options) {
  Printed printed;
  const auto files = exercises_of(options, printed);
  if (!files) return bad_input(files.error());
  std::error_code failed;
  std::filesystem::create_directories(options.output, failed);
  if (failed) return bad_input(InputError{.what = failed.message(), .file = options.output});
  for (const ExerciseFile& file : *files)
    for (int seed = 1; seed <= options.seeds; ++seed) {
      const auto own = static_cast<std::uint64_t>(seed);
      const auto instance = make_instance(*file.exercise, own);
      const auto session = instance ? open_instance(*file.exercise, *instance) : tl::unexpected(instance.error());
      if (!session) return bad_input(session.error());
      const auto sheet = sheet_of(*file.exercise, *session, own, false);
      if (!sheet) {
        printed.warnings.push_back(sheet.error());
        break;
      }
      const std::string stem = options.output + "/" + file.exercise->id + "-" + std::to_string(seed);
      for (const auto& [name, text] :
           {std::pair{stem + ".svg", *sheet},
            std::pair{stem + "-solution.svg", *sheet_of(*file.exercise, *session, own, true)}}) {
        if (const auto written = write_file(name, text); !written) return bad_input(written.error());
        printed.text += line_of({{"exercise", file.exercise->id}, {"seed", seed}, {"file", name}});
      }
    }
  return printed;
}

/// What many seeds of an exercise have in common.
struct Checked {
  int seeds = 0, broken = 0;
  std::int64_t passed_over = 0;
  std::vector<int> decisions, hard;  // of each instance; hard: nearer to a tie than twice what is promised
  double nearest = std::numeric_limits<double>::infinity();  // to a tie
  std::vector<std::string> faults;
};

constexpr int kPlayed = 100;  // as many seeds are played

/// Right, wrong by each rule, and at random: each attempt must earn what it should.
void play(const std::shared_ptr<const lesson::Exercise>& exercise, std::uint64_t seed, int decisions,
          Checked& checked) {
  const int of = exercise->build ? exercise->build->levels : decisions;
  const auto earns = [&](int wrong, const std::string& rule) {
    const auto attempt = model_attempt(*exercise, seed, wrong, rule);
    const auto graded = attempt ? grade(exercise, *attempt) : tl::unexpected(attempt.error());
    if (!graded) return checked.faults.push_back("seed " + std::to_string(seed) + ": " + graded.error().message());
    if (graded->mark != of - (wrong > 0 ? 1 : 0) || graded->decided != decisions)
      checked.faults.push_back("seed " + std::to_string(seed) + ": an attempt with decision " + std::to_string(wrong) +
                               " wrong earns " + std::to_string(graded->mark) + " of " + std::to_string(of));
  };
  earns(0, "");
  if (exercise->build) return;
  Random random(seed);
  earns(static_cast<int>(random.below(static_cast<std::uint32_t>(decisions))) + 1, "");
}

void check_seed(const std::shared_ptr<const lesson::Exercise>& exercise, std::uint64_t seed, Checked& checked) {
  ++checked.seeds;
  const auto instance = make_instance(*exercise, seed);
  const auto session = instance ? open_instance(*exercise, *instance) : tl::unexpected(instance.error());
  if (!session) {
    ++checked.broken;
    return checked.faults.push_back("seed " + std::to_string(seed) + ": " + session.error().message());
  }
  checked.passed_over += instance->passed_over;
  const int decisions = exercise->build ? 1 : static_cast<int>(session->conversation().questions().size());
  checked.decisions.push_back(decisions);
  checked.hard.push_back(0);
  for (const lesson::Asked& asked : session->conversation().questions()) {
    if (exercise->ties && has_tie(asked, session->player().run(0))) continue;
    const double margin = asked.kind->margin(asked, session->player().run(0));
    checked.nearest = std::min(checked.nearest, margin);
    checked.hard.back() += margin < 2 * exercise->apart;
  }
  if (checked.nearest < exercise->apart) ++checked.broken;
  if (seed <= kPlayed) play(exercise, seed, decisions, checked);
}

/// The harder levels, on a tenth of the seeds each.
void check_levels_above(const std::shared_ptr<const lesson::Exercise>& exercise, int seeds, Checked& checked) {
  for (int level = exercise->level + 1; level <= static_cast<int>(exercise->harder.size()); ++level) {
    const auto own = std::make_shared<const lesson::Exercise>(at_level(*exercise, level));
    Checked above;
    for (int seed = 1; seed <= std::max(seeds / 10, 5); ++seed)
      check_seed(own, static_cast<std::uint64_t>(seed), above);
    checked.broken += above.broken;
    for (const std::string& fault : above.faults)
      checked.faults.push_back("level " + std::to_string(level) + ", " + fault);
  }
}

/// A seed is hundreds of cases: a thousandth of those of other exercises is enough.
tl::expected<void, InputError> check_written(const std::vector<WrittenExercise>& all, int seeds, Printed& printed) {
  for (const WrittenExercise& exercise : all) {
    const auto told = checked(exercise, std::max(seeds / 1000, 1));
    if (!told) return tl::unexpected(told.error());
    if (!told->at("kept").get<bool>()) printed.status = 1;
    printed.text += line_of(*told);
  }
  return {};
}

/// How even a count is over the instances; null if no seed has one.
Json spread_of(std::vector<int>& counts) {
  if (counts.empty()) return nullptr;
  std::sort(counts.begin(), counts.end());
  const double sum = std::accumulate(counts.begin(), counts.end(), 0.0), all = static_cast<double>(counts.size());
  return {
      {"least", counts.front()}, {"median", counts[counts.size() / 2]}, {"mean", sum / all}, {"most", counts.back()}};
}

CommandResult run_check(const ExerciseOptions& options) {
  std::vector<ExerciseFile> files;
  std::vector<WrittenExercise> written;
  for (const std::string& id : options.ids) {
    if (is_written(id)) {
      auto one = find_written(options.folder, id);
      if (!one) return bad_input(one.error());
      written.push_back(*std::move(one));
      continue;
    }
    auto file = exercise_at_level(options, id);
    if (!file) return bad_input(file.error());
    files.push_back(*std::move(file));
  }
  if (options.ids.empty()) {
    auto all = read_exercises(options.folder);
    if (!all) return bad_input(all.error());
    files = *std::move(all);
    auto all_written = read_written(options.folder);
    if (!all_written) return bad_input(all_written.error());
    written = *std::move(all_written);
  }
  Printed printed;
  for (const ExerciseFile& file : files) {
    Checked checked;
    Progress progress(file.exercise->id.c_str(), options.seeds);
    for (int seed = 1; seed <= options.seeds; ++seed, progress.advance()) check_seed(file.exercise, seed, checked);
    check_levels_above(file.exercise, options.seeds, checked);
    const bool kept = checked.broken == 0 && checked.faults.empty();
    if (!kept) printed.status = 1;
    checked.faults.resize(std::min<std::size_t>(checked.faults.size(), 3));
    printed.text += line_of({{"exercise", file.exercise->id},
                             {"seeds", checked.seeds},
                             {"kept", kept},
                             {"passed_over", static_cast<double>(checked.passed_over) / checked.seeds},
                             {"decisions", spread_of(checked.decisions)},
                             {"hard", spread_of(checked.hard)},
                             {"promised", file.exercise->apart},
                             {"nearest", checked.nearest},
                             {"faults", checked.faults}});
  }
  if (const auto done = check_written(written, options.seeds, printed); !done) return bad_input(done.error());
  return printed;
}

void add_level(CLI::App& command, int& level) {
  command.add_option("--level", level, "How hard, from 0")->transform(whole_number(0, lesson::kMostLevels));
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "The student's seed")->transform(seed_of_page());
}

}  // namespace

void add_exercise(Commands& commands) {
  CLI::App& group = *commands.app.add_subcommand("exercise", "List, make, play, answer, print or check exercises");
  group.require_subcommand(1);

  CLI::App& list = *group.add_subcommand("list", "List the exercises");
  list.footer(
      "JSON Lines: {\"exercise\",\"kind\",\"title\",\"minutes\",\"set\",\"sets\",\"lesson\",\"file\",\"levels\"}.");
  add_lessons_folder(list, add_command<ExerciseOptions>(commands, list, run_list)->folder);

  CLI::App& make = *group.add_subcommand("make", "Make the instance of a seed");
  make.footer(
      "One JSON object, the same on every machine: "
      "{\"exercise\",\"hash\",\"seed\",\"instance\",\"decisions\",\"of\"}.\n"
      "\"instance\" has its dimension, the algorithm, the handles with their places, the numbers that it is made of,\n"
      "and the hash of the run's trace.");
  const auto made = add_command<ExerciseOptions>(commands, make, run_make);
  make.add_option("ID", made->id, "The exercise's id, or its file, which ends in .toml")->required();
  add_seed(make, made->seed);
  add_level(make, made->level);
  add_lessons_folder(make, made->folder);

  CLI::App& play = *group.add_subcommand("play", "Open an exercise in the window");
  const auto played = add_command<WindowOptions>(
      commands, play, [open_window = commands.open_window](const WindowOptions& options) -> CommandResult {
        if (const auto known = find_exercise("", options.exercise); !known) return bad_input(known.error());
        return Printed{"", open_window(options)};
      });
  play.add_option("ID", played->exercise, "The exercise's id")->required();
  play.add_option("--seed", played->seed, "The student's seed; by default a fresh one")->transform(seed_of_page());

  CLI::App& answer = *group.add_subcommand("answer", "Write a result file with the model's decisions");
  answer.footer("For tests, and for teachers who try their reports.");
  const auto answered = add_command<ExerciseOptions>(commands, answer, run_answer);
  answer.add_option("ID", answered->id, "The exercise's id, or its file, which ends in .toml")->required();
  add_seed(answer, answered->seed);
  add_level(answer, answered->level);
  answer.add_option("--wrong", answered->wrong, "K, or K=RULE: decision K is wrong, by that wrong rule");
  answer.add_option("--student", answered->student, "The name in the file");
  answer.add_option("-o", answered->output, "The file; by default standard output");
  add_lessons_folder(answer, answered->folder);

  CLI::App& print = *group.add_subcommand("print", "Print instances on paper");
  print.footer("Writes an SVG of A4 for each exercise of the set and each seed from 1 on, with the instance drawn, its "
               "coordinates and\n"
               "lines for the answers, and a second one with the solution. Each question begins from the right state, "
               "so that a later\n"
               "one may tell an earlier one's answer.");
  const auto printed = add_command<ExerciseOptions>(commands, print, run_print);
  print.add_option("SET", printed->id, "The set's id, or an exercise's")->required();
  printed->seeds = 1;
  print.add_option("--seeds", printed->seeds, "How many instances of each")->transform(whole_number(1, 10'000));
  print.add_option("-o", printed->output, "The folder to write to")->required();
  add_lessons_folder(print, printed->folder);

  CLI::App& check = *group.add_subcommand("check", "Prove what the exercises promise of their instances");
  check.footer(
      "Makes the instances of many seeds, of harder levels of a tenth as many, and plays the first 100, right and "
      "wrong. A line for each exercise:\n"
      "{\"exercise\",\"seeds\",\"kept\",\"passed_over\",\"decisions\":{\"least\",\"median\",\"mean\",\"most\"},\n"
      "\"hard\",\"promised\",\"nearest\",\"faults\"}: how many seeds were passed over for one, how many decisions an "
      "instance\n"
      "has, how many of these are hard (nearer to a tie than twice what is promised, counted likewise), both null if "
      "no "
      "seed\n"
      "has an instance, and how near to a tie the nearest of all decisions is, as a share of the extent, or null. Exit "
      "status 1 if a promise is "
      "broken. Of an exercise in which a function is written, its reference solution, its other methods and each of "
      "its\n"
      "usual mistakes are tried, which takes Node: "
      "{\"exercise\",\"seeds\",\"kept\",\"methods\",\"mistakes\",\"faults\"}.");
  const auto checked = add_command<ExerciseOptions>(commands, check, run_check);
  check.add_option("ID", checked->ids, "Ids, or files that end in .toml; by default all exercises");
  check.add_option("--seeds", checked->seeds, "How many seeds")->transform(whole_number(1, 1'000'000));
  add_level(check, checked->level);
  add_lessons_folder(check, checked->folder);
}

}  // namespace snug::desktop
