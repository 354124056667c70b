#include "scene/schedule.hpp"

#include <algorithm>

#include "geometry/sort.hpp"

namespace snug::scene {
namespace {

/// The slots that every scene has from the start: its bodies, and time.
constexpr SlotSet kGiven = slots(Slot::kTime, Slot::kPoses, Slot::kVelocities);

bool calls(std::span<const Planned> planned, std::string_view name) {
  return std::any_of(planned.begin(), planned.end(), [&](const Planned& one) { return one.kind->name == name; });
}

/// The effects that are called, and what is wrong with the other calls: an unknown effect, or one that was called
/// already.
struct Called {
  std::vector<Planned> planned;
  std::vector<InputError> faults;
};

Called called(std::span<const EffectCall> all, std::span<const EffectKind> kinds) {
  Called result;
  std::vector<Planned>& planned = result.planned;
  for (const EffectCall& call : all) {
    const EffectKind* kind = find_effect(kinds, call.name);
    if (kind == nullptr)
      result.faults.push_back(error_at(call.line, "there is no effect called \"" + call.name + "\""));
    else if (!kind->many && calls(planned, call.name))
      result.faults.push_back(error_at(call.line, call.name + " is called for twice"));
    else planned.push_back({kind, call});
  }
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const std::string name(planned[i].kind->calls_for);
    if (!name.empty() && !calls(planned, name))
      planned.push_back({find_effect(kinds, name), {.name = name, .line = planned[i].call.line}});
  }
  sort_stably(planned, [](const Planned& a, const Planned& b) { return a.kind < b.kind; });
  return result;
}

std::string names_of(SlotSet set) {
  std::string names;
  for (std::size_t i = 0; i < kSlots; ++i)
    if (has(set, static_cast<Slot>(i))) names.append(names.empty() ? "" : ", ").append(kSlotNames[i]);
  return names;
}

/// Which effects would write any of these slots: ": broad_phase would".
std::string makers_of(SlotSet set, std::span<const EffectKind> kinds) {
  std::string names;
  for (const EffectKind& kind : kinds)
    if ((kind.writes & set) != 0) names.append(names.empty() ? "" : ", ").append(kind.name);
  return names.empty() ? names : ": " + names + " would";
}

SlotSet all_reads(const EffectKind& kind) { return kind.reads | kind.reads_last | kind.revises; }

/// Whether a has to run before b.
bool comes_before(const EffectKind& a, const EffectKind& b) {
  if (&a == &b) return false;
  const bool for_readers = ((a.writes | a.revises) & b.reads) != 0;
  const bool for_revisers = (a.writes & b.revises) != 0;
  const bool of_revisers = (a.revises & b.revises) != 0 && &a < &b;
  return for_readers || for_revisers || of_revisers;
}

/// Each effect that reads what no effect of the scene makes.
std::vector<InputError> lacking(const std::vector<Planned>& planned, std::span<const EffectKind> kinds) {
  std::vector<InputError> faults;
  SlotSet made = kGiven;
  for (const Planned& one : planned) made |= one.kind->writes;
  for (const Planned& one : planned)
    if (const SlotSet missing = all_reads(*one.kind) & ~made)
      faults.push_back(error_at(one.call.line, one.call.name + " reads " + names_of(missing) +
                                                   ", which no effect of the scene makes" + makers_of(missing, kinds)));
  return faults;
}

}  // namespace

std::vector<Planned> known_calls(std::span<const EffectCall> all, std::span<const EffectKind> kinds) {
  return called(all, kinds).planned;
}

std::vector<InputError> plan_faults(std::span<const EffectCall> all, std::span<const EffectKind> kinds) {
  Called found = called(all, kinds);
  return found.faults.empty() ? lacking(found.planned, kinds) : found.faults;
}

tl::expected<std::vector<Planned>, InputError> plan(std::span<const EffectCall> all,
                                                    std::span<const EffectKind> kinds) {
  if (std::vector<InputError> faults = plan_faults(all, kinds); !faults.empty())
    return tl::unexpected(std::move(faults.front()));
  std::vector<Planned> planned = known_calls(all, kinds);
  std::vector<Planned> order;
  while (!planned.empty()) {
    const auto is_next = [&](const Planned& one) {
      return std::none_of(planned.begin(), planned.end(),
                          [&](const Planned& other) { return comes_before(*other.kind, *one.kind); });
    };
    const auto next = std::find_if(planned.begin(), planned.end(), is_next);
    if (next == planned.end())
      return tl::unexpected(
          error_at(planned.front().call.line, planned.front().call.name + " waits for an effect that waits for it"));
    order.push_back(std::move(*next));
    planned.erase(next);
  }
  return order;
}

SlotSet missing_for(const EffectKind& kind, std::span<const EffectCall> all, std::span<const EffectKind> kinds) {
  SlotSet made = kGiven;
  for (const EffectCall& call : all)
    if (const EffectKind* writer = find_effect(kinds, call.name)) made |= writer->writes;
  return all_reads(kind) & ~made;
}

}  // namespace snug::scene
