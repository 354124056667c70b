// What the desktop window holds besides the app: its lessons, its notices, and what its panels ask for.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "app/app.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "desktop/course_screen.hpp"
#include "desktop/kept.hpp"

namespace snug::desktop {

class Shell {
 public:
  /// kept: from earlier visits.
  Shell(app::App& app, std::vector<LessonFile> lessons, Kept kept)
      : app_(app), lessons_(std::move(lessons)), kept_(std::move(kept)) {}

  [[nodiscard]] app::App& app() { return app_; }
  [[nodiscard]] lesson::Session& session() { return *app_.session(); }
  [[nodiscard]] const std::vector<LessonFile>& lessons() const { return lessons_; }

  /// The title of the open lesson's chapter.
  [[nodiscard]] const std::string& chapter() const { return lessons_[open_].chapter; }

  [[nodiscard]] const Kept& kept() const { return kept_; }

  /// Where to start or to continue, and the word for it.
  [[nodiscard]] std::pair<std::size_t, std::string> lead() const;
  /// Opens a lesson where it was left, or on what stands before its first step.
  void open_at_place(std::size_t lesson);
  /// Where the open lesson was left, if it was.
  void go_to_kept_place();
  void show_course();
  /// Keeps where the open lesson stands, unless it is on the move.
  void keep();
  void erase_answers();

  /// Errors are kept as the notice too.
  tl::expected<void, InputError> open(const std::string& id);
  /// A mesh of the program's own by name, or a point file by path, instead of the points that are there.
  void use_mesh(const std::string& name);
  void use_file(const std::string& path);

  /// What was measured of the chart that is shown, as a new file in the folder that the program was started in; the
  /// notice says which, or why not. format: csv or json.
  void save_costs(const std::string& format);

  bool course_shown = false;  // in the place of the lesson
  CourseScreen course;
  bool erase_asked = false;  // a second press erases

  /// One sentence that stands until it is clicked away; empty for none.
  std::string notice;
  bool keys_shown = false;
  bool hint_shown = false;       // of the task
  std::array<char, 32> typed{};  // of the name that answers a question
  bool points_tab = false;
  std::vector<std::pair<std::string, app::Rect>> links;  // of the prose, by their targets, where they stand
  bool unread = false;                                   // another lesson was opened: its prose begins at the beginning
  float scrolled = 0;                                    // how far the prose was, in the last frame
  int section = -1;                                      // of the prose, that the step was about in the last frame
  double read_at = -1e9;                                 // when the prose was last scrolled by hand, in ImGui's seconds
  float scroll_to = -1;                                  // where the prose is on its way to; less than 0: nowhere
  // As measured in the last frame: of the left column's lower part, of the right one's, and of the stage's foot, which
  // a question covers.
  float pinned_height = 300, code_height = 300, foot = 0;
  bool measured_anew = false;  // it was other than thought: one more frame is due

  /// Keeps what went wrong as the notice; returns whether it went right.
  template <class T>
  bool tell(const tl::expected<T, InputError>& result) {
    if (!result) notice = result.error().message();
    return result.has_value();
  }

 private:
  template <class Row>
  void lay_over(const std::string& path);

  app::App& app_;
  std::vector<LessonFile> lessons_;
  std::size_t open_ = 0;  // which of them
  Kept kept_;
  std::uint64_t kept_revision_ = 0;  // of the session
};

}  // namespace snug::desktop
