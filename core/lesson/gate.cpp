// Where questions stand on a trace.
#include <algorithm>
#include <optional>

#include "lesson/ask.hpp"
#include "lesson/box_tests.hpp"
#include "lesson/frustum_tests.hpp"
#include "lesson/methods.hpp"
#include "lesson/scene_figures.hpp"
#include "lesson/words.hpp"

namespace snug::lesson {
namespace {

using namespace fit;
using Asks = Question::Asks;

const Step3& step_at(Trace trace, int i) { return trace[i].step; }

std::size_t fact_index(std::string_view name) {
  const auto names = fact_names();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

bool outermost(const Step3& step) {
  if (const auto* forced = std::get_if<BoundaryForced>(&step.fact)) return forced->depth == 1;
  if (const auto* moved = std::get_if<MovedToFront>(&step.fact)) return moved->depth == 0;
  return true;
}

/// The n-th step of that name, or the trace's size.
int find_fact(Trace trace, std::string_view name, int occurrence) {
  const std::size_t fact = fact_index(name);
  int i = 0;
  for (; i < static_cast<int>(trace.size()); ++i)
    if (step_at(trace, i).fact.index() == fact && outermost(step_at(trace, i)) && --occurrence == 0) break;
  return i;
}

/// Just behind the last step of that name before a step, or the one that is counted; the step itself where there is
/// none.
int place_after(Trace trace, const Gate& gate, int before) {
  if (gate.after == Gate::kStart) return 0;
  if (gate.after_nth > 0) return std::min(find_fact(trace, gate.after, gate.after_nth) + 1, before);
  const std::size_t fact = fact_index(gate.after);
  for (int i = before; i-- > 0;)
    if (step_at(trace, i).fact.index() == fact) return i + 1;
  return before;
}

/// Behind the step; of a point forced onto the boundary, behind the end of its recursion.
int place_decided(Trace trace, int fact, Asks asks) {
  const bool whole = asks == Asks::kLeaves || asks == Asks::kGrows;
  if (!whole || !std::holds_alternative<BoundaryForced>(step_at(trace, fact).fact)) return fact + 1;
  for (int i = fact; i < static_cast<int>(trace.size()); ++i)
    if (std::holds_alternative<MovedToFront>(step_at(trace, i).fact) && outermost(step_at(trace, i))) return i + 1;
  return fact + 1;
}

void add_choice(Asked& asked, std::string text, Index point = kNoIndex) {
  asked.choices.push_back(std::move(text));
  asked.choice_points.push_back(point);
}

const char* add_axes(Asked& asked, Trace trace, int dim) {
  const auto* pair = std::get_if<PairChosen>(&step_at(trace, asked.fact).fact);
  if (pair == nullptr || pair->axis == kNoIndex) return "\"axis\" asks of a pair of extreme points along the axes";
  const ExtremesFound<double, 3>* extremes = nullptr;
  for (int i = asked.fact; extremes == nullptr && i-- > 0;)
    extremes = std::get_if<ExtremesFound<double, 3>>(&step_at(trace, i).fact);
  if (extremes == nullptr) return "\"axis\" asks of a pair after the extreme points are found";
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(dim); ++axis) {
    add_choice(asked, std::string("the ") + "xyz"[axis] + " pair", extremes->least[axis]);
    asked.stage_points.push_back(extremes->least[axis]);
    asked.stage_points.push_back(extremes->greatest[axis]);
  }
  asked.on_stage = true;
  return nullptr;
}

const char* add_support(Asked& asked, Trace trace) {
  const auto& fact = step_at(trace, asked.fact).fact;
  if (!std::holds_alternative<SupportReplaced>(fact) && !std::holds_alternative<BoundaryForced>(fact))
    return "\"leaves\" asks of support_replaced or boundary_forced";
  add_choice(asked, "none");
  for (const Index i : support_after(trace, asked.fact)) {
    add_choice(asked, point_name(i), i);
    asked.stage_points.push_back(i);
  }
  if (asked.stage_points.empty()) return "\"leaves\" asks where no point holds the ball yet";
  asked.on_stage = true;
  return nullptr;
}

const char* add_tested_axes(Asked& asked, Trace trace, int dim) {
  if (!std::holds_alternative<query::Verdict<double, 3>>(step_at(trace, asked.fact).fact))
    return "\"which_axis\" asks of verdict";
  std::size_t tested = 0;
  for (int i = 0; i < asked.fact; ++i)
    tested += std::holds_alternative<query::AxisTested<double, 3>>(step_at(trace, i).fact);
  if (tested != axis_names(dim).size()) return "\"which_axis\" asks of a test that goes through all axes";
  for (const AxisName& axis : axis_names(dim)) add_choice(asked, axis.text);
  add_choice(asked, "none");
  asked.on_axes = true;
  return nullptr;
}

const char* add_corners(Asked& asked, const Step3& step, int dim) {
  const auto* tested = std::get_if<query::PlaneTested<double, 3>>(&step.fact);
  if (tested == nullptr || tested->skipped) return "\"p_vertex\" and \"n_vertex\" ask of plane_tested";
  for (int corner = 0; corner < 1 << dim; ++corner) {
    asked.stage_points.push_back(index_of(dim, {Place::Kind::kCorner, 0, corner}));
    add_choice(asked, sign_name(dim, corner), asked.stage_points.back());
  }
  asked.on_stage = true;
  return nullptr;
}

const char* add_cullings(Asked& asked, bool of_it, const char* refused) {
  for (const std::string_view name : query::kCullingNames) add_choice(asked, std::string(name));
  return of_it ? nullptr : refused;
}

const char* add_ranges(Asked& asked, const Step3& step) {
  if (!std::holds_alternative<FrameTaken>(step.fact)) return "\"figure\" asks of frame_taken";
  const Question& question = *asked.question;
  for (std::string& range : scene_range_texts(question.figure, question.bounds)) add_choice(asked, std::move(range));
  return nullptr;
}

/// Any point of a cloud; of boxes every vertex of those that the answer is of.
const char* add_points(Asked& asked, const Step3& step, int dim) {
  const std::vector<Index> named = points_named(step, dim);
  if (named.empty()) return "\"point\" asks of a step that names no point";
  asked.on_stage = true;
  for (int box = 0; box < 2 && asked.boxes; ++box) {
    if (std::none_of(named.begin(), named.end(), [&](Index i) { return place_of(dim, i).box == box; })) continue;
    for (int corner = 0; corner < 1 << dim; ++corner)
      asked.stage_points.push_back(index_of(dim, {Place::Kind::kCorner, box, corner}));
  }
  return nullptr;
}

/// What may be answered. Returns why the step cannot be asked that, or null.
const char* add_choices(Asked& asked, Trace trace, int dim) {
  const auto& fact = step_at(trace, asked.fact).fact;
  switch (asked.question->asks) {
    case Asks::kPoint: return add_points(asked, step_at(trace, asked.fact), dim);
    case Asks::kAxis: return add_axes(asked, trace, dim);
    case Asks::kLeaves: return add_support(asked, trace);
    case Asks::kBetter:
      if (!std::holds_alternative<PassJudged<double, 3>>(fact) &&
          !std::holds_alternative<CandidateTried<double, 3>>(fact))
        return "\"better\" asks of pass_judged or candidate_tried";
      [[fallthrough]];
    case Asks::kGrows: add_choice(asked, "yes"), add_choice(asked, "no"); return nullptr;
    case Asks::kSeparates:
      if (!std::holds_alternative<query::AxisTested<double, 3>>(fact)) return "\"separates\" asks of axis_tested";
      add_choice(asked, "yes"), add_choice(asked, "no");
      return nullptr;
    case Asks::kWhichAxis: return add_tested_axes(asked, trace, dim);
    case Asks::kPVertex:
    case Asks::kNVertex: return add_corners(asked, step_at(trace, asked.fact), dim);
    case Asks::kPlaneSide:
      return add_cullings(asked, std::holds_alternative<query::PlaneTested<double, 3>>(fact),
                          "\"plane_side\" asks of plane_tested");
    case Asks::kVerdict:
      return add_cullings(asked, std::holds_alternative<query::Classified>(fact), "\"verdict\" asks of classified");
    case Asks::kFigure: return add_ranges(asked, step_at(trace, asked.fact));
    case Asks::kHolds:
      if (!std::holds_alternative<Finished>(fact)) return "\"holds\" asks of finished";
      for (int n = 1; n <= dim + 1; ++n) add_choice(asked, std::to_string(n));
      return nullptr;
    case Asks::kChoice:
      for (const std::string& choice : asked.question->choices) add_choice(asked, in_words_of(dim, choice));
      return nullptr;
    case Asks::kOnFront:
    case Asks::kSlowest:
    case Asks::kTimesSlower: return "this is asked of a lesson with chart = \"cost\"";
  }
  return nullptr;
}

}  // namespace

std::optional<Asked> resolve(const Question& question, std::string_view volume, Trace trace, int dim,
                             std::string& why) {
  const Gate& gate = question.gate;
  Asked asked;
  asked.question = &question;
  asked.dim = dim;
  put_words(asked, false);
  asked.boxes = has_boxes(volume);
  asked.frustum = volume == kFrustumBox;
  asked.fact = find_fact(trace, gate.fact, gate.occurrence);
  if (asked.fact == static_cast<int>(trace.size())) {
    why = gate.algorithm + " does not take step " + gate.fact +
          (gate.occurrence > 1 ? " " + std::to_string(gate.occurrence) + " times" : "") + " on these points";
    return std::nullopt;
  }
  asked.step = gate.after.empty() ? asked.fact : place_after(trace, gate, asked.fact);
  asked.until = place_decided(trace, asked.fact, question.asks);
  if (const char* refused = add_choices(asked, trace, dim)) {
    why = refused;
    return std::nullopt;
  }
  return asked;
}

void put_words(Asked& asked, bool own_run) {
  const Question& question = *asked.question;
  const auto words = [&](const std::string& here, const std::string& anywhere) {
    return in_words_of(asked.dim, own_run && !here.empty() ? here : anywhere);
  };
  asked.prompt = words(question.prompt_here, question.prompt);
  asked.because = words(question.because_here, question.because);
}

std::vector<Asked> asked_on(const Lesson& lesson, std::string_view algorithm, Trace trace, int dim, bool own_run) {
  std::vector<Asked> all;
  std::string why;
  for (const Question& question : lesson.questions) {
    if (question.gate.algorithm != algorithm || (question.own_points && !own_run)) continue;
    auto asked = resolve(question, lesson.volume, trace, dim, why);
    if (!asked) continue;
    put_words(*asked, own_run);
    all.push_back(*std::move(asked));
  }
  std::stable_sort(all.begin(), all.end(), [](const Asked& a, const Asked& b) { return a.step < b.step; });
  std::vector<Asked> apart;
  for (Asked& asked : all)
    if (apart.empty() || asked.step >= apart.back().until) apart.push_back(std::move(asked));
  return apart;
}

}  // namespace snug::lesson
