// What the desktop window has besides the app: its lessons, its notices, and the state of its panels.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/app.hpp"
#include "app/focus.hpp"
#include "desktop/cli/drafts.hpp"
#include "desktop/cli/exercise_files.hpp"
#include "desktop/cli/page_address.hpp"
#include "desktop/course_screen.hpp"
#include "desktop/demo_play.hpp"
#include "desktop/file_card.hpp"
#include "desktop/hall.hpp"
#include "desktop/kept.hpp"
#include "desktop/loading.hpp"

namespace snug::desktop {

/// The state of the settings panel while it is open.
struct SettingsPanel {
  bool sure = false;    // whether the next press erases
  bool erased = false;  // whether the answers were just erased
  float height = 200;   // measured in the last frame
};

class Shell {
 public:
  /// kept: what was kept from earlier visits. drafts: where the lessons come from while they are being written; then
  /// `lessons` is not needed.
  Shell(app::App& app, std::vector<LessonFile> lessons, Kept kept, std::optional<Drafts> drafts = {});

  [[nodiscard]] app::App& app() { return app_; }
  [[nodiscard]] const app::App& app() const { return app_; }
  [[nodiscard]] lesson::Session& session() { return *app_.session(); }
  /// The course's lessons in order, then the lab sheets, then the named cases.
  [[nodiscard]] const std::vector<LessonFile>& lessons() const { return lessons_; }
  /// How many of them are the course's.
  [[nodiscard]] std::size_t course_size() const;

  /// The title of the open lesson's chapter.
  [[nodiscard]] std::string chapter() const { return app_.sitting() != nullptr ? "Exercise" : lessons_[open_].chapter; }

  [[nodiscard]] const Kept& kept() const { return kept_; }
  /// What is kept of a lesson; null if it was not begun, or if the file of one's own says something else by now.
  [[nodiscard]] const KeptLesson* kept_lesson(const std::string& id) const { return kept_.lesson(id, hash_of(id)); }

  /// The lesson to start or continue with, and the words for it.
  [[nodiscard]] std::pair<std::size_t, std::string> lead() const;
  /// Opens a lesson at the place where it was left, or at its start.
  void open_at_place(std::size_t lesson);
  /// The same for a lesson by its id.
  void open_at_place(const std::string& id);
  /// The open lesson's place in the course, and the lesson that many places after it; none beyond the ends.
  [[nodiscard]] std::size_t opened() const { return open_; }
  [[nodiscard]] std::optional<std::size_t> beside(int by) const;
  /// Goes to the place where the open lesson was left, if it was.
  void go_to_kept_place();
  void show_course();
  /// The course's playground; none if it has none, or if that is open.
  [[nodiscard]] std::optional<std::size_t> playground() const;
  /// Opens it with what stands on the stage.
  void go_to_playground();
  /// In the playground, the lesson that one came from; none if one came from none.
  [[nodiscard]] std::optional<std::size_t> way_back() const;
  /// Starts or ends a presentation: the projector's theme, larger words, no bar and no text column.
  void present(bool on);
  /// While it presents, makes words as large as the window asks for, and none lower than a fortieth of its height,
  /// which the last row of a hall still reads. Returns whether they were of another size.
  bool fit_words(float width, float height);
  /// Keeps which invitations were followed and, unless it is moving, the open lesson's place.
  void keep(bool dragging = false);
  /// Keeps how the window looks; not while it presents, which changes that for a while.
  /// extent: x, y, width and height in the window system's own units.
  void keep_view(const std::array<int, 4>& extent);
  void erase_answers();

  /// Errors are also shown as the notice. anew: it is the one that is open, read anew.
  tl::expected<void, InputError> open(const std::string& id, bool anew = false);
  /// Replaces the points by one of the program's meshes, by name, or by a point file, by path.
  void use_mesh(const std::string& name);
  void use_file(const std::string& path);
  void use_points(const io::PointFile& points, const std::string& path);
  /// Takes the first of several dropped files; the notice says what became of each.
  void use_dropped(const std::vector<std::string>& paths);

  /// Saves what the cover shows as a new file in the folder that the program was started in; the notice says which
  /// file, or why it failed. format: one of the cover's.
  void save_cover(std::string_view format);
  /// The same for the stage: "png" or "svg".
  void save_stage(std::string_view format);
  /// The address of where one stands, and of the view that a hand has made.
  [[nodiscard]] std::string address() const { return page_address(*app_.session(), app_.hand_view()); }
  /// Adds where one stands to the demo that this window records: a new file, which grows by a state each time.
  void record();
  /// Shows the code of where one stands, to take it along.
  void show_code();

