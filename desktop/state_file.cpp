#include "desktop/state_file.hpp"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/told/view.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/keys_card.hpp"
#include "desktop/measured_before.hpp"
#include "lesson/door_words.hpp"
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

/// Adds the places of the sliders' tracks. scale: as for add_places.
void add_tracks(Json& sliders, const Shell& shell, float scale) {
  for (Json& slider : sliders)
    for (const auto& [number, track] : shell.tracks)
      if (slider["number"] == number)
        slider["x"] = track.x * scale, slider["y"] = (track.y + track.height / 2) * scale,
        slider["width"] = track.width * scale;
}

/// scale: pixels of the window system, for a real mouse, in one pixel of the page.
void add_places(Json& state, Shell& shell, float scale) {
  state["links"] = Json::array();
  for (const auto& [target, at] : shell.links)
    state["links"].push_back(
        {{"to", target}, {"x", (at.x + at.width / 2) * scale}, {"y", (at.y + at.height / 2) * scale}});
  state["storedRows"] = Json::array();
  for (const auto& [mark, at] : shell.stored_rows)
    state["storedRows"].push_back({{"mark", mark},
                                   {"text", shell.stored_before[mark].first},
                                   {"x", (at.x + at.width / 2) * scale},
                                   {"y", (at.y + at.height / 2) * scale}});
  state["figuresDrawn"] = shell.figures;
  state["handles"] = Json::array();
  for (const app::Handle& handle : shell.app().handles())
    state["handles"].push_back({{"id", handle.id}, {"x", handle.x * scale}, {"y", handle.y * scale}});
}

/// What the page tells of a lesson, and what only the window has.
Json lesson_state(Shell& shell, float scale) {
  app::App& app = shell.app();
  const lesson::Session& session = shell.session();
  Json state = Json::parse(app::told::view_text(app));
  state["trace"] = hex_of(session.player().trace_hash());
  state["points"] = state["size"];
  if (session.conversation().asked() != nullptr) state["asked"]["targets"] = session.conversation().target_names();
  state["sheet"] = shell.sheet() != nullptr ? json_of(shell.sheet()->lesson.id, 0, shell.sheet_work()) : Json();
  const MeasuredTable* const before = shell.measured_before();
  state["measured_before"] = before != nullptr ? Json(measured_says(*before)) : Json();
  add_tracks(state["sliders"], shell, scale);
  state["notice"] = shell.notice;
  state["focus"] = shell.focus.name();
  state["text_scale"] = shell.app().settings().text_scale;
  state["theme"] = lesson::kThemeWords[static_cast<std::size_t>(shell.app().settings().theme)];
  state["presenting"] = shell.presenting;
  state["freeHeight"] = app.free_height();
  state["textShown"] = shell.presenting ? shell.text_shown : true;
  state["section"] = shell.section;
  state["scrolled"] = shell.scrolled;
  state["scrolling"] = shell.scroll_to >= 0;
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
  state["scanned"] = shell.hall.taken.letters;
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
  state.erase("framesDrawn");  // a frame that shows nothing new is not written
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
