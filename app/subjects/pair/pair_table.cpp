#include "app/subjects/pair/pair_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>

#include "app/widgets.hpp"
#include "lesson/names.hpp"
#include "lesson/subjects.hpp"
#include "lesson/subjects/pair/volumes.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

constexpr std::size_t kKinds = kVolumeNames.size();
constexpr float kPairCell = 24, kKindNames = 58, kPairHeading = 24, kPairWords = 12, kPairLine = 18;

/// The marks of query::PairTest in a cell: what it compares.
constexpr std::array<const char*, query::kPairTestNames.size()> kTestMarks{"d²", "d", "d", "[ ]", "[ ]+", "SAT", "GJK"};

std::string pair_kind_name(std::size_t kind, int dim) {
  if (kVolumeNames[kind] == "aabb") return "AABB";
  return kVolumeNames[kind] == "obb" ? "OBB" : std::string(lesson::volume_word(kVolumeNames[kind], dim));
}

query::PairTest pair_test_of(const lesson::Kinds& kinds) { return query::kPairTests[kinds[0]][kinds[1]]; }

std::string pair_test_title(const lesson::Kinds& kinds) {
  const auto name = query::kPairTestNames[static_cast<std::size_t>(pair_test_of(kinds))];
  return std::string(lesson::find_method(lesson::volume_tests(), name)->title);
}

/// Puts a pair on the stage, with its own test, which begins anew unless the result was shown.
void choose_pair(lesson::Session& session, const lesson::Kinds& kinds) {
  const bool at_end = session.player().step() == session.player().steps();
  auto next = session.stage().subject().clone();
  static_cast<lesson::VolumesSubject&>(*next).choose_kinds(kinds);
  static_cast<void>(session.stage().become(std::move(next)));
  const auto own = query::kPairTestNames[static_cast<std::size_t>(pair_test_of(kinds))];
  if (lesson::is_among(session.lesson().algorithms, own)) static_cast<void>(session.player().choose(0, own));
  if (!at_end) session.go(0);
}

/// What a test takes: "41", "1.2k".
std::string nanoseconds_text(double ns) {
  std::array<char, 16> words{};
  std::snprintf(words.data(), words.size(), ns < 1000 ? "%.0f" : "%.1fk", ns < 1000 ? ns : ns / 1000);
  return words.data();
}

/// "41.2 ns"
std::string time_words_of(double ns) { return lesson::number_text(ns, 3) + " ns"; }

/// The measured times, and how they compare.
struct PairHeat {
  std::span<const cost::PairCost> rows;
  double least = 0, most = 0;

  explicit PairHeat(const cost::PairCostRun* costs) {
    if (costs == nullptr) return;
    rows = costs->rows();
    for (const cost::PairCost& row : rows) {
      least = least == 0 ? row.time.median : std::min(least, row.time.median);
      most = std::max(most, row.time.median);
    }
  }
  [[nodiscard]] const cost::PairCost* of(const lesson::Kinds& kinds) const {
    for (const cost::PairCost& row : rows)
      if (row.a == kinds[0] && row.b == kinds[1]) return &row;
    return nullptr;
  }
  /// From 0 for the cheapest to 1 for the most expensive, by factors.
  [[nodiscard]] float share(const cost::PairCost& row) const {
    return most > least && least > 0 ? static_cast<float>(std::log(row.time.median / least) / std::log(most / least))
                                     : 0;
  }
};

struct PairTable {
  const Look& look;
  ImDrawList* list;
  ImVec2 at;  // of the first cell
  float cell;
  int dim;
  lesson::Kinds shown;
  PairHeat heat;

