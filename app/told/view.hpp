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

/// What a part is told from: the session alone, so that it changes only with App::session_revision, or the app as well.
enum class From { kSession, kApp };

/// Calls see(from, part) for each part of what is told of the open lesson, where part() makes it. Two parts have no key
/// of the same name.
template <class See>
void see_parts(App& app, See&& see) {
  const lesson::Session& session = *app.session();
  see(From::kApp, [&] { return player_of(app, session); });
  see(From::kApp, [&] { return Frames{app.frames_drawn()}; });
  see(From::kSession, [&] { return algorithms_of(session); });
  see(From::kSession, [&] { return conversation_of(session); });
  see(From::kSession, [&] { return log_of(session); });
  see(From::kSession, [&] { return tasks_of(session); });
  see(From::kApp, [&] { return exercise_of(app); });
  see(From::kSession, [&] { return figures_of(session); });
  see(From::kApp, [&] { return panels_of(app); });
  see(From::kApp, [&] { return points_of(app, session); });
  see(From::kSession, [&] { return parts_of(session); });
  see(From::kApp, [&] { return cover_of(app); });
}

/// All of it.
[[nodiscard]] std::string view_text(App& app);

/// Tells only those parts that have changed.
class Changes {
 public:
  /// An object with the keys of what is another than at the call before.
  [[nodiscard]] std::string tell(App& app);

 private:
  std::vector<std::string> last_;    // the texts of the parts
  App::SessionRevision revision_{};  // when they were told
};

}  // namespace snug::app::told
