#include "lesson/trace_hash.hpp"

#include "lesson/playable.hpp"
#include "lesson/situations.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
tl::expected<TraceHash, InputError> trace_hash(Session& session) {
  TraceHash result{session.lesson().id};
  Fnv1a hash;
  for (const std::string_view situation : situation_names(session.lesson())) {
    if (const Done shown = session.stage().show_situation(situation); !shown) return tl::unexpected(shown.error());
    for (const std::string& algorithm : playable(session)) {
      if (const auto chosen = session.player().choose(0, algorithm); !chosen) return tl::unexpected(chosen.error());
      result.steps += session.player().steps();
      hash.add_bits(session.player().trace_hash());
    }
  }
  result.hash = hash.value();
  return result;
}

std::string line_of(const TraceHash& hash) {
  return hash.lesson + ' ' + std::to_string(hash.steps) + ' ' + hex_of(hash.hash);
}

}  // namespace snug::lesson
