#include "lesson/stored.hpp"

#include "lesson/subjects/pair/read_volumes.hpp"
#include "lesson/subjects/pair/stored.hpp"

namespace snug::lesson {
namespace {

/// The tables of the situation that is shown, if it says what is stored, or else the lesson's own.
const VolumeTables& tables_of(const Session& session) {
  for (const Situation& situation : session.lesson().situations) {
    if (situation.name != session.stage().situation()) continue;
    const auto& tables = static_cast<const VolumeTables&>(*situation.tables);
    if (tables.stored[0] || tables.stored[1]) return tables;
  }
  return static_cast<const VolumeTables&>(*session.lesson().tables);
}

}  // namespace

std::vector<StoredVolume> stored_volumes(const Session& session) {
  const auto* subject = as<VolumesSubject>(session.stage().subject());
  if (subject == nullptr) return {};
  const auto& wanted = tables_of(session).stored;
  std::vector<StoredVolume> all;
  for (const std::size_t side : {0, 1}) {
    if (!wanted[side]) continue;
    const HeldVolume& held = subject->pair().held[side];
    const std::string name = side == 0 ? "A" : "B";
    all.push_back({name, name + ": " + stored_title(held.volume, held.dim), stored_forms(held.volume, held.dim)});
  }
  return all;
}

}  // namespace snug::lesson
