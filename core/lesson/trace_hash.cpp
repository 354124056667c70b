#include "lesson/trace_hash.hpp"

#include <tuple>

#include "lesson/play.hpp"

namespace snug::lesson {
namespace {

std::uint64_t fold(std::uint64_t hash, std::uint64_t bits) {
  for (int byte = 0; byte < 8; ++byte, bits >>= 8) hash = (hash ^ (bits & 0xff)) * 0x100000001b3u;
  return hash;
}

}  // namespace

tl::expected<TraceHash, InputError> trace_hash(Session& session) {
  TraceHash result{session.lesson().id, 0, 0xcbf29ce484222325u};
  for (const std::string& algorithm : playable(session)) {
    if (const auto chosen = session.choose(0, algorithm); !chosen) return tl::unexpected(chosen.error());
    result.steps += session.steps();
    result.hash = fold(result.hash, session.trace_hash());
  }
  return result;
}

std::string hex_of(std::uint64_t hash) {
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[hash >> shift & 0xf];
  return digits;
}

std::string line_of(const TraceHash& hash) {
  return hash.lesson + ' ' + std::to_string(hash.steps) + ' ' + hex_of(hash.hash);
}

bool comes_before(const Lesson& a, const Lesson& b) { return std::tie(a.order, a.id) < std::tie(b.order, b.id); }

}  // namespace snug::lesson
