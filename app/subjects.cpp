#include "app/subjects.hpp"

#include <algorithm>
#include <array>

#include "app/subjects/claims/claims_cover.hpp"
#include "app/subjects/cloud/view.hpp"
#include "app/subjects/cost/costs.hpp"
#include "app/subjects/criteria/criteria_board.hpp"
#include "app/subjects/field/view.hpp"
#include "app/subjects/frustum/view.hpp"
#include "app/subjects/pair/view.hpp"
#include "app/subjects/scene/view.hpp"
#include "app/subjects/tree/view.hpp"
#include "app/subjects/update/view.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

constexpr std::array kSubjects{
    SubjectRow{"cloud", cloud_view, nullptr},      SubjectRow{"pair", pair_view, nullptr},
    SubjectRow{"volumes", volumes_view, nullptr},  SubjectRow{"frustum", frustum_view, nullptr},
    SubjectRow{"field", field_view, nullptr},      SubjectRow{"tree", tree_view, nullptr},
    SubjectRow{"scene", scene_view, nullptr},      SubjectRow{"update", update_view, nullptr},
    SubjectRow{"cost", cloud_view, cost_cover},    SubjectRow{"criteria", cloud_view, criteria_cover},
    SubjectRow{"claims", cloud_view, claims_cover}};

}  // namespace

const SubjectRow& subject_of(const lesson::Lesson& lesson) {
  const std::string_view name = lesson.subject->name;
  return *std::find_if(kSubjects.begin(), kSubjects.end(), [&](const SubjectRow& row) { return row.name == name; });
}

}  // namespace snug::app
