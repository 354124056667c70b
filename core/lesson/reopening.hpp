// Where one is in a lesson, kept while its file is read anew: a teacher who saves a lesson stays at the step in view.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/point_file.hpp"
#include "lesson/session.hpp"

namespace snug::lesson {

/// Everything that a session holds, as far as it can be taken over.
class Reopening {
 public:
  explicit Reopening(const Session& session);

  /// Takes the place in a session that was just opened, as far as the lesson still has it. Edits are kept in every
  /// situation, unless the file now has something else there; the algorithm if it is still offered; the step, or the
  /// last one if there are fewer, and the end stays the end. Answers are judged by what the file says now; those to
  /// questions that are gone, or that cannot be answered so any more, are dropped. Does nothing for another lesson.
  void take(Session& session) const;

 private:
  struct Try {
    std::string question;  // its id
    Answer answer;
  };
  /// A situation's stage.
  struct Stage {
    int dim = 2;
    Rows own, rows;               // of the lesson's own stage, and as it was edited; the latter empty if it was not
    bool scattered = false;       // by another seed than the lesson's
    bool recast = false;          // whether it is in another scalar than the lesson's own
    std::vector<double> sliders;  // their values, if any has moved
    Subject::Origin origin;       // of what is on the stage, and
    std::string own_source;       // of the lesson's own
    std::optional<io::PointFile> file;  // the points, if they come from a mesh or a file
    std::optional<StageFile> text;      // from which the stage is made
    [[nodiscard]] bool changed() const {
      return !rows.empty() || scattered || !sliders.empty() || origin.source != own_source || recast;
    }
  };
  [[nodiscard]] static Stage stage_of(const lesson::Stage::Situated& visited, const Lesson& lesson);
  void take_source(Session& session, const Stage& left) const;
  void take_one(Session& session, const Stage& left) const;
  void take_stage(Session& session) const;
  void take_methods(Session& session) const;
  void take_answers(Session& session) const;
  void take_step(Session& session) const;
  void take_try(Session& session) const;

  std::string lesson_;
  std::vector<Stage> stages_;  // of the situations that were shown; that of the stage is the last
  std::size_t task_;           // the one in hand, if the stage is a task's
  std::string algorithm_;
  std::optional<std::string> beside_;  // if it is not the lesson's own choice; "" for none
  int step_ = 0;
  bool at_end_ = false, previewing_ = false;
  std::vector<Outcome> outcomes_;
  std::string told_;          // the question whose outcome is shown
  std::optional<Try> tried_;  // a wrong first answer
};

}  // namespace snug::lesson