  // ---- exercises (shell_exercises.cpp) ----------------------------------------------------------
  /// Takes the exercises and their sets, which the first screen lists.
  void take_exercises(std::vector<ExerciseFile> exercises, std::vector<lesson::ExerciseSet> sets);
  [[nodiscard]] const std::vector<lesson::ExerciseSet>& sets() const { return sets_; }
  /// Null if there is none of that id.
  [[nodiscard]] const lesson::Exercise* exercise(const std::string& id) const;
  /// Opens an exercise: on the instance of a seed, or else on a fresh one; the attempt that was left goes on.
  /// level: of difficulty. practises: without a mark. resumes: goes on with what was left of it.
  tl::expected<void, InputError> open_exercise(const std::string& id, std::optional<std::uint64_t> seed, int level = 0,
                                               bool practises = false, bool resumes = true);
  /// Opens an exercise with all that an attempt decided, to look at. Nothing of it is kept. Errors: those of
  /// open_exercise; the attempt's decisions are not of its instance.
  tl::expected<void, InputError> watch(const lesson::Attempt& attempt);
  /// Another instance of the exercise that is open: "another"; "harder", at the next level; "other_terms", without a
  /// mark where it was for one, and the other way round.
  void next_instance(std::string_view how);
  /// Opens it as it was left, or on a fresh instance.
  void go_on_with_exercise(const std::string& id);
  /// Saves the attempt as a result file in the folder that the program was started in; the notice says which.
  void hand_in();
  /// The same under a path. Returns whether it was saved; the notice says why not.
  bool hand_in_as(const std::string& path);
  /// "Best 8 of 9 in 3 tries"; empty after one.
  [[nodiscard]] std::string best_says() const;

  // ---- files and the clipboard (shell_files.cpp) -----------------------------------------------
  /// The lesson that points are opened in where none is open.
  [[nodiscard]] std::optional<std::size_t> lesson_for_points() const;
  /// Opens a point file, and remembers it among the recent ones.
  void open_points(const std::string& path);
  void remember(const std::string& path);
  /// Reads a large file in a thread. poll_loading shows what was read once it is there.
  void begin_loading(const std::string& path);
  void poll_loading();
  void cancel_loading() { loading_.reset(); }
  [[nodiscard]] const Loading* loading() const { return loading_.get(); }
  /// Opens a lesson's file in a window of its own.
  void open_lesson_file(const std::string& path);
  /// Writes the points, or the table of the chart, in the format of the path's ending; replaces a file that is there.
  void save_points(const std::string& path);
  void export_table(const std::string& path);
  void copy_points();
  void paste_points();
  /// A new file in the class's folder of results, or else in the folder that the program was started in: stem.csv,
  /// stem-2.csv, stem-3.csv …, the first that does not exist; nothing is overwritten. Empty, with a notice, if there is
  /// no such folder.
  [[nodiscard]] std::string new_file(const std::string& stem, const std::string& extension);
  /// From the lesson to the course, and back.
  void switch_course();
  void next_theme();
  /// Whether the text can be a size larger (1) or smaller (-1), and makes it so.
  [[nodiscard]] bool may_resize(int by) const;
  void resize_text(int by);

  // ---- lab sheets (shell_sheets.cpp) ------------------------------------------------------------
  /// The sheet that is open; null if the lesson is none.
  [[nodiscard]] const lesson::Sheet* sheet() const;
  /// What was done of it.
  [[nodiscard]] SheetWork& sheet_work();
  /// Keeps what was written.
  void sheet_changed();
  /// The student's name, as it goes into results.
  [[nodiscard]] std::string& student() { return kept_.student; }
  /// The table that is shown again: the one that was asked for, or until something is measured the one of these points,
  /// or else the first that there is. Null if there is none, and where it would give a prediction's answer away.
  [[nodiscard]] const MeasuredTable* measured_before();
  /// Shows the table of a part of the sheet.
  void show_measured(const std::string& part) { measured_shown_ = part; }
  /// "2 of 6 parts are missing."; empty if none is.
  [[nodiscard]] std::string sheet_lacks();

  // ---- lessons that are being written (shell_drafts.cpp) ------------------------------------
  [[nodiscard]] bool writing() const { return drafts_.has_value(); }
  /// Reads the files that have changed. If that of the open lesson has, opens it anew at the same place; if it cannot
  /// be drawn now, the lesson stays as it was. Returns whether anything has changed.
  bool look_at_files();
  /// Whether a lesson has never been drawable yet. Then the course is shown until it is, and opens it.
  bool waits_for(const std::string& id);
  /// What is wrong with the file of the lesson that is open or waited for, and with that of the course; empty if
  /// nothing is.
  [[nodiscard]] std::vector<check::DraftText> strip() const;

  bool course_shown = false;  // instead of the lesson
  CourseScreen course;
  SettingsPanel settings_panel;
  bool presenting = false, text_shown = false;  // text_shown: whether a presentation shows the lesson's text
  std::optional<DemoPlay> demo;                 // that is presented; none otherwise
  app::Focus focus;

