// Which volume when, in the stage's place: small pictures of all volumes around the points, and the tables of their
// criteria, which are measured in slices between frames.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cover.hpp"
#include "app/subjects/criteria/small_pictures.hpp"
#include "lesson/subjects/criteria/criteria_words.hpp"
#include "measure/criteria_run.hpp"
#include "measure/report.hpp"

namespace snug::app {

class CriteriaBoard final : public Cover {
 public:
  explicit CriteriaBoard(const Platform& platform);

  [[nodiscard]] bool shown() const override { return shown_; }
  void show(bool on) override { shown_ = on, ++version_; }
  [[nodiscard]] CoverButton button() const override {
    return {"toggle_pictures", shown_ ? "One volume" : "All volumes"};
  }
  void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) override;
  [[nodiscard]] std::string caption(const lesson::Session& session) const override;
  /// The pictures, named by algorithm.
  [[nodiscard]] std::vector<Handle> handles() const override { return handles_; }

  /// Names: measure stop_measuring toggle_pictures next_volume previous_volume show_criteria show_total show_ranks
  /// show_other orbit_left orbit_right orbit_up orbit_down; sort:COLUMN, which sorts the table, or if it was sorted by
  /// that column, restores the lesson's order; pick:VOLUME. Returns false if the command is impossible now.
  bool command(lesson::Session& session, std::string_view name) override;
  [[nodiscard]] std::string_view command_of_key(std::string_view key) const override;
  [[nodiscard]] std::vector<CoverButton> choices(const lesson::Session& session) const override;
  [[nodiscard]] std::array<CoverButton, 2> work_buttons(const lesson::Session& session) const override;
  [[nodiscard]] std::string status(const lesson::Session& session) const override;
  /// Everyone sees it once the questions are answered and the volumes measured.
  [[nodiscard]] WordTable table(const lesson::Session& session) const override;
  [[nodiscard]] bool decided(const lesson::Session& session) const override;
  /// The formats of `snug which`.
  [[nodiscard]] std::span<const std::string_view> formats() const override;
  [[nodiscard]] std::string file_name() const override { return "snug-criteria"; }
  [[nodiscard]] std::string file(std::string_view format) const override;
  /// Errors: every table, because it compares none.
  std::optional<tl::expected<void, InputError>> lay_over(lesson::Session& session, std::string_view text,
                                                         std::string_view name) override;

  /// Takes a sample of a large file, so that every volume can be fitted between two frames.
  tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file,
                                      std::string_view name) override;
  void work(lesson::Session& session, double budget) override;
  [[nodiscard]] bool running() const override { return run_ != nullptr; }
  [[nodiscard]] double progress() const override { return run_ != nullptr ? run_->progress() : 1; }
  [[nodiscard]] int version() const override { return version_; }

 private:
  void start(const lesson::Session& session);
  void finish(lesson::Session& session);
  bool pick(lesson::Session& session, std::size_t volume);
  bool pick_next(lesson::Session& session, int by);
  bool sort_by(std::string_view column);
  [[nodiscard]] std::vector<SmallPicture> pictures(const lesson::Session& session) const;

  cost::Clock clock_;
  cost::Provenance here_;
  cost::CostOptions options_;
  std::unique_ptr<lesson::Subject> measured_;  // what is measured, as it stood when that began
  std::unique_ptr<cost::CriteriaRun> run_;
  cost::Provenance provenance_;          // of the last measurement,
  std::vector<cost::CriteriaRow> rows_;  // its figures
  lesson::Load load_;                    // and the load as the sliders stood when it was last shown
  lesson::CriteriaTableKind kind_ = lesson::CriteriaTableKind::kCriteria;
  std::array<int, 3> sorted_{-1, -1, -1};  // by which column each table is sorted; -1: in the lesson's order
  Gaze gaze_;
  std::vector<Handle> handles_;
  bool shown_ = true;
  int version_ = 0;
};

[[nodiscard]] std::unique_ptr<Cover> criteria_cover(const Platform& platform);

}  // namespace snug::app
