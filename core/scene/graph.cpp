#include "scene/graph.hpp"

#include <algorithm>

#include "geometry/sort.hpp"

namespace snug::scene {

int Rail::first() const {
  int first = begin();
  for (const std::vector<int>* stops : {&readers, &late})
    if (!stops->empty()) first = std::min(first, stops->front());
  return first;
}

int Rail::last() const {
  int last = begin();
  for (const std::vector<int>* stops : {&writers, &readers, &late})
    if (!stops->empty()) last = std::max(last, stops->back());
  return last;
}

std::vector<Rail> rails_of(std::span<const EffectKind* const> order) {
  std::vector<Rail> rails;
  for (std::size_t i = 0; i < kSlots; ++i) {
    Rail rail{.slot = static_cast<Slot>(i), .writers = {}, .readers = {}, .late = {}};
    for (std::size_t place = 0; place < order.size(); ++place) {
      const EffectKind& kind = *order[place];
      if (has(kind.writes | kind.revises, rail.slot)) rail.writers.push_back(static_cast<int>(place));
      if (has(kind.reads | kind.revises, rail.slot)) rail.readers.push_back(static_cast<int>(place));
      if (has(kind.reads_last, rail.slot)) rail.late.push_back(static_cast<int>(place));
    }
    if (!rail.writers.empty() || !rail.readers.empty() || !rail.late.empty()) rails.push_back(std::move(rail));
  }
  sort_stably(rails, [](const Rail& a, const Rail& b) { return a.begin() < b.begin(); });
  return rails;
}

}  // namespace snug::scene
