#include "app/subjects.hpp"

#include <algorithm>
#include <array>

#include "app/subjects/cloud/view.hpp"
#include "app/subjects/cost/costs.hpp"
#include "app/subjects/frustum/view.hpp"
#include "app/subjects/pair/view.hpp"
#include "app/subjects/scene/view.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/frustum_tests.hpp"

namespace snug::app {
namespace {

constexpr std::array kSubjects{SubjectRow{"cloud", cloud_view, nullptr}, SubjectRow{"pair", pair_view, nullptr},
                               SubjectRow{"frustum", frustum_view, nullptr}, SubjectRow{"scene", scene_view, nullptr},
                               SubjectRow{kCostSubject, cloud_view, cost_cover}};

std::string_view name_of(const lesson::Lesson& lesson) {
  if (lesson.measures) return kCostSubject;
  if (lesson.volume == lesson::kBoxPair) return "pair";
  if (lesson.volume == lesson::kFrustumBox) return "frustum";
  return lesson.scene ? "scene" : "cloud";
}

}  // namespace

const SubjectRow& subject_of(const lesson::Lesson& lesson) {
  const std::string_view name = name_of(lesson);
  return *std::find_if(kSubjects.begin(), kSubjects.end(), [&](const SubjectRow& row) { return row.name == name; });
}

}  // namespace snug::app
