#include "desktop/cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace snug::desktop {
namespace {

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool is_terminal() { return isatty(STDOUT_FILENO) == 1; }

bool has_color() {
  const char* const term = std::getenv("TERM");
  return is_terminal() && !is_set("NO_COLOR") && term != nullptr && std::string_view(term) != "dumb";
}

int terminal_width() {
  constexpr int kUsual = 100, kLeast = 40;
  winsize size{};
  if (!is_terminal() || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < kLeast) return kUsual;
  return size.ws_col;
}

}  // namespace snug::desktop
