#include "desktop/cli/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace snug::desktop {
namespace {

using namespace std::chrono_literals;
constexpr auto kLong = 500ms;
constexpr auto kBetween = 100ms;
constexpr int kWidth = 30;

/// "40 s", "3 min", "2 h"
std::string duration_text(double seconds) {
  const auto rounded = [](double value) { return std::to_string(static_cast<std::int64_t>(std::ceil(value))); };
  if (seconds < 100) return rounded(seconds) + " s";
  return seconds < 5400 ? rounded(seconds / 60) + " min" : rounded(seconds / 3600) + " h";
}

}  // namespace

std::string progress_text(std::string_view label, int done, int total, double seconds) {
  const std::size_t filled = std::int64_t{kWidth} * done / std::max(total, 1);
  const double rate = seconds > 0 ? done / seconds : 0;
  std::string text(label);
  text += " [" + std::string(filled, '#') + std::string(kWidth - filled, '.') + "] " + std::to_string(done) + " of " +
          std::to_string(total);
  if (done == 0 || rate <= 0) return text;
  std::array<char, 32> per{};
  if (rate >= 1) std::snprintf(per.data(), per.size(), ", %.3g a second", rate);
  else std::snprintf(per.data(), per.size(), ", %.3g s each", 1 / rate);
  return text + per.data() + ", " + duration_text((total - done) / rate) + " left";
}

Progress::Progress(const char* label, int total)
    : label_(label), total_(total), terminal_(isatty(STDERR_FILENO) == 1), begun_(Clock::now()), due_(begun_ + kLong) {}

Progress::~Progress() {
  if (shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::advance() {
  ++done_;
  if (!terminal_ || Clock::now() < due_) return;
  due_ = Clock::now() + kBetween;
  shown_ = true;
  const double seconds = std::chrono::duration<double>(Clock::now() - begun_).count();
  std::fprintf(stderr, "\r%s\x1b[K", progress_text(label_, done_, total_, seconds).c_str());
  std::fflush(stderr);
}

}  // namespace snug::desktop
