// The figures of the run in the lesson's texts, as they are now.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/prose.hpp"
#include "lesson/session/telling.hpp"

namespace snug::lesson {

/// A figure as a text shows it.
struct FigureNow {
  std::string text;       // "2.118 units", on one line; or what stands for it
  std::string_view says;  // why it is not shown: "hidden until you answer"; empty: it is shown
};

inline constexpr std::string_view kFigureHidden = "hidden until you answer", kFigureUnknown = "not known yet",
                                  kFigureRefused = "not for these points", kFigureNone = "none";

/// Looks the figures of one moment up, each once.
class ProseFigures {
 public:
  explicit ProseFigures(const Conversation& now) : now_(now) {}
  /// It stays where it is as long as this does.
  [[nodiscard]] const FigureNow& of(const RunFigure& figure);
  /// Whether the sentence that a stretch of the paragraph belongs to is shown: not while one of its figures has no
  /// value yet.
  [[nodiscard]] bool tells(const Paragraph& paragraph, const Stretch& stretch);

 private:
  [[nodiscard]] FigureNow look_up(const RunFigure& figure);

  const Conversation& now_;
  std::optional<std::vector<Figure>> shown_;  // those of the inspector
  std::map<std::string, FigureNow> found_;
};

/// Whether a figure of a method's result may be told now, in a chart as in a text.
[[nodiscard]] bool may_tell_result(const Conversation& now, const Method& method, std::string_view key);

/// A text with inline markup, such as a prompt, with its figures as they are now, in plain words.
[[nodiscard]] std::string plain_now(std::string_view text, ProseFigures& figures);

}  // namespace snug::lesson
