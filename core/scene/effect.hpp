// The effects that a scene may call for. What an effect reads and writes decides when it runs, and whether it does.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "scene/world.hpp"

namespace snug::scene {

class Effect {
 public:
  virtual ~Effect() = default;
  Effect() = default;
  Effect(const Effect&) = delete;
  Effect& operator=(const Effect&) = delete;

  /// Runs one frame. Calls World::state.changed for each slot whose content it changed.
  virtual void run(World& world) = 0;
  /// Whether the effect would change nothing if only time has changed. Only called for effects that read time.
  [[nodiscard]] virtual bool idle(const World&) const { return false; }
  /// Called when the state was reset to an earlier one: resets what the effect keeps from frame to frame.
  virtual void restored(World&) {}
};

/// The parts of a body's pose that an effect sets itself, as bits: what other effects did to them is lost.
using PosePart = unsigned;
inline constexpr PosePart kPlace = 1, kTurn = 2, kWholePose = kPlace | kTurn;

/// A row of the catalogue.
struct EffectKind {
  std::string_view name;
  std::string_view says;   // what it does, in half a sentence
  SlotSet reads = 0;       // as of this frame: it runs after all effects that write or revise them
  SlotSet reads_last = 0;  // as the last frame left them
  SlotSet revises = 0;     // changes what others wrote: it runs after those, and before all readers
  SlotSet writes = 0;
  std::string_view calls_for;  // another effect that is added with it; empty for none
  bool many = false;           // whether a scene may call for it more than once, for several bodies
  tl::expected<std::unique_ptr<Effect>, std::vector<InputError>> (*make)(const EffectCall& call,
                                                                         World& world) = nullptr;
  PosePart drives = 0;          // of the bodies that it is about; no two effects may drive the same part of one body
  std::string_view idles = {};  // of one that reads time: why it has nothing to do when it is idle
};

/// All effects. A new one is its file in effects/ and its row here.
[[nodiscard]] std::span<const EffectKind> catalogue();
/// The effect with that name; null if there is none.
[[nodiscard]] const EffectKind* find_effect(std::span<const EffectKind> kinds, std::string_view name);

/// Why an effect cannot be made: all that is wrong with its settings, or with the scene for it.
using Faults = std::vector<InputError>;
/// What the rows' makers return.
using MadeEffect = tl::expected<std::unique_ptr<Effect>, Faults>;

/// Reads a call's settings, and keeps what is wrong with them.
class Settings {
 public:
  Settings(const EffectCall& call, const World& world) : call_(call), world_(world) {}
  /// The number, from least to most; `otherwise` if it is missing or refused.
  double number(std::string_view key, double otherwise, double least, double most);
  V3 vector(std::string_view key, const V3& otherwise);
  /// A list of places, stored as three numbers each.
  std::vector<V3> places(std::string_view key);
  /// The index of a word; 0, the first, if the call has none.
  std::size_t word(std::string_view key, std::span<const std::string_view> words);
  /// The bodies that the call is about: one, or all that are not fixed.
  std::vector<std::size_t> bodies();
  /// The body that a call must name; 0 if the call is refused.
  std::size_t body();
  /// Refuses the effect for what follows from its settings, unless one of them was wrong itself.
  void refuse(std::string what);

  /// Makes the effect, unless something was wrong or a setting was unknown.
  template <class Kind, class... Arguments>
  MadeEffect make(Arguments&&... arguments) {
    if (Faults all = faults(); !all.empty()) return tl::unexpected(std::move(all));
    return std::unique_ptr<Effect>(std::make_unique<Kind>(std::forward<Arguments>(arguments)...));
  }

 private:
  const Setting* find(std::string_view key);
  void wrong(std::string_view key, const std::string& what);
  void refuse_body(std::string what);
  [[nodiscard]] Faults faults();

  const EffectCall& call_;
  const World& world_;
  std::vector<const Setting*> known_;
  Faults wrong_;
  bool sound_ = true;  // whether no setting was wrong
};

}  // namespace snug::scene
