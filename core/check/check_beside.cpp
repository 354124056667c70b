#include "check/check_beside.hpp"

#include <algorithm>

#include "check/play.hpp"
#include "geometry/sort.hpp"
#include "lesson/names.hpp"
#include "lesson/prose.hpp"
#include "lesson/subjects.hpp"

namespace snug::check {
namespace {

FilePlace place_of_error(const InputError& error) {
  return error.unit == InputError::Unit::kLine ? FilePlace(static_cast<int>(error.position)) : FilePlace();
}

/// Collects a draft's mistakes and leaves them in the file's order.
class Mistakes {
 public:
  Mistakes(Draft& draft, std::string_view file) : draft_(draft), file_(file) {}
  Mistakes(const Mistakes&) = delete;
  Mistakes& operator=(const Mistakes&) = delete;
  ~Mistakes() {
    const auto earlier = [](const FileError& a, const FileError& b) {
      return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    };
    sort_stably(draft_.mistakes, earlier);
  }
  void add(FilePlace place, std::string what) { draft_.mistakes.push_back({place, std::move(what), file_}); }

 private:
  Draft& draft_;
  std::string file_;
};

void check_play(const Played& played, const Lesson& lesson, Mistakes& mistakes) {
  const auto place_of = [&](const std::string& id) {
    const auto named = [&](const Question& question) { return question.id == id; };
    return std::find_if(lesson.questions.begin(), lesson.questions.end(), named)->place;
  };
  for (const std::string& id : played.not_asked)
    mistakes.add(place_of(id), "the question \"" + id + "\" is never asked: its step does not come");
  for (const Played::Algorithm& algorithm : played.algorithms)
    for (const Outcome& outcome : algorithm.outcomes)
      if (!outcome.right)
        mistakes.add(place_of(outcome.question), "the question \"" + outcome.question +
                                                     "\" takes its own answer for wrong: it says " + outcome.says);
  for (std::size_t i = 0; i < played.grades.size(); ++i)
    if (!played.grades[i].done)
      mistakes.add(lesson.tasks[i].model_place, "the model does not solve the task: " + played.grades[i].says);
}

}  // namespace

void check_names_beside(Draft& draft, std::string_view file, const Beside& beside) {
  Mistakes mistakes(draft, file);
  for (const auto& [name, idea, place] : draft.names_beside) {
    const std::vector<std::string>& names = idea ? beside.ideas : beside.lessons;
    if (is_among(names, name) || (idea && names.empty())) continue;
    const std::string_view meant = nearest(names, name);
    mistakes.add(place, (idea ? "\"covers\" names an idea that the course does not list: "
                              : "\"text\" links to a lesson that is not there: ") +
                            name + (meant.empty() ? "" : "; did you mean " + std::string(meant) + "?"));
  }
}

void check_played(Draft& draft, std::string_view file, std::optional<io::PointFile> mesh) {
  if (!draft.lesson || !draft.mistakes.empty()) return;
  const Lesson lesson = *draft.lesson;
  Mistakes mistakes(draft, file);
  auto session = Session::open(lesson, std::move(mesh));
  if (!session) return mistakes.add(place_of_error(session.error()), session.error().what);
  const auto played = play(*session);
  if (played) check_play(*played, lesson, mistakes);
  else mistakes.add(place_of_error(played.error()), played.error().what);
}

}  // namespace snug::check
