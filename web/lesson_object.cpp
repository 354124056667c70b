// The constant data of an open lesson.
#include "lesson/exercise/sitting.hpp"
#include "lesson/say.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"
#include "web/prose.hpp"
#include "web/values.hpp"
#include "web/view.hpp"

namespace snug::web {
namespace {

using emscripten::val;

val section_object(const lesson::Section& section) {
  val object = val::object();
  object.set("title", section.title);
  object.set("situation", section.situation);
  object.set("blocks", array_of(section.blocks, block_object));
  return object;
}

val algorithm_object(const lesson::Lesson& lesson, std::string_view name) {
  val object = val::object();
  const lesson::Method* algorithm = lesson::find_method(lesson, name);
  object.set("name", text(name));
  object.set("title", algorithm != nullptr ? val(lesson::title_in(lesson, *algorithm)) : text(name));
  object.set("source", text(algorithm != nullptr ? algorithm->source : ""));
  object.set("maxPoints", algorithm != nullptr ? algorithm->max_points : 0);
  return object;
}

val tools_object(const lesson::Subject& subject) {
  const lesson::Tools tools = subject.tools();
  val object = val::object();
  object.set("word", text(tools.word));
  object.set("title", text(tools.title));
  object.set("points", tools.points);
  return object;
}

void set_points(val& object, const lesson::Points& points) {
  object.set("generate", points.generate);
  object.set("count", points.count);
  object.set("mesh", points.mesh);
  object.set("scalar", points.in_float ? "float" : "double");
}

/// None where the lesson has only its own.
val situations_array(const lesson::Lesson& lesson) {
  if (lesson.situations.empty()) return val::array();
  return array_of(lesson::situation_names(lesson), [&](std::string_view name) {
    val object = val::object();
    object.set("name", text(name));
    object.set("title", lesson::situation_title(lesson, name));
    set_points(object, lesson::points_in(lesson, name));
    return object;
  });
}

}  // namespace

val lesson_object(const lesson::Session& session) {
  const lesson::Lesson& lesson = session.lesson();
  val object = val::object();
  object.set("id", lesson.id);
  object.set("minutes", lesson.minutes);
  object.set("title", lesson.title);
  object.set("summary", lesson.summary);
  object.set("sections", array_of(lesson.sections, section_object));
  object.set("algorithms",
             array_of(lesson.algorithms, [&](std::string_view name) { return algorithm_object(lesson, name); }));
  object.set("stepWord", text(lesson.subject->step_word));
  object.set("measures", lesson.subject->experiment != nullptr);
  object.set("tools", tools_object(session.stage().subject()));
  object.set("stageSays", text(session.stage().subject().stage_says()));
  object.set("handleWords", array_of(session.stage().subject().handle_words(), text));
  object.set("situations", situations_array(lesson));
  object.set("dim", lesson.points.dim);
  set_points(object, lesson.points);
  object.set("seed", static_cast<double>(lesson.seed));
  object.set("meshes", array_of(lesson.meshes, text));
  object.set("generators", array_of(lesson.generators, text));
  object.set("compare", lesson.compare);
  val tasks = val::array();
  const std::size_t count =
      session.stage().conduct().builds ? 0 : lesson.tasks.size();  // what is built has its own card
  for (std::size_t i = 0; i < count; ++i) {
    const lesson::Task& own = lesson.tasks[i];
    val task = val::object();
    task.set("heading", lesson::task_heading(i, lesson.tasks.size()));
    task.set("prompt", prompt_array(own.prompt));
    task.set("hint", prompt_array(own.hint));
    task.set("algorithm", own.algorithm);
    task.set("points", own.points);
    task.set("start", lesson::start_task_text(session, own));
    tasks.call<void>("push", task);
  }
  object.set("tasks", tasks);
  return object;
}

val words_object() {
  val object = val::object();
  object.set("answer", text(lesson::kAnswerWord));
  object.set("skip", text(lesson::kSkipWord));
  object.set("prediction", text(lesson::kPredictionWord));
  object.set("decision", text(lesson::kDecisionWord));
  object.set("watch", text(lesson::kWatchWord));
  object.set("again", text(lesson::kPredictAgainWord));
  object.set("practise", text(lesson::kPractiseWord));
  object.set("task", text(lesson::kTaskWord));
  object.set("hint", text(lesson::kHintWord));
  object.set("go_on", text(lesson::kContinueWord));
  object.set("show", text(lesson::kShowMeWord));
  object.set("summary", text(lesson::kSummaryWord));
  object.set("go_on_with", text(lesson::kGoOnWord));
  object.set("waiting", text(lesson::kWaitingWord));
  object.set("to_task", text(lesson::kToTaskWord));
  object.set("next_lesson", text(lesson::kNextLessonWord));
  object.set("close", text(lesson::kCloseWord));
  object.set("watching", text(lesson::kWatching));
  object.set("hand_in", text(lesson::kHandInWord));
  object.set("another", text(lesson::kAnotherInstanceWord));
  object.set("to_lesson", text(lesson::kToLessonWord));
  object.set("take_back", text(lesson::kTakeBackWord));
  object.set("your_mark", text(lesson::kYourMarkWord));
  object.set("finish", text(lesson::kFinishWord));
  object.set("start_again", text(lesson::kStartAgainWord));
  object.set("back_to_best", text(lesson::kBackToBestWord));
  object.set("back_to_solution", text(lesson::kBackToSolutionWord));
  object.set("show_model", text(lesson::kShowModelWord));
  object.set("harder", text(lesson::kHarderWord));
  object.set("without_mark", text(lesson::kWithoutMarkWord));
  object.set("for_mark", text(lesson::kForMarkWord));
  object.set("right_run", text(lesson::kRightRunWord));
  object.set("your_run", text(lesson::kYourRunWord));
  object.set("both_runs", text(lesson::kBothRunsWord));
  object.set("next_decision", text(lesson::kNextDecisionWord));
  return object;
}

}  // namespace snug::web