  [[nodiscard]] Rect rect(const lesson::Kinds& kinds) const {
    return {at.x + static_cast<float>(kinds[1]) * cell, at.y + static_cast<float>(kinds[0]) * look.px(kPairCell), cell,
            look.px(kPairCell)};
  }
  /// The name of a row, and above its first cell, which is on the diagonal, that of its column.
  void names(std::size_t kind) const {
    const Rect row = rect({kind, 0}), first = rect({kind, kind});
    text(list, look, Face::kRegular, 11, {at.x - look.px(kKindNames), middle_of(row.y + row.height / 2, look.px(11))},
         look->muted, pair_kind_name(kind, dim));
    constexpr std::array<const char*, kKinds> kLetters{"S", "A", "O", "Ca", "L", "K", "H"};
    text_middle(list, look, Face::kSemiBold, 11, {first.x + cell / 2, at.y - look.px(14)}, look->muted,
                kind == 0 && dim == 2 ? "C" : kLetters[kind]);
  }
  /// Returns whether it is pointed at; clicked: whether it was chosen.
  bool one(const lesson::Kinds& kinds, bool& clicked) const {
    const Rect box = rect(kinds);
    const std::string name = says(kinds);
    const Touch touch =
        touch_area(("pair " + pair_kind_name(kinds[0], dim) + pair_kind_name(kinds[1], dim)).c_str(), box, name);
    const cost::PairCost* cost = heat.of(kinds);
    clicked = touch.clicked;
    const bool lit = touch.hovered || touch.focused, on = kinds == shown;
    const bool own = pair_test_of(kinds) != query::PairTest::kGjk;
    if (touch.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    const ImVec2 low{box.x + 1, box.y + 1}, high{box.x + box.width - 1, box.y + box.height - 1};
    if (cost != nullptr)
      list->AddRectFilled(low, high, with_alpha(look->examined, 0.06f + 0.44f * heat.share(*cost)), 3);
    else list->AddRectFilled(low, high, with_alpha(own ? look->current : look->muted, own ? 0.12f : 0.06f), 3);
    if (on || lit) list->AddRect(low, high, with_alpha(look->current, on ? 1.0f : 0.6f), 3, 0, on ? 2.0f : 1.0f);
    text_middle(list, look, on ? Face::kMonoBold : Face::kMono, 10,
                {box.x + box.width / 2, middle_of(box.y + box.height / 2, look.px(10))}, look->ink,
                cost != nullptr ? nanoseconds_text(cost->time.median)
                                : kTestMarks[static_cast<std::size_t>(pair_test_of(kinds))]);
    return lit;
  }
  /// "circle and hull: GJK, 412 ns; in a scene 310 ns", "OBB and OBB: Separating axes, 5.0 ns; in a scene 3.5 ns; GJK
  /// 230 ns"
  [[nodiscard]] std::string says(const lesson::Kinds& kinds) const {
    std::string words =
        pair_kind_name(kinds[0], dim) + " and " + pair_kind_name(kinds[1], dim) + ": " + pair_test_title(kinds);
    const cost::PairCost* cost = heat.of(kinds);
    if (cost == nullptr) return words;
    words += ", " + time_words_of(cost->time.median) + "; in a scene " + time_words_of(cost->scene.median);
    if (pair_test_of(kinds) != query::PairTest::kGjk) words += "; GJK " + time_words_of(cost->gjk.median);
    return words;
  }
};

/// Whether it is still to be predicted which test is cheaper.
bool cheaper_waits(const lesson::Session& session) {
  const auto& questions = session.lesson().questions;
  return std::any_of(questions.begin(), questions.end(), [&](const lesson::Question& question) {
    return question.asks == "cheaper" && session.conversation().is_open(question);
  });
}

constexpr std::string_view kPredictCheaper =
    "Predict which test is cheaper. Then you can measure what each pair costs.";

const lesson::VolumesSubject& volumes_on(const lesson::Session& session) {
  return *lesson::as<lesson::VolumesSubject>(session.stage().subject());
}

/// Whether the button would give an answer away.
bool measuring_waits(const lesson::Session& session) {
  return volumes_on(session).costs() == nullptr && cheaper_waits(session);
}

CoverButton measure_button(const lesson::VolumesSubject& subject) {
  const bool running = subject.costs() != nullptr && !subject.costs()->done();
  return {.command = std::string(kMeasurePairs),
          .words = running ? "Measured: " + std::to_string(subject.costs()->rows().size()) + " of 28"
                   : subject.costs() != nullptr ? "Measure again"
                                                : "Measure what each costs",
          .enabled = !running};
}

/// The button that measures, and what was measured. Returns how high it is.
float draw_pair_measuring(const Look& look, lesson::Session& session, ImVec2 at, float width) {
  if (!volumes_on(session).can_measure()) return 0;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float height = look.fingers ? 44.0f : look.px(30);
  if (measuring_waits(session))
    return paragraph(list, look, Face::kRegular, kPairWords, kPairLine, at, width, look->muted, kPredictCheaper);
  const CoverButton measure = measure_button(volumes_on(session));
  if (button(list, look,
             {.id = "measure pairs",
              .rect = {at.x, at.y, width, height},
              .words = measure.words,
              .kind = ButtonKind::kOutlined,
              .enabled = measure.enabled,
              .size = 13}))
    measure_pairs(session);
  if (volumes_on(session).costs() == nullptr) return height;
  return height + look.px(6) +
         paragraph(list, look, Face::kRegular, 11, 16, {at.x, at.y + height + look.px(6)}, width, look->muted,
                   "Nanoseconds of one test on this machine, on the same 96 pairs of random bodies near contact. The "
                   "line above "
                   "has the time in a scene, where most bodies are apart, and GJK’s. The stronger the tint, the more "
                   "expensive the test.");
}

}  // namespace

