// The sliders of a lesson: their places and words, and what they drive.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lesson/subject.hpp"

namespace snug::lesson {

/// Where the sliders stand. Each of their moves begins at base, so that a drag there and back ends with the same bits.
struct Slid {
  std::vector<double> values;  // of all of the lesson's sliders
  // What stood on the stage after the last edit by other means, and the sliders' values there.
  std::shared_ptr<const Subject> base;
  std::vector<double> base_values;
};

/// What stands on the stage, with its sliders.
struct Snapshot {
  std::unique_ptr<Subject> subject;
  Slid slid;
  [[nodiscard]] Snapshot clone() const { return {subject->clone(), slid}; }
};

/// A slider as it is shown.
struct ShownSlider {
  const Slider* slider = nullptr;
  std::size_t number = 0;  // among the lesson's
  double value = 0;
  int place = 0, places = 1;  // of its knob, from 0 on: the nearest to the value
  std::string text;           // the value with its unit
};

/// Whether a slider is there in the subject's situation.
[[nodiscard]] bool is_there(const Slider& slider, const Subject& subject);
/// What it drives; none if the subject has nothing of that name.
[[nodiscard]] std::optional<Drive> drive_of(const Slider& slider, const Subject& subject);

/// Puts the sliders at their start, over a subject that has just come to the stage. own: whether it is the lesson's
/// own, which is driven to what the file says; of others, numbers that can be told stay. The subject's origin stays.
/// Errors: those of Subject::drive.
[[nodiscard]] tl::expected<Snapshot, InputError> with_sliders(const Lesson& lesson, std::unique_ptr<Subject> subject,
                                                              bool own);
/// Takes over what can be told of a subject that was edited by other means.
void follow_edit(const Lesson& lesson, Slid& slid, const Subject& subject);
/// What stands after sliders were moved to these values. Errors: those of Subject::drive; nothing has changed then.
[[nodiscard]] tl::expected<Snapshot, InputError> slid_to(const Lesson& lesson, const Snapshot& from,
                                                         std::vector<double> values);

/// The sliders that are there. by_hand: whether a method by hand is shown; without one, those that move only what it
/// starts from are left out.
[[nodiscard]] std::vector<ShownSlider> shown_sliders(const Lesson& lesson, const Slid& slid, const Subject& subject,
                                                     bool by_hand);
/// The value at a place of the knob.
[[nodiscard]] double value_at(const Slider& slider, const Drive& drive, int place);

}  // namespace snug::lesson
