#include "lesson/packed_rows.hpp"

#include <array>
#include <cmath>
#include <cstdint>

#include "number/bits.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr int kMostPackedDecimals = 9, kWholeDoubles = 255;
constexpr double kMostUnits = 1e15;  // a multiple of the last decimal's unit that a double counts exactly
constexpr std::size_t kMostUnpacked = 1'000'000;
constexpr std::array<double, kMostPackedDecimals + 1> kPowers{1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};

using Bytes = std::string;

std::string packed_letters(const Bytes& bytes) {
  std::string word;
  std::uint32_t bits = 0;
  int count = 0;
  const auto put = [&] {
    while (count >= 6) count -= 6, word += kLetters[bits >> count & 63];
  };
  for (const char byte : bytes) bits = bits << 8 | static_cast<unsigned char>(byte), count += 8, put();
  if (count > 0) bits <<= 6 - count, count = 6, put();
  return word;
}

std::optional<Bytes> unpacked_bytes(std::string_view word) {
  Bytes bytes;
  std::uint32_t bits = 0;
  int count = 0;
  for (const char letter : word) {
    const std::size_t value = kLetters.find(letter);
    if (value == std::string_view::npos) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(value), count += 6;
    if (count >= 8) count -= 8, bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

/// Seven bits a byte, the lowest first.
void put_whole(Bytes& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes += static_cast<char>(value | 0x80);
  bytes += static_cast<char>(value);
}

struct PackReader {
  std::string_view left;
  bool good = true;
  std::uint64_t byte() {
    if (left.empty()) return good = false, 0;
    const auto value = static_cast<unsigned char>(left.front());
    return left.remove_prefix(1), value;
  }
  std::uint64_t whole() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 63; shift += 7) {
      const std::uint64_t next = byte();
      value |= (next & 0x7f) << shift;
      if (next < 0x80) return value;
    }
    return good = false, 0;
  }
};

/// The number in units of its last decimal; none if that does not give the number back, bit for bit.
std::optional<std::int64_t> units_of(double number, int decimals) {
  const double count = std::round(number * kPowers[decimals]);
  if (!(std::abs(count) <= kMostUnits)) return std::nullopt;
  const auto whole = static_cast<std::int64_t>(count);  // which has no -0
  const double back = static_cast<double>(whole) / kPowers[decimals];
  return bits_of(back) == bits_of(number) ? std::optional(whole) : std::nullopt;
}

/// The fewest decimals that all numbers have; kWholeDoubles if that is more than kMostPackedDecimals.
int decimals_in(const Rows& rows) {
  const auto all_have = [&](int decimals) {
    for (const std::vector<double>& row : rows)
      for (const double number : row)
        if (!units_of(number, decimals)) return false;
    return true;
  };
  for (int decimals = 0; decimals <= kMostPackedDecimals; ++decimals)
    if (all_have(decimals)) return decimals;
  return kWholeDoubles;
}

void put_number(Bytes& bytes, double number, int decimals) {
  if (decimals != kWholeDoubles) {
    const std::int64_t count = *units_of(number, decimals);  // the sign is the lowest bit
    return put_whole(bytes, static_cast<std::uint64_t>(count) << 1 ^ static_cast<std::uint64_t>(count >> 63));
  }
  const auto bits = bits_of(number);
  for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
}

double take_number(PackReader& reader, int decimals) {
  if (decimals != kWholeDoubles) {
    const std::uint64_t folded = reader.whole();
    return static_cast<double>(static_cast<std::int64_t>(folded >> 1 ^ (~(folded & 1) + 1))) / kPowers[decimals];
  }
  std::uint64_t bits = 0;
  for (int shift = 0; shift < 64; shift += 8) bits |= reader.byte() << shift;
  return double_of(bits);
}

}  // namespace

std::string packed_rows(const Rows& rows) {
  const int decimals = decimals_in(rows);
  Bytes bytes(1, static_cast<char>(decimals));
  for (std::size_t i = 0, same = 0; i < rows.size(); i += same) {
    for (same = 1; i + same < rows.size() && rows[i + same].size() == rows[i].size();) ++same;
    put_whole(bytes, same);
    put_whole(bytes, rows[i].size());
    for (std::size_t k = i; k < i + same; ++k)
      for (const double number : rows[k]) put_number(bytes, number, decimals);
  }
  return packed_letters(bytes);
}

std::optional<Rows> unpacked_rows(std::string_view word) {
  const auto bytes = unpacked_bytes(word);
  if (!bytes) return std::nullopt;
  PackReader reader{*bytes};
  const int decimals = static_cast<int>(reader.byte());
  if (decimals > kMostPackedDecimals && decimals != kWholeDoubles) return std::nullopt;
  Rows rows;
  while (reader.good && !reader.left.empty()) {
    const std::uint64_t same = reader.whole(), numbers = reader.whole();
    if (!reader.good || same == 0 || numbers == 0 || same > kMostUnpacked || numbers > reader.left.size())
      return std::nullopt;
    for (std::uint64_t k = 0; k < same && reader.good; ++k) {
      std::vector<double>& row = rows.emplace_back();
      for (std::uint64_t n = 0; n < numbers && reader.good; ++n) {
        row.push_back(take_number(reader, decimals));
        if (!std::isfinite(row.back())) return std::nullopt;
      }
    }
  }
  return reader.good && !rows.empty() ? std::optional(std::move(rows)) : std::nullopt;
}

}  // namespace snug::lesson
