#include <algorithm>

#include "scene/effect.hpp"

namespace snug::scene {

// Each in its effect's file.
MadeEffect make_spin(const EffectCall& call, World& world);
MadeEffect make_orbit(const EffectCall& call, World& world);
MadeEffect make_path(const EffectCall& call, World& world);
MadeEffect make_fall(const EffectCall& call, World& world);
MadeEffect make_drag(const EffectCall& call, World& world);
MadeEffect make_bounce(const EffectCall& call, World& world);
MadeEffect make_move(const EffectCall& call, World& world);
MadeEffect make_refit(const EffectCall& call, World& world);
MadeEffect make_broad_phase(const EffectCall& call, World& world);
MadeEffect make_narrow_phase(const EffectCall& call, World& world);
MadeEffect make_cull(const EffectCall& call, World& world);
MadeEffect make_shadow(const EffectCall& call, World& world);
MadeEffect make_trail(const EffectCall& call, World& world);
MadeEffect make_projection_rays(const EffectCall& call, World& world);

namespace {

using enum Slot;

// drag acts through velocities, so it has no effect on a body whose pose another effect drives.
constexpr EffectKind kKinds[] = {
    {"spin", "rotates a body about an axis", slots(kTime), 0, 0, slots(kPoses), "", true, make_spin, kTurn,
     "its rotation is done"},
    {"orbit", "moves a body around a centre", slots(kTime), 0, 0, slots(kPoses), "", true, make_orbit, kPlace,
     "its speed is 0"},
    {"path", "moves a body from place to place", slots(kTime), 0, 0, slots(kPoses), "", true, make_path, kPlace,
     "its body has arrived"},
    {"fall", "gravity, by semi-implicit Euler", slots(kTime), 0, 0, slots(kVelocities), "move", false, make_fall, 0,
     "no body is awake"},
    {"drag", "pulls a body to a point", slots(kTime), slots(kPoses), 0, slots(kVelocities), "move", false, make_drag,
     kWholePose, "its body is asleep"},
    {"bounce", "impulses where bodies touch", 0, slots(kContacts), slots(kVelocities), slots(kPoses), "move", false,
     make_bounce},
    {"move", "moves bodies by their velocities", slots(kTime, kVelocities), 0, 0, slots(kPoses), "", false, make_move,
     0, "no body has a velocity"},
    {"refit", "updates the volumes to the new poses", slots(kPoses), 0, 0, slots(kVolumes), "", false, make_refit},
    {"broad_phase", "finds the pairs whose AABBs overlap", slots(kVolumes), 0, 0, slots(kPairs), "", false,
     make_broad_phase},
    {"narrow_phase", "bounding spheres, then the exact test, on the pairs that are left", slots(kPairs, kPoses), 0, 0,
     slots(kContacts), "", false, make_narrow_phase},
    {"cull", "tests the volumes against a view frustum", slots(kVolumes), 0, 0, slots(kVisibility), "", false,
     make_cull},
    {"shadow", "shadows on the ground", slots(kPoses), 0, 0, slots(kShadows), "", false, make_shadow},
    {"trail", "where bodies have been", slots(kPoses), 0, 0, slots(kTrails), "", false, make_trail},
    {"projection_rays", "from bodies straight down to the ground", slots(kPoses), 0, 0, slots(kRays), "", false,
     make_projection_rays},
};

std::string quoted(std::string_view text) { return "\"" + std::string(text) + "\""; }

}  // namespace

std::span<const EffectKind> catalogue() { return kKinds; }

const EffectKind* find_effect(std::span<const EffectKind> kinds, std::string_view name) {
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const EffectKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

const Setting* Settings::find(std::string_view key) {
  for (const Setting& setting : call_.settings)
    if (setting.key == key) {
      known_.push_back(&setting);
      return &setting;
    }
  return nullptr;
}

/// A setting may be wrong in two ways; only the first is reported.
void Settings::wrong(std::string_view key, const std::string& what) {
  const auto found = std::find_if(call_.settings.begin(), call_.settings.end(),
                                  [&](const Setting& setting) { return setting.key == key; });
  const int line = found != call_.settings.end() && found->line > 0 ? found->line : call_.line;
  const std::string begins = call_.name + ": " + quoted(key);
  if (std::none_of(wrong_.begin(), wrong_.end(), [&](const InputError& one) { return one.what.starts_with(begins); }))
    wrong_.push_back(error_at(line, begins + " " + what));
  sound_ = false;
}

void Settings::refuse_body(std::string what) {
  wrong_.push_back(error_at(call_.line, call_.name + ": " + std::move(what)));
  sound_ = false;
}

void Settings::refuse(std::string what) {
  if (sound_) wrong_.push_back(error_at(call_.line, call_.name + ": " + std::move(what)));
}

double Settings::number(std::string_view key, double otherwise, double least, double most) {
  const Setting* setting = find(key);
  if (setting == nullptr) return otherwise;
  if (setting->numbers.size() != 1) {
    wrong(key, "must be a number");
    return otherwise;
  }
  const double value = setting->numbers.front();
  if (value >= least && value <= most) return value;
  wrong(key, "is out of range");
  return otherwise;
}

V3 Settings::vector(std::string_view key, const V3& otherwise) {
  const Setting* setting = find(key);
  if (setting == nullptr) return otherwise;
  if (setting->numbers.size() != 3) {
    wrong(key, "must be three numbers");
    return otherwise;
  }
  const V3 v(setting->numbers[0], setting->numbers[1], setting->numbers[2]);
  if (v.cwiseAbs().maxCoeff() <= 1e12) return v;
  wrong(key, "is not finite, or too large");
  return otherwise;
}

std::vector<V3> Settings::places(std::string_view key) {
  std::vector<V3> all;
  const Setting* setting = find(key);
  if (setting == nullptr || setting->numbers.size() % 3 != 0 || setting->numbers.empty()) {
    wrong(key, "must be a list of places");
    return all;
  }
  for (std::size_t i = 0; i < setting->numbers.size(); i += 3) {
    all.emplace_back(setting->numbers[i], setting->numbers[i + 1], setting->numbers[i + 2]);
    if (!(all.back().cwiseAbs().maxCoeff() <= 1e12)) wrong(key, "is not finite, or too large");
  }
  return all;
}

std::size_t Settings::word(std::string_view key, std::span<const std::string_view> words) {
  const Setting* setting = find(key);
  if (setting == nullptr) return 0;
  const auto found = std::find(words.begin(), words.end(), setting->text);
  if (found != words.end()) return found - words.begin();
  std::string known;
  for (const std::string_view word : words) known.append(known.empty() ? "" : ", ").append(word);
  wrong(key, "is none of " + known);
  return 0;
}

std::vector<std::size_t> Settings::bodies() {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < world_.size(); ++i)
    if (call_.body.empty() ? !world_.members[i].fixed : world_.members[i].name == call_.body) all.push_back(i);
  if (all.empty()) refuse_body(call_.body.empty() ? "no body moves" : "there is no body called " + call_.body);
  if (!call_.body.empty() && !all.empty() && world_.members[all.front()].fixed) refuse_body(call_.body + " is fixed");
  return all;
}

std::size_t Settings::body() {
  if (call_.body.empty()) {
    refuse_body("needs a \"body\"");
    return 0;
  }
  const auto named = bodies();
  return named.empty() ? 0 : named.front();
}

Faults Settings::faults() {
  for (const Setting& setting : call_.settings)
    if (std::find(known_.begin(), known_.end(), &setting) == known_.end())
      wrong_.push_back(error_at(setting.line > 0 ? setting.line : call_.line,
                                call_.name + ": has no setting " + quoted(setting.key)));
  return wrong_;
}

}  // namespace snug::scene
