// What the app holds, for app.cpp and the commands.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/app.hpp"
#include "app/cover.hpp"
#include "app/look.hpp"
#include "app/stage.hpp"
#include "app/subjects.hpp"
#include "lesson/invitations.hpp"
#include "lesson/kept_answers.hpp"

namespace snug::app {

inline constexpr int kSettleFrames = 2;  // ImGui answers an input over this many frames

struct AppState {
  Platform platform;
  Settings settings, drawn_settings;
  std::array<std::string, 4> font_bytes;  // ImGui reads glyphs from them on demand
  Look look;
  std::optional<lesson::Session> session;
  std::uint64_t opened = 0;                            // how many sessions were
  std::optional<lesson::Sitting> sitting;              // at the exercise that is open
  std::map<std::string, lesson::KeptAnswers> answers;  // those of lessons that were left, by id
  const SubjectRow* subject = nullptr;                 // the session's subject, and its view
  std::unique_ptr<SubjectView> view;
  std::unique_ptr<Cover> cover;
  Stage stage;
  StageGl gl;
  lesson::Invitations invitations;
  std::optional<Invitation> invitation;
  std::string invited_handle;  // which one is to be dragged
  Rect step_button, play_button;
  bool playing = false;
  float speed = 1;
  double next_step_at = 0;
  double watched_pause = 0;  // seconds per step while the way to an outcome is played; 0: none is played
  double watched_until = 0;  // when that ends, even if not all steps were shown
  bool press_ends = false;   // the press that ended it does nothing else
  double now = 0;
  std::uint64_t drawn_revision = 0;
  int drawn_cover = 0, drawn_percent = 0;
  int settle = kSettleFrames;
  bool to_top = false;  // another lesson's numbers begin at their top
  long frames = 0;
  float figures_height = 0;

  void load_fonts();
  void refresh_look(bool fingers);
  void open(lesson::Session next, bool anew);
  /// Forgets the answers; what was measured would give them away.
  void forget();

  /// Seconds per step while playing at speed 1: of frames the time that one simulates. watched: the least time per step
  /// while the steps up to an outcome are played, in which a frame would be too short to see; otherwise 0.
  [[nodiscard]] double seconds_of_step(double watched) const;
  /// Seconds from one playing step to the next.
  [[nodiscard]] double pause() const;
  /// Takes the steps that are due.
  void play_on();
  /// After an answer: plays the skipped steps, fast enough to show all of them in time. With reduced motion, they are
  /// played only on request.
  void watch();
  void end_watching();

  [[nodiscard]] bool covered() const { return cover != nullptr && cover->shown(); }
  [[nodiscard]] int percent() const { return cover != nullptr ? static_cast<int>(100 * cover->progress()) : 0; }
  /// Starts what decides the predictions about the cover, once all of them are given and one waits for it.
  void decide_by_measuring();
  /// Draws the stage or its cover, and the button that switches between them.
  void draw_stage(const Rect& rect);
  void invite(const Rect& rect);
  /// The rightmost, and the same one as long as it is there.
  [[nodiscard]] std::optional<Rect> handle_to_drag(const Rect& rect);
};

}  // namespace snug::app
