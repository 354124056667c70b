#include "lesson/subjects/scene/effect_words.hpp"

#include <algorithm>
#include <vector>

namespace snug::lesson {
namespace {

using Did = scene::Deed::Kind;

/// "1 of 8 effects runs", "none of 8 effects runs".
std::string share_words(std::int64_t some, std::int64_t all, const char* what, const char* one, const char* many) {
  const std::string all_of_them = std::to_string(all) + " " + what;
  if (some == all) return "all " + all_of_them + " " + many;
  if (some == 0) return "none of " + all_of_them + " " + one;
  return std::to_string(some) + " of " + all_of_them + " " + (some == 1 ? one : many);
}

}  // namespace

std::string name_of(const scene::EffectCall& call) { return call.name + (call.body.empty() ? "" : " " + call.body); }

std::string slot_words(scene::SlotSet slots) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < scene::kSlots; ++i)
    if (scene::has(slots, static_cast<scene::Slot>(i))) names.push_back(scene::kSlotNames[i]);
  std::string words;
  for (std::size_t i = 0; i < names.size(); ++i)
    words.append(i == 0 ? "" : i + 1 == names.size() ? " and " : ", ").append(names[i]);
  return words;
}

std::string deed_words(const scene::EffectKind& kind, const scene::Deed& deed) {
  switch (deed.kind) {
    case Did::kNone: return "has not run yet";
    case Did::kOff: return "switched off";
    case Did::kSkipped:
      return "skipped: " + (kind.idles.empty() ? "its inputs are unchanged" : std::string(kind.idles));
    case Did::kRan: break;
  }
  return deed.first ? "runs: all its inputs are new" : "runs: new " + slot_words(deed.news);
}

scene::Deed deed_of(const SceneRecording& run, int frame, std::size_t effect) {
  return frame == 0 ? scene::Deed() : run.deeds[(frame - 1) * run.tallies.size() + effect];
}

std::string counts_words(const SceneRecording& run, int frame) {
  const auto effects = static_cast<std::int64_t>(run.tallies.size());
  std::int64_t ran = 0;
  for (std::size_t i = 0; i < run.tallies.size(); ++i) ran += deed_of(run, frame, i).kind == Did::kRan ? 1 : 0;
  const auto bodies =
      std::count_if(run.members.begin(), run.members.end(), [](const scene::Member& member) { return member.moves(); });
  std::string words = effects == 0 ? "no effect is called for" : share_words(ran, effects, "effects", "runs", "run");
  if (bodies > 0) words += "; " + share_words(run.awake[frame], bodies, "bodies", "is awake", "are awake");
  return words + ".";
}

}  // namespace snug::lesson
