#include "lesson/subjects/scene/searched.hpp"

#include <algorithm>

#include "lesson/ask.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/scene/entries.hpp"

namespace snug::lesson {
namespace {

std::optional<hierarchy::PairSearch> search_named(std::string_view name) {
  const auto& names = hierarchy::kPairSearchNames;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<hierarchy::PairSearch>(found - names.begin());
}

/// The effects by which bodies move from the velocities that they have.
bool is_of_velocities(const scene::EffectCall& call) {
  return call.name == "fall" || call.name == "bounce" || call.name == "drag" || call.name == "move";
}

/// Bodies do not move by their velocities in the scenes shown (search_shown), so no margin is added.
Aabb<double, 3> box_searched(const Aabb<double, 3>& aabb) { return scene::with_room(aabb, 0); }

std::optional<hierarchy::PairSearch> search_asked(const Asked& asked) {
  return search_shown(as<SceneSubject>(*asked.subject)->set(), asked.question->gate.algorithm);
}

}  // namespace

std::optional<hierarchy::PairSearch> search_shown(const SceneSet& set, std::string_view method) {
  if (std::any_of(set.effects.begin(), set.effects.end(), is_of_velocities)) return std::nullopt;
  for (const scene::EffectCall& call : set.effects) {
    if (call.name != "broad_phase") continue;
    if (const auto own = search_named(method)) return own;
    for (const scene::Setting& setting : call.settings)
      if (setting.key == "search") return search_named(setting.text);
    return hierarchy::PairSearch::kSweepAndPrune;
  }
  return std::nullopt;
}

std::vector<BodyPair> pairs_compared(const SceneFrame& frame, hierarchy::PairSearch search) {
  std::vector<Aabb<double, 3>> boxes;
  for (const Aabb<double, 3>& aabb : frame.volumes) boxes.push_back(box_searched(aabb));
  std::vector<BodyPair> compared;
  hierarchy::SweepOrder sweep{frame.swept_along, frame.swept};
  static_cast<void>(hierarchy::broad_phase(boxes, search, &sweep, &compared));
  return compared;
}

std::vector<Index> compared_with(std::span<const BodyPair> compared, Index body) {
  std::vector<Index> others;
  for (const BodyPair& pair : compared) {
    if (pair.a == body) others.push_back(pair.b);
    if (pair.b == body) others.push_back(pair.a);
  }
  std::sort(others.begin(), others.end());
  return others;
}

std::vector<Index> most_compared(std::span<const BodyPair> compared, std::size_t bodies) {
  std::vector<int> counts(bodies, 0);
  for (const BodyPair& pair : compared) ++counts[pair.a], ++counts[pair.b];
  const int most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  std::vector<Index> all;
  for (std::size_t i = 0; most > 0 && i < bodies; ++i)
    if (counts[i] == most) all.push_back(static_cast<Index>(i));
  return all;
}

std::vector<Index> active_list(const SceneFrame& frame, Index body) {
  std::vector<Index> active;
  const int axis = frame.swept_along;
  const auto box = [&](Index i) { return box_searched(frame.volumes[i]); };
  for (const Index other : frame.swept) {
    if (other == body) break;
    if (box(other).max[axis] >= box(body).min[axis]) active.push_back(other);
  }
  return active;
}

const char* offer_bodies(Asked& asked, const Run&) {
  const auto* scene = as<SceneSubject>(*asked.subject);
  if (scene == nullptr || !scene->set().at_points() || scene->set().bodies.size() != 1)
    return "\"most_compared\" can only be asked if there is a body at each point and no other";
  if (!search_asked(asked)) return "\"most_compared\" can only be asked of a search for pairs";
  asked.on_stage = true;
  return nullptr;
}

Truth most_compared_truth(const Asked& asked, const Run& run) {
  const SceneFrame& frame = scene_run(run).recording().frames[asked.fact + 1];
  const std::vector<BodyPair> compared = pairs_compared(frame, *search_asked(asked));
  Truth truth;
  truth.points = most_compared(compared, frame.bodies.size());
  truth.happened = asked.names(truth.points);
  const std::size_t most = truth.points.empty() ? 0 : compared_with(compared, truth.points.front()).size();
  truth.sentence = truth.points.empty()
                       ? std::string("No two AABBs are compared.")
                       : truth.happened + (truth.points.size() == 1 ? " is" : " are each") + " compared with " +
                             count_text(static_cast<std::int64_t>(most)) + (most == 1 ? " other." : " others.");
  return truth;
}

}  // namespace snug::lesson
