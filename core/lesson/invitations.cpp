#include "lesson/invitations.hpp"

namespace snug::lesson {

bool Invitations::is_followed(const Session& session, bool playing) const {
  switch (static_cast<Invited>(followed_)) {
    case Invited::kDrag: return session.stage().edited();
    case Invited::kStep: return session.player().step() > shown_at_;
    case Invited::kPlay:
      return playing || session.player().step() > shown_at_ + 1;  // where it plays on within a moment
  }
  return false;
}

std::optional<Invited> Invitations::due(const Session& session, bool playing) {
  if (followed_ < kAll && shown_at_ >= 0 && is_followed(session, playing)) ++followed_, shown_at_ = -1;
  const bool told = session.conversation().asked() != nullptr || session.conversation().deciding() != nullptr ||
                    session.conversation().outcome() != nullptr;
  if (followed_ >= kAll || told || session.conversation().at_summary() || session.player().previewing())
    return std::nullopt;
  if (followed_ == 0 && session.player().step() > 0) return std::nullopt;
  if (static_cast<Invited>(followed_) == Invited::kStep && session.player().step() >= session.player().steps())
    return std::nullopt;
  if (shown_at_ < 0) shown_at_ = session.player().step();
  return static_cast<Invited>(followed_);
}

std::string invitation_text(Invited invited, std::string_view handle, std::string_view step) {
  switch (invited) {
    case Invited::kDrag: return "Drag " + std::string(handle);
    case Invited::kStep: return "Now press " + std::string(step);
    case Invited::kPlay: break;
  }
  return "Press Play: it stops where it asks you";
}

}  // namespace snug::lesson
