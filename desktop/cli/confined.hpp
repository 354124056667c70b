// Runs another program within limits: for code that somebody else wrote.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace snug::desktop {

struct Limits {
  double seconds = 10;               // on the clock
  std::int64_t bytes = 512LL << 20;  // of memory in use, and of what it prints
  /// Whether it starts no other program, has no network, and changes no file. What the system allows of this is done:
  /// all of it on Linux, on the processors that Debian is for.
  bool confined = true;
};

struct Ended {
  enum class How : std::uint8_t { kDone, kTime, kMemory, kOutput, kSignal, kNotStarted } how = How::kDone;
  int status = 0;  // its exit status, or the signal
  std::string out, err;
};

/// Runs it until it ends or a limit ends it. arguments: the program's path or name first. input: its standard input.
[[nodiscard]] Ended run_within(const Limits& limits, const std::vector<std::string>& arguments, std::string_view input,
                               const std::vector<std::string>& environment = {});

}  // namespace snug::desktop
