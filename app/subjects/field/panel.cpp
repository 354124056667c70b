// What each method costs on the field, beside the stage.
#include <algorithm>
#include <string>

#include "app/subjects/field/draw.hpp"
#include "app/widgets.hpp"
#include "lesson/figures.hpp"
#include "lesson/say.hpp"
#include "lesson/subjects.hpp"

namespace snug::app {
namespace {

constexpr double kMeasuringOfFrame = 3e6;  // ns
constexpr float kFieldHead = 26, kFieldTime = 74, kFieldWords = 13;

/// The figures that the panel's bars would give away.
bool asks_of_tests(const lesson::Question& question) {
  return question.figure == "saved" || question.figure == "planes" || question.figure == "products" ||
         question.figure == "products_saved";
}

/// Whether a question about what a method costs is still to be answered.
bool is_to_be_predicted(const lesson::Session& session, const lesson::Method& method) {
  const auto& questions = session.lesson().questions;
  return std::any_of(questions.begin(), questions.end(), [&](const lesson::Question& question) {
    return question.gate.algorithm == method.name && asks_of_tests(question) &&
           session.conversation().is_open(question);
  });
}

/// "0.042 ms", "12.3 ms"
std::string milliseconds(double ns) { return lesson::number_text(ns / 1e6, 2) + " ms"; }

/// Tests of planes, if every plane is tested against every box.
double all_tests(const lesson::Session& session) {
  return 6.0 * static_cast<double>(lesson::field_run(session.player().run(0)).objects());
}

/// "Plane tests, of 60,000"
std::string tests_words(const lesson::Session& session) {
  return "Plane tests, of " + lesson::count_text(static_cast<std::int64_t>(all_tests(session)));
}

/// How many tests of planes a method makes: the chosen one up to the step, another if it was measured.
std::optional<double> tests_of(const lesson::Session& session, const lesson::Method& method,
                               const FieldCosts::Entry* entry) {
  const lesson::FieldRun& run = lesson::field_run(session.player().run(0));
  if (&method == session.player().method(0)) return static_cast<double>(run.tally(run.steps()).planes);
  if (entry == nullptr) return std::nullopt;
  return static_cast<double>(entry->measured.cost.planes);
}

/// "12.5 %"
std::string share_words(double tests, double all) { return lesson::number_text(100 * (tests / all), 3) + " %"; }

struct FieldTable {
  const Look& look;
  const lesson::Session& session;
  const FieldCosts& costs;
  ImDrawList* list;
  float x, width;
  double all;  // all_tests

  /// Returns the row's height. What is shown already moves with the stage; what has to be measured is pale until it is.
  [[nodiscard]] float row(const lesson::Method& method, float y) const {
    const bool chosen = &method == session.player().method(0), hidden = is_to_be_predicted(session, method);
    const FieldCosts::Entry* entry = hidden ? nullptr : costs.of(method);
    const bool fresh = entry != nullptr && costs.is_of_now(*entry);
    const float leading = look.px(18), middle = y + leading / 2, small = look.px(12);
    if (entry != nullptr && entry->measured.ns)
      text_right(list, look, Face::kMono, 12, {x + width, middle_of(middle, small)}, fresh ? look->ink : look->muted,
                 milliseconds(*entry->measured.ns));
    const Face face = chosen ? Face::kSemiBold : Face::kRegular;
    float below = middle;
    for (const std::string_view line : lines_of(look, face, kFieldWords, method.title, width - look.px(kFieldTime))) {
      text(list, look, face, kFieldWords, {x, middle_of(below, look.px(kFieldWords))}, look->ink, line);
      below += leading;
    }
    bar(hidden ? std::nullopt : tests_of(session, method, entry), chosen, fresh || chosen, below);
    if (hidden)
      text_right(list, look, Face::kRegular, 12, {x + width, middle_of(below, small)}, look->muted, "predict");
    return below + leading - y + look.px(4);
  }

