#include "app/subjects/cloud/view.hpp"

#include "app/subjects/cloud/call_panel.hpp"
#include "app/subjects/cloud/draw.hpp"
#include "lesson/words.hpp"

namespace snug::app {
namespace {

class CloudView final : public SubjectView {
 public:
  void refresh(const lesson::Session& session, bool want_optimum) override {
    shown_ = cloud_shown_at(session, want_optimum);
  }
  [[nodiscard]] const Shown& shown() const override { return shown_; }
  void draw(Brush& brush) const override { draw_cloud(brush, shown_); }
  void draw_marks(Brush& brush) const override { mark_cloud(brush, shown_); }
  void name_marks(PointNames& names) const override { name_cloud(names, shown_); }
  [[nodiscard]] bool offers_optimum() const override { return true; }

  float draw_panels(const Look& look, lesson::Session& session, ImVec2 at, float width) const override {
    return draw_call_panel(look, session, at, width);
  }
  [[nodiscard]] MarkWords mark_words(const lesson::Session& session) const override {
    MarkWords words;
    if (session.method(0)->volume == "sphere") words.grew = lesson::ball_word(session.dim()) + std::string(" grew");
    return words;
  }

 private:
  CloudShown shown_;
};

}  // namespace

std::unique_ptr<SubjectView> cloud_view() { return std::make_unique<CloudView>(); }

}  // namespace snug::app
