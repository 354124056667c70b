#include "app/subjects/pair/shown.hpp"

#include "lesson/box_figures.hpp"

namespace snug::app {
namespace {

/// Fills in what has a picture of its own.
struct PairFiller {
  PairShown& shown;
  const fit::Step3& step;
  const lesson::Session& session;

  void operator()(const auto&) const { shown.spoken_of = named_by(step, session); }
  void operator()(const query::AxisTested<double, 3>&) const {}  // PairShown::axis
  void operator()(const query::OutlinesCompared& fact) const { shown.outlines = fact; }
  void operator()(const query::CornerTried& fact) const { shown.corner = fact; }
};

/// A question about an axis shows which one it means, and leaves the answer to be found.
void show_axis_asked(PairShown& shown, const lesson::Session& session) {
  const lesson::Asked* asked = session.asked();
  if (asked == nullptr) return;
  const auto& fact = session.recording(0).steps[asked->fact].step.fact;
  if (const auto* axis = std::get_if<query::AxisTested<double, 3>>(&fact)) shown.axis_asked = *axis;
}

}  // namespace

PairShown pair_shown_at(const lesson::Session& session) {
  PairShown shown{shown_at(session, false)};
  if (const lesson::Trace steps = steps_shown(session); !steps.empty()) {
    shown.axis = lesson::axis_at(steps);
    std::visit(PairFiller{shown, steps.back().step, session}, steps.back().step.fact);
  }
  show_axis_asked(shown, session);
  return shown;
}

}  // namespace snug::app
