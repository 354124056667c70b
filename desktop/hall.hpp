// What a lecturer has over whatever the window shows: a spotlight, a pen that fades, a ruler for the height of type;
// black, a picture that stands; and the state to take along.
#pragma once

#include <string>
#include <vector>

#include "app/look.hpp"
#include "desktop/cli/page_address.hpp"

namespace snug::desktop {

class Hall {
 public:
  /// L: the spotlight; W: the pen; R: the ruler; or one of curtain_key. Returns whether the key was one of them.
  bool answer_key(const std::string& key);
  /// B or a full stop: black; F: the picture is frozen. Returns whether the key was one of them.
  bool curtain_key(const std::string& key);
  /// Lets the class see the window again.
  void lift() { black = frozen = false; }
  /// Puts away what is in use. Returns whether there was anything.
  bool put_away();
  void draw(const app::Look& look, const app::Rect& window, double now);
  /// Whether something fades, so that another frame is due.
  [[nodiscard]] bool moves() const { return !strokes_.empty(); }

  CodeWords taken;      // shown over everything, while it has letters
  bool black = false;   // whether the screen is
  bool frozen = false;  // whether the picture is frozen, whatever is done meanwhile

 private:
  struct Stroke {
    std::vector<ImVec2> points;
    double ended = 0;  // seconds
  };
  void write(const app::Look& look, const app::Rect& window, double now);

  bool spotlight_ = false, pen_ = false, ruler_ = false;
  std::vector<Stroke> strokes_;
  bool down_ = false;
};

}  // namespace snug::desktop
