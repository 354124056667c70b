#include "lesson/subjects/criteria/criteria_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "lesson/figures.hpp"

namespace snug::lesson {
namespace {

constexpr int kFigureDigits = 3, kShareDigits = 2;
constexpr std::string_view kDash = "–";

CriteriaCell cost_cell(std::optional<double> cost, bool counted) {
  return {cost ? cost_text(*cost, counted) : std::string(kDash), cost};
}

std::vector<CriteriaCell> criteria_cells(const CriteriaSubject& subject, std::size_t i) {
  const bool counted = subject.is_counted();
  const auto value = [&](Criterion criterion) { return subject.value(i, criterion, subject.load_now()); };
  const auto cost = [&](Criterion criterion) { return cost_cell(value(criterion), counted); };
  const auto loose = value(Criterion::kLooseness), bytes = value(Criterion::kBytes);
  return {cost(Criterion::kTest),
          {loose ? number_text(*loose) : std::string(kDash), loose},
          cost(Criterion::kBuild),
          cost(Criterion::kUpdate),
          {bytes ? count_text(std::llround(*bytes)) : std::string(kDash), bytes},
          cost(Criterion::kTotal)};
}

std::vector<CriteriaCell> total_cells(const CriteriaSubject& subject, std::size_t i) {
  const bool counted = subject.is_counted();
  const auto total = subject.total(i, subject.load_now());
  const auto cell = [&](double TotalCost::*part) {
    return cost_cell(total ? std::optional((*total).*part) : std::nullopt, counted);
  };
  return {cell(&TotalCost::build), cell(&TotalCost::updates), cell(&TotalCost::tests),
          cell(&TotalCost::false_positives), cost_cell(total ? std::optional(total->sum()) : std::nullopt, counted)};
}

/// The place of a volume in the textbooks' order of tests, from the simplest to the one that takes most, from 1.
std::optional<double> textbook_place(const Method& method) {
  constexpr std::array<std::string_view, 5> kOrder{"sphere", "aabb", "kdop", "obb", "hull"};
  const auto* const found = std::find(kOrder.begin(), kOrder.end(), method.volume);
  if (found == kOrder.end()) return std::nullopt;
  return static_cast<double>(found - kOrder.begin() + 1);
}

/// All ranks count from 1 for the best, and those of one criterion are one column.
std::vector<std::vector<int>> all_ranks(const CriteriaSubject& subject) {
  std::vector<std::vector<int>> ranks;
  for (const Criterion criterion : {Criterion::kTest, Criterion::kBuild, Criterion::kUpdate, Criterion::kBytes,
                                    Criterion::kLooseness, Criterion::kTotal})
    ranks.push_back(subject.ranks(criterion, subject.load_now()));
  return ranks;
}

CriteriaCell rank_cell(std::optional<double> rank) {
  return {rank ? count_text(std::llround(*rank)) : std::string(kDash), rank};
}

std::vector<CriteriaCell> rank_cells(const Method& method, const std::vector<std::vector<int>>& ranks, std::size_t i) {
  std::vector<CriteriaCell> cells{rank_cell(textbook_place(method))};
  for (const std::vector<int>& column : ranks)
    cells.push_back(rank_cell(column.empty() ? std::nullopt : std::optional<double>(column[i] + 1)));
  return cells;
}

/// The volume with the least total cost, but for one; none before it is known.
std::optional<std::size_t> least_of(const CriteriaSubject& subject, const Load& load,
                                    std::optional<std::size_t> except = {}) {
  std::optional<std::size_t> least;
  double sum = 0;
  for (std::size_t i = 0; i < subject.around().volumes.size(); ++i) {
    const auto own = subject.value(i, Criterion::kTotal, load);
    if (own && i != except && (!least || *own < sum)) least = i, sum = *own;
  }
  return least;
}

/// "sphere", "14-DOP"
std::string in_sentence(const Method& method) {
  const std::string_view title = short_title(method);
  return std::string(title.size() > 1 && std::islower(static_cast<unsigned char>(title[1])) != 0 ? method.volume
                                                                                                 : title);
}

/// The parts of a total cost: what they are called, and what a volume does there.
enum class Part : std::uint8_t { kBuild, kUpdates, kTests, kFalsePositives };
constexpr std::array kParts{&TotalCost::build, &TotalCost::updates, &TotalCost::tests, &TotalCost::false_positives};
constexpr std::array<std::string_view, 4> kPartNames{"building", "updates", "tests", "false positives"};

/// "one update moves one point"; empty where the figures say it all.
std::string what_it_does(const FittedVolume& fitted, Part part, const Load& load) {
  struct Work {
    std::string_view volume, update, test;
  };
  constexpr std::array<Work, 7> kWorks{
      {{"sphere", "moves one point", "compares one distance"},
       {"aabb", "climbs over the hull for six bounds", "compares three pairs of intervals"},
       {"obb", "is one product of two matrices", "goes through up to fifteen axes"},
       {"capsule", "moves two points", "takes the distance of two segments"},
       {"lozenge", "moves one point and two edges", "takes the distance of two rectangles"},
       {"kdop", "climbs over the hull for each bound", "compares a pair of intervals for each direction"},
       {"hull", "moves every vertex", "is GJK"}}};
  const auto* const work =
      std::find_if(kWorks.begin(), kWorks.end(), [&](const Work& one) { return one.volume == fitted.method->volume; });
  if (work == kWorks.end()) return {};
  if (part == Part::kTests) return "its test " + std::string(work->test);
  if (part == Part::kUpdates && !load.deforms) return "its update " + std::string(work->update);
  if (part == Part::kFalsePositives) return "it is " + looseness_words(fitted);
  return {};
}

}  // namespace

std::string_view short_title(const Method& method) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTitles{{{"sphere", "Sphere"},
                                                                                  {"aabb", "AABB"},
                                                                                  {"obb", "OBB"},
                                                                                  {"capsule", "Capsule"},
                                                                                  {"lozenge", "Lozenge"},
                                                                                  {"hull", "Hull"}}};
  for (const auto& [name, title] : kTitles)
    if (name == method.volume) return title;
  return method.title;  // a k-DOP's says its k
}

