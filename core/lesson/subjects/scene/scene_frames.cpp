#include "lesson/subjects/scene/scene_frames.hpp"

#include <utility>

#include "scene/bytes.hpp"

namespace snug::lesson {
namespace {

// If not all frames are kept, those that are kept get this fraction of the memory, because the scene's snapshots take
// some as well (kMostSnapshotBytes in scene/scene.cpp). bench_frames measures both together.
constexpr std::size_t kShareBesideSnapshots = 7;

std::size_t bytes_of(const SceneFrame& frame) {
  return sizeof frame + scene::bytes_in(frame.bodies) + scene::bytes_in(frame.volumes) + scene::bytes_in(frame.pairs) +
         scene::bytes_in(frame.near) + scene::bytes_in(frame.touching) + scene::bytes_in(frame.shadows) +
         scene::bytes_in(frame.trails) + scene::bytes_in(frame.rays) + scene::bytes_in(frame.asleep) +
         scene::bytes_in(frame.visibility) + scene::bytes_in(frame.swept);
}

SceneFrame seen(const scene::Scene& scene) {
  const scene::State& state = scene.world().state;
  SceneFrame frame{{},         state.volumes,     state.pairs, state.near,      {}, state.shadows, state.trails,
                   state.rays, state.funnel.axis, {},          state.visibility};
  if (frame.swept_along >= 0) frame.swept = state.sweep.bodies;
  frame.bodies.reserve(scene.world().bodies.size());
  for (const scene::Motion& body : scene.world().bodies) {
    frame.bodies.push_back({body.position, body.orientation});
    frame.asleep.push_back(body.asleep ? 1 : 0);
  }
  for (const scene::Contact& contact : scene.world().contacts)
    if (contact.touching) frame.touching.push_back(contact.pair);
  return frame;
}

}  // namespace

SceneFrames::SceneFrames(scene::Scene scene, std::size_t most) : scene_(std::move(scene)), size_(1), most_(most) {
  kept_.push_back(seen(*scene_));
  bytes_ = bytes_of(kept_.back());
}

void SceneFrames::drop(bool front) const {
  bytes_ -= bytes_of(front ? kept_.front() : kept_.back());
  if (front) kept_.pop_front(), ++first_;
  else kept_.pop_back();
}

void SceneFrames::step() {
  scene_->step();
  kept_.push_back(seen(*scene_));
  bytes_ += bytes_of(kept_.back());
  ++size_;
  if (first_ == 0 && bytes_ <= most_) return;
  while (bytes_ > most_ / kShareBesideSnapshots && kept_.size() > 1) drop(true);
}

void SceneFrames::finish() {
  if (kept_.size() == size_) scene_.reset();
}

const SceneFrame& SceneFrames::operator[](std::size_t frame) const {
  if (frame < first_ || frame >= end()) take_anew(frame);
  return kept_[frame - first_];
}

/// Computes a frame again, with those before it from the nearest snapshot on: who steps back needs them next.
void SceneFrames::take_anew(std::size_t frame) const {
  const auto wanted = static_cast<int>(frame);
  const int start = scene_->start_of(wanted);
  std::deque<SceneFrame> taken;
  scene_->go(start);
  if (start == wanted) taken.push_back(seen(*scene_));
  while (scene_->frame() < wanted) {
    scene_->step();
    taken.push_back(seen(*scene_));
  }
  const std::size_t first = frame + 1 - taken.size();
  const bool before = frame + 1 == first_, after = first == end();
  if (!before && !after) kept_.clear(), bytes_ = 0;
  if (!after) first_ = first;
  for (const SceneFrame& one : taken) bytes_ += bytes_of(one);
  kept_.insert(after ? kept_.end() : kept_.begin(), std::make_move_iterator(taken.begin()),
               std::make_move_iterator(taken.end()));
  while (bytes_ > most_ / kShareBesideSnapshots && kept_.size() > 1)
    drop(first_ < frame && (after || end() == frame + 1));
}

}  // namespace snug::lesson
