// A lesson's traces in one number: where it is the same natively and in WebAssembly, so is every bit of every step.
#pragma once

#include <cstdint>
#include <string>

#include "lesson/session.hpp"

namespace snug::lesson {

struct TraceHash {
  std::string lesson;      // its id
  std::int64_t steps = 0;  // of all algorithms together
  std::uint64_t hash = 0;  // over the hashes of their traces
};

/// Hashes every playable algorithm, in the lesson's order, on the session's points. The session is left with the last
/// of them in slot 0. Errors: as of choose.
[[nodiscard]] tl::expected<TraceHash, InputError> trace_hash(Session& session);

/// "ID STEPS HASH" without a line feed; the hash as hex_of has it.
[[nodiscard]] std::string line_of(const TraceHash& hash);

}  // namespace snug::lesson
