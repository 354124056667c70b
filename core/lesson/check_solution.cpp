#include "lesson/check_solution.hpp"

#include "lesson/grade.hpp"

namespace snug::lesson {

void check_solution(const Lesson& lesson, const Task& task, const Subject& own, Complaints& complaints) {
  const View none;  // no run is at hand
  const auto subject = own.clone();
  subject->begin_task(lesson, task, own);
  for (const Requirement& due : task.conditions)
    if (const Judged judged = judge_requirement(due, lesson, task.algorithm, *subject, none); !judged.known)
      return complaints.add(due.place, judged.says);
  if (task.sound && subject->grade(lesson, task, none).done)
    return complaints.add(task.place, "the task is solved before the student begins");
  if (task.searched) return complaints.add(task.model_place, "\"model\" can be \"search\" in an exercise only");
  if (const Done made = subject->set_rows(task.model); !made)
    return complaints.add(task.model_place, made.error().what);
  if (const Grade graded = subject->grade(lesson, task, none); !graded.done)
    complaints.add(task.model_place, "the model does not solve the task: " + graded.says);
}

}  // namespace snug::lesson
