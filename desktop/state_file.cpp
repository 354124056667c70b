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
  state["notice"] = shell.notice;
  state["readout"] = nlohmann::ordered_json::object();
  for (const auto& figure : session->figures())
    if (figure.known) state["readout"][figure.key] = figure.value;
  state["handles"] = nlohmann::ordered_json::array();
  for (const app::Handle& handle : app.handles())  // in the window system's pixels, where a mouse would find them
    state["handles"].push_back(
        {{"id", handle.id}, {"x", handle.x * extent.window_per_page}, {"y", handle.y * extent.window_per_page}});
  std::string text = state.dump();
  if (text == written_) return;
  written_ = std::move(text);
  state["framesDrawn"] = app.frames_drawn();
  static_cast<void>(write_file(path_, state.dump() + "\n"));  // a state that cannot be written must not end a lesson
}

}  // namespace snug::desktop