bool measure_pairs(lesson::Session& session) {
  const lesson::VolumesSubject& subject = volumes_on(session);
  if (!subject.pair().any || !subject.can_measure() || measuring_waits(session)) return false;
  if (subject.costs() != nullptr && !subject.costs()->done()) return false;
  session.inform<lesson::VolumesSubject>([](lesson::VolumesSubject& own) { own.measure_costs(); });
  return true;
}

bool work_on_pairs(lesson::Session& session) {
  constexpr double kBudget = 4e6;  // ns of a frame
  const cost::PairCostRun* costs = volumes_on(session).costs();
  if (costs == nullptr || costs->done()) return false;
  session.inform<lesson::VolumesSubject>([](lesson::VolumesSubject& own) { own.work_on_costs(kBudget); });
  return true;
}

std::optional<PanelWords> pairs_in_words(const lesson::Session& session) {
  const lesson::VolumesSubject& subject = volumes_on(session);
  if (!subject.pair().any || session.stage().conduct().decides) return std::nullopt;
  const PairHeat heat(subject.costs());
  PanelWords words{
      {.head = {"Pair", "Test", "Its time", "In a scene", "GJK’s time", "Apart", "Source"}, .title = "All 28 pairs"}};
  const int dim = subject.pair().dim;
  for (std::size_t i = 0; i < kKinds; ++i)
    for (std::size_t j = i; j < kKinds; ++j) {
      const cost::PairCost* cost = heat.of({i, j});
      const auto time = [&](cost::Timing cost::PairCost::*which) {
        return cost != nullptr ? time_words_of((cost->*which).median) : std::string();
      };
      words.table.rows.push_back({pair_kind_name(i, dim) + " and " + pair_kind_name(j, dim), pair_test_title({i, j}),
                                  time(&cost::PairCost::time), time(&cost::PairCost::scene), time(&cost::PairCost::gjk),
                                  cost != nullptr ? lesson::number_text(100 * cost->apart, 3) + " %" : std::string(),
                                  std::string(query::source_of(query::kPairTests[i][j]))});
    }
  if (!subject.can_measure()) return words;
  if (measuring_waits(session)) words.says = kPredictCheaper;
  else words.button = measure_button(subject);
  return words;
}

float draw_pair_table(const Look& look, lesson::Session& session, ImVec2 at, float width) {
  const lesson::VolumePair& pair = lesson::as<lesson::VolumesSubject>(session.stage().subject())->pair();
  if (!pair.any || session.stage().conduct().decides) return 0;  // an exercise has its pair
  ImDrawList* list = ImGui::GetWindowDrawList();
  text(list, look, Face::kSemiBold, 13, {at.x, at.y + look.px(5)}, look->muted, "All 28 pairs: choose one");
  const float top = at.y + look.px(kPairHeading + kPairLine), names = look.px(kKindNames);
  const PairTable table{look,
                        list,
                        {at.x + names, top},
                        (width - names) / kKinds,
                        pair.dim,
                        lesson::kinds_of(pair),
                        PairHeat(lesson::as<lesson::VolumesSubject>(session.stage().subject())->costs())};
  lesson::Kinds said = table.shown;
  for (std::size_t i = 0; i < kKinds; ++i) {
    table.names(i);
    for (std::size_t j = i; j < kKinds; ++j) {
      bool clicked = false;
      if (table.one({i, j}, clicked)) said = {i, j};
      if (clicked)
        return choose_pair(session, {i, j}), top - at.y + kKinds * look.px(kPairCell) + look.px(2 * kPairLine);
    }
  }
  const float foot = top + kKinds * look.px(kPairCell) + look.px(6);
  paragraph(list, look, Face::kRegular, kPairWords, kPairLine, {at.x, foot}, width, look->ink, table.says(said));
  const float measuring = foot + look.px(2 * kPairLine + 4);
  return measuring - at.y + draw_pair_measuring(look, session, {at.x, measuring}, width);
}

}  // namespace snug::app
