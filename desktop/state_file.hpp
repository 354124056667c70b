// The window's state as a file, for tests and lab scripts: where SNUG_STATE names one, it is written anew with each
// frame that shows something new. The same object as the page's window.snug.state(), with its handles.
#pragma once

#include <string>

#include "desktop/glfw_host.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {

class StateFile {
 public:
  StateFile();
  void write(Shell& shell, const Extent& extent);

 private:
  std::string path_, written_;
};

}  // namespace snug::desktop
