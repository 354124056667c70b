// What the user does on the page: each is a function that page/door.js calls. An error is a sentence; "" is none.
#pragma once

#include <emscripten/val.h>

#include <string>

namespace snug::web {

using emscripten::val;

bool command(const std::string& name);
std::string command_of_key(const std::string& key, bool shift, bool control);
/// Chooses an answer by its number; the same once more gives it.
void pick_choice(int choice);
/// A handle's name as it was typed. false: it cannot be the answer.
bool pick_name(const std::string& name);
/// The names of the handles that can be the answer: of a mesh thousands, so they are no part of view().
val targets();
/// Two fingers: factor > 1 as they part, around (x, y), which moved by (dx, dy).
void pinch(float factor, float x, float y, float dx, float dy);
void go(int step);
void jump(int step);
void forget_answers();
/// The answers given, for the device to keep; and those of an earlier visit to a lesson, before it is opened.
std::string kept_answers();
void keep_answers(const std::string& lesson, const std::string& kept);
/// Those of every lesson.
void erase_answers();
/// name: "" clears the one beside.
std::string choose(int slot, const std::string& name);
void select_point(int point);
std::string move_point(int point, double x, double y, double z);
/// Points anew from a seed, of the kind that they are now.
void scatter(double seed);
/// Points of another kind.
std::string set_generator(const std::string& kind, int count, double seed);
/// A point file of any of the formats, or an earlier file of what the lesson shows beside its stage.
std::string load_file(const std::string& bytes, const std::string& name);
/// A slice of the measurement that runs. milliseconds: the budget.
void measure_slice(double milliseconds);
bool measuring();
/// How much of the run is done, from 0 to 1.
double measured();
val cover_file(const std::string& format);
/// Lights a mark that the prose links to, until another, or "" for none.
void light(const std::string& mark);
void start_task();
/// Of one of view()'s numbers, by the places of its group and row.
std::string set_numbers(int group, int row, const val& values);
std::string set_rows(const val& rows);
std::string change_rows(const val& moved);
val shared_rows();

}  // namespace snug::web
