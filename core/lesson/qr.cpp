#include "lesson/qr.hpp"

#include <qrcodegen.hpp>

namespace snug::lesson {
namespace {

constexpr int kLargestVersion = 11;                               // 61 modules
constexpr std::size_t kMostCodeBytes = 321;                       // at the lowest level of correction
constexpr std::string_view kConsonants = "BCDFGHJKMNPQRSTVWXYZ";  // which make no word, and are not taken for 1 and 0

}  // namespace

std::optional<QrCode> qr_code(const std::string& text) {
  if (text.size() > kMostCodeBytes) return std::nullopt;  // the generator would throw
  using qrcodegen::QrCode;
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  const QrCode made =
      QrCode::encodeSegments({qrcodegen::QrSegment::makeBytes(bytes)}, QrCode::Ecc::LOW, 1, kLargestVersion);
  lesson::QrCode code{made.getSize(), {}};
  for (int y = 0; y < code.size; ++y)
    for (int x = 0; x < code.size; ++x) code.dark.push_back(made.getModule(x, y));
  return code;
}

std::string fingerprint(std::uint64_t trace_hash) {
  std::string letters;
  for (int i = 0; i < 4; ++i, trace_hash /= kConsonants.size()) letters += kConsonants[trace_hash % kConsonants.size()];
  return letters;
}

}  // namespace snug::lesson
