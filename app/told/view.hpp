// What changes while a lesson is open, in parts: one object has the keys of all of them.
#pragma once

#include <string>
#include <vector>

#include "app/told/answers.hpp"
#include "app/told/cover.hpp"
#include "app/told/exercise.hpp"
#include "app/told/figures.hpp"
#include "app/told/json.hpp"
#include "app/told/player.hpp"
#include "app/told/stage.hpp"

namespace snug::app::told {

/// Calls see(part) for each part of what is told of the open lesson. Two parts have no key of the same name.
template <class See>
void see_parts(App& app, See&& see) {
  const lesson::Session& session = *app.session();
  see(player_of(app, session));
  see(Frames{app.frames_drawn()});
  see(algorithms_of(session));
  see(conversation_of(session));
  see(log_of(session));
  see(tasks_of(session));
  see(exercise_of(app));
  see(figures_of(app, session));
  see(points_of(app, session));
  see(parts_of(session));
  see(cover_of(app));
}

/// All of it.
[[nodiscard]] std::string view_text(App& app);

/// Tells only those parts that have changed.
class Changes {
 public:
  /// An object with the keys of what is another than at the call before.
  [[nodiscard]] std::string tell(App& app);

 private:
  std::vector<std::string> last_;  // the texts of the parts
};

}  // namespace snug::app::told
