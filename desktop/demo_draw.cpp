#include "desktop/demo_draw.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>

#include "app/marks.hpp"

namespace snug::desktop {
namespace {

using app::Face;

constexpr float kLargestDot = 1 / 14.0f;  // of the stage's height: the radius of a place that all have voted for

/// Draws a dot on each place, its area proportional to the votes: a ring for the first vote, a disc for the last.
void draw_dots(Shell& shell, const lesson::Vote& vote, const app::Rect& stage, ImDrawList* list) {
  const app::Look& look = shell.app().look();
  for (const lesson::VoteRow& row : vote.rows()) {
    const auto at =
        row.words.empty() ? shell.app().place_named(row.name) : std::nullopt;  // a choice may be called so too
    if (!at) continue;
    const auto radius = [&](int round) {
      return kLargestDot * stage.height * std::sqrt(static_cast<float>(vote.percent(row, round)) / 100);
    };
    const bool second = vote.counted(1);
    const float last = radius(second ? 1 : 0);
    if (last > 0) app::disc(list, {at->x, at->y}, last, app::with_alpha(look->current, 0.55f));
    if (second && radius(0) > 0) app::ring(list, {at->x, at->y}, radius(0), look->ink, look->stroke);
  }
}

/// A row's shares as bars, the second vote's under the first's.
void draw_bars(ImDrawList* list, const app::Look& look, const lesson::Vote& vote, const lesson::VoteRow& row, float x,
               float y, float width) {
  constexpr float kBar = 5;
  for (int round = 0; round < 2; ++round) {
    if (!vote.counted(round)) continue;
    const float long_ = width * static_cast<float>(vote.percent(row, round)) / 100;
    const app::Color color = round == 0 && vote.counted(1) ? look->previous : look->current;
    list->AddRectFilled({x, y}, {x + std::max(2.0f, long_), y + look.px(kBar)}, color, 2);
    y += look.px(kBar + 2);
  }
}

}  // namespace

void draw_vote(Shell& shell, const app::Rect& stage) {
  constexpr float kSize = 18, kLeading = 26, kPad = 16, kBars = 16;
  if (!shell.demo || shell.demo->vote() == nullptr || shell.demo->vote_over()) return;
  const lesson::Vote& vote = *shell.demo->vote();
  const app::Look& look = shell.app().look();
  ImDrawList* const list = ImGui::GetForegroundDrawList();
  std::vector<std::pair<std::string, const lesson::VoteRow*>> lines;
  const bool told = shell.demo->vote_told();
  if (!told) lines.emplace_back(vote.hidden_text(), nullptr);
  else
    for (const lesson::VoteRow& row : vote.rows())
      if (row.hands[0] >= 0 || row.hands[1] >= 0 || !row.words.empty()) lines.emplace_back(vote.row_text(row), &row);
  if (lines.empty() || lines.front().first.empty()) return;
  if (told) draw_dots(shell, vote, stage, list);
  float widest = 0;
  for (const auto& [words, row] : lines) widest = std::max(widest, app::measure(look, Face::kSemiBold, kSize, words).x);
  const float step = look.px(kLeading) + (told ? look.px(kBars) : 0);
  const ImVec2 window = ImGui::GetIO().DisplaySize;  // the corner that the question leaves
  app::Rect card{0, 0, widest + 2 * kPad, step * static_cast<float>(lines.size()) + 2 * kPad};
  card.x = window.x - card.width - 20, card.y = window.y - card.height - 20;
  list->AddRectFilled({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->panel, 8);
  list->AddRect({card.x, card.y}, {card.x + card.width, card.y + card.height}, look->line, 8, 0, 1);
  float y = card.y + kPad;
  for (const auto& [words, row] : lines) {
    app::text(list, look, Face::kSemiBold, kSize, {card.x + kPad, y + (look.px(kLeading) - look.px(kSize)) / 2},
              look->ink, words);
    if (row != nullptr) draw_bars(list, look, vote, *row, card.x + kPad, y + look.px(kLeading), widest);
    y += step;
  }
}

void draw_notes(ImDrawList* list, const app::Look& look, const app::Rect& rect, const DemoPlay& demo,
                const Hall& hall) {
  constexpr float kMargin = 32;
  const float width = rect.width - 2 * kMargin, x = rect.x + kMargin;
  float y = rect.y + kMargin;
  const auto say = [&](Face face, float size, float leading, app::Color color, std::string_view words) {
    y += app::paragraph(list, look, face, size, leading, {x, y}, width, color, words) + look.px(leading) / 2;
  };
  const std::time_t now = std::time(nullptr);
  std::tm time{};
  localtime_r(&now, &time);
  const long since = static_cast<long>(std::difftime(now, demo.began));
  std::array<char, 48> clock{};
  std::snprintf(clock.data(), clock.size(), "%02d:%02d · %ld:%02ld", time.tm_hour, time.tm_min, since / 60, since % 60);
  const lesson::DemoState& state = demo.states()[demo.at()];
  say(Face::kRegular, 20, 28, look->ink, clock.data());
  say(Face::kRegular, 14, 20, look->muted, demo.place_text());
  say(Face::kSemiBold, 22, 30, look->ink, state.slide);
  say(Face::kRegular, 20, 30, look->ink, state.notes);
  if (demo.vote() != nullptr) say(Face::kSemiBold, 18, 26, look->current_text, demo.vote()->told_text());
  say(Face::kRegular, 16, 24, look->ink, demo.next_text());
  if (hall.black || hall.frozen)
    say(Face::kSemiBold, 16, 24, look->wrong_text, hall.black ? "The screen is black." : "The picture is frozen.");
}

}  // namespace snug::desktop
