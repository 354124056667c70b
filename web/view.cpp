#include "web/view.hpp"

#include <span>

#include "app/panel_words.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/say.hpp"
#include "lesson/speaking.hpp"
#include "lesson/stored.hpp"
#include "lesson/subjects.hpp"
#include "web/cover.hpp"
#include "web/deeds.hpp"
#include "web/numbers.hpp"
#include "web/prose.hpp"
#include "web/values.hpp"

namespace snug::web {
namespace {

using emscripten::val;

/// [x, y] or [x, y, z].
val coordinates(const Vector<double, 3>& point, int dim) { return array_of(std::span(point.data(), dim), number); }

void set_algorithms(val& object, const lesson::Session& session) {
  const lesson::Method* main = session.player().method(0);
  const lesson::Method* beside = session.player().method(1);
  const auto name = [&](const lesson::Method& method) { return text(lesson::name_in(session.lesson(), method)); };
  object.set("algorithm", name(*main));
  object.set("beside", beside != nullptr ? name(*beside) : val::null());
  object.set("codeTitle", text(main->title));
  object.set("code", array_of(session.player().pseudocode(0), text));
  object.set("line", session.player().line());
  object.set("rivals", array_of(session.player().rivals(), [&](const lesson::Rival& rival) {
               val row = val::object();
               row.set("name", name(*rival.method));
               row.set("title", lesson::title_in(session.lesson(), *rival.method));
               const bool hidden = session.telling().hides_result(*rival.method);
               row.set("size", hidden ? val::null() : val(rival.size));
               row.set("excess", rival.excess && !hidden ? val(*rival.excess) : val::null());
               return row;
             }));
}

void set_figures(val& object, const lesson::Session& session) {
  val readout = val::object();
  const auto figures = session.telling().figures();
  for (const auto& figure : figures)
    if (figure.known) readout.set(figure.key, figure.value);
  object.set("readout", readout);
  object.set("figures", array_of(figures, [](const lesson::Figure& figure) {
               val row = val::object();
               row.set("key", figure.key);
               row.set("name", figure.name);
               row.set("text", figure.text);
               return row;
             }));
}

void set_points(val& object, const app::App& app, const lesson::Session& session) {
  object.set("numbers", numbers_object(session));
  object.set("toolsWord", text(session.stage().subject().tools().word));
  object.set("toolsTitle", text(session.stage().subject().tools().title));
  object.set("size", lesson::count_of(session.stage().subject()));
  object.set("dim", session.stage().subject().dim());
  object.set("edited", session.stage().edited());
  object.set("source", session.stage().subject().origin().source);
  object.set("seed", static_cast<double>(session.stage().subject().origin().seed));
  const bool in_float = session.stage().subject().in_float(), offered = session.stage().subject().scalar() != nullptr;
  object.set("scalar", offered ? val(in_float ? "float" : "double") : val::null());
  object.set("canUndo", session.stage().can_undo());
  object.set("canRedo", session.stage().can_redo());
  const Index selected = app.selected();
  const bool any = selected >= 0 && selected < session.stage().subject().size();
  object.set("selected", any ? val(selected) : val::null());
  object.set("selectedName", any ? val(session.stage().subject().name_of(selected)) : val::null());
  object.set("coordinates",
             any ? coordinates(session.stage().subject().at(selected), session.stage().subject().dim()) : val::null());
}

void set_sliders(val& object, const lesson::Session& session) {
  object.set("situation", session.lesson().situations.empty() ? val::null() : val(session.stage().situation()));
  object.set("sliders", array_of(session.stage().sliders(), [](const lesson::ShownSlider& slider) {
               val row = val::object();
               row.set("number", static_cast<double>(slider.number));
               row.set("title", slider.slider->title);
               row.set("value", slider.value);
               row.set("text", slider.text);
               row.set("place", slider.place);
               row.set("places", slider.places);
               return row;
             }));
}

/// What the prose lights on the stage, and the stage in the prose.
val lit_object(const app::App& app, const lesson::Session& session) {
  val object = val::object();
  object.set("mark", text(app.lit()));
  object.set("handles", array_of(lesson::marked_handles(session, app.lit()),
                                 [&](Index handle) { return val(session.stage().subject().name_of(handle)); }));
  object.set("words", array_of(app.marks_in_hand(), text));
  return object;
}

/// Adds a place on the canvas.
void set_rect(val& object, const app::Rect& rect) {
  object.set("x", rect.x);
  object.set("y", rect.y);
  object.set("width", rect.width);
  object.set("height", rect.height);
}

/// What one who is new is asked to do next, at its place on the canvas.
val invitation_object(const std::optional<app::Invitation>& invitation) {
  if (!invitation) return val::null();
  val object = val::object();
  object.set("words", invitation->words);
  set_rect(object, invitation->at);
  return object;
}

/// The lesson's close-up: where in the scene, how wide, how many times larger; and its panel's place on the canvas.
val close_up_object(const std::optional<app::CloseUp>& close_up, int dim) {
  if (!close_up) return val::null();
  val object = val::object();
  object.set("at", coordinates(close_up->at, dim));
  object.set("size", close_up->size);
  object.set("times", close_up->times);
  set_rect(object, close_up->panel);
  return object;
}

val stored_form_object(const lesson::StoredForm& form) {
  val object = val::object();
  object.set("name", form.name);
  object.set("bytes", form.bytes());
  object.set("members", array_of(form.members, [](const lesson::StoredMember& member) {
               val row = val::object();
               row.set("declared", member.declared);
               row.set("text", member.text);
               row.set("mark", member.mark);
               return row;
             }));
  object.set("operations", array_of(form.operations, [](const lesson::StoredOperation& operation) {
               val row = val::object();
               row.set("name", operation.name);
               row.set("says", operation.says);
               row.set("least", operation.least);
               return row;
             }));
  return object;
}

/// What a panel beside the stage tells: {title, head, rows, says, button}.
val panel_object(const app::PanelWords& panel) {
  val object = val::object();
  object.set("title", panel.table.title);
  object.set("head", array_of(panel.table.head, text));
  object.set("rows", array_of(panel.table.rows, [](const auto& row) { return array_of(row, text); }));
  object.set("says", panel.says);
  object.set("button", panel.button ? button_object(*panel.button) : val::null());
  return object;
}

/// How the volumes on the stage are stored.
val stored_object(const lesson::Session& session) {
  return array_of(lesson::stored_of(session), [](const lesson::StoredVolume& volume) {
    val object = val::object();
    object.set("title", volume.title);
    object.set("forms", array_of(volume.forms, stored_form_object));
    return object;
  });
}

/// The text that the stage is made from.
val file_object(const lesson::Session& session) {
  const auto file = session.stage().subject().file();
  if (!file) return val::null();
  val object = val::object();
  object.set("own", file->own);
  object.set("runs", file->runs);
  object.set("typed", file->typed);
  object.set("heading", file->heading());
  object.set("mistakes", array_of(file->mistakes, text));
  return object;
}

val switch_object(const lesson::Switch& one) {
  val object = val::object();
  object.set("effect", one.name);
  object.set("on", one.on);
  object.set("constructed", static_cast<double>(one.constructed));
  object.set("run", static_cast<double>(one.run));
  object.set("skipped", static_cast<double>(one.skipped));
  object.set("microseconds", one.microseconds);
  object.set("called", one.called);
  object.set("says", one.says);
  return object;
}

}  // namespace

val view_object(app::App& app, const lesson::Session& session) {
  val object = val::object();
  object.set("lesson", session.lesson().id);
  object.set("step", session.player().step());
  object.set("steps", session.player().steps());
  object.set("caption", app.caption());
  const std::optional<int> section = lesson::section_at(session);
  object.set("section", section ? val(*section) : val::null());
  object.set("lit", lit_object(app, session));
  object.set("invitation", invitation_object(app.invitation()));
  object.set("closeUp", close_up_object(app.close_up(), session.stage().subject().dim()));
  object.set("invited", app.invitations_followed());
  object.set("playing", app.playing());
  object.set("speed", app.speed());
  object.set("previewing", session.player().previewing());
  set_answers(object, session);
  object.set("exercise", exercise_object(app));
  object.set("preparing", preparing());
  object.set("framesDrawn", static_cast<double>(app.frames_drawn()));
  object.set("cover", cover_object(app));
  set_algorithms(object, session);
  set_figures(object, session);
  object.set("panels", array_of(app.panel_words(), panel_object));
  object.set("proseFigures", prose_figures_object(session));
  set_points(object, app, session);
  set_sliders(object, session);
  object.set("stored", stored_object(session));
  object.set("file", file_object(session));
  object.set("effects", array_of(session.player().switches(), switch_object));
  return object;
}

}  // namespace snug::web
