#include "lesson/subjects.hpp"

#include <algorithm>
#include <array>

#include "lesson/names.hpp"
#include "lesson/speaking.hpp"
#include "lesson/stored.hpp"
#include "lesson/subjects/claims/claims.hpp"
#include "lesson/subjects/cloud/cloud.hpp"
#include "lesson/subjects/cloud/stored.hpp"
#include "lesson/subjects/cost/cost.hpp"
#include "lesson/subjects/criteria/criteria.hpp"
#include "lesson/subjects/field/field.hpp"
#include "lesson/subjects/frustum/frustum.hpp"
#include "lesson/subjects/pair/axis_rows.hpp"
#include "lesson/subjects/pair/pair.hpp"
#include "lesson/subjects/pair/stored.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/tree/tree.hpp"
#include "lesson/subjects/update/update.hpp"

namespace snug::lesson {

std::span<const SubjectRow* const> subjects() {
  static constexpr std::array kSubjects{&kCloudRow, &kPairRow,   &kVolumesRow, &kFrustumRow,  &kFieldRow, &kTreeRow,
                                        &kSceneRow, &kUpdateRow, &kCostRow,    &kCriteriaRow, &kClaimsRow};
  return kSubjects;
}

std::span<const StoredOn> stored_on_subjects() {
  static constexpr std::array<StoredOn, 2> kStored{&stored_volumes, &stored_fit};
  return kStored;
}

std::span<const MarkOn> marks_on_subjects() {
  static constexpr std::array<MarkOn, 1> kMarks{&is_axis_mark};
  return kMarks;
}

const SubjectRow* find_subject(std::string_view volume, std::string_view chart) {
  for (const SubjectRow* row : subjects())
    if ((row->experiment != nullptr ? row->experiment->chart : "") == chart && is_among(row->volumes(), volume))
      return row;
  return nullptr;
}

const SubjectRow* subject_named(std::string_view name) {
  for (const SubjectRow* row : subjects())
    if (row->name == name) return row;
  return nullptr;
}

const Method* find_method(std::span<const Method> methods, std::string_view name) {
  for (const Method& method : methods)
    if (method.name == name) return &method;
  return nullptr;
}

const Method* find_method(const Lesson& lesson, std::string_view name) {
  const std::size_t slash = name.find('/');
  if (slash == std::string_view::npos) return find_method(lesson.subject->methods(lesson.volume), name);
  const std::string_view volume = name.substr(0, slash);
  if (!is_among(lesson.subject->volumes(), volume)) return nullptr;
  return find_method(lesson.subject->methods(volume), name.substr(slash + 1));
}

std::string name_in(const Lesson& lesson, const Method& method) {
  const bool own = find_method(lesson.subject->methods(lesson.volume), method.name) == &method;
  return own ? std::string(method.name) : std::string(method.volume) + '/' + std::string(method.name);
}

std::string offered(const Lesson& lesson, std::string_view name) {
  const Method* method = find_method(lesson, name);
  std::string own = method != nullptr ? name_in(lesson, *method) : std::string();
  return is_among(lesson.algorithms, own) ? own : std::string();
}

bool is_mixed(const Lesson& lesson) {
  return std::any_of(lesson.algorithms.begin(), lesson.algorithms.end(),
                     [](const std::string& name) { return name.find('/') != std::string::npos; });
}

}  // namespace snug::lesson
