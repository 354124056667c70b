// A cloud of points, and the volume that an algorithm fits around it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "lesson/point_subject.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/cloud/fit_run.hpp"
#include "lesson/subjects/cloud/hand.hpp"

namespace snug::lesson {

extern const SubjectRow kCloudRow;

/// What sizes are compared with.
struct Reference {
  std::optional<double> size;  // none if it is not known
  std::string name;            // "the optimum", "the convex hull"
  std::string word;            // on the stage: "smallest circle", "convex hull"
  bool by_measure = false;     // whether all sizes are areas or volumes, also those of spheres
};

class CloudSubject final : public PointSubject, public HasScalar, public HasGoals {
 public:
  static constexpr const SubjectRow& kRow = kCloudRow;
  CloudSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh);

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<CloudSubject>(*this); }
  // Behind the points come the handles of what is set by hand, in a lesson that has such a method.
  [[nodiscard]] const Hand& hand() const { return hand_; }
  [[nodiscard]] Index size() const override { return count() + hand_.size(); }
  [[nodiscard]] Point3 at(Index i) const override;
  [[nodiscard]] std::string name_of(Index i) const override;
  [[nodiscard]] std::vector<std::vector<Index>> things() const override;
  /// The points, and the rows of what is set by hand.
  [[nodiscard]] Rows rows() const override;
  /// rows: if there are none of the points, or none of the hand, those stay as they are.
  Done set_rows(const Rows& rows) override;
  Done move(Index i, const Point3& to) override;
  /// Deletes a point, or a direction of a k-DOP that is set by hand.
  Done remove(Index i) override;
  /// What points have, and the number of a k-DOP's "axes" that are set by hand.
  [[nodiscard]] std::vector<Drive> drives() const override;
  Done drive(std::string_view name, double from, double to) override;
  Done load(const io::PointFile& file, std::string_view name) override;
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) override;
  void scatter(std::uint64_t seed, const Subject& own) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;

  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  [[nodiscard]] std::vector<Rival> rivals(const Lesson& lesson, const View& view) const override;
  [[nodiscard]] std::optional<double> result_size(const Method& method, bool by_measure,
                                                  const View& view) const override;
  [[nodiscard]] std::int64_t operations(const Method& method) const override;
  Done set_float(bool in_float) override { return round_to_float(in_float); }
  [[nodiscard]] bool reaches(std::string_view goal) const override;
  [[nodiscard]] std::string goal_says(std::string_view goal) const override;

  /// The recording of the lesson's reference, or else of the smallest volume of the lesson's kind: computed when first
  /// needed after an edit, unless the view shows it. Null if there is no such algorithm or it cannot take these points.
  /// reference is cheaper if only the size is needed.
  [[nodiscard]] const fit::Recording* optimum(const View& view) const;
  [[nodiscard]] Reference reference(const View& view) const;
  /// Whether the lesson offers a naive method: then containment is judged exactly, and the certificate has its numbers.
  [[nodiscard]] bool offers_naive() const { return has_naive_; }
  /// What sizes are compared with; null for nothing.
  [[nodiscard]] const Method* compared_with() const;

 protected:
  [[nodiscard]] Abilities abilities() override { return {.points = this, .scalar = this, .goals = this}; }
  void points_changed() override {
    worked_ = {};
    hand_.follow(*points());
  }

 private:
  struct Worked {
    std::shared_ptr<const fit::Recording> optimum;
    std::optional<double> size;  // of the reference
  };
  [[nodiscard]] Done begun(Done done);
  [[nodiscard]] fit::Recording record(const Method& method, fit::Recording room) const;
  [[nodiscard]] fit::Volume3 fitted(const Method& method) const;
  [[nodiscard]] double size_of(const Method& method, const View& view) const;
  [[nodiscard]] double size_of(const fit::Volume3& volume) const;
  /// How many tests of a naive algorithm were wrong so far, and which was the first.
  static void add_wrong_tests(std::vector<Figure>& figures, const View& view);

  const Method* reference_ = nullptr;  // null for none
  bool by_measure_ = false;
  bool has_naive_ = false;
  bool is_tested_ = false;  // whether the overlap test of its volumes is counted
  Hand hand_;
  mutable Worked worked_;  // computed on demand, and forgotten with the next edit
};

/// A slot's recording, if the subject's methods fit volumes; null otherwise, or if the slot is empty.
[[nodiscard]] const fit::Recording* recording_of(const Session& session, int slot);

/// The catalogue's algorithms of a volume, and the methods by hand.
[[nodiscard]] std::span<const Method> fit_methods(std::string_view volume);

// figures.cpp, proofs.cpp
[[nodiscard]] std::vector<Figure> fit_figures(const View& view, const FitRun& run, const Reference& reference);
[[nodiscard]] std::vector<Proof> fit_proofs(const View& view, const FitRun& run);
}  // namespace snug::lesson
