// The front end that both doors share: a lesson on a stage, its timeline and its inspector.
// A door gives it a GL context, an ImGui context that it feeds with input, fonts, and rectangles to draw in.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/session.hpp"
#include "measure/rows.hpp"

namespace snug::app {

/// A rectangle in pixels of the page (CSS pixels; logical pixels on the desktop), from the top left of the canvas.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;
};

/// Where things stand. An empty rectangle leaves its part out (a phone shows the inspector on a tab of its own).
struct Layout {
  Rect stage;
  Rect timeline;
  Rect inspector;
  bool fingers = false;  // large targets: 44 px
  float tools = 0;       // how far the door's own buttons reach from the stage's left edge, in its top corner
  float foot = 0;        // how much of the stage's foot the door covers with a question: the stage frames itself above
};

enum class Theme { kLight, kDark, kHighContrast, kProjector };

struct Settings {
  Theme theme = Theme::kLight;
  float text_scale = 1;  // 1 is 15 px prose
  bool reduced_motion = false;
  bool prose_in_canvas = false;  // the step's sentence on the stage; the page has it as HTML above the canvas instead
  bool tools = true;             // the stage's own buttons; a picture of the stage has none
  bool show_optimum = false;     // the smallest ball beside the current one before the end; there it always shows
};

/// What differs between the doors.
struct Platform {
  /// The bytes of a font: "Inter-Regular", "Inter-SemiBold", "JetBrainsMono-Regular", "JetBrainsMono-Bold".
  std::string (*font)(std::string_view name) = nullptr;
  /// The first line of each shader: "#version 330 core" or "#version 300 es".
  const char* glsl_version = "#version 330 core";
  /// Nanoseconds since some moment, only forward: costs and the effects of scenes are timed by it. Null: nothing is.
  double (*clock)() = nullptr;
  /// How long one run may take where growth is followed, ns: a page keeps no frame waiting, a window does for a moment.
  double longest_run = 12e6;
  /// What is told of this program and machine with what was measured; what of, and the clock's step, are found here.
  cost::Provenance here;
};

/// A draggable thing, at its place on the canvas.
struct Handle {
  std::string id;  // "P0", "P1" …; in 3-D only those in front of the camera
  float x = 0, y = 0;
};

struct Look;
struct DrawnWords;
class Cover;

class App {
 public:
  /// Needs a current ImGui context; no GL yet.
  explicit App(const Platform& platform);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Makes what lives in the GL context; again after a lost context. false: the shaders did not build (see
  /// graphics_error).
  bool create_graphics();
  /// Forgets GL objects of a context that is lost.
  void abandon_graphics();
  [[nodiscard]] const std::string& graphics_error() const;

  /// Opens a lesson at its start, with the answers that were given when it was open before. Errors: as of
  /// Session::open; what was open then stays.
  tl::expected<void, InputError> open(lesson::Lesson lesson, std::optional<io::PointFile> mesh = {});
  /// The answers of an earlier visit to a lesson, for when it is opened; and all answers, of every lesson, away.
  void keep_answers(const std::string& lesson, std::vector<lesson::Outcome> outcomes);
  void forget_answers();
  /// A file's points, in the open lesson. Errors: as of Session::load, and of the cover's.
  tl::expected<void, InputError> load(const io::PointFile& file, std::string_view name);
  /// The name of what the open lesson is about, as app/subjects has it; "" before the first open.
  [[nodiscard]] std::string_view subject() const;
  /// What can stand in the stage's place; null where nothing can.
  [[nodiscard]] Cover* cover();
  /// One slice of what the cover has to do, for a door to call between frames. ns.
  void measure(double budget);
  /// Null before the first open.
  [[nodiscard]] lesson::Session* session();

  [[nodiscard]] Settings& settings();
  /// Fonts and palette as of the last frame, for a door that draws more (app/look.hpp).
  [[nodiscard]] const Look& look() const;

  /// Does what a button or key says. Names: those of the cover, and first back step play last next_mark
  /// previous_mark faster slower undo redo add_point delete_point scatter reset_points reset_view skip_question
  /// commit_answer
  /// select_next select_previous select_none move_left move_right move_up move_down move_nearer move_farther (the
  /// selected point; "_fine" behind it for a tenth), zoom_in zoom_out orbit_left orbit_right orbit_up orbit_down
  /// toggle_optimum watch_outcome continue show_answer close_summary; review:QUESTION, which tells its outcome again;
  /// and turn:EFFECT, which switches an effect of the scene off, and on again. At a question, next_mark and step say
  /// that a second press skips it: a clicker has no other key. Where an outcome is told, they and play and
  /// commit_answer continue. While the way to an outcome is played, any command ends it. watch_outcome goes back to
  /// where the outcome's question was asked and plays on to the outcome; it cannot where nothing lies between. Returns
  /// false where the name is unknown or it cannot be done now (undo with nothing to undo).
  bool command(std::string_view name);
  /// The command of a key, as the browser names keys ("ArrowRight", "PageDown", " ", "Home", "z"); empty for none.
  /// Arrow keys move the selected point where it was selected by a key, by select() or by a click that moved nothing,
  /// and step otherwise: after a drag or an answer they step.
  [[nodiscard]] std::string_view command_of_key(std::string_view key, bool shift, bool control) const;

  /// The selected point, kNoIndex for none.
  [[nodiscard]] Index selected() const;
  void select(Index point);
  /// Lights a mark that the prose links to (lesson/speaking.hpp), "" for none; and the marks of the prose that the
  /// handle under the pointer belongs to, whose words a door lights.
  void light(std::string_view mark);
  [[nodiscard]] std::string_view lit() const;
  [[nodiscard]] std::vector<std::string_view> marks_in_hand() const;
  [[nodiscard]] bool playing() const;
  [[nodiscard]] float speed() const;  // steps a second are 2 * speed, a scene's its own frames a second * speed

  /// Two fingers on the stage: factor > 1 as they part, around their middle (canvas coordinates), which moved by
  /// (dx, dy) since the last call.
  void pinch(float factor, float x, float y, float dx = 0, float dy = 0);

  /// Draws into the rectangles and answers ImGui's input; call between ImGui::NewFrame and ImGui::Render, then
  /// draw_3d_behind with the framebuffer bound, then ImGui's own drawing. now: seconds, rising.
  void frame(const Layout& layout, double now);
  /// Takes the steps that are due while it plays: frame without drawing, for a door that has nothing to draw on.
  void advance(double now);
  /// Until the next playing step, in seconds; infinity where nothing plays.
  [[nodiscard]] double seconds_until_step(double now) const;
  /// The GL part of the stage, beneath ImGui's; the door clears all before, in the panels' colour and with the
  /// depth. Framebuffer size in device pixels, scale: device pixels per page pixel.
  void draw_3d_behind(int framebuffer_width, int framebuffer_height, float scale);
  /// Whether another frame is due without any input: something moves, plays, or the session changed since the last.
  [[nodiscard]] bool wants_frame(double now) const;
  /// For a door that sleeps between frames: 0 when one is due now, the seconds until the next playing step, or infinity
  /// when nothing changes without input.
  [[nodiscard]] double seconds_until_due(double now) const;
  /// From now on each frame's words are noted there, until null is given: for tests of where they stand.
  void note_words(std::vector<DrawnWords>* drawn);
  /// How many frames were drawn.
  [[nodiscard]] long frames_drawn() const;

  /// The sentence of the step, for both doors; "" before a lesson is open.
  [[nodiscard]] std::string caption() const;
  [[nodiscard]] std::vector<Handle> handles() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace snug::app
