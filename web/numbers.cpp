#include "web/numbers.hpp"

#include "web/values.hpp"

namespace snug::web {

using emscripten::val;

val numbers_object(const lesson::Session& session) {
  const auto row_object = [](const lesson::NumberRow& row) {
    val object = val::object();
    object.set("words", text(row.words));
    object.set("unit", text(row.unit));
    object.set("turn", row.turn);
    object.set("names", array_of(row.names, text));
    object.set("values", array_of(row.values, number));
    return object;
  };
  return array_of(session.stage().subject().numbers(), [&](const lesson::NumberGroup& group) {
    val object = val::object();
    object.set("heading", text(group.heading));
    object.set("name", text(group.name));
    object.set("rows", array_of(group.rows, row_object));
    return object;
  });
}

std::string take_numbers(lesson::Session& session, int group, int row, const val& values) {
  const auto set = session.stage().set_numbers(group, row, emscripten::vecFromJSArray<double>(values));
  return set ? "" : set.error().message();
}

}  // namespace snug::web
