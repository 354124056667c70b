// The window's lab sheets: what is measured, built and written is kept, and handed in as one file.
#include <map>

#include "app/cover.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/result_file.hpp"
#include "desktop/shell.hpp"

namespace snug::desktop {

const lesson::Sheet* Shell::sheet() const {
  return app_.session() != nullptr && app_.sitting() == nullptr ? lessons_[open_].sheet.get() : nullptr;
}

SheetWork& Shell::sheet_work() { return kept_.sheet(sheet()->lesson.id); }

/// Keeps what stands on the stage, if it solves a task and is smaller than what was kept.
void Shell::see_built() {
  for (std::size_t i = 0; i < sheet()->lesson.tasks.size(); ++i) {
    const lesson::Rows rows = session().stage().subject().rows();
    const auto found = sheet_work().built.find(i);
    if (found != sheet_work().built.end() && !lesson::is_smaller(rows, found->second)) continue;
    if (!session().grade(i).done) continue;
    sheet_work().built[i] = rows;
    sheet_changed();
  }
}

/// Takes the table of a measurement that has come to its end.
void Shell::see_measured(const lesson::Sheet& sheet) {
  const app::Cover* const cover = app_.cover();
  if (cover == nullptr || cover->version() == cover_seen_) return;
  if (cover->running()) return measured_shown_.clear();
  cover_seen_ = cover->version();
  const Json table = Json::parse(cover->file("json"), nullptr, false);
  if (!table.is_object() || table["rows"].size() != sheet.lesson.algorithms.size()) return;
  const lesson::Measured* const part =
      measurement_of(sheet, table["table"].get<std::string>(), table["provenance"]["points"].get<std::string>());
  if (part == nullptr) return;
  const auto before = sheet_work().measured.find(part->id);
  if (before != sheet_work().measured.end() && before->second.table == table) return;
  sheet_work().measured[part->id] = {today(), table};
  sheet_changed();
}

const MeasuredTable* Shell::measured_before() {
  const app::Cover* const cover = app_.cover();
  if (sheet() == nullptr || cover == nullptr || cover->running() || session().conversation().asked() != nullptr)
    return nullptr;
  const std::map<std::string, MeasuredTable>& all = sheet_work().measured;
  const auto asked = all.find(measured_shown_);
  if (asked != all.end()) return &asked->second;
  if (all.empty() || !cover->file("json").empty()) return nullptr;
  for (const auto& [part, one] : all)
    if (const std::string points = one.table["provenance"]["points"].get<std::string>();
        points == session().stage().subject().origin().source)
      return &one;
  return &all.begin()->second;
}

void Shell::sheet_changed() {
  kept_.sheet_changed(sheet()->lesson.id);
  kept_.write();
}

std::string Shell::sheet_lacks() { return missing_of(*sheet(), sheet_work()); }

}  // namespace snug::desktop
