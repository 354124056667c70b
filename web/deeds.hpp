// What the user does on the page, as functions that page/door.js calls. They return an error as a sentence, or ""; or
// what app/told has a type for.
#pragma once

#include <emscripten/val.h>

#include <string>

namespace snug::web {

using emscripten::val;

bool command(const std::string& name);
/// The rows of the card of keys that every door has: [keys, words].
emscripten::val key_rows();
std::string command_of_key(const std::string& key, bool shift, bool control);
/// Chooses an answer by its number; choosing it again gives it.
void pick_choice(int choice);
/// Chooses a handle by its typed name. Returns false if it cannot be the answer.
bool pick_name(const std::string& name);
/// The names of the handles that can be the answer. A mesh has thousands, so they are not part of view().
val targets();
/// The hash of the run, for scripts alone: it takes every step of it, and no frame of a drag waits for that.
val trace();
/// Whether the step's own numbers may need the whole column, and their height in the last frame, in pixels.
bool figures_fill();
double figures_height();
/// A pinch: factor > 1 as the fingers part, around (x, y), which moved by (dx, dy).
void pinch(float factor, float x, float y, float dx, float dy);
void go(int step);
void jump(int step);
/// The given answers, for the device to keep; and those of an earlier visit, passed in before the lesson is opened.
std::string kept_answers();
void keep_answers(const std::string& lesson, const std::string& kept);
/// Erases the answers to all lessons.
void erase_answers();
/// name: "" clears the comparison.
std::string choose(int slot, const std::string& name);
void select_point(int point);
std::string move_point(int point, double x, double y, double z);
std::string show_situation(const std::string& name);
/// Whether a slider is in hand: its moves meanwhile are one edit.
std::string hold_slider(bool held);
/// Moves a slider, by its number, to a place of its knob.
std::string slide(int slider, int place);
/// Scatters the same things again, from a seed.
void scatter(double seed);
/// An edit that takes long; null for none. go_on: goes on with it, and returns why it is
/// refused; the stage changes when it is done. give_up: the stage stays as it is.
[[nodiscard]] emscripten::val preparing();
std::string go_on(double milliseconds);
void give_up();
/// Scatters points of another kind.
std::string set_generator(const std::string& kind, int count, double seed);
/// Chooses float or double for the runs.
std::string set_float(bool in_float);
/// Loads a point file in any of the formats, or an earlier file of the cover.
std::string load_file(const std::string& bytes, const std::string& name);
/// Does a slice of the running measurement. milliseconds: the budget.
void measure_slice(double milliseconds);
bool measuring();
/// The progress of the measurement, from 0 to 1.
double measured();
/// The way to the course's playground: its words; takes along what stands on the stage; and puts that down in the
/// lesson that is open now, as `name`. Returns an error's sentence.
std::string playground_says();
void carry_points();
std::string put_down_points(const std::string& name);
/// Reads an exercise's file for open_exercise. Returns its first mistake, "" for none.
std::string read_exercise(const std::string& toml, const std::string& name);
/// Opens the instance of a seed at a level, for a mark or to practise. Returns an error, "" for none.
std::string open_exercise(double seed, int level, bool practises);
/// Makes the decisions that an attempt has, on what was just opened. Returns an error, "" for none.
std::string take_up_attempt(const emscripten::val& decisions);
emscripten::val attempt();
/// The seed of a student's name.
double seed_of_name(const std::string& name);
/// Lights a mark that the prose links to, until another, or "" for none.
void light(const std::string& mark);
/// The first invitations, of which so many were followed before.
void invite(int followed);
void start_task(int task);
/// Puts on the stage again what the task was done by.
std::string solve_again(int task);
/// Sets a row of view()'s numbers, by the indices of its group and row.
std::string set_numbers(int group, int row, const val& values);
/// Makes the stage from what was typed in its file; and says that the typing is over, for undo.
std::string set_file(const std::string& text);
void end_typing();
/// Where one stands. bare: without what was edited.
val place(bool bare);
/// The same as a [[state]] of a demo's file.
std::string demo_state();
/// Reads an address, on the way to whose place go_along then goes.
val read_place(const std::string& address);
/// Lends the mesh that is needed.
std::string lend_mesh(const std::string& bytes);
/// Goes the next part of the way. A part may have to be prepared first (preparing).
val go_along();

}  // namespace snug::web
