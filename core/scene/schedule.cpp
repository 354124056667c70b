#include "scene/schedule.hpp"

#include <algorithm>

namespace snug::scene {
namespace {

/// The slots that every scene has from the start: its bodies, and time.
constexpr SlotSet kGiven = slots(Slot::kTime, Slot::kPoses, Slot::kVelocities);

bool calls(std::span<const Planned> planned, std::string_view name) {
  return std::any_of(planned.begin(), planned.end(), [&](const Planned& one) { return one.kind->name == name; });
}

tl::expected<std::vector<Planned>, InputError> called(std::span<const EffectCall> all,
                                                      std::span<const EffectKind> kinds) {
  std::vector<Planned> planned;
  for (const EffectCall& call : all) {
    const EffectKind* kind = find_effect(kinds, call.name);
    if (kind == nullptr) return tl::unexpected(error_at(call.line, "there is no effect called \"" + call.name + "\""));
    if (!kind->many && calls(planned, call.name))
      return tl::unexpected(error_at(call.line, call.name + " is called for twice"));
    planned.push_back({kind, call});
  }
  for (std::size_t i = 0; i < planned.size(); ++i) {
    const std::string name(planned[i].kind->calls_for);
    if (!name.empty() && !calls(planned, name))
      planned.push_back({find_effect(kinds, name), {.name = name, .line = planned[i].call.line}});
  }
  std::stable_sort(planned.begin(), planned.end(), [](const Planned& a, const Planned& b) { return a.kind < b.kind; });
  return planned;
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

}  // namespace

tl::expected<std::vector<Planned>, InputError> plan(std::span<const EffectCall> all,
                                                    std::span<const EffectKind> kinds) {
  auto planned = called(all, kinds);
  if (!planned) return planned;
  SlotSet made = kGiven;
  for (const Planned& one : *planned) made |= one.kind->writes;
  for (const Planned& one : *planned)
    if (const SlotSet missing = all_reads(*one.kind) & ~made)
      return tl::unexpected(error_at(one.call.line, one.call.name + " reads " + names_of(missing) +
                                                        ", which no effect of the scene makes" +
                                                        makers_of(missing, kinds)));

  std::vector<Planned> order;
  while (!planned->empty()) {
    const auto is_next = [&](const Planned& one) {
      return std::none_of(planned->begin(), planned->end(),
                          [&](const Planned& other) { return comes_before(*other.kind, *one.kind); });
    };
    const auto next = std::find_if(planned->begin(), planned->end(), is_next);
    if (next == planned->end())
      return tl::unexpected(
          error_at(planned->front().call.line, planned->front().call.name + " waits for an effect that waits for it"));
    order.push_back(std::move(*next));
    planned->erase(next);
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
