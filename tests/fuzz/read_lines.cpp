// libFuzzer: any bytes as the JSON Lines of `snug overlap` and `snug cull`, through the whole command: they are
// answered or refused, and nothing else. (Both print: see fuzz.sh.)
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <string>

#include "desktop/cli/cli.hpp"
#include "fuzz/bytes.hpp"

namespace {

int no_window(const snug::desktop::WindowOptions&) { return 2; }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  // The size stands for choices that the bytes alone make repeatable.
  const char* const command = size % 2 == 0 ? "overlap" : "cull";
  const char* const scalar = size / 2 % 2 == 0 ? "double" : "float";
  const int file = memfd_create("lines", 0);
  snug::fuzz::require(file >= 0 && write(file, data, size) == static_cast<ssize_t>(size));
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  const std::array<const char*, 5> arguments{"snug", command, "--scalar", scalar, path.c_str()};
  const int status = snug::desktop::run_command(5, arguments.data(), no_window);
  snug::fuzz::require(status == 0 || status == 2);
  close(file);
  return 0;
}
