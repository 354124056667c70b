// A large file that is read beside the window, which answers meanwhile.
#pragma once

#include <chrono>
#include <cstdint>
#include <future>
#include <string>
#include <tl/expected.hpp>

#include "geometry/input_error.hpp"
#include "io/point_file.hpp"

namespace snug::desktop {

class Loading {
 public:
  /// A file of fewer bytes is read at once, in a part of a second.
  static constexpr std::uintmax_t kLarge = 4'000'000;
  explicit Loading(std::string path);

  [[nodiscard]] const std::string& path() const { return path_; }
  /// What is read, how large it is, for how long already, and about how long still.
  [[nodiscard]] std::string says() const;
  [[nodiscard]] bool done() const { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// What was read; once, when it is done.
  [[nodiscard]] tl::expected<io::PointFile, InputError> take() { return result_.get(); }

 private:
  std::string path_;
  std::uintmax_t bytes_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::future<tl::expected<io::PointFile, InputError>> result_;
};

}  // namespace snug::desktop
