#include "app/subjects/cloud/matrix_inset.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "app/shown.hpp"
#include "lesson/figures.hpp"
#include "lesson/subjects/cloud/by_hand.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"

namespace snug::app {
namespace {

using SummedProducts = fit::ProductsAdded<double, 3>;
using MatrixFound = fit::CovarianceFound<double, 3>;

constexpr float kEntryPad = 10, kEntryHead = 22, kEntryRow = 20;
constexpr float kEntryNames = 28, kEntryNumbers = 62;  // the columns beside the bars
constexpr float kEntriesStage = 560;                   // a narrower stage has a narrower panel
constexpr float kUnderEntries = 200;                   // height for the picture where the panel is above it

/// What the bars show at a step.
struct EntryBars {
  const char* title = nullptr;
  Matrix<double, 3> entries;
  double longest = 0;  // the size of the longest bar
};

std::optional<EntryBars> entry_bars_at(const lesson::Session& session) {
  const lesson::FitTrace all = lesson::fit_run(session.player().run(0)).trace();
  const lesson::FitTrace steps = all.first(session.player().step());
  if (steps.empty()) return std::nullopt;
  const auto* sums = last_fact<SummedProducts>(steps);
  const auto* found = last_fact<MatrixFound>(steps);
  const bool stays = sums != nullptr || session.player().method(0)->name == lesson::kEigenByHand;
  if (!stays && !std::holds_alternative<MatrixFound>(steps.back().step.fact)) return std::nullopt;
  if (found != nullptr)
    return EntryBars{"Covariance matrix", found->covariance, found->covariance.cwiseAbs().maxCoeff()};
  if (sums == nullptr) return std::nullopt;
  const double last =
      last_fact<SummedProducts>(all)->sum.cwiseAbs().maxCoeff();  // so that bars grow, and not their scale
  return EntryBars{"Sums of products", sums->sum, std::max(last, sums->sum.cwiseAbs().maxCoeff())};
}

std::string bar_number(double entry) { return lesson::number_text(entry, 3); }

float widest_entry(const Look& look, const EntryBars& bars, int dim) {
  float widest = 0;
  for (int row = 0; row < dim; ++row)
    for (int column = row; column < dim; ++column)
      widest = std::max(widest, measure(look, Face::kMono, 12, bar_number(bars.entries(row, column))).x);
  return widest;
}

void draw_entry_bar(Brush& brush, const Rect& room, double share) {
  const Palette& p = brush.p;
  const float middle = room.x + room.width / 2, end = middle + static_cast<float>(share) * room.width / 2;
  const Color color = share < 0 ? p.wrong : p.current;
  const ImVec2 low{std::min(middle, end), room.y}, high{std::max(middle, end), room.y + room.height};
  brush.list->AddRectFilled(low, high, with_alpha(color, 0.3f));
  const std::array<ImVec2, 4> outline{low, ImVec2{high.x, low.y}, high, ImVec2{low.x, high.y}};
  path(brush.list, outline, true, share < 0 ? Stroke::kDashed : Stroke::kSolid, color, 1.5f);
  line(brush.list, {middle, room.y - 3}, {middle, room.y + room.height + 3}, Stroke::kSolid, p.ink, 1);
}

float entries_height(const Look& look, int dim) {
  return look.px(kEntryHead) + static_cast<float>(dim * (dim + 1) / 2) * look.px(kEntryRow) + look.px(6);
}

}  // namespace

float matrix_room(const Look& look, const lesson::Session& session, const Rect& stage) {
  if (session.stage().subject().dim() != 3 || stage.width >= kEntriesStage || !entry_bars_at(session)) return 0;
  return room_over_picture(look, stage, entries_height(look, 3) + 12, kUnderEntries);
}

Rect draw_matrix_inset(Brush& brush, ImVec2 at) {
  const auto bars = entry_bars_at(brush.session);
  if (!bars) return {};
  const Look& look = brush.look;
  const Palette& p = brush.p;
  const int dim = brush.dim();
  const float least = look.px(brush.rect.width < kEntriesStage ? 168 : 216), most = brush.rect.width / 2;
  const float usual = look.px(kEntryNumbers), numbers = std::max(usual, widest_entry(look, *bars, dim) + look.px(8));
  const float width = std::min(least + numbers - usual, std::max(least, most));  // the longest number would reach a bar
  const Rect panel{at.x, at.y, width, entries_height(look, dim)};
  if (panel.y + panel.height > brush.canvas.camera.free_bottom() || least > most) return {};
  const ImVec2 low{panel.x, panel.y}, high{panel.x + panel.width, panel.y + panel.height};
  brush.panel(panel);
  text(brush.list, look, Face::kSemiBold, 12, {low.x + kEntryPad, low.y + look.px(5)}, p.muted, bars->title);
  float y = low.y + look.px(kEntryHead);
  for (int row = 0; row < dim; ++row)
    for (int column = row; column < dim; ++column) {
      const double entry = bars->entries(row, column);
      const std::string name{"xyz"[row], ' ', "xyz"[column]};
      text(brush.list, look, Face::kMono, 12, {low.x + kEntryPad, y + look.px(3)}, p.ink, name);
      const Rect room{low.x + kEntryPad + look.px(kEntryNames), y + look.px(5),
                      panel.width - 2 * kEntryPad - look.px(kEntryNames) - numbers, look.px(kEntryRow) - look.px(9)};
      draw_entry_bar(brush, room, bars->longest > 0 ? entry / bars->longest : 0);
      text_right(brush.list, look, Face::kMono, 12, {high.x - kEntryPad, y + look.px(3)}, p.ink, bar_number(entry));
      y += look.px(kEntryRow);
    }
  return panel;
}

}  // namespace snug::app
