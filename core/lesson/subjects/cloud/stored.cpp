#include "lesson/subjects/cloud/stored.hpp"

#include "lesson/subjects/cloud/cloud.hpp"

namespace snug::lesson {
namespace {

bool is_stored(const Session& session) {
  const Tables* tables = session.lesson().tables.get();
  for (const Situation& situation : session.lesson().situations)
    if (situation.name == session.stage().situation()) tables = situation.tables.get();
  return tables != nullptr && static_cast<const CloudTables*>(tables)->stored;
}

void hide(StoredMember& member) { member.text = "—", member.lines.clear(); }

/// How many slabs of a k-DOP the run has found; they come in order.
std::size_t slabs_found(FitTrace trace, int steps) {
  std::size_t found = 0;
  for (int i = 0; i < steps; ++i)
    if (std::holds_alternative<fit::SlabFound>(trace[i].step.fact)) ++found;
  return found;
}

/// A k-DOP's bounds are stored as all minima, then all maxima.
void hide_bounds_from(StoredForm& form, std::size_t slab) {
  const std::size_t slabs = form.members.size() / 2;
  for (std::size_t i = 0; i < form.members.size(); ++i)
    if (i % slabs >= slab) hide(form.members[i]);
}

}  // namespace

std::vector<StoredVolume> stored_fit(const Session& session) {
  if (as<CloudSubject>(session.stage().subject()) == nullptr || !is_stored(session)) return {};
  const FitRun& run = fit_run(session.player().run(0));
  const fit::Volume3* now = session.player().volume(0);
  const fit::Volume3& volume = now != nullptr ? *now : run.recording().result.volume;
  std::vector<StoredForm> forms = stored_forms(volume, session.stage().subject().dim());
  if (forms.empty()) return {};
  if (now == nullptr)
    for (StoredForm& form : forms)
      for (StoredMember& member : form.members) hide(member);
  else if (std::holds_alternative<Kdop<double, 3>>(volume))
    hide_bounds_from(forms.front(), slabs_found(run.trace(), session.player().step()));
  std::vector<StoredVolume> all;
  all.push_back({"V", stored_title(volume, session.stage().subject().dim()), std::move(forms)});
  return all;
}

}  // namespace snug::lesson
