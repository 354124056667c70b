#include "lesson/subject.hpp"

#include <algorithm>
#include <numeric>

#include "fit/catalogue.hpp"
#include "lesson/ask.hpp"

namespace snug::lesson {
namespace {

std::string drive_name(const NumberGroup& group, const NumberRow& row, std::size_t i) {
  std::string name = group.drive;
  if (!row.drive.empty()) (name += ' ') += row.drive;
  if (!row.names.empty()) (name += ' ') += row.names[i];
  return name;
}

}  // namespace

bool Untold::hides(std::string_view figure) const {
  return std::find(figures.begin(), figures.end(), figure) != figures.end();
}

Run::~Run() = default;
std::vector<Index> Run::candidates(int) const { return {}; }
std::vector<Index> Run::support(int) const { return {}; }

Subject::~Subject() = default;
std::vector<std::vector<Index>> Subject::things() const {
  std::vector<Index> all(size());
  std::iota(all.begin(), all.end(), Index{0});
  return {all};
}
std::string Subject::refusal(const Method& method) const {
  const std::string title(method.title);
  if (points() == nullptr) return {};
  if (fit::count_of(*points()) > method.max_points)
    return title + " takes at most " + std::to_string(method.max_points) + " points";
  if (dim() == 2 && !method.plane) return title + " is for points in space";
  if (dim() == 3 && !method.space) return title + " is for points in the plane";
  return {};
}
std::optional<StageFile> Subject::file() const {
  if (const HasText* const own = text()) return own->file();
  return std::nullopt;
}
const AnyPointSet* Subject::points() const {
  const HasPoints* const own = with_points();
  return own != nullptr ? &own->set_of_points() : nullptr;
}
std::vector<Drive> Subject::drives() const {
  std::vector<Drive> all;
  for (const NumberGroup& group : numbers())
    for (const NumberRow& row : group.rows)
      for (std::size_t i = 0; i < row.values.size(); ++i) {
        Drive& drive = all.emplace_back(Drive{.name = drive_name(group, row, i), .now = row.values[i]});
        if (!row.unit.empty()) drive.unit = row.unit;
        if (row.turn > 0) drive.now.reset();
      }
  return all;
}
Done Subject::drive(std::string_view name, double from, double to) {
  const std::vector<NumberGroup> groups = numbers();
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (std::size_t r = 0; r < groups[g].rows.size(); ++r) {
      const NumberRow& row = groups[g].rows[r];
      std::vector<double> values = row.values;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (drive_name(groups[g], row, i) != name) continue;
        values[i] = row.turn > 0 ? to - from : to;
        return set_numbers(g, r, values);
      }
    }
  return tl::unexpected(InputError{.what = "there is no " + std::string(name) + " to drive"});
}
Done Subject::set_numbers(std::size_t, std::size_t, std::span<const double>) {
  return tl::unexpected(InputError{.what = "there are no such numbers"});
}
std::vector<Rival> Subject::rivals(const Lesson&, const View&) const { return {}; }
std::vector<Figure> Subject::figures_at_end(const Method& method, const View& view) const {
  for (const Slot& slot : view.slots)
    if (slot.method == &method && slot.run != nullptr) return figures({{slot, Slot{}}, 0, slot.run->steps()});
  const std::unique_ptr<Run> own = run(method, nullptr);
  return figures({{Slot{&method, own.get()}, Slot{}}, 0, own->steps()});
}
std::vector<Figure> Subject::results(const Method& method, const View& view) const {
  return figures_at_end(method, view);
}
std::optional<double> Subject::result_size(const Method&, bool, const View&) const { return std::nullopt; }
std::int64_t Subject::operations(const Method&) const { return 0; }
Grade Subject::grade(const Lesson& lesson, const Task& task, const View& view) const {
  return grade_by_requirements(lesson, task, *this, view);
}

}  // namespace snug::lesson
