// The lectures' claims as charts on the stage: tried in slices between frames, each a chart of its own; a cloud on
// which one does not hold is put on the stage.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/chart.hpp"
#include "app/cover.hpp"
#include "measure/report.hpp"
#include "measure/trials.hpp"

namespace snug::app {

class ClaimsCover final : public Cover {
 public:
  explicit ClaimsCover(const Platform& platform);

  [[nodiscard]] bool shown() const override { return shown_; }
  void show(bool on) override { shown_ = on, ++version_; }
  [[nodiscard]] CoverButton button() const override { return {"toggle_chart", shown_ ? "Shape" : "Chart"}; }
  void draw(const Look& look, lesson::Session& session, const Rect& rect, bool with_sentence) override;
  [[nodiscard]] std::string caption(const lesson::Session& session) const override;
  /// The last mark of each line, named by its kind.
  [[nodiscard]] std::vector<Handle> handles() const override;

  /// Names: measure stop_measuring toggle_chart chart_next chart_previous chart_up chart_down chart_load show_other,
  /// and "show_" with a claim's name.
  bool command(lesson::Session& session, std::string_view name) override;
  [[nodiscard]] std::string_view command_of_key(std::string_view key) const override;
  [[nodiscard]] std::vector<CoverButton> choices(const lesson::Session& session) const override;
  [[nodiscard]] std::array<CoverButton, 2> work_buttons(const lesson::Session& session) const override;
  [[nodiscard]] std::string status(const lesson::Session& session) const override;
  [[nodiscard]] WordTable table(const lesson::Session& session) const override;
  [[nodiscard]] bool decided(const lesson::Session& session) const override;
  [[nodiscard]] std::span<const std::string_view> formats() const override;
  [[nodiscard]] std::string file_name() const override;
  /// The clouds of all claims.
  [[nodiscard]] std::string file(std::string_view format) const override;
  [[nodiscard]] const Chart* picture() const override { return &chart_; }
  std::optional<tl::expected<void, InputError>> lay_over(lesson::Session&, std::string_view,
                                                         std::string_view) override {
    return std::nullopt;  // trials are the same everywhere
  }
  tl::expected<void, InputError> load(lesson::Session& session, const io::PointFile& file,
                                      std::string_view name) override;
  void work(lesson::Session& session, double budget) override;
  [[nodiscard]] bool running() const override { return run_ != nullptr; }
  [[nodiscard]] double progress() const override { return run_ != nullptr ? run_->progress() : 1; }
  [[nodiscard]] int version() const override { return version_; }

  /// The claim whose chart is shown.
  [[nodiscard]] const cost::Claim& claim() const { return *claim_; }

 private:
  void look_at(const cost::Claim& claim);
  /// Turns to the claim of the question that is asked or whose outcome is told, once for each.
  void follow(const lesson::Session& session);
  void take_rows();
  void finish(lesson::Session& session);
  void move_focus(int line, int point);
  /// The cloud that has the focus; null for none.
  [[nodiscard]] const cost::TrialRow* focused() const;
  [[nodiscard]] bool put_on_stage(lesson::Session& session);

  cost::Clock clock_;
  cost::Provenance here_;
  std::unique_ptr<cost::TrialRun> run_;
  std::vector<cost::TrialRow> rows_;
  const cost::Claim* claim_ = cost::tried_claims().front();
  std::string followed_;  // the question that it last turned to
  Chart chart_;
  std::vector<ChartPlace> places_;  // where the chart's series were drawn
  std::optional<ChartHit> focus_;
  bool shown_ = true;
  int version_ = 0;
};

[[nodiscard]] std::unique_ptr<Cover> claims_cover(const Platform& platform);

}  // namespace snug::app
