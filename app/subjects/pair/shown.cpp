#include "app/subjects/pair/shown.hpp"

#include <algorithm>

#include "lesson/subjects/pair/box_figures.hpp"

namespace snug::app {
namespace {

/// Fills in what facts show beyond marks on vertices.
struct PairFiller {
  PairShown& shown;
  const lesson::Session& session;

  void operator()(const auto&) const { shown.spoken_of = named_now(session); }
  void operator()(const query::AxisTested<double, 3>&) const {}  // PairShown::axis
  void operator()(const query::OutlinesCompared& fact) const { shown.outlines = fact; }
  void operator()(const query::CornerTried& fact) const { shown.corner = fact; }
};

/// While a question about an axis is open, shows only the axis, and hides the answer.
void show_axis_asked(PairShown& shown, const lesson::Session& session) {
  const lesson::Asked* asked = session.conversation().asked();
  if (asked == nullptr) return;
  const auto& fact = lesson::pair_run(session.player().run(0)).trace()[asked->fact].step.fact;
  if (const auto* axis = std::get_if<query::AxisTested<double, 3>>(&fact)) shown.axis_asked = *axis;
}

}  // namespace

lesson::PairSteps steps_shown(const lesson::Session& session) {
  return lesson::pair_run(session.player().run(0)).trace().first(session.player().step());
}

void show_row(PairShown& shown, const lesson::Session& session, int row) {
  const auto in_row = [&](const query::AxisTested<double, 3>& axis) {
    return lesson::axis_index(session.stage().subject().dim(), axis.axis) == row;
  };
  const auto tested = lesson::axes_seen(steps_shown(session));
  shown.axis.reset(), shown.axis_asked.reset();
  if (const auto found = std::find_if(tested.begin(), tested.end(), in_row); found != tested.end()) {
    shown.axis = *found;
    return;
  }
  const lesson::PairTrace all = lesson::record("sat_all", lesson::boxes_of(session.stage().subject()));
  const auto axes = lesson::axes_seen(all);
  if (const auto found = std::find_if(axes.begin(), axes.end(), in_row); found != axes.end()) shown.axis_asked = *found;
}

PairShown pair_shown_at(const lesson::Session& session) {
  PairShown shown{shown_at(session)};
  if (const lesson::PairSteps steps = steps_shown(session); !steps.empty()) {
    shown.axis = lesson::axis_at(steps);
    std::visit(PairFiller{shown, session}, steps.back().step.fact);
  }
  show_axis_asked(shown, session);
  return shown;
}

}  // namespace snug::app
