// What can be asked about culling a field.
#include "lesson/subjects/field/entries.hpp"

#include <algorithm>

namespace snug::lesson {

const char* offer_planes(Asked& asked, const Run&) {
  for (const std::string_view plane : kFrustumPlaneNames<3>) asked.add_choice(std::string(plane));
  return nullptr;
}

/// Every plane that rejects as many as any is right.
Truth rejects_most_truth(const Asked&, const Run& run) {
  std::int64_t most = -1;
  for (const auto& entry : field_run(run).trace())
    if (const auto* sweep = std::get_if<PlaneSwept>(&entry.step.fact)) most = std::max(most, sweep->rejected);
  Truth truth;
  for (const auto& entry : field_run(run).trace()) {
    const auto* sweep = std::get_if<PlaneSwept>(&entry.step.fact);
    if (sweep == nullptr || sweep->rejected != most) continue;
    truth.choices.push_back(sweep->plane);
    truth.happened += (truth.happened.empty() ? "" : " or ");
    truth.happened += kFrustumPlaneNames<3>[sweep->plane];
  }
  truth.sentence = "The " + truth.happened + " plane rejects " + objects_text(most) + ".";
  return truth;
}

int after_sweeps(const Run& run, int) {
  const auto trace = field_run(run).trace();
  const auto is_sweep = [](const auto& entry) { return std::holds_alternative<PlaneSwept>(entry.step.fact); };
  return static_cast<int>(trace.rend() - std::find_if(trace.rbegin(), trace.rend(), is_sweep));
}

}  // namespace snug::lesson
