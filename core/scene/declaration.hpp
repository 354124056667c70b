// A scene as its author declares it: bodies, and the effects that it calls for. Nothing else is ever built or
// run.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <variant>
#include <vector>

#include "geometry/input_error.hpp"
#include "geometry/point_set.hpp"
#include "geometry/pose.hpp"
#include "geometry/volume.hpp"

namespace snug::scene {

using V3 = Vector<double, 3>;
using Volume3 = Volume<double, 3>;

/// The vertices of a mesh, or any points, that a body consists of.
using Cloud = std::vector<V3>;

/// Lengths in scene units, metres where gravity is to look right; kilograms and seconds.
struct Body {
  std::string name;                    // effects refer to it by this name; it may be empty
  std::variant<Volume3, Cloud> shape;  // in its own frame
  Quaternion orientation;              // of any length except 0
  V3 position = V3::Zero();            // of its frame's origin
  double mass = 1;                     // finite and > 0, even for a fixed body, where it has no effect
  bool fixed = false;                  // nothing moves it
  V3 velocity = V3::Zero();
  V3 angular_velocity = V3::Zero();  // radians a second about the world's axes
  int line = 0;                      // in the file that declares it, for errors; 0: none
};

/// A setting of an effect: numbers or a word.
struct Setting {
  std::string key;
  std::vector<double> numbers;
  std::string text;
  int line = 0;  // in the file, for errors; 0: that of its effect
};

struct EffectCall {
  std::string name;  // one of catalogue()
  std::string body;  // the body that it is about; empty: every body that is not fixed
  std::vector<Setting> settings;
  int line = 0;
};

struct Declaration {
  std::vector<Body> bodies;
  std::vector<EffectCall> effects;
  std::uint64_t seed = 1;
  double step = 1.0 / 60;  // seconds a frame, > 0 and at most 1
};

/// All that makes no sense in a declaration. Errors, each with the body's or effect's name and line: no body; a
/// repeated name; a mass that is 0, negative, infinite or NaN; a pose, velocity, shape or step that is NaN, too large
/// or too small; an empty shape; two effects that drive the same part of one body's pose, so that the later would undo
/// the earlier.
[[nodiscard]] std::vector<InputError> declaration_faults(const Declaration& declaration);
/// Errors: the first of declaration_faults.
[[nodiscard]] tl::expected<void, InputError> check(const Declaration& declaration);

/// The same bodies by name, each that makes no sense replaced by a small sphere out of the way of all others.
[[nodiscard]] Declaration with_sound_bodies(Declaration declaration);

/// An error about a line of the file; 0: no line.
[[nodiscard]] InputError error_at(int line, std::string what);

}  // namespace snug::scene
