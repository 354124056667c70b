// Bodies that move, and the effects that a scene calls for.
#pragma once

#include "lesson/facts.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/session.hpp"
#include "lesson/subjects/scene/read_scene.hpp"
#include "lesson/subjects/scene/scene_run.hpp"

namespace snug::lesson {

extern const SubjectRow kSceneRow;

class SceneSubject;

/// Its frames are recorded when something of them is asked for. What is the same of every frame records none.
class SceneRun final : public FactRun<SceneRun, FrameStep> {
 public:
  SceneRun(const SceneSubject& subject, SceneRecorder recorder) : subject_(subject), recorder_(std::move(recorder)) {}
  [[nodiscard]] int steps() const override { return recorder_.frames(); }
  [[nodiscard]] std::string_view fact(int) const override { return FrameTaken::kName; }
  [[nodiscard]] std::span<const QuestionKind> question_kinds(int) const override;
  [[nodiscard]] std::optional<Mark::Kind> mark(int) const override { return std::nullopt; }
  [[nodiscard]] bool counts(int) const override { return true; }
  [[nodiscard]] std::span<const Recorder<FrameStep>::Entry> trace() const { return recording(steps()).steps; }
  [[nodiscard]] const Recorder<FrameStep>::Entry& entry(int i) const { return recording(i + 1).steps[i]; }
  /// The recording, up to this frame at least.
  [[nodiscard]] const SceneRecording& recording(int frame) const { return recorder_.up_to(frame); }
  [[nodiscard]] const SceneRecording& recording() const { return recording(steps()); }
  [[nodiscard]] int recorded() const { return recorder_.recorded(); }
  [[nodiscard]] const SceneSubject& subject() const { return subject_; }
  struct Where {
    const SceneRun& run;
    int i;
    const Untold* untold;
    [[nodiscard]] const FrameStep& step() const { return run.entry(i).step; }
    [[nodiscard]] const SceneSubject& subject() const { return run.subject_; }
    [[nodiscard]] bool hides(std::string_view figure) const { return untold != nullptr && untold->hides(figure); }
  };

 private:
  const SceneSubject& subject_;
  mutable SceneRecorder recorder_;  // of all frames the same bits, whenever they are recorded
};

extern template class FactRun<SceneRun, FrameStep>;

[[nodiscard]] inline const SceneRun& scene_run(const Run& run) { return static_cast<const SceneRun&>(run); }

class SceneSubject final : public PointSubject, public HasParts, public HasFrames, public HasText {
 public:
  static constexpr const SubjectRow& kRow = kSceneRow;
  SceneSubject(const Lesson& lesson, AnyPointSet points, std::optional<io::PointFile> mesh, Clock clock);

  [[nodiscard]] const SubjectRow& row() const override { return kRow; }
  [[nodiscard]] std::unique_ptr<Subject> clone() const override { return std::make_unique<SceneSubject>(*this); }
  [[nodiscard]] std::array<std::string_view, 2> handle_words() const override {
    return set().at_points() ? std::array<std::string_view, 2>{"body", "bodies"} : PointSubject::handle_words();
  }
  [[nodiscard]] std::string_view stage_says() const override {
    return set().at_points() ? "bodies that move, and their volumes" : "a body that moves, and the volume around it";
  }
  [[nodiscard]] Tools tools() const override {
    return set().at_points() ? Tools{"Bodies", "Bodies", true} : PointSubject::tools();
  }
  [[nodiscard]] double seconds_of_frame() const override { return set().step; }
  [[nodiscard]] std::string_view fixed_now() const override;
  [[nodiscard]] std::unique_ptr<Run> run(const Method& method, std::unique_ptr<Run> earlier) const override;
  [[nodiscard]] std::string opening(const Method& method) const override;
  [[nodiscard]] std::vector<Figure> figures(const View& view) const override;
  [[nodiscard]] std::vector<Proof> proofs(const View& view) const override;
  [[nodiscard]] std::vector<Figure> figures_at_end(const Method& method, const View& view) const override;
  [[nodiscard]] std::vector<Figure> results(const Method& method, const View& view) const override;
  [[nodiscard]] std::vector<Switch> switches(const View& view) const override;
  bool turn(std::string_view name, bool on, const View& view) override;
  [[nodiscard]] bool is_disturbed() const override { return !off_.empty() || !pushed_.empty(); }
  /// The declaration's effects, if the lesson is about them. They are part of rows(): where they differ from the
  /// lesson's own, the last row has a 1 for each that is called for, in the order of the file.
  Done call_for(std::string_view name, bool called) override;
  [[nodiscard]] Rows rows() const override;
  Done set_rows(const Rows& rows) override;
  [[nodiscard]] StageFile file() const override;
  Done set_file(std::string text) override;
  void begin_task(const Lesson& lesson, const Task& task, const Subject& own) override;
  [[nodiscard]] Grade grade(const Lesson& lesson, const Task& task, const View& view) const override;
  /// Lets the body at a point hop.
  bool push(Index i, const View& view) override;
  Done move(Index i, const Point3& to) override;
  Done add(const Point3& at) override;
  Done load(const io::PointFile& file, std::string_view name) override;
  Done set_generator(std::string_view kind, int count, int dim, std::uint64_t seed, const Subject& own) override;

  [[nodiscard]] const SceneSet& set() const { return *set_; }
  /// Why the scene as it stands cannot run, as a sentence; empty if it can.
  [[nodiscard]] std::string refusal_now(std::string_view method) const;
  /// The step after which an effect was switched off; -1 if it is on, or was on in the given step.
  [[nodiscard]] int off_since(std::string_view effect, int step) const;

 protected:
  /// Where the effects are what the lesson is about, its scene is a text, which the student edits.
  [[nodiscard]] Abilities abilities() override {
    HasText* const text = set().graph && !set().text.empty() ? this : nullptr;
    return {.points = this, .parts = this, .frames = this, .text = text};
  }

 private:
  [[nodiscard]] std::string time_of(const scene::EffectTally& tally) const;
  void points_changed() override { pushed_.clear(); }
  [[nodiscard]] Done is_sound() const;
  /// Whether it differs from the lesson's own only in the effects that are called for.
  [[nodiscard]] bool is_switched() const;
  [[nodiscard]] std::vector<FileError> mistakes_of(const SceneSet& next) const;

  /// What was typed last, if it has mistakes.
  struct TypedText {
    std::string text;
    std::vector<FileError> mistakes;
  };
  std::shared_ptr<const SceneSet> set_, own_set_;  // with the effects that it calls for now, and as the lesson has it
  std::optional<TypedText> typed_;
  std::vector<std::string> methods_;  // that the lesson offers
  Clock clock_;
  double clock_step_ = 0;  // ns
  std::vector<SwitchedOff> off_;
  std::vector<Pushed> pushed_;
  mutable std::string refused_;  // why the last run stands still; empty if it runs
};

/// The recording of a slot's run, in a lesson about a scene; null otherwise. Its current frame is step_of(slot), up to
/// which it goes while something is dragged; else it has all frames.
[[nodiscard]] const SceneRecording* recorded_scene(const Session& session, int slot);
/// The current frame of slot 0, valid until another is requested; null if there is none.
[[nodiscard]] const SceneFrame* frame_of(const Session& session);
// The scene of a lesson about a scene.
[[nodiscard]] inline const SceneSet& set_of(const Session& session) {
  return static_cast<const SceneSubject&>(session.stage().subject()).set();
}
[[nodiscard]] inline std::span<const scene::Member> members_of(const Session& session) {
  return scene_run(session.player().run(0)).recording(0).members;
}

}  // namespace snug::lesson
