#include "desktop/state_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "desktop/cli/files.hpp"
#include "desktop/keys_card.hpp"
#include "desktop/measured_before.hpp"
#include "lesson/door_words.hpp"
#include "lesson/patience.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
StateFile::StateFile(app::App& app) {
  const char* const path = std::getenv("SNUG_STATE");
  if (path == nullptr) return;
  path_ = path;
  app.note_words(&words_);
}

namespace {

using Json = nlohmann::ordered_json;

/// The lines of the strip, those of a file after its heading.
Json mistakes_of(const Shell& shell) {
  Json lines = Json::array();
  for (const check::DraftText& says : shell.strip()) {
    lines.push_back(says.heading);
    for (const check::DraftText::Line& line : says.lines) lines.push_back(line.text);
  }
  return lines;
}

/// The lowest words on the screen; null where there are none.
Json smallest_of(const std::vector<app::DrawnWords>& words) {
  const auto lower = [](const app::DrawnWords& a, const app::DrawnWords& b) { return a.size < b.size; };
  const auto smallest = std::min_element(words.begin(), words.end(), lower);
  if (smallest == words.end()) return {};
  return {{"size", smallest->size}, {"words", smallest->words}};
}

Json course_state(Shell& shell) {
  Json state{{"lesson", nullptr},
             {"chosen", shell.course.chosen(shell)},
             {"lead", shell.lead().second},
             {"focus", shell.focus.name()},
             {"asked", shell.course.asked()},
             {"found", shell.course.found(shell)},
             {"found_beside", shell.course.found_beside(shell)},
             {"kept", shell.kept().works()},
             {"set_aside", shell.kept().set_aside()}};
  for (std::size_t i = 0; i < shell.lessons().size(); ++i) {
    const auto& [path, lesson, chapter, slides, is_case, is_playground, sheet] = shell.lessons()[i];
    if (sheet != nullptr) {
      state["sheets"].push_back(lesson.id);
      continue;
    }
    if (is_case) {
      state["cases"].push_back(lesson.id);
      continue;
    }
    const KeptLesson* const kept = shell.kept_lesson(lesson.id);
    state["course"].push_back({{"id", lesson.id},
                               {"number", i + 1},
                               {"title", lesson.title},
                               {"chapter", chapter},
                               {"done", kept != nullptr && kept->done}});
  }
  return state;
}

void add_answers(Json& state, const lesson::Session& session) {
  state["asked"] = nullptr;
  if (const lesson::Asked* asked = session.conversation().asked())
    state["asked"] = {{"id", asked->question->id},
                      {"choices", asked->choices},
                      {"targets", session.conversation().target_names()},
                      {"says", session.conversation().answer_says()}};
  state["outcomes"] = session.log().outcomes().size();
  const lesson::Outcome* told = session.conversation().outcome();
  state["outcome"] = told != nullptr ? Json(told->question) : Json();
  state["deciding"] = session.conversation().deciding() != nullptr;
  state["summary"] = session.conversation().at_summary();
  const lesson::Tally tally = session.conversation().tally();
  state["tally"] = {{"right", tally.right}, {"wrong", tally.wrong}, {"skipped", tally.skipped}, {"open", tally.open}};
}

/// Adds the sliders, with the places of their tracks. scale: as for add_places.
void add_sliders(Json& state, Shell& shell, float scale) {
  state["sliders"] = Json::array();
  for (const lesson::ShownSlider& slider : shell.session().stage().sliders()) {
    Json one{{"title", slider.slider->title}, {"value", slider.value}, {"text", slider.text}};
    for (const auto& [number, track] : shell.tracks)
      if (number == slider.number)
        one["x"] = track.x * scale, one["y"] = (track.y + track.height / 2) * scale, one["width"] = track.width * scale;
    state["sliders"].push_back(std::move(one));
  }
}

/// scale: pixels of the window system, for a real mouse, in one pixel of the page.
void add_places(Json& state, Shell& shell, float scale) {
  state["links"] = Json::array();
  for (const auto& [target, at] : shell.links)
    state["links"].push_back(
        {{"to", target}, {"x", (at.x + at.width / 2) * scale}, {"y", (at.y + at.height / 2) * scale}});
  state["stored"] = Json::array();
  for (const auto& [mark, at] : shell.stored_rows)
    state["stored"].push_back({{"mark", mark},
                               {"text", shell.stored_before[mark].first},
                               {"x", (at.x + at.width / 2) * scale},
                               {"y", (at.y + at.height / 2) * scale}});
  state["figures"] = shell.figures;
  state["handles"] = Json::array();
  for (const app::Handle& handle : shell.app().handles())
    state["handles"].push_back({{"id", handle.id}, {"x", handle.x * scale}, {"y", handle.y * scale}});
}

/// Null while a lesson is open.
Json exercise_state(Shell& shell) {
  const lesson::Sitting* const sitting = shell.app().sitting();
  if (sitting == nullptr) return {};
  const lesson::Session& session = shell.session();
  return {{"exercise", sitting->exercise().id}, {"seed", sitting->seed()},
          {"decision", sitting->at(session)},   {"decisions", sitting->of()},
          {"mark", sitting->mark(session)},     {"finished", sitting->finished(session)},
          {"hints", sitting->hints(session)},   {"run", static_cast<int>(sitting->looks_at(session))}};
}

Json lesson_state(Shell& shell, float scale) {
  const app::App& app = shell.app();
  const lesson::Session& session = shell.session();
  Json state{{"lesson", session.lesson().id},
             {"seed", session.stage().subject().origin().seed},
             {"step", session.player().step()},
             {"steps", session.player().steps()},
             {"caption", app.caption()},
             {"trace", hex_of(session.player().trace_hash())},
             {"points", lesson::count_of(session.stage().subject())},
             {"selected", app.selected()}};
  add_answers(state, session);
  state["exercise"] = exercise_state(shell);
  state["sheet"] = shell.sheet() != nullptr ? json_of(shell.sheet()->lesson.id, 0, shell.sheet_work()) : Json();
  const MeasuredTable* const before = shell.measured_before();
  state["measured_before"] = before != nullptr ? Json(measured_says(*before)) : Json();
  state["situation"] = session.lesson().situations.empty() ? Json() : Json(session.stage().situation());
  add_sliders(state, shell, scale);
  state["scalar"] = session.stage().subject().in_float() ? "float" : "double";
  if (const auto file = session.stage().subject().file())
    state["file"] = {{"runs", file->runs}, {"typed", file->typed}, {"mistakes", file->mistakes}};
  state["notice"] = shell.notice;
  const lesson::Preparation* const preparing = session.stage().preparing();
  state["preparing"] = preparing != nullptr ? Json{{"says", preparing->says()}, {"share", preparing->share()}} : Json();
  state["focus"] = shell.focus.name();
  state["text_scale"] = shell.app().settings().text_scale;
  state["theme"] = lesson::kThemeWords[static_cast<std::size_t>(shell.app().settings().theme)];
  state["presenting"] = shell.presenting;
  state["freeHeight"] = app.free_height();
  state["textShown"] = shell.presenting ? shell.text_shown : true;
  const auto& invitation = app.invitation();
  state["invitation"] = invitation ? Json(invitation->words) : Json();
  state["section"] = shell.section;
  state["scrolled"] = shell.scrolled;
  state["lit"] = app.lit();
  state["marks"] = app.marks_in_hand();
  state["scrolling"] = shell.scroll_to >= 0;
  state["algorithm"] = lesson::name_in(session.lesson(), *session.player().method(0));
  state["readout"] = Json::object();
  for (const auto& figure : session.telling().figures())
    if (figure.known) state["readout"][figure.key] = figure.value;
  if (shell.demo) {
    const lesson::Vote* const vote = shell.demo->vote();
    state["demo"] = {{"state", shell.demo->at() + 1},
                     {"notes", shell.demo->notes_wanted},
                     {"next", shell.demo->next_text()},
                     {"vote", vote != nullptr ? vote->told_text() : ""},
                     {"shown", vote == nullptr           ? ""
                               : shell.demo->vote_told() ? vote->told_text()
                                                         : vote->hidden_text()}};
  }
  state["code"] = shell.hall.taken.letters;
  state["codeAddress"] = shell.hall.taken.address;
  state["hall"] = {{"black", shell.hall.black}, {"frozen", shell.hall.frozen}};
  add_places(state, shell, scale);
  return state;
}

}  // namespace

