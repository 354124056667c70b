// The `snug` command. Its window is a program of its own, so that the command needs neither OpenGL nor a screen's
// libraries: where the window is asked for, that program takes this one's place, with the same arguments.
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "desktop/cli/cli.hpp"
#include "desktop/cli/data_folder.hpp"

namespace {

char** arguments;

int become_window(const snug::desktop::WindowOptions&) {
  const auto program = snug::desktop::window_program();
  ::execv(program.c_str(), arguments);
  if (errno == ENOENT) std::fprintf(stderr, "snug: the window is not installed: there is no %s\n", program.c_str());
  else std::fprintf(stderr, "snug: %s: %s\n", program.c_str(), std::strerror(errno));
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  arguments = argv;
  return snug::desktop::run_command(argc, argv, {&become_window, false});
}
