// What to do first, on the stage of the course's first lesson: three invitations, one at a time, each gone once it was
// followed.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lesson/session.hpp"

namespace snug::lesson {

enum class Invited { kDrag, kStep, kPlay };

class Invitations {
 public:
  static constexpr int kAll = 3;
  /// followed: so many were, and are not shown again.
  explicit Invitations(int followed = kAll) : followed_(followed) {}

  /// How many were followed.
  [[nodiscard]] int followed() const { return followed_; }
  /// The one that is due: none beside a question and what is said of it, nor before the player was used on a result
  /// that is shown first, nor to step after the last step. What was shown before and has been done since is followed.
  std::optional<Invited> due(const Session& session, bool playing);

 private:
  [[nodiscard]] bool is_followed(const Session& session, bool playing) const;

  int followed_;
  int shown_at_ = -1;  // the step at which the one that is due was first shown
};

/// "Drag P12", "Now press Step" … handle: its name. step: the word on the button.
[[nodiscard]] std::string invitation_text(Invited invited, std::string_view handle, std::string_view step);

}  // namespace snug::lesson
