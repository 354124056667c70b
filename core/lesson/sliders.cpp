#include "lesson/sliders.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/figures.hpp"

namespace snug::lesson {
namespace {

constexpr int kUsualPlaces = 100, kMostPlaces = 1000, kPlacesOfDecade = 10;
constexpr int kMostDecimals = 6;
constexpr int kDigits = 3, kDigitsShown = 4;  // of values whose decimals the file does not say
constexpr double kSame = 1e-9;                // relative: two values differ by rounding alone

bool is_same(double a, double b) { return std::abs(a - b) <= kSame * (1 + std::abs(b)); }

double power_of_ten(int exponent) {
  double power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

double rounded_to(double value, int decimals) {
  const double scale = power_of_ten(decimals);
  return std::round(value * scale) / scale;
}

/// Rounds to so few digits that it hides the last bits, in which logarithms differ from library to library.
double rounded_to_digits(double value, int digits = kDigits) {
  if (value == 0) return 0;
  const int decimals = digits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (decimals >= 0) return rounded_to(value, decimals);
  const double scale = power_of_ten(-decimals);
  return std::round(value / scale) * scale;
}

int places_of(const Slider& slider, const Drive& drive) {
  if (slider.steps > 0) return slider.steps;
  if (slider.logarithmic) {
    const double decades = std::log10(slider.to / slider.from);
    return std::clamp(static_cast<int>(std::ceil(kPlacesOfDecade * decades)), kPlacesOfDecade, kMostPlaces);
  }
  return drive.whole ? std::clamp(static_cast<int>(slider.to - slider.from), 1, kMostPlaces) : kUsualPlaces;
}

/// The fewest decimals with which its places are exact.
int decimals_of(const Slider& slider, const Drive& drive) {
  if (slider.decimals) return *slider.decimals;
  if (drive.whole) return 0;
  const double step = (slider.to - slider.from) / places_of(slider, drive);
  for (int decimals = 0; decimals < kMostDecimals; ++decimals)
    if (is_same(rounded_to(step, decimals), step) && is_same(rounded_to(slider.from, decimals), slider.from))
      return decimals;
  return kMostDecimals;
}

/// The place that is nearest to a value.
int knob_at(const Slider& slider, const Drive& drive, double value) {
  const double at = std::clamp(value, slider.from, slider.to);
  const double share = slider.logarithmic ? std::log(at / slider.from) / std::log(slider.to / slider.from)
                                          : (at - slider.from) / (slider.to - slider.from);
  return static_cast<int>(std::lround(share * places_of(slider, drive)));
}

/// As many decimals as at the slider's places, and more where a value between them has more.
int decimals_shown(double value, int at_places) {
  int decimals = at_places;
  while (decimals < kMostDecimals && !is_same(rounded_to(value, decimals), value)) ++decimals;
  return decimals;
}

std::string text_of(const Slider& slider, const Drive& drive, double value) {
  std::string unit = slider.unit ? *slider.unit : std::string(drive.unit);
  const bool fixed = slider.decimals || (!slider.logarithmic && !drive.whole);
  const double shown = fixed ? rounded_to(value, decimals_of(slider, drive)) : value;
  const double rounded = is_same(shown, value) ? shown : rounded_to_digits(value, kDigitsShown);
  std::string text = plain_number(rounded);
  if (fixed && std::abs(value) < power_of_ten(4) && text.find_first_not_of("0123456789,.−-") == std::string::npos)
    text = decimal_text(rounded, decimals_shown(rounded, decimals_of(slider, drive)));
  if (text == "1" && (unit == "units" || unit == "points")) unit.pop_back();
  if (unit == "times") return "× " + text;
  return text + (unit == "degrees" ? "°" : unit.empty() ? "" : " " + unit);
}

/// An angle that differs by full turns, between the ends if there is one.
double angle_between(const Slider& slider, double degrees) {
  constexpr double kTurn = 360;
  const double turned = degrees + kTurn * std::ceil((slider.from - degrees) / kTurn - kSame);
  return turned <= slider.to ? turned : degrees;
}

/// Where a slider stands over a subject: its value, or `otherwise` if that cannot be told.
double value_on(const Slider& slider, const Subject& subject, double otherwise) {
  const std::optional<Drive> drive = drive_of(slider, subject);
  if (!drive || !drive->now) return otherwise;
  const double value = drive->unit == "degrees" ? angle_between(slider, *drive->now) : *drive->now;
  return is_same(value, otherwise) ? otherwise : value;
}

double start_of(const Slider& slider, double resting) {
  if (slider.start) return *slider.start;
  return resting >= slider.from && resting <= slider.to ? resting : slider.from;
}

/// What a slider drives there; none if it is not there, or has nothing to drive: the check of the lesson says so.
std::optional<Drive> drive_there(const Slider& slider, const Subject& subject) {
  return is_there(slider, subject) ? drive_of(slider, subject) : std::nullopt;
}

}  // namespace

bool is_there(const Slider& slider, const Subject& subject) {
  return slider.situation.empty() || slider.situation == subject.origin().situation;
}

std::optional<Drive> drive_of(const Slider& slider, const Subject& subject) {
  for (Drive& drive : subject.drives())
    if (drive.name == slider.drives) return std::move(drive);
  return std::nullopt;
}

tl::expected<Snapshot, InputError> with_sliders(const Lesson& lesson, std::unique_ptr<Subject> subject, bool own) {
  Snapshot fresh{std::move(subject), {}};
  if (lesson.sliders.empty()) return fresh;
  std::vector<double> values;
  for (const Slider& slider : lesson.sliders) {
    const std::optional<Drive> drive = drive_there(slider, *fresh.subject);
    const double resting = drive ? value_on(slider, *fresh.subject, drive->rest) : slider.from;
    fresh.slid.base_values.push_back(resting);
    values.push_back(own || !drive || !drive->now ? start_of(slider, resting) : resting);
  }
  fresh.slid.values = fresh.slid.base_values;
  fresh.slid.base = fresh.subject->clone();
  auto begun = slid_to(lesson, fresh, std::move(values));
  if (begun) begun->subject->set_origin(fresh.subject->origin());
  return begun;
}

void follow_edit(const Lesson& lesson, Slid& slid, const Subject& subject) {
  if (lesson.sliders.empty()) return;
  for (std::size_t i = 0; i < lesson.sliders.size(); ++i)
    if (is_there(lesson.sliders[i], subject)) slid.values[i] = value_on(lesson.sliders[i], subject, slid.values[i]);
  slid.base = nullptr;
  slid.base_values = slid.values;
}

tl::expected<Snapshot, InputError> slid_to(const Lesson& lesson, const Snapshot& from, std::vector<double> values) {
  const Slid& slid = from.slid;
  Snapshot next{slid.base != nullptr ? slid.base->clone() : from.subject->clone(), slid};
  if (next.slid.base == nullptr) next.slid.base = from.subject->clone();
  for (std::size_t i = 0; i < lesson.sliders.size(); ++i) {
    const Slider& slider = lesson.sliders[i];
    if (values[i] == slid.base_values[i] || !drive_there(slider, *next.subject)) continue;
    if (Done driven = next.subject->drive(slider.drives, slid.base_values[i], values[i]); !driven)
      return tl::unexpected(std::move(driven.error()));
  }
  next.slid.values = std::move(values);
  return next;
}

std::vector<ShownSlider> shown_sliders(const Lesson& lesson, const Slid& slid, const Subject& subject, bool by_hand) {
  std::vector<ShownSlider> shown;
  for (std::size_t i = 0; i < lesson.sliders.size(); ++i) {
    const Slider& slider = lesson.sliders[i];
    const std::optional<Drive> drive = drive_there(slider, subject);
    if (!drive || (drive->by_hand && !by_hand)) continue;
    const double value = slid.values[i];
    shown.push_back(
        {&slider, i, value, knob_at(slider, *drive, value), places_of(slider, *drive), text_of(slider, *drive, value)});
  }
  return shown;
}

double value_at(const Slider& slider, const Drive& drive, int place) {
  const int places = places_of(slider, drive);
  if (place <= 0) return slider.from;
  if (place >= places) return slider.to;
  const double share = static_cast<double>(place) / places;
  const double value = slider.logarithmic ? slider.from * std::exp(share * std::log(slider.to / slider.from))
                                          : slider.from + share * (slider.to - slider.from);
  if (drive.whole) return std::round(value);
  return slider.logarithmic && !slider.decimals ? rounded_to_digits(value)
                                                : rounded_to(value, decimals_of(slider, drive));
}

}  // namespace snug::lesson