 private:
  /// How many of all tests are made; planes: none if that is not to be seen.
  void bar(std::optional<double> planes, bool chosen, bool fresh, float middle) const {
    const float words = look.px(64), high = 6, long_as = width - words, small = look.px(12);
    list->AddRectFilled({x, middle - high / 2}, {x + long_as, middle + high / 2}, look->track, high / 2);
    if (!planes) return;
    const double share = *planes / all;
    list->AddRectFilled({x, middle - high / 2},
                        {x + long_as * static_cast<float>(std::min(share, 1.0)), middle + high / 2},
                        chosen ? look->current : look->previous, high / 2);
    text_right(list, look, Face::kMonoBold, 12, {x + width, middle_of(middle, small)}, fresh ? look->ink : look->muted,
               share_words(*planes, all));
  }
};

/// What the batch buys, once both are measured and may be seen.
std::string batch_words(const lesson::Session& session, const FieldCosts& costs) {
  const lesson::Method& alone = lesson::field_methods()[static_cast<std::size_t>(hierarchy::FieldWay::kPnVertex)];
  const lesson::Method& batch = lesson::field_methods()[static_cast<std::size_t>(hierarchy::FieldWay::kAtOnce)];
  const FieldCosts::Entry *slow = costs.of(alone), *fast = costs.of(batch);
  if (slow == nullptr || fast == nullptr || is_to_be_predicted(session, alone) || is_to_be_predicted(session, batch))
    return {};
  if (!slow->measured.ns || !fast->measured.ns || !(*fast->measured.ns < *slow->measured.ns)) return {};
  const std::string times = lesson::number_text(*slow->measured.ns / std::max(*fast->measured.ns, 1.0), 2);
  return "Eight at once is " + times +
         " times as fast here as the p- and n-vertex one by one, though it tests every plane.";
}

}  // namespace

void FieldCosts::measure(const lesson::Session& session) {
  const auto& subject = *lesson::as<lesson::FieldSubject>(session.stage().subject());
  lesson::Rows rows = subject.rows();
  const bool still = rows == rows_ && seed_ == session.stage().subject().origin().seed;
  if (!still) rows_ = std::move(rows), seed_ = session.stage().subject().origin().seed, ++stage_, at_work_.reset();
  working_ = false;
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method& method = *lesson::find_method(session.lesson(), name);
    if (const Entry* own = of(method); own != nullptr && is_of_now(*own)) continue;
    working_ = true;
    if (still) measure_next(session, method);
    return;
  }
}

void FieldCosts::measure_next(const lesson::Session& session, const lesson::Method& method) {
  if (!at_work_ || measured_ != &method) {
    at_work_.emplace(lesson::as<lesson::FieldSubject>(session.stage().subject())->measuring(method));
    measured_ = &method;
  }
  at_work_->work(kMeasuringOfFrame);
  if (!at_work_->done()) return;
  const Entry entry{&method, at_work_->result(), stage_};
  at_work_.reset();
  std::erase_if(entries_, [&](const Entry& one) { return one.method == &method; });
  entries_.push_back(entry);
}

const FieldCosts::Entry* FieldCosts::of(const lesson::Method& method) const {
  for (const Entry& entry : entries_)
    if (entry.method == &method) return &entry;
  return nullptr;
}

PanelWords field_in_words(const lesson::Session& session, const FieldCosts& costs) {
  PanelWords words{{.head = {"", "Share", "Time"}, .title = tests_words(session)}, batch_words(session, costs)};
  for (const std::string& name : session.lesson().algorithms) {
    const lesson::Method& method = *lesson::find_method(session.lesson(), name);
    const bool hidden = is_to_be_predicted(session, method);
    const FieldCosts::Entry* entry = hidden ? nullptr : costs.of(method);
    const std::optional<double> tests = hidden ? std::nullopt : tests_of(session, method, entry);
    const bool timed = entry != nullptr && costs.is_of_now(*entry) && entry->measured.ns;
    words.table.rows.push_back({std::string(method.title),
                                hidden  ? "predict"
                                : tests ? share_words(*tests, all_tests(session))
                                        : std::string(),
                                timed ? milliseconds(*entry->measured.ns) : std::string()});
  }
  return words;
}

float draw_field_panel(const Look& look, const lesson::Session& session, const FieldCosts& costs, ImVec2 at,
                       float width) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float middle = middle_of(at.y + look.px(11), look.px(kFieldWords));
  text(list, look, Face::kSemiBold, kFieldWords, {at.x, middle}, look->muted, tests_words(session));
  text_right(list, look, Face::kSemiBold, kFieldWords, {at.x + width, middle}, look->muted, "Time");
  float y = at.y + look.px(kFieldHead);
  const FieldTable table{look, session, costs, list, at.x, width, all_tests(session)};
  for (const std::string& name : session.lesson().algorithms) {
    y += table.row(*lesson::find_method(session.lesson(), name), y);
  }
  if (const std::string words = batch_words(session, costs); !words.empty())
    y += paragraph(list, look, Face::kRegular, 12, 17, {at.x, y}, width, look->muted, words);
  return y - at.y;
}

}  // namespace snug::app
