#include "desktop/cli/progress.hpp"

#include <cstdio>
#include <string>
#include <unistd.h>

namespace snug::desktop {
namespace {

using namespace std::chrono_literals;
constexpr auto kLong = 500ms;
constexpr auto kBetween = 100ms;
constexpr int kWidth = 30;

}  // namespace

Progress::Progress(const char* label, int total)
    : label_(label), total_(total), terminal_(isatty(STDERR_FILENO) == 1), due_(Clock::now() + kLong) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::advance() {
  ++done_;
  if (!terminal_ || Clock::now() < due_) return;
  due_ = Clock::now() + kBetween;
  shown_ = true;
  const std::size_t filled = std::int64_t{kWidth} * done_ / total_;
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  std::fprintf(stderr, "\r%s [%s] %d of %d", label_, bar.c_str(), done_, total_);
  std::fflush(stderr);
}

}  // namespace snug::desktop
