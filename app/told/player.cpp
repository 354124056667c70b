#include "app/told/player.hpp"

#include <utility>

#include "app/timeline_map.hpp"
#include "app/told/stage.hpp"
#include "lesson/patience.hpp"
#include "lesson/speaking.hpp"

namespace snug::app::told {
namespace {

Rectangle rectangle_of(const Rect& own) { return {own.x, own.y, own.width, own.height}; }

}  // namespace

Player player_of(const App& app, const lesson::Session& session) {
  const lesson::Subject& subject = session.stage().subject();
  Player told{.lesson = session.lesson().id,
              .step = session.player().step(),
              .steps = session.player().steps(),
              .furthest = furthest_to_show(session, app.sitting()),
              .caption = app.caption(),
              .section = lesson::section_at(session),
              .lit = {.mark = app.lit(), .words = app.marks_in_hand()},
              .invited = app.invitations_followed(),
              .playing = app.playing(),
              .speed = app.speed(),
              .previewing = session.player().previewing(),
              .preparing = preparing_of(session)};
  for (const Index handle : lesson::marked_handles(session, app.lit()))
    told.lit.handles.push_back(subject.name_of(handle));
  if (const auto& invitation = app.invitation())
    told.invitation = Invitation{rectangle_of(invitation->at), invitation->words};
  if (const auto close_up = app.close_up())
    told.close_up = CloseUp{rectangle_of(close_up->panel), coordinates_of(close_up->at, subject.dim()), close_up->size,
                            close_up->times};
  return told;
}

std::optional<Preparing> preparing_of(const lesson::Session& session) {
  const lesson::Preparation* now = session.stage().preparing();
  if (now == nullptr) return std::nullopt;
  return Preparing{now->says(), now->share()};
}

}  // namespace snug::app::told
