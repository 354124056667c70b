#include "lesson/stored.hpp"

#include "lesson/figures.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

constexpr std::string_view kMark = "stored:";

/// "stored:A/0/2": the third member of A's first representation.
std::string mark_of(const std::string& volume, std::size_t form, std::size_t member) {
  return std::string(kMark) + volume + '/' + std::to_string(form) + '/' + std::to_string(member);
}

}  // namespace

int StoredForm::numbers() const {
  std::size_t all = 0;
  for (const StoredMember& member : members) all += member.numbers.size();
  return static_cast<int>(all);
}

std::string StoredForm::bytes() const {
  const auto of = [&](std::size_t each) { return count_text(numbers() * static_cast<int>(each)); };
  return of(sizeof(float)) + " bytes in float, " + of(sizeof(double)) + " in double";
}

std::string stored_title(const fit::Volume3& volume, int dim) {
  if (const auto* kdop = std::get_if<Kdop<double, 3>>(&volume)) return std::to_string(kdop->k) + "-DOP";
  const std::string_view kind = kVolumeNames[volume.index()];
  if (kind == "aabb") return "AABB";
  return kind == "obb" ? "OBB" : std::string(volume_word(kind, dim));
}

std::vector<StoredVolume> stored_of(const Session& session) {
  const WithDecimals wished(session.lesson().view.decimals);
  std::vector<StoredVolume> all;
  for (const StoredOn own : stored_on_subjects())
    for (StoredVolume& volume : own(session)) all.push_back(std::move(volume));
  for (StoredVolume& volume : all)
    for (std::size_t form = 0; form < volume.forms.size(); ++form)
      for (std::size_t i = 0; i < volume.forms[form].members.size(); ++i)
        volume.forms[form].members[i].mark = mark_of(volume.name, form, i);
  return all;
}

std::vector<std::vector<Point3>> stored_lines(const Session& session, std::string_view mark) {
  if (!mark.starts_with(kMark) ||
      (session.conversation().asked() != nullptr && session.conversation().asked()->on_stage))
    return {};
  for (StoredVolume& volume : stored_of(session))
    for (StoredForm& form : volume.forms)
      for (StoredMember& member : form.members)
        if (member.mark == mark) return std::move(member.lines);
  return {};
}

}  // namespace snug::lesson
