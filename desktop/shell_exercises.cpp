// The window's exercises: opened, kept, and handed in.
#include <random>

#include "desktop/cli/files.hpp"
#include "desktop/cli/result_file.hpp"
#include "desktop/shell.hpp"
#include "lesson/figures.hpp"

namespace snug::desktop {

void Shell::take_exercises(std::vector<ExerciseFile> exercises, std::vector<lesson::ExerciseSet> sets) {
  exercises_ = std::move(exercises), sets_ = std::move(sets);
}

const lesson::Exercise* Shell::exercise(const std::string& id) const {
  for (const ExerciseFile& file : exercises_)
    if (file.exercise->id == id) return file.exercise.get();
  return nullptr;
}

tl::expected<void, InputError> Shell::open_exercise(const std::string& id, std::optional<std::uint64_t> seed, int level,
                                                    bool practises, bool resumes) {
  if (app_.session() != nullptr) keep();
  std::shared_ptr<const lesson::Exercise> known;
  for (const ExerciseFile& file : exercises_)
    if (file.exercise->id == id) known = file.exercise;
  if (known == nullptr) return tl::unexpected(InputError{.what = "there is no exercise \"" + id + '"'});
  const std::uint64_t own = seed ? *seed : std::random_device()();
  const auto opened =
      app_.open_exercise(std::make_shared<const lesson::Exercise>(at_level(*known, level)), own, practises);
  if (!tell(opened)) return opened;
  watches_ = counted_ = false;
  begin_panels();
  course_shown = false, tab = Tab::kLesson;
  kept_revision_ = session().revision();
  const KeptExercise* const kept = kept_.exercise(id);
  const bool goes_on = kept != nullptr && kept->now && kept->now->seed == own && kept->now->level == level;
  if (goes_on && resumes && !practises && kept->now->hash == known->hash)
    tell(app_.sitting()->take_up(session(), *kept->now));
  return {};
}

void Shell::go_on_with_exercise(const std::string& id) {
  const KeptExercise* const kept = kept_.exercise(id);
  const bool goes_on = kept != nullptr && kept->now;
  tell(open_exercise(id, goes_on ? std::optional(kept->now->seed) : std::nullopt, goes_on ? kept->now->level : 0));
}

void Shell::next_instance(std::string_view how) {
  const lesson::Sitting& sitting = *app_.sitting();
  const std::string id = sitting.exercise().id;
  const int level = sitting.exercise().level + (how == "harder" ? 1 : 0);
  const bool practises = how == "other_terms" ? !sitting.practises() : sitting.practises();
  tell(open_exercise(id, std::nullopt, level, practises));
}

tl::expected<void, InputError> Shell::watch(const lesson::Attempt& attempt) {
  if (const auto opened = open_exercise(attempt.exercise, attempt.seed, attempt.level, false, false); !opened)
    return opened;
  watches_ = true;
  return app_.sitting()->take_up(session(), attempt);
}

void Shell::keep_exercise() {
  const lesson::Sitting& sitting = *app_.sitting();
  if (sitting.practises() || watches_) return;
  const bool over = sitting.finished(session()), counts = over && !counted_;
  counted_ = over;
  kept_.keep(sitting.attempt(session()), sitting.mark(session()), sitting.of(), over, counts);
  kept_.write();
}

std::string Shell::best_says() const {
  const KeptExercise* const kept = kept_.exercise(app_.sitting()->exercise().id);
  if (kept == nullptr || kept->tries < 2) return {};
  return "Best " + lesson::plain_number(kept->mark) + " of " + std::to_string(kept->of) + " in " +
         std::to_string(kept->tries) + " tries";
}

void Shell::hand_in() {
  const std::string stem = app_.sitting() == nullptr
                               ? sheet()->lesson.id
                               : app_.sitting()->exercise().id + "-" + std::to_string(app_.sitting()->seed());
  const std::string path = new_file(stem, ".json");
  if (!path.empty() && hand_in_as(path)) return;
  file_card = {.what = FileCard::What::kHandIn, .path = stem + ".json", .opened = true};  // another place has room
}

bool Shell::hand_in_as(const std::string& path) {
  const lesson::Sitting* const sitting = app_.sitting();
  const std::string text =
      sitting == nullptr
          ? result_text(student(), {}, {json_of(sheet()->lesson.id, sheet()->hash, sheet_work())})
          : result_text(student(), {json_of(sitting->attempt(session()), sitting->mark(session()), sitting->of())});
  if (!tell(write_file(path, text))) return false;
  say("Saved as " + path + ". " +
      (sitting == nullptr ? sheet_lacks() : "It is no signature: it proves that these decisions earn this mark."));
  return true;
}

}  // namespace snug::desktop