void StateFile::write(Shell& shell, const Extent& extent) {
  if (path_.empty() || (!shell.course_shown && shell.app().session() == nullptr)) return;
  Json state = shell.course_shown ? course_state(shell) : lesson_state(shell, extent.window_per_page);
  state["height"] = extent.height;
  state["smallest"] = smallest_of(words_);
  state["asks_path"] = shell.file_card.what != FileCard::What::kNone && !shell.dialog_open;
  state["dialog"] = shell.dialog_open;
  state["frames_beside"] = beside_;
  state["keys"] = Json::array();
  if (shell.keys_shown)
    for (const app::KeyRow& row : key_rows(shell)) state["keys"].push_back(row.keys);
  state["about"] = shell.about_shown ? shell.parts : "";
  state["replaces"] = shell.file_card.replaces;
  state["mistakes"] = mistakes_of(shell);
  std::string text = state.dump();
  if (text == written_) return;
  written_ = std::move(text);
  if (!shell.course_shown) state["framesDrawn"] = shell.app().frames_drawn();
  static_cast<void>(write_file(path_, state.dump() + "\n"));  // a failure to write must not end the lesson
}

void StateFile::write_beside(const std::string& time) {
  ++beside_;
  if (path_.empty() || written_.empty()) return;
  Json state = Json::parse(written_);
  state["frames_beside"] = beside_;
  state["preparing"]["time"] = time;
  static_cast<void>(write_file(path_, state.dump() + "\n"));
}

}  // namespace snug::desktop