  /// One sentence that is shown until it is dismissed; empty for none.
  std::string notice;
  std::string
      picture_wanted;  // a file, to which the window draws the cover's chart or the stage after this frame; or empty
  PictureHow picture_how;  // how
  Hall hall;               // what a lecturer points with
  bool keys_shown = false, about_shown = false;
  float keys_scroll = 0;  // how far a key scrolls the card of keys in the next frame
  std::string wish;       // what a menu asks of the window after this frame: "quit", "full_screen", "copy_picture"
  std::string version;    // the program's
  std::string parts;      // of what it is built and runs with: "Dear ImGui 1.92.2b, GLFW 3.3.8 …"
  FileCard file_card;
  bool dialog_open = false;      // whether the system's own dialog asks for what the card would
  float file_card_height = 200;  // measured in the last frame
  ImGuiID first_menu = 0;        // the control of the bar's first menu
  int hint_of = -1;              // the task whose hint is shown; -1 for none
  std::array<char, 96> typed{};  // what is typed to answer a question
  enum class Tab : std::uint8_t { kLesson, kPoints, kFile, kSheet, kSide } tab = Tab::kLesson;  // of the left column
  bool narrow = false;       // whether it has numbers and pseudocode as well, under a tab: two columns leave no stage
  bool asks_beside = false;  // whether it has the question as well: the stage is too small for a card on it
  bool file_typing = false;  // whether the scene's file has the keys
  std::string file_text;     // what is typed as the scene's file
  enum class SideTab : std::uint8_t { kStored, kNumbers, kCode } side_tab = SideTab::kStored;  // of the right column
  std::vector<SideTab> side_tabs;                              // those that there are; none where one thing is enough
  float figures_most = 0;                                      // pixels that the lesson's numbers have wanted at most
  std::vector<std::pair<std::string, app::Rect>> stored_rows;  // the members there: their marks and places
  std::string stored_lit;                                      // the mark of the member that is pointed at there
  std::map<std::string, std::pair<std::string, double>> stored_before;  // each member's numbers, and since when
  int slider = -1;                                        // the one that the keyboard is on, by its number; -1 for none
  std::vector<std::pair<std::size_t, app::Rect>> tracks;  // of the sliders, by their numbers
  bool task_wanted = false;                               // whether to scroll to the task in the next frame
  std::vector<std::pair<std::string, app::Rect>> links;   // the links of the prose: their targets and places
  std::vector<std::string> figures;                       // the figures of the run in it, as they were drawn
  bool unread = false;                                    // another lesson was opened: its prose starts at the top
  float scrolled = 0;                                     // how far the prose was scrolled in the last frame
  int section = -1;                                       // the section that the step was about in the last frame
  double read_at = -1e9;  // when the prose was last scrolled by hand, in ImGui's seconds
  float scroll_by = 0;    // how far a key scrolls the prose in the next frame
  float scroll_to = -1;   // where the prose is scrolling to; less than 0: nowhere
  // Heights measured in the last frame: of the lower parts of the left and the right column, and of the question.
  int code_seen = -1;  // the line of the pseudocode that was lit then
  bool low = false;    // whether a lecture is on a low screen: then all that is not the stage is
  float pinned_height = 300, code_height = 300, question_height = 0;
  float strip_height = 60;     // of what is wrong with the lesson's file, measured in the last frame
  bool measured_anew = false;  // whether a height differed from the expected one, so that another frame is due

  /// Shows a notice of something that was done, which is no error.
  void say(std::string done) { said_ = notice = std::move(done); }
  [[nodiscard]] bool is_said() const { return notice == said_; }
  /// Shows an error as the notice; returns whether there was none.
  template <class T>
  bool tell(const tl::expected<T, InputError>& result) {
    if (!result) notice = result.error().message();
    return result.has_value();
  }

 private:
  std::string said_;
  /// The hash of the file of a lesson of one's own; 0 for the course's.
  [[nodiscard]] std::uint64_t hash_of(const std::string& id) const;
  std::string recorded_;  // the file of the demo that record() adds to; empty before the first state
  /// What is shown beside another stage begins anew.
  void begin_panels();
  void take_files();
  void keep_exercise();
  void see_measured(const lesson::Sheet& sheet);
  void see_built();
  [[nodiscard]] const std::string& of_strip() const;
  void read_again();

  std::optional<KeptView> view_seen_;
  std::unique_ptr<Loading> loading_;  // the file that is being read; null for none
  app::App& app_;
  std::vector<LessonFile> lessons_;
  std::size_t open_ = 0;  // index into lessons_
  std::vector<ExerciseFile> exercises_;
  std::vector<lesson::ExerciseSet> sets_;
  std::optional<std::size_t> came_from_;
  std::optional<Drafts> drafts_;
  std::string waited_for_;  // the id of a lesson that cannot be drawn yet
  int opened_version_ = 0;  // that of the open lesson's draft
  Kept kept_;
  bool watches_ = false;                        // whether the exercise is an attempt that is only looked at
  bool counted_ = false;                        // whether the exercise, finished, has counted as a try
  int cover_seen_ = -1;                         // the cover's version when its table was last taken
  std::string measured_shown_;                  // the part of the sheet whose table was asked for; empty for none
  std::uint64_t kept_changes_ = 0;              // the sitting's changes when it was last kept
  std::optional<std::uint64_t> kept_revision_;  // the session's revision when it was last kept
  app::Settings before_presenting_;
};

}  // namespace snug::desktop
