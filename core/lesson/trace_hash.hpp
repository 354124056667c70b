// A lesson's traces as one number: if it is the same natively and in WebAssembly, so is every bit of every step.
#pragma once

#include <cstdint>
#include <string>

#include "lesson/session.hpp"

namespace snug::lesson {

struct TraceHash {
  std::string lesson;      // its id
  std::int64_t steps = 0;  // those of all algorithms together
  std::uint64_t hash = 0;  // a hash over the hashes of their traces
};

/// Hashes every playable algorithm, in the lesson's order, on the session's points. The session is left with the last
/// of them in slot 0. Errors: those of choose.
[[nodiscard]] tl::expected<TraceHash, InputError> trace_hash(Session& session);

/// "ID STEPS HASH" without a line feed; the hash in the form of hex_of.
[[nodiscard]] std::string line_of(const TraceHash& hash);

}  // namespace snug::lesson
