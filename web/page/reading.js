// What is read: the title, the prose and the task with its grade as it stands.
import { button, by_id, element, set_hidden, set_text, when_changed, whole_names } from "./dom.js";
import { notice } from "./messages.js";

const paragraph = (stretches) =>
  element("p", {}, ...stretches.map(({ text, strong }) => (strong ? element("strong", {}, whole_names(text)) : whole_names(text))));

export class Reading {
  #words;
  #start_task;
  #grade_says = element("p", { class: "grade", role: "status" });
  #was_open = false; // the task, when it was last graded in this lesson

  /** start_task: lays out the points that the task begins with. */
  constructor(words, start_task) {
    this.#words = words;
    this.#start_task = start_task;
  }

  open(lesson) {
    for (const id of ["heading", "title"]) set_text(by_id(id), lesson.title);
    by_id("prose").replaceChildren(...lesson.sections.flatMap((section) => [
      ...(section.title ? [element("h2", {}, section.title)] : []), ...section.paragraphs.map(paragraph)]));
    by_id("read").scrollTop = 0;
    this.#was_open = false;
    const box = by_id("task");
    set_hidden(box, !lesson.task);
    if (!lesson.task) return box.replaceChildren();
    box.replaceChildren(element("h2", { class: "kicker" }, this.#words.task), element("p", {}, lesson.task.prompt),
      element("p", {}, button(lesson.task.start, this.#start_task)), this.#grade_says,
      ...(lesson.task.hint ? [element("details", {}, element("summary", {}, this.#words.hint), element("p", {}, lesson.task.hint))] : []));
  }

  update(view) {
    this.#show_grade(view.lesson, view.grade);
  }

  #show_grade = when_changed((_lesson, grade) => {
    if (!grade) return;
    const box = by_id("task");
    // On a phone it stands far below the stage where it was done. One that an address brings along done is no news.
    const { top, bottom } = box.getBoundingClientRect();
    if (grade.done && this.#was_open && (bottom < 0 || top > innerHeight)) notice(`✓ ${grade.says}`, "told");
    this.#was_open = !grade.done;
    box.classList.toggle("done", grade.done);
    set_text(this.#grade_says, `${grade.done ? "✓ " : ""}${grade.says}`);
  });
}
