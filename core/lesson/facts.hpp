// How a subject describes its facts. Each fact has one entry: its sentence, the handles that it is about, whether it is
// a mark on the timeline, and what can be asked of it. A fact without an entry does not compile.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <variant>

#include "lesson/ask.hpp"

namespace snug::lesson {

/// The entry of a fact. Where: the step in its run (Own::Where). It has
///   static std::string sentence(const Fact&, const Where&)
/// and redefines whichever of the defaults below it needs.
template <class Fact>
struct Entry;

struct EntryDefaults {
  static std::vector<Index> handles(const auto&, const auto&) { return {}; }
  static std::string predicate(const auto&, const auto&, bool plural) { return plural ? "are named" : "is named"; }
  static std::optional<Mark::Kind> mark(const auto&, const auto&) { return std::nullopt; }
  static bool counts(const auto&) { return true; }
  static constexpr std::array<QuestionKind, 0> kQuestionKinds{};
};

/// A run whose steps are facts of a variant. Own: the run itself, with
///   std::span<const Recorder<Step>::Entry> trace() const
///   struct Where, made of the run, the step's place and Untold
/// and, if not all steps are recorded at once, steps() and `entry(int i)`, which records as many as it needs.
/// The definitions are in fact_run.hpp, for the one file that has all entries and instantiates it.
template <class Own, class Step>
class FactRun : public Run {
 public:
  [[nodiscard]] int steps() const override;
  [[nodiscard]] std::string_view fact(int i) const override;
  [[nodiscard]] int line(int i) const final;
  [[nodiscard]] std::string sentence(int i, const Untold& untold) const final;
  [[nodiscard]] std::vector<Index> handles(int i) const final;
  [[nodiscard]] std::string predicate(int i, bool plural) const final;
  [[nodiscard]] std::optional<Mark::Kind> mark(int i) const override;
  [[nodiscard]] std::span<const QuestionKind> question_kinds(int i) const override;
  [[nodiscard]] bool counts(int i) const override;
  [[nodiscard]] std::uint64_t hash() const final;
  [[nodiscard]] const fit::Volume3* volume(int steps) const final;

 private:
  [[nodiscard]] const Own& own() const { return static_cast<const Own&>(*this); }
  [[nodiscard]] const Step& step_at(int i) const;
  template <class Call>
  auto visit(int i, Call call) const;
  [[nodiscard]] auto where(int i, const Untold* untold = nullptr) const;
};

template <class Facts>
struct FactList;
template <class... Facts>
struct FactList<std::variant<Facts...>> {
  /// The names of all facts, in order.
  static std::vector<std::string_view> names() { return {Facts::kName...}; }
  /// What can be asked of any of these facts.
  static std::vector<FactQuestionKind> question_kinds() {
    std::vector<FactQuestionKind> all;
    const auto add = [&](std::string_view fact, const auto& some) {
      for (const QuestionKind& kind : some) all.push_back({fact, &kind});
    };
    (add(Facts::kName, Entry<Facts>::kQuestionKinds), ...);
    return all;
  }
};

/// The answers of a yes-or-no question.
inline const char* offer_yes_no(Asked& asked, const Run&) {
  asked.add_choice("yes");
  asked.add_choice("no");
  return nullptr;
}
inline constexpr int kYes = 0, kNo = 1;
[[nodiscard]] inline Truth yes(std::string sentence) { return {{kYes}, {}, "yes", std::move(sentence)}; }
[[nodiscard]] inline Truth no(std::string sentence) { return {{kNo}, {}, "no", std::move(sentence)}; }

}  // namespace snug::lesson
