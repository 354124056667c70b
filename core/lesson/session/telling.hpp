// What may be told now of a run, and what an open question keeps hidden.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lesson/session/conversation.hpp"

namespace snug::lesson {

class Telling {
 public:
  explicit Telling(const Conversation& now) : now_(now), stage_(now.stage()), player_(now.player()) {}

  /// The sentence for the current step.
  [[nodiscard]] std::string caption() const;
  [[nodiscard]] std::vector<Figure> figures(int slot = 0) const;
  /// The key of the figure that the open question asks for, which is hidden meanwhile; empty for none.
  [[nodiscard]] std::string_view asked_figure() const;
  /// Whether a figure is hidden: it is asked for, or the first question about it is still open, further on.
  [[nodiscard]] bool is_hidden(std::string_view figure) const { return untold().hides(figure); }
  [[nodiscard]] Untold untold() const;
  /// Whether a question about a step is open: the result of the run is then hidden everywhere.
  [[nodiscard]] bool predicting() const;
  /// Whether a question that compares the lesson's methods is still open, in the run of any of them: their results are
  /// hidden until it is answered or skipped. false for a subject that was edited.
  [[nodiscard]] bool comparing() const;
  /// Whether a question about a figure of that method is still open here, in whatever run the player is; empty: any
  /// question in that method's run. false for a subject that was edited.
  [[nodiscard]] bool awaits(const Method& of, std::string_view figure) const;
  /// Whether a method's result is hidden in the comparison.
  [[nodiscard]] bool hides_result(const Method& of) const;

 private:
  const Conversation& now_;
  const Stage& stage_;
  const Player& player_;
};

}  // namespace snug::lesson
