// A state to take along: its address as a QR code, and four letters by which two screens see that they show the same.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snug::lesson {

struct QrCode {
  int size = 0;            // modules along a side, without the quiet zone
  std::vector<bool> dark;  // row by row
  [[nodiscard]] bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < size && y < size && dark[static_cast<std::size_t>(y * size + x)];
  }
};

/// Modules of the light margin that a reader needs on each side.
inline constexpr int kQuietZone = 4;

/// None if the text needs more than 61 modules a side: from forty metres away, a phone's camera cannot tell more apart
/// on a code two metres high. 321 bytes always fit.
[[nodiscard]] std::optional<QrCode> qr_code(const std::string& text);

/// Four consonants: states whose traces differ nearly always have different ones (160,000 of them).
[[nodiscard]] std::string fingerprint(std::uint64_t trace_hash);

}  // namespace snug::lesson
