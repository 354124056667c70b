// A progress bar on stderr, for long work.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace snug::desktop {

/// "timing [####......] 4 of 10, 2 a second, 3 s left". seconds: since the work began.
[[nodiscard]] std::string progress_text(std::string_view label, int done, int total, double seconds);

/// It is shown only on a terminal, only if the work is long, and removed when done.
class Progress {
 public:
  /// label: a word that outlives it. total: how many times advance will be called.
  Progress(const char* label, int total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance();

 private:
  using Clock = std::chrono::steady_clock;
  const char* label_;
  int total_;
  int done_ = 0;
  bool terminal_;
  bool shown_ = false;
  Clock::time_point begun_, due_;
};

}  // namespace snug::desktop
