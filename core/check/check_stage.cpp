#include "check/check_stage.hpp"

#include "lesson/names.hpp"
#include "lesson/sliders.hpp"
#include "lesson/subjects.hpp"

namespace snug::check {
namespace {

/// Checks that what a slider drives can be drawn at both of its ends.
bool check_ends(const Slider& slider, const Lesson& lesson, const Subject& subject, Complaints& complaints) {
  const Method& first = *find_method(lesson, lesson.algorithms.front());
  const Drive drive = *drive_of(slider, subject);
  bool sound = true;
  for (const double end : {slider.from, slider.to}) {
    const auto there = subject.clone();
    const Done driven = there->drive(slider.drives, drive.now.value_or(drive.rest), end);
    const std::string refused = driven && subject.suits(first) ? there->refusal(first) : "";
    if (driven && refused.empty()) continue;
    sound = false;
    complaints.add(slider.place, "at " + plain_number(end) +
                                     " the slider cannot be drawn: " + (driven ? refused : driven.error().what));
  }
  return sound;
}

void check_place(TomlTable& table, std::string_view key, const StagePlace& place, const Subject& own) {
  if (place.is_gap()) {
    if (own.with_volumes() == nullptr || !own.with_volumes()->gap())
      table.wrong(key, "is the gap between two volumes, and there are none");
    return;
  }
  if (place.handle.empty()) {
    if (place.numbers != static_cast<std::size_t>(own.dim()))
      table.wrong(key, "must have " + std::to_string(own.dim()) + " coordinates");
    return;
  }
  if (handle_named(own, place.handle)) return;
  table.wrong(key, "names no handle: " + place.handle + meant_text(names_of_handles(own), place.handle));
}

void check_names_of_points(TomlTable& table, const StageView& view, const Subject& own) {
  if (view.names.empty()) return;
  if (own.points() == nullptr) return table.wrong("names", "are for points, and there are none");
  if (view.names.size() > static_cast<std::size_t>(own.size()))
    return table.wrong("names", "are " + std::to_string(view.names.size()) + ", and there are only " +
                                    std::to_string(own.size()) + " points");
  for (Index i = 0; i < own.size(); ++i)
    for (Index j = 0; j < i; ++j)
      if (plain_name(own.name_of(i)) == plain_name(own.name_of(j)))
        return table.wrong("names", "has a name that another point has: " + own.name_of(j));
}

}  // namespace

std::vector<std::string> names_of_handles(const Subject& own) {
  std::vector<std::string> names;
  for (Index i = 0; i < own.size(); ++i) names.push_back(own.name_of(i));
  return names;
}

std::string meant_text(const std::vector<std::string>& names, const std::string& name) {
  const std::string_view meant = nearest(names, name);
  if (!meant.empty()) return "; did you mean " + std::string(meant) + "?";
  return names.empty() ? "" : "; the last one is " + names.back();
}

void check_sliders(Lesson& lesson, const Subject& subject, Complaints& complaints) {
  std::vector<std::string> names;
  for (const Drive& drive : subject.drives()) names.push_back(drive.name);
  for (Slider& slider : lesson.sliders) {
    if (!is_there(slider, subject) || slider.drives.empty()) continue;
    if (!is_among(names, slider.drives)) {
      complaints.add(slider.drives_place, names.empty() ? "\"drives\": nothing here can be driven"
                                                        : "\"drives\" " + none_of_text(slider.drives, names));
      slider.drives = nearest(names, slider.drives);
      slider.sound = slider.sound && !slider.drives.empty();
    }
    if (slider.sound) slider.sound = check_ends(slider, lesson, subject, complaints);
  }
}

void check_view(const StageView& view, const toml::table& lesson, const Subject& own, Complaints& complaints) {
  const toml::table* toml = lesson["view"].as_table();
  if (toml == nullptr) return;
  TomlTable table(*toml, "[view]", complaints);
  if (view.camera && own.dim() == 2) table.wrong("camera", "is for lessons in space");
  if (view.look_at) check_place(table, "look_at", *view.look_at, own);
  if (view.outline && own.points() == nullptr) table.wrong("outline", "is for points, and there are none");
  check_names_of_points(table, view, own);
  if (!view.inset) return;
  TomlTable inset(*toml->get_as<toml::table>("inset"), "\"inset\"", complaints);
  check_place(inset, "at", view.inset->at, own);
}

}  // namespace snug::check
