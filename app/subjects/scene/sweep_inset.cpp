// The intervals of a sweep, sorted by where they begin, and the active list when it comes to a body.
#include <algorithm>
#include <string>

#include "app/marks.hpp"
#include "app/subjects/scene/owner.hpp"
#include "app/subjects/scene/search.hpp"
#include "lesson/subjects/scene/scene.hpp"

namespace snug::app {
namespace {

using lesson::SceneFrame;

constexpr float kSweepPad = 10, kSweepHead = 26, kSweepFoot = 22, kSweepWords = 12;
constexpr float kSweepStage = 340, kMostRow = 9, kLeastRow = 2, kSweepRows = 84;
constexpr float kMostOfSweep = 640, kBesideSweep = 84;  // its greatest width, and what it leaves free beside it
constexpr std::size_t kMostSwept = 60;                  // more intervals cannot be told apart
constexpr float kLeastUnderSweep = 150;                 // height for the bodies

/// The height of the picture of so many intervals.
float sweep_height(const Look& look, std::size_t intervals) {
  const float row = std::clamp(look.px(kSweepRows) / static_cast<float>(intervals), kLeastRow, kMostRow);
  return look.px(kSweepHead + kSweepFoot) + row * static_cast<float>(intervals) + 6;
}

/// "P3", or the name that the scene gives to a body of another kind.
std::string name_of_body(const lesson::Session& session, Index body) {
  const Owner owner = owner_of(lesson::set_of(session));
  const Index handle = body - static_cast<Index>(owner.body);
  if (owner.at_points && handle >= 0 && handle < session.stage().subject().size())
    return session.stage().subject().name_of(handle);
  const std::string& name = lesson::members_of(session)[body].name;
  return name.empty() ? "a body" : name;
}

struct SweepPicture {
  Brush& brush;
  const SceneFrame& frame;
  const SearchShown& shown;
  Rect panel, plot;
  double least = 0, greatest = 1;

  [[nodiscard]] const Aabb<double, 3>& box(Index body) const { return frame.volumes[body]; }
  [[nodiscard]] float x(double at) const {
    return plot.x + plot.width * static_cast<float>((at - least) / (greatest - least));
  }
  [[nodiscard]] static bool has(const std::vector<Index>& list, Index body) {
    return std::find(list.begin(), list.end(), body) != list.end();
  }

  void bars() const {
    const Palette& p = brush.p;
    const int axis = frame.swept_along;
    const float row = plot.height / static_cast<float>(frame.swept.size());
    for (std::size_t i = 0; i < frame.swept.size(); ++i) {
      const Index body = frame.swept[i];
      const float y = plot.y + (static_cast<float>(i) + 0.5f) * row, from = x(box(body).min[axis]),
                  to = std::max(from + 2, x(box(body).max[axis]));
      const bool own = body == shown.body, active = has(shown.active, body), later = !active && has(shown.others, body);
      const Color color = own ? p.support : active || later ? p.examined : with_alpha(p.muted, 0.55f);
      line(brush.list, {from, y}, {to, y}, later ? Stroke::kDotted : Stroke::kSolid, color,
           std::max(1.5f, row * (own ? 0.75f : 0.5f)));
      if (own) diamond(brush.list, {from, y}, 4 * p.mark, p.support, p.panel);
    }
  }

  /// The line of the sweep, where the body begins.
  void sweep() const {
    const float at = x(box(shown.body).min[frame.swept_along]);
    line(brush.list, {at, plot.y - 3}, {at, plot.y + plot.height + 3}, Stroke::kDashed, brush.p.ink, 1);
  }

  /// Counts the bodies that begin after this one: the sweep reaches them later.
  static std::string later_words(std::size_t later) {
    return std::to_string(later) + (later == 1 ? " begins" : " begin") + " later (dotted)";
  }

  void words() const {
    const Palette& p = brush.p;
    const Look& look = brush.look;
    text(brush.list, look, Face::kSemiBold, kSweepWords, {panel.x + kSweepPad, panel.y + look.px(6)}, p.muted,
         std::string("Sorted along ") + "xyz"[frame.swept_along] + ", as the sweep comes to " +
             name_of_body(brush.session, shown.body));
    text(brush.list, look, Face::kRegular, kSweepWords,
         {panel.x + kSweepPad, panel.y + panel.height - look.px(kSweepFoot - 2)}, p.examined_text,
         std::to_string(shown.active.size()) + " in the active list, " +
             later_words(shown.others.size() - shown.active.size()));
  }
};

}  // namespace

float sweep_room(const Look& look, const lesson::Session& session, const Rect& stage) {
  const std::size_t bodies = lesson::members_of(session).size();
  const auto search = lesson::search_shown(lesson::set_of(session), session.player().method(0)->name);
  if (search != hierarchy::PairSearch::kSweepAndPrune || lesson::set_of(session).graph || stage.width < kSweepStage ||
      bodies == 0 || bodies > kMostSwept)
    return 0;
  if (lesson::frame_of(session)->swept.empty()) return 0;  // before the first frame
  return room_over_picture(look, stage, sweep_height(look, bodies) + 8, kLeastUnderSweep);
}

Rect draw_sweep_inset(Brush& brush, const SceneFrame& frame, const SearchShown& shown, ImVec2 at) {
  const Look& look = brush.look;
  if (frame.swept.empty() || sweep_room(look, brush.session, brush.rect) == 0) return {};
  const Rect panel{at.x, at.y, std::min(look.px(kMostOfSweep), brush.rect.width - kBesideSweep),
                   sweep_height(look, frame.swept.size())};
  SweepPicture picture{brush,
                       frame,
                       shown,
                       panel,
                       {panel.x + kSweepPad, panel.y + look.px(kSweepHead), panel.width - 2 * kSweepPad,
                        panel.height - look.px(kSweepHead + kSweepFoot) - 6}};
  const int axis = frame.swept_along;
  picture.least = frame.volumes.front().min[axis], picture.greatest = frame.volumes.front().max[axis];
  for (const Aabb<double, 3>& box : frame.volumes) {
    picture.least = std::min(picture.least, box.min[axis]);
    picture.greatest = std::max(picture.greatest, box.max[axis]);
  }
  if (!(picture.greatest > picture.least)) picture.greatest = picture.least + 1;
  brush.panel(panel);
  picture.bars();
  picture.sweep();
  picture.words();
  return panel;
}

}  // namespace snug::app