std::string cost_text(double ns, bool counted) {
  if (counted) return count_text(std::llround(std::min(ns, 1e18)));
  constexpr std::array<std::pair<double, std::string_view>, 4> kUnits{
      {{1e9, " s"}, {1e6, " ms"}, {1e3, " µs"}, {1, " ns"}}};
  const auto* unit = std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& one) { return ns >= one.first; });
  if (unit == kUnits.end()) unit = &kUnits.back();
  const double value = ns / unit->first;
  const int decimals = value >= 100 ? 0 : value >= 10 ? kFigureDigits - 2 : kFigureDigits - 1;
  return ns == 0 ? std::string("0") : decimal_text(value, decimals) + std::string(unit->second);
}

CriteriaTable criteria_table(const CriteriaSubject& subject, CriteriaTableKind kind) {
  CriteriaTable table;
  using Kind = CriteriaTableKind;
  table.head =
      kind == Kind::kCriteria ? std::vector<std::string>{"Volume", "Test", "Looseness", "Build", "Update", "Bytes", "T"}
      : kind == Kind::kTotal
          ? std::vector<std::string>{"Volume", "Build", "Updates", "Tests", "False pos.", "T"}
          : std::vector<std::string>{"Volume", "Textbook", "Test", "Build", "Update", "Bytes", "Looseness", "T"};
  const std::vector<std::vector<int>> ranks = kind == Kind::kRanks ? all_ranks(subject) : decltype(ranks){};
  const std::vector<FittedVolume>& volumes = subject.around().volumes;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    table.names.emplace_back(short_title(*volumes[i].method));
    table.cells.push_back(kind == Kind::kCriteria ? criteria_cells(subject, i)
                          : kind == Kind::kTotal  ? total_cells(subject, i)
                                                  : rank_cells(*volumes[i].method, ranks, i));
  }
  return table;
}

std::string looseness_words(const FittedVolume& volume) {
  return volume.over_hull ? number_text(*volume.over_hull, kFigureDigits) + " times the hull" : "flat";
}

std::string winner_text(const CriteriaSubject& subject, const Load& own) {
  const auto best = least_of(subject, own), next = least_of(subject, own, best);
  if (!best || !next) return {};
  const TotalCost won = *subject.total(*best, own), lost = *subject.total(*next, own);
  std::size_t saved = 0, paid = 0;  // where the winner's lead is largest, and where it is behind most
  for (std::size_t i = 1; i < kParts.size(); ++i) {
    const auto lead = [&](std::size_t part) { return lost.*kParts[part] - won.*kParts[part]; };
    if (lead(i) > lead(saved)) saved = i;
    if (lead(i) < lead(paid)) paid = i;
  }
  const auto& volumes = subject.around().volumes;
  const auto against = [&](std::size_t part) {
    return std::string(kPartNames[part]) + " (" + cost_text(won.*kParts[part], subject.is_counted()) + " against " +
           cost_text(lost.*kParts[part], subject.is_counted()) + ")";
  };
  const auto reason = [&](std::size_t volume, std::size_t part) {
    const std::string does = what_it_does(volumes[volume], static_cast<Part>(part), own);
    return does.empty() ? does : ": " + does;
  };
  std::string says = "Beside the next, the " + in_sentence(*volumes[*next].method) + ", the " +
                     in_sentence(*volumes[*best].method) + " saves most on " + against(saved) + reason(*best, saved) +
                     ".";
  if (won.*kParts[paid] > lost.*kParts[paid]) says += " It pays more for " + against(paid) + reason(*best, paid) + ".";
  return says;
}

std::string defence_text(const CriteriaSubject& subject, std::size_t volume) {
  const FittedVolume& own = subject.around().volumes[volume];
  const std::string name(short_title(*own.method));
  const auto total = subject.total(volume, subject.load_now());
  const auto least = least_of(subject, subject.load_now());
  if (!total || !least) return name + ": " + looseness_words(own) + ". Press Measure to see what it costs.";
  const bool counted = subject.is_counted();
  std::size_t most = 0;
  for (std::size_t i = 1; i < kParts.size(); ++i)
    if ((*total).*kParts[i] > (*total).*kParts[most]) most = i;
  std::string says = name + ": T = " + cost_text(total->sum(), counted) + ", " +
                     number_text(100 * (*total).*kParts[most] / total->sum(), kShareDigits) + " % of it " +
                     std::string(kPartNames[most]) + ". It passes " +
                     number_text(100 * subject.around().rows[volume].passes.rate(), kFigureDigits) +
                     " % of the pairs that are apart.";
  if (*least == volume) return says + " Nothing costs less here.";
  const auto best = subject.value(*least, Criterion::kTotal, subject.load_now());
  return says + " Least: " + std::string(short_title(*subject.around().volumes[*least].method)) + ", " +
         cost_text(*best, counted) + ".";
}

}  // namespace snug::lesson
