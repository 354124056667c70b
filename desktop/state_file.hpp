// The window's state as a file, for tests and lab scripts: if SNUG_STATE names a file, it is rewritten with each frame
// that shows something new. It is the same object as the page's window.snug.state(), and beside that what only a
// window has. Where both have a section, it is the one that the window drew.
#pragma once

#include <string>
#include <vector>

#include "desktop/glfw_host.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {

class StateFile {
 public:
  explicit StateFile(app::App& app);
  void write(Shell& shell, const Extent& extent);
  /// While a thread has the session, after a frame: what the window says of the time. All else stands as it was written
  /// last.
  void write_beside(const std::string& time);

 private:
  std::string path_, written_;
  std::vector<app::DrawnWords> words_;  // of the frame
  int beside_ = 0;                      // frames that were drawn while a thread had the session
};

}  // namespace snug::desktop
