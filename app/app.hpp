// The front end that both doors share: a lesson on a stage, its timeline and its inspector.
// A door (the page or the window) provides a GL context, an ImGui context with input, fonts, and rectangles to draw in.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "lesson/exercise/sitting.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/session.hpp"
#include "measure/rows.hpp"

namespace snug::app {

/// A rectangle in pixels of the page (CSS pixels; logical pixels on the desktop), from the top left of the canvas.
struct Rect {
  float x = 0, y = 0, width = 0, height = 0;
};

/// Where the parts are. An empty rectangle leaves its part out (a phone shows the inspector on a separate tab).
struct Layout {
  Rect stage;
  Rect timeline;
  Rect inspector;
  bool fingers = false;  // large targets: 44 px
  float tools = 0;       // how far the door's own buttons reach from the stage's left edge, in its top corner
  float foot = 0;        // how much of the stage's foot a question covers: the stage frames itself above
};

enum class Theme { kLight, kDark, kHighContrast, kProjector };

struct Settings {
  Theme theme = Theme::kLight;
  float text_scale = 1;   // 1 is 15 px prose
  float least_words = 0;  // no words are lower, page pixels: the last row of a hall reads them
  bool reduced_motion = false;
  bool prose_in_canvas = false;  // the step's sentence on the stage; the page has it as HTML above the canvas instead
  bool tools = true;             // whether the stage has its buttons; a picture of it has none
  bool show_optimum = false;     // whether the smallest volume is shown before the end; at the end it always is
  bool labels = true;            // whether the stage has its names and measures; a picture of it may do without
  bool ground = true;            // whether it has a ground; a picture of it may be transparent
};

/// What differs between the doors.
struct Platform {
  /// The bytes of a font: "Inter-Regular", "Inter-SemiBold", "JetBrainsMono-Regular", "JetBrainsMono-Bold".
  std::string (*font)(std::string_view name) = nullptr;
  /// The first line of each shader: "#version 330 core" or "#version 300 es".
  const char* glsl_version = "#version 330 core";
  /// Nanoseconds since some moment, never going back: it times costs and the effects of scenes. Null: nothing is timed.
  double (*clock)() = nullptr;
  /// How long one run may take on the growth chart, ns: a page must not delay a frame, a window may for a moment.
  double longest_run = 12e6;
  /// Whether an edit that takes long goes in pieces, which the door goes on with between frames (Stage::go_on).
  bool gives_way = false;
  /// Describes this program and machine for measurements; what was measured and the clock's step are added here.
  cost::Provenance here;
};

/// A draggable handle, at its place on the canvas.
struct Handle {
  std::string id;  // "P0", "P1" …; in 3-D only those in front of the camera
  float x = 0, y = 0;
};

/// The close-up on the stage.
struct CloseUp {
  Vector<double, 3> at;  // what is in its middle
  double size = 0;       // how wide the part of the scene is that it shows, scene units
  double times = 1;      // how many times larger than on the stage
  Rect panel;            // its place on the canvas
  float x = 0, y = 0;    // that of what it shows
};

/// What one who is new is asked to do next, beside what it speaks of.
struct Invitation {
  std::string words;
  Rect at;
};

struct AppState;
struct Look;
struct DrawnWords;
struct GlScene;
class Cover;
struct PanelWords;

class App {
 public:
  /// Needs a current ImGui context; no GL yet.
  explicit App(const Platform& platform);
  ~App();
  App(const App&) = delete;
  App& operator=(const App&) = delete;

  /// Creates the GL objects; again after a lost context. Returns false if the shaders did not build (see
  /// graphics_error).
  bool create_graphics();
  /// Forgets the GL objects of a lost context.
  void abandon_graphics();
  [[nodiscard]] const std::string& graphics_error() const;

  /// Opens a lesson at its start, with the answers given when it was open before. Errors: those of Session::open; the
  /// lesson that was open then stays. anew: it is the one that is open, read anew; the view of the stage stays.
  tl::expected<void, InputError> open(lesson::Lesson lesson, std::optional<io::PointFile> mesh = {}, bool anew = false);
  /// Opens the instance of a seed of an exercise, with nothing decided. Errors: those of make_instance; what was open
  /// then stays.
  /// practises: without a mark.
  tl::expected<void, InputError> open_exercise(std::shared_ptr<const lesson::Exercise> exercise, std::uint64_t seed,
                                               bool practises = false);
  /// The exercise that is open; null while a lesson is.
  [[nodiscard]] lesson::Sitting* sitting();
  [[nodiscard]] const lesson::Sitting* sitting() const;
  /// Keeps the answers of an earlier visit for when the lesson is opened; and forgets all answers of all lessons.
  void keep_answers(const std::string& lesson, lesson::KeptAnswers answers);
  void forget_answers();
  /// Loads a file's points into the open lesson. Errors: those of Stage::load and of the cover.
  tl::expected<void, InputError> load(const io::PointFile& file, std::string_view name);
  /// The name of the open lesson's subject, as in app/subjects; "" before the first open.
  [[nodiscard]] std::string_view subject() const;
  /// From where a hand has made the stage be seen, rounded: in the plane the height in view and the middle; in space
  /// yaw and pitch in degrees, the height, and the place that it turns around. Empty while it is framed by itself.
  [[nodiscard]] std::vector<double> hand_view() const;
  /// Looks from there. Returns false if that is no view of this stage.
  bool look_from(const std::vector<double>& view);
  /// What can replace the stage; null if nothing can.
  [[nodiscard]] Cover* cover();
  /// Does a slice of the cover's work, for a door to call between frames. budget: ns.
  void measure(double budget);
  /// Null before the first open.
  [[nodiscard]] lesson::Session* session();
  /// Which session is open, counted from 1, and its revision: whatever it tells changes with them.
  struct SessionRevision {
    std::uint64_t session = 0, revision = 0;
    bool operator==(const SessionRevision&) const = default;
  };
  [[nodiscard]] SessionRevision session_revision() const;

