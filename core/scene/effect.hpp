// An effect: what a scene may call for. What it reads and writes decides when it runs, and whether.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "scene/world.hpp"

namespace snug::scene {

class Effect {
 public:
  virtual ~Effect() = default;
  Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;

  /// One frame. Says World::state.changed of each slot in which it left something other than was there.
  virtual void run(World& world) = 0;
  /// Whether time alone, with all else as it was, would have it change nothing. Asked of effects that read time.
  [[nodiscard]] virtual bool idle(const World&) const { return false; }
  /// The state is an earlier one: what the effect keeps from frame to frame is to be as it was then.
  virtual void restored(World&) {}
};

/// What of a body's pose an effect says itself, bits: what others would make of it is lost.
using PosePart = unsigned;
inline constexpr PosePart kPlace = 1, kTurn = 2, kWholePose = kPlace | kTurn;

/// A row of the catalogue.
struct EffectKind {
  std::string_view name;
  std::string_view says;   // what it does, in half a sentence
  SlotSet reads = 0;       // as they are in this frame: it runs after all that write or revise them
  SlotSet reads_last = 0;  // as the last frame left them
  SlotSet revises = 0;     // changes what others wrote: it runs after those, and before all that read
  SlotSet writes = 0;
  std::string_view calls_for;  // another effect that comes along with it; empty for none
  bool many = false;           // whether a scene may call for it more than once, for several bodies
  tl::expected<std::unique_ptr<Effect>, InputError> (*make)(const EffectCall& call, World& world) = nullptr;
  PosePart drives = 0;  // of the bodies that it is about; two effects drive no common part of one body
};

/// Every effect that there is. A new one is its file in effects/ and its row here.
[[nodiscard]] std::span<const EffectKind> catalogue();
/// Null where there is none of that name.
[[nodiscard]] const EffectKind* find_effect(std::span<const EffectKind> kinds, std::string_view name);

/// Reads a call's settings, and keeps the first thing that is wrong with them.
class Settings {
 public:
  Settings(const EffectCall& call, const World& world) : call_(call), world_(world) {}
  /// least <= the number <= most.
  double number(std::string_view key, double otherwise, double least, double most);
  V3 vector(std::string_view key, const V3& otherwise);
  /// Places, three numbers each, one after the other.
  std::vector<V3> places(std::string_view key);
  /// One of the words, the first where the call has none; its place among them.
  std::size_t word(std::string_view key, std::span<const std::string_view> words);
  /// Those that the call is about: one, or all that are not fixed.
  std::vector<std::size_t> bodies();
  /// The one that a call must name; 0 where it is refused.
  std::size_t body();
  void refuse(std::string what);

  /// The effect, unless something was wrong or a setting was not asked for.
  template <class Kind, class... Arguments>
  tl::expected<std::unique_ptr<Effect>, InputError> make(Arguments&&... arguments) {
    if (auto error = fault()) return tl::unexpected(*std::move(error));
    return std::unique_ptr<Effect>(std::make_unique<Kind>(std::forward<Arguments>(arguments)...));
  }

 private:
  const Setting* find(std::string_view key);
  [[nodiscard]] std::optional<InputError> fault();

  const EffectCall& call_;
  const World& world_;
  std::vector<const Setting*> known_;
  std::optional<InputError> wrong_;
};

/// What the rows call.
using MadeEffect = tl::expected<std::unique_ptr<Effect>, InputError>;
[[nodiscard]] MadeEffect make_spin(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_orbit(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_path(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_fall(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_drag(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_bounce(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_move(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_refit(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_broad_phase(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_narrow_phase(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_cull(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_shadow(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_trail(const EffectCall& call, World& world);
[[nodiscard]] MadeEffect make_projection_rays(const EffectCall& call, World& world);

}  // namespace snug::scene
