#include "lesson/draft_text.hpp"
#include "web/values.hpp"
#include "web/view.hpp"

namespace snug::web {

using emscripten::val;

val draft_object(const lesson::Draft& draft, std::string_view file) {
  const lesson::DraftText says = lesson::text_of(draft, file);
  val object = val::object();
  object.set("heading", says.heading);
  object.set("lines", array_of(says.lines, [](const lesson::DraftText::Line& line) {
               val row = val::object();
               row.set("text", line.text);
               row.set("warning", line.warning);
               return row;
             }));
  return object;
}

}  // namespace snug::web
