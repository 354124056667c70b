// What the desktop window holds besides the app: its lessons, its notices, and what its panels ask for.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/app.hpp"
#include "desktop/cli/lesson_files.hpp"

namespace snug::desktop {

class Shell {
 public:
  Shell(app::App& app, std::vector<LessonFile> lessons) : app_(app), lessons_(std::move(lessons)) {}

  [[nodiscard]] app::App& app() { return app_; }
  [[nodiscard]] lesson::Session& session() { return *app_.session(); }
  [[nodiscard]] const std::vector<LessonFile>& lessons() const { return lessons_; }

  /// The title of the open lesson's chapter.
  [[nodiscard]] const std::string& chapter() const { return lessons_[open_].chapter; }

  /// Errors are kept as the notice too.
  tl::expected<void, InputError> open(const std::string& id);
  /// A mesh of the program's own by name, or a point file by path, instead of the points that are there.
  void use_mesh(const std::string& name);
  void use_file(const std::string& path);

  /// What was measured of the chart that is shown, as a new file in the folder that the program was started in; the
  /// notice says which, or why not. format: csv or json.
  void save_costs(const std::string& format);

  /// One sentence that stands until it is clicked away; empty for none.
  std::string notice;
  bool keys_shown = false;
  bool hint_shown = false;       // of the task
  std::array<char, 32> typed{};  // of the name that answers a question
  bool points_tab = false;
  float pinned_height = 300;   // of the column's lower part, as measured in the last frame
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
};

}  // namespace snug::desktop
