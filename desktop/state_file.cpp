#include "desktop/state_file.hpp"

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "desktop/cli/files.hpp"
#include "number/fnv.hpp"

namespace snug::desktop {
StateFile::StateFile() {
  if (const char* path = std::getenv("SNUG_STATE")) path_ = path;
}

void StateFile::write(Shell& shell, const Extent& extent) {
  app::App& app = shell.app();
  const lesson::Session* session = app.session();
  if (path_.empty() || session == nullptr) return;
  nlohmann::ordered_json state;
  state["lesson"] = session->lesson().id;
  if (shell.course_shown) {
    state = {{"lesson", nullptr}, {"chosen", shell.course.chosen()}, {"lead", shell.lead().second}};
    for (std::size_t i = 0; i < shell.lessons().size(); ++i) {
      const auto& [path, lesson, chapter] = shell.lessons()[i];
      const KeptLesson* const kept = shell.kept().lesson(lesson.id);
      state["course"].push_back({{"id", lesson.id},
                                 {"number", i + 1},
                                 {"title", lesson.title},
                                 {"chapter", chapter},
                                 {"done", kept != nullptr && kept->done}});
    }
    if (std::string text = state.dump(); text != written_)
      static_cast<void>(write_file(path_, (written_ = text) + "\n"));
    return;
  }
  state["seed"] = session->seed();
  state["step"] = session->step();
  state["steps"] = session->steps();
  state["caption"] = app.caption();
  state["trace"] = hex_of(session->trace_hash());
  state["points"] = session->size();
  state["selected"] = app.selected();
  state["asked"] = nullptr;
  if (const lesson::Asked* asked = session->asked())
    state["asked"] = {{"id", asked->question->id},
                      {"choices", asked->choices},
                      {"targets", session->target_names()},
                      {"says", session->answer_says()}};
  state["outcomes"] = session->outcomes().size();
  const lesson::Outcome* told = session->outcome();
  state["outcome"] = told != nullptr ? nlohmann::ordered_json(told->question) : nlohmann::ordered_json();
  state["deciding"] = session->deciding() != nullptr;
  state["summary"] = session->at_summary();
  const lesson::Tally tally = session->tally();
  state["tally"] = {{"right", tally.right}, {"wrong", tally.wrong}, {"skipped", tally.skipped}, {"open", tally.open}};
  state["notice"] = shell.notice;
  state["section"] = shell.section;
  state["scrolled"] = shell.scrolled;
  state["lit"] = app.lit();
  state["marks"] = app.marks_in_hand();
  state["scrolling"] = shell.scroll_to >= 0;
  state["algorithm"] = session->method(0)->name;
  state["links"] = nlohmann::ordered_json::array();
  for (const auto& [target, at] : shell.links)
    state["links"].push_back({{"to", target},
                              {"x", (at.x + at.width / 2) * extent.window_per_page},
                              {"y", (at.y + at.height / 2) * extent.window_per_page}});
  state["readout"] = nlohmann::ordered_json::object();
  for (const auto& figure : session->figures())
    if (figure.known) state["readout"][figure.key] = figure.value;
  state["handles"] = nlohmann::ordered_json::array();
  for (const app::Handle& handle : app.handles())  // in the window system's pixels, for a real mouse
    state["handles"].push_back(
        {{"id", handle.id}, {"x", handle.x * extent.window_per_page}, {"y", handle.y * extent.window_per_page}});
  std::string text = state.dump();
  if (text == written_) return;
  written_ = std::move(text);
  state["framesDrawn"] = app.frames_drawn();
  static_cast<void>(write_file(path_, state.dump() + "\n"));  // a failure to write must not end the lesson
}

}  // namespace snug::desktop
