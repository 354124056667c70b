// Charts of what the lectures claim: each claim is tried on hundreds of clouds, and what came of it decides the
// answers. A cloud on which a claim does not hold can be put on the stage.
#pragma once

#include "lesson/on_cloud.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects.hpp"
#include "measure/trials.hpp"

namespace snug::lesson {

extern const SubjectRow kClaimsRow;

class ClaimsSubject final : public OnCloud {
 public:
  static constexpr const SubjectRow& kRow = kClaimsRow;
  explicit ClaimsSubject(std::unique_ptr<Subject> cloud) : OnCloud(std::move(cloud)) {}

  /// Takes what came of all clouds of all claims, which no edit of the stage changes.
  void tried(std::vector<cost::TrialRow> trials) { trials_ = std::move(trials); }
  /// Empty before that.
  [[nodiscard]] const std::vector<cost::TrialRow>& trials() const { return trials_; }

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<ClaimsSubject>(*this); }
  [[nodiscard]] std::string_view stage_says() const override { return "the chart of a claim, or the points"; }
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;

  // The cloud's.
  [[nodiscard]] std::vector<Rival> rivals(const Lesson& lesson, const View& view) const override {
    return cloud().rivals(lesson, view);
  }
  [[nodiscard]] std::optional<double> result_size(const Method& method, bool by_measure,
                                                  const View& view) const override {
    return cloud().result_size(method, by_measure, view);
  }
  [[nodiscard]] std::int64_t operations(const Method& method) const override { return cloud().operations(method); }

 private:
  void points_changed() override {}  // the clouds that were tried are not those on the stage

  std::vector<cost::TrialRow> trials_;
};

/// The lesson's name of the method that shows where a claim does not hold.
[[nodiscard]] std::string shown_by(const Lesson& lesson, const cost::Claim& claim);

/// What came of a claim, as an answer says it: "holds on all 240 clouds", and the verdict's place among the answers.
[[nodiscard]] std::string tally_text(const cost::TrialTally& tally);

}  // namespace snug::lesson