  [[nodiscard]] Settings& settings();
  /// The fonts and palette of the last frame, for a door that draws more (app/look.hpp).
  [[nodiscard]] const Look& look() const;

  /// While the way to an outcome is played, any press ends that and does nothing else: a click and a command see to it
  /// themselves, a door's keys by this. Returns false if none is played.
  bool end_playing();
  /// Runs the command of a button or key: one of the cover's or of the panels' buttons, or one of app/commands. Returns
  /// false if the name is unknown or the command impossible now (undo with nothing to undo).
  bool command(std::string_view name);
  /// Chooses an answer to the open question by its number, as Conversation::pick does. Where the last prediction about
  /// a cover was given, by this or by a command, measuring begins: it is what decides it.
  bool pick_choice(int choice);
  /// The command of a key, as the browser names keys ("ArrowRight", "PageDown", " ", "Home", "z"); empty for none.
  /// Arrow keys move the selected point if it was selected by a key, by select() or by a click without a drag.
  /// Otherwise, as after a drag or an answer, they step.
  [[nodiscard]] std::string_view command_of_key(std::string_view key, bool shift, bool control) const;

  /// The selected point, kNoIndex for none.
  [[nodiscard]] Index selected() const;
  void select(Index point);
  /// Lights a mark that the prose links to (lesson/speaking.hpp), "" for none; and the marks that the handle under the
  /// pointer belongs to, whose words the door lights.
  void light(std::string_view mark);
  [[nodiscard]] std::string_view lit() const;
  [[nodiscard]] std::vector<std::string_view> marks_in_hand() const;
  /// Invites on the stage of the lesson that was just opened (lesson/invitations.hpp). followed: as many were before.
  void invite(int followed);
  /// How many were followed by now.
  [[nodiscard]] int invitations_followed() const;
  /// The one that is due, as of the last frame.
  [[nodiscard]] const std::optional<Invitation>& invitation() const;
  /// The height of the stage that its buttons, its sentence and a card left free in the last frame, pixels.
  [[nodiscard]] float free_height() const;
  /// The height of the step's own figures and panels in the last frame, in pixels; 0 if they were not drawn.
  [[nodiscard]] float figures_height() const;
  /// Whether they may need the inspector's whole column.
  [[nodiscard]] bool figures_fill() const;
  [[nodiscard]] bool playing() const;
  [[nodiscard]] float speed() const;  // steps a second are 2 * speed; for a scene, its frames a second * speed

  /// Two fingers on the stage: factor > 1 as they part, around their middle (canvas coordinates), which moved by
  /// (dx, dy) since the last call.
  void pinch(float factor, float x, float y, float dx = 0, float dy = 0);

  /// Draws into the rectangles and answers ImGui's input; call between ImGui::NewFrame and ImGui::Render, then
  /// draw_3d_behind with the framebuffer bound, then ImGui's own drawing. now: seconds, rising.
  void frame(const Layout& layout, double now);
  /// Takes the steps that are due while playing.
  void advance(double now);
  /// The same, and goes on with what the panels measure: frame without drawing, for a door that cannot draw.
  void advance_unseen(double now);
  /// The time until that is due again, in seconds: 0 while something is measured; infinity if nothing plays either.
  [[nodiscard]] double seconds_until_unseen(double now) const;
  /// Draws the GL part of the stage, beneath ImGui's. The door first clears colour (to that of the panels) and depth.
  /// The framebuffer's size is in device pixels; scale: device pixels per page pixel.
  void draw_3d_behind(int framebuffer_width, int framebuffer_height, float scale);
  /// Whether another frame is due without any input: something moves, plays, or the session changed since the last.
  [[nodiscard]] bool wants_frame(double now) const;
  /// For a door that sleeps between frames: 0 if one is due now, the seconds until the next playing step, or infinity
  /// if nothing changes without input.
  [[nodiscard]] double seconds_until_due(double now) const;
  /// Records each frame's words there from now on, until called with null: for tests of where words are drawn. apart:
  /// they are not drawn, for a picture that has them as text.
  void note_words(std::vector<DrawnWords>* drawn, bool apart = false);
  /// How many frames were drawn.
  [[nodiscard]] long frames_drawn() const;

  /// The sentence of the step, for both doors; "" before a lesson is open.
  [[nodiscard]] std::string caption() const;
  [[nodiscard]] std::vector<Handle> handles() const;
  /// Where a handle of that name is on the stage, whether or not it can be dragged; none if there is none in view.
  [[nodiscard]] std::optional<Handle> place_named(std::string_view name) const;
  /// What OpenGL draws of the last frame, as plain data; null while the stage is covered.
  [[nodiscard]] const GlScene* scene() const;
  /// What the panels beside the stage tell beyond the figures; none while the stage is covered.
  [[nodiscard]] std::vector<PanelWords> panel_words() const;
  /// The lesson's close-up, as of the last frame; none if there is none on the stage.
  [[nodiscard]] std::optional<CloseUp> close_up() const;

 private:
  [[nodiscard]] double seconds_until_step(double now) const;
  std::unique_ptr<AppState> state_;
};

}  // namespace snug::app
