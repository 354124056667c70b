#include "web/cover.hpp"

#include "web/values.hpp"

namespace snug::web {
namespace {

using emscripten::val;

val button_object(const app::CoverButton& button) {
  val object = val::object();
  object.set("command", button.command);
  object.set("words", button.words);
  object.set("chosen", button.chosen);
  object.set("enabled", button.enabled);
  return object;
}

val table_object(const app::WordTable& table) {
  val object = val::object();
  object.set("head", array_of(table.head, text));
  object.set("rows", array_of(table.rows, [](const auto& row) { return array_of(row, text); }));
  object.set("title", table.title);
  object.set("sorts", array_of(table.sorts, text));
  object.set("sorted", table.sorted);
  object.set("picks", array_of(table.picks, text));
  object.set("picked", table.picked);
  object.set("best", array_of(table.best, [](const auto& row) {
               val flags = val::array();
               for (const bool best : row) flags.call<void>("push", best);
               return flags;
             }));
  return object;
}

}  // namespace

cost::Provenance web_provenance(const std::string& processor) {
  return {.version = SNUG_VERSION, .build = SNUG_BUILD, .platform = "WebAssembly", .processor = processor};
}

val cover_object(app::App& app) {
  const app::Cover* const cover = app.cover();
  if (cover == nullptr) return val::null();
  const lesson::Session& session = *app.session();
  const app::WordTable table = cover->table(session);
  val object = val::object();
  object.set("choices", array_of(cover->choices(session), button_object));
  object.set("work", array_of(cover->work_buttons(session), button_object));
  object.set("button", button_object(cover->button()));
  object.set("shown", cover->shown());
  object.set("running", cover->running());
  object.set("progress", cover->progress());
  object.set("decided", cover->decided(session));
  object.set("says", cover->status(session));
  object.set("table", table_object(table));
  object.set("formats", array_of(cover->formats(), text));
  object.set("any", !table.rows.empty());
  return object;
}

val cover_file_object(app::App& app, const std::string& format) {
  val object = val::object();
  object.set("name", app.cover()->file_name() + "." + format);
  object.set("text", app.cover()->file(format));
  return object;
}

}  // namespace snug::web
