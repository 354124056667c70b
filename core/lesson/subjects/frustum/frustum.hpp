// A body and a frustum, and the tests that classify the body.
#pragma once

#include "lesson/boxes.hpp"
#include "lesson/facts.hpp"
#include "lesson/subjects/frustum/frustum_tests.hpp"
#include "lesson/subjects/frustum/survey.hpp"

namespace snug::lesson {

extern const SubjectRow kFrustumRow;

class FrustumRun final : public FactRun<FrustumRun, FrustumStep> {
 public:
  /// Records the test.
  FrustumRun(std::string_view test, const BoxPair& pair);
  [[nodiscard]] FrustumSteps trace() const { return trace_; }
  [[nodiscard]] const std::string& body() const { return body_; }
  /// Whether the test says outside of a body that reaches into the frustum.
  [[nodiscard]] bool loses() const { return loses_; }
  /// Whether that plane has no normal left in the test's matrix: what was tested in its place rejects nothing.
  [[nodiscard]] bool has_no_normal(int plane) const { return far_lost_ && plane == planes_of_frustum(dim_) - 1; }
  /// Every vertex of the box. Not inline: tests make such a run themselves, and this room has no type information.
  [[nodiscard]] std::vector<Index> candidates(int i) const override;
  struct Where {
    const FrustumRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] int dim() const { return run.dim_; }
    [[nodiscard]] const std::string& body() const { return run.body_; }
    [[nodiscard]] bool loses() const { return run.loses_; }
  };

 private:
  int dim_;
  std::string body_;  // "box"
  bool box_;
  FrustumTrace trace_;
  bool loses_;
  bool far_lost_;
};

extern template class FactRun<FrustumRun, FrustumStep>;

[[nodiscard]] inline const FrustumRun& frustum_run(const Run& run) { return static_cast<const FrustumRun&>(run); }

class FrustumSubject final : public BoxSubject, public HasVolumes, public HasGoals {
 public:
  static constexpr const SubjectRow& kRow = kFrustumRow;
  /// clock: by which the survey keeps to its portions; null for none.
  FrustumSubject(const BoxPair& pair, std::uint64_t seed, Clock clock = nullptr)
      : BoxSubject(pair, seed), clock_(clock) {}
  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<FrustumSubject>(*this); }
  /// "Box", "Box turn", "+−" (sign_name), "Circle", "Circle radius", "Point", "Frustum", "Frustum turn", "F3".
  [[nodiscard]] std::string name_of(Index i) const override;
  /// The body; a point is a sphere without a radius.
  [[nodiscard]] std::vector<fit::Volume3> volumes() const override;
  [[nodiscard]] Rows planes() const override;
  [[nodiscard]] std::string_view stage_says() const override;
  [[nodiscard]] Tools tools() const override;
  [[nodiscard]] Words words_of(int box) const override;
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  /// Besides the number fields, "near": its distance over that of the far plane. The far face stays.
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;
  [[nodiscard]] bool reaches(std::string_view goal) const override;
  [[nodiscard]] std::string goal_says(std::string_view goal) const override;

  /// Starts a survey of the sphere's radius around the frustum, by the seed on the stage; works on it for so many
  /// nanoseconds, or without a clock to its end. An edit ends it.
  void start_survey();
  void work_on_survey(double budget);
  /// That of what stands on the stage, started or done; null for none.
  [[nodiscard]] const FrustumSurvey* survey() const;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.volumes = this, .scalar = this, .goals = this}; }
  [[nodiscard]] Done check(const BoxPair& pair) const override;

 private:
  Clock clock_;
  std::shared_ptr<FrustumSurvey> survey_;  // shared, to keep snapshots small
};

}  // namespace snug::lesson
