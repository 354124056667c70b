// path: moves a body from place to place in straight lines at constant speed, to the last place or round and round.
#include <cmath>

#include "scene/effect.hpp"

namespace snug::scene {
namespace {

class Path final : public Effect {
 public:
  Path(std::size_t body, World& world, std::vector<V3> places, double speed, bool round)
      : body_(body), places_(std::move(places)), speed_(speed), round_(round) {
    world.members[body].driven = true;
    if (round_) places_.push_back(places_.front());
    ends_.push_back(0);
    for (std::size_t i = 1; i < places_.size(); ++i)
      ends_.push_back(ends_.back() + (places_[i] - places_[i - 1]).norm());
  }

  void run(World& world) override {
    world.place(body_, at(speed_ * world.step * world.state.frame), world.bodies[body_].orientation);
    world.state.changed(Slot::kPoses);
  }
  [[nodiscard]] bool idle(const World& world) const override {
    return ends_.back() == 0 || speed_ == 0 ||
           (!round_ && speed_ * world.step * (world.state.frame - 1) >= ends_.back());
  }

 private:
  [[nodiscard]] V3 at(double way) const {
    if (round_ && ends_.back() > 0) way = std::fmod(way, ends_.back());
    for (std::size_t i = 1; i < places_.size(); ++i)
      if (way < ends_[i])
        return places_[i - 1] + (places_[i] - places_[i - 1]) * ((way - ends_[i - 1]) / (ends_[i] - ends_[i - 1]));
    return places_.back();
  }

  std::size_t body_;
  std::vector<V3> places_;
  std::vector<double> ends_;  // the length of the way to each place
  double speed_;
  bool round_;
};

}  // namespace

MadeEffect make_path(const EffectCall& call, World& world) {
  Settings settings(call, world);
  const std::size_t body = settings.body();
  auto places = settings.places("places");
  const double speed = settings.number("speed", 1, 0, 1e6);
  constexpr std::string_view kEnds[] = {"stop", "round"};
  const bool round = settings.word("then", kEnds) == 1;
  if (places.empty()) places.push_back(V3::Zero());  // an empty list was refused
  return settings.make<Path>(body, world, std::move(places), speed, round);
}

}  // namespace snug::scene
