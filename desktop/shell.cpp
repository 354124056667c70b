#include "desktop/shell.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "app/cover.hpp"
#include "app/cover_picture.hpp"
#include "desktop/cli/cost_file.hpp"
#include "desktop/cli/defaults.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/cli/page_address.hpp"
#include "lesson/demo.hpp"
#include "lesson/door_words.hpp"
#include "lesson/kept_answers.hpp"
#include "lesson/playground.hpp"
#include "lesson/say.hpp"
#include "lesson/words.hpp"

namespace snug::desktop {
Shell::Shell(app::App& app, std::vector<LessonFile> lessons, Kept kept, std::optional<Drafts> drafts)
    : app_(app), lessons_(std::move(lessons)), drafts_(std::move(drafts)), kept_(std::move(kept)) {
  if (drafts_) take_files();
}

std::size_t Shell::course_size() const {
  const auto first =
      std::find_if(lessons_.begin(), lessons_.end(), [](const LessonFile& file) { return !file.of_course(); });
  return first - lessons_.begin();
}

void Shell::begin_panels() {
  hint_of = code_seen = -1, typed = {}, unread = true, task_wanted = false;
  side_tab = SideTab::kStored, figures_most = 0, stored_before.clear(), stored_lit.clear();
}

tl::expected<void, InputError> Shell::open(const std::string& id, bool anew) {
  for (const LessonFile& file : lessons_) {
    if (file.lesson.id != id) continue;
    auto mesh = mesh_of(file.lesson);
    if (!tell(mesh)) return tl::unexpected(mesh.error());
    auto opened = app_.open(file.lesson, *std::move(mesh), anew);
    cover_seen_ = -1, measured_shown_.clear();
    if (opened) {
      open_ = static_cast<std::size_t>(&file - lessons_.data());
      begin_panels();
      waited_for_.clear();
      if (drafts_) opened_version_ = drafts_->find(id)->version, drafts_->play(file.lesson.id);
      if (open_ == 0) app_.invite(drafts_ ? lesson::Invitations::kAll : kept_.invited);
    }
    tell(opened);
    if (!opened && drafts_ && app_.session() == nullptr) waited_for_ = id, course_shown = true;
    return opened;
  }
  return tl::unexpected(InputError{.what = "there is no lesson \"" + id + "\"; `snug lesson list` lists them"});
}

std::uint64_t Shell::hash_of(const std::string& id) const {
  const DraftFile* const draft = drafts_ ? drafts_->find(id) : nullptr;
  return draft != nullptr ? draft->hash : 0;
}

std::pair<std::size_t, std::string> Shell::lead() const {
  std::size_t last = lessons_.size();
  for (std::size_t i = 0; i < course_size(); ++i)
    if (lessons_[i].lesson.id == kept_.last() && kept_lesson(kept_.last()) != nullptr) last = i;
  if (last == lessons_.size()) return {0, std::string(lesson::kStartWord)};
  const auto done = [&](std::size_t i) {
    const KeptLesson* const kept = kept_lesson(lessons_[i].lesson.id);
    return kept != nullptr && kept->done;
  };
  if (!done(last)) return {last, std::string(lesson::kContinueWord)};
  for (std::size_t i = last + 1; i < course_size(); ++i)
    if (!done(i)) return {i, std::string(lesson::kNextLessonWord)};
  return {last, std::string(lesson::kContinueWord)};
}

void Shell::go_to_kept_place() {
  const KeptLesson* const kept = kept_lesson(session().lesson().id);
  if (kept == nullptr) return;
  const lesson::AtOnce at_once(session().stage());  // each part is of what the last one left
  lesson::Place place = kept->place;
  if (text_of_stage(session()) != kept->text) place.file.clear(), place.draft.clear();
  // What the lesson no longer has is left out.
  for (lesson::WayTo way(place, mesh_named); !way.done();) static_cast<void>(way.go_on(session()));
  session().jump(std::min(kept->step, session().player().steps()));
  if (!place.camera.empty()) app_.look_from(place.camera);
}

void Shell::open_at_place(std::size_t lesson) {
  if (app_.session() != nullptr) keep();
  const std::string id = lessons_[lesson].lesson.id;
  if (waits_for(id)) return;
  const KeptLesson* const kept = kept_lesson(id);
  if (kept != nullptr) app_.keep_answers(id, lesson::kept_answers_of(kept->answers));
  if (!open(id)) return;
  if (kept != nullptr) go_to_kept_place();
  else session().go(0);
  kept_revision_ = session().revision();
  course_shown = false;
}

void Shell::open_at_place(const std::string& id) {
  for (std::size_t i = 0; i < lessons_.size(); ++i)
    if (lessons_[i].lesson.id == id) return open_at_place(i);
}

std::optional<std::size_t> Shell::beside(int by) const {
  const std::size_t to = open_ + static_cast<std::size_t>(by);  // below the first it wraps beyond the last
  return to < course_size() || (lessons_[open_].is_case && to < lessons_.size()) ? std::optional(to) : std::nullopt;
}

std::optional<std::size_t> Shell::playground() const {
  const auto found =
      std::find_if(lessons_.begin(), lessons_.end(), [](const LessonFile& one) { return one.is_playground; });
  const std::size_t at = found - lessons_.begin();
  return found == lessons_.end() || at == open_ ? std::nullopt : std::optional(at);
}

void Shell::go_to_playground() {
  const auto to = playground();
  if (!to) return;
  const auto points = lesson::points_to_try(session());
  const std::string from = session().lesson().id;
  const std::size_t came_from = open_;
  open_at_place(*to);
  if (open_ != *to) return;
  came_from_ = came_from;
  if (points) tell(app_.load(*points, from));
}

std::optional<std::size_t> Shell::way_back() const { return lessons_[open_].is_playground ? came_from_ : std::nullopt; }

void Shell::show_course() {
  if (app_.playing()) app_.command("play");
  if (app_.session() == nullptr) return;
  keep();
  present(false);
  focus.leave();
  course_shown = true;
}

void Shell::present(bool on) {
  if (on == presenting) return;
  presenting = on, text_shown = false;
  if (!on) {
    demo.reset(), hall.lift();
    while (hall.put_away()) {
    }
  }
  focus.leave();
  app::Settings& settings = app_.settings();
  if (!on) {
    settings.theme = before_presenting_.theme, settings.text_scale = before_presenting_.text_scale;
    settings.least_words = 0;
    return;
  }
  before_presenting_ = settings;
  settings.theme = app::Theme::kProjector;
}

bool Shell::fit_words(float width, float height) {
  constexpr float kWidth = 1280, kHeight = 720, kScale = 1.3f;
  constexpr float kDemoScale = 1.5f;  // a demo shows less beside its stage
  // What the last row reads; a narrow window is nobody's projector.
  constexpr float kOfHeight = 1 / 40.0f, kOfWidth = 3 / 160.0f;
  if (!presenting) return false;
  const float least = std::min(height * kOfHeight, width * kOfWidth);
  const float larger = std::max(1.0f, std::min(width / kWidth, height / kHeight));
  const float scale =
      std::max(before_presenting_.text_scale, (demo ? kDemoScale : kScale) * larger / app::kProjector.text);
  const bool other_scale = std::exchange(app_.settings().text_scale, scale) != scale;
  return std::exchange(app_.settings().least_words, least) != least || other_scale;
}

void Shell::keep(bool dragging) {
  if (app_.session() == nullptr || demo) return;  // a demo is nobody's work
  if (const lesson::Sheet* const of = sheet()) see_measured(*of);
  if (const int followed = app_.invitations_followed(); open_ == 0 && !drafts_ && followed > kept_.invited) {
    kept_.invited = followed;
    kept_.write();
  }
  if (dragging || (app_.sitting() == nullptr && lessons_[open_].is_case)) return;  // a case is not worked through
  const std::uint64_t changes = app_.sitting() != nullptr ? app_.sitting()->changes() : 0;
  if (app_.playing() || (session().revision() == kept_revision_ && changes == kept_changes_)) return;
  kept_revision_ = session().revision(), kept_changes_ = changes;
  if (sheet() != nullptr) see_built();
  if (app_.sitting() != nullptr) return keep_exercise();
  kept_.keep(session(), hash_of(session().lesson().id), app_.hand_view());
  kept_.write();
}

void Shell::keep_view(const std::array<int, 4>& extent) {
  if (presenting) return;
  const app::Settings& settings = app_.settings();
  const auto& [x, y, width, height] = extent;
  const KeptView view{static_cast<int>(settings.theme), settings.text_scale, width, height, x, y};
  // What a window opens with was nobody's choice.
  if (const auto before = std::exchange(view_seen_, view); !before || before == view) return;
  kept_.view = view;
  kept_.write();
}

void Shell::erase_answers() {
  kept_.erase();
  kept_.write();
  app_.forget_answers();
  if (app_.session() != nullptr) kept_revision_ = session().revision();
}

void Shell::use_mesh(const std::string& name) {
  const auto read = mesh_named(name);
  if (tell(read)) tell(app_.load(*read, name));
}

void Shell::use_file(const std::string& path) {
  if (const auto start = read_start(path, 4096); app_.cover() != nullptr && start && !table_name(*start).empty()) {
    auto text = read_file(path);
    const auto table = text ? table_as_csv(std::move(*text), path) : std::move(text);
    if (tell(table)) tell(*app_.cover()->lay_over(session(), *table, path));
    return;
  }
  const auto read = read_point_file(path);
  if (tell(read)) use_points(*read, path);
}

void Shell::use_points(const io::PointFile& points, const std::string& path) {
  const auto loaded = app_.load(points, std::filesystem::path(path).filename().string());
  if (!loaded) notice = lesson::capital(loaded.error().message()) + ".";
}

void Shell::use_dropped(const std::vector<std::string>& paths) {
  if (paths.empty()) return;
  const auto name_of = [](const std::string& path) { return std::filesystem::path(path).filename().string(); };
  open_points(paths.front());
  if (notice.empty() && loading_ == nullptr && session().stage().preparing() == nullptr)
    say(name_of(paths.front()) + " is open.");
  if (paths.size() == 1) return;
  std::string others;
  for (std::size_t i = 1; i < paths.size(); ++i) others += (i > 1 ? ", " : "") + name_of(paths[i]);
  notice += " One file is taken at a time; not opened: " + others + ".";
}

std::string Shell::new_file(const std::string& stem, const std::string& extension) {
  std::error_code error;
  std::filesystem::path folder = std::filesystem::current_path(error);
  if (!defaults().results.empty()) {
    folder = defaults().results;
    std::filesystem::create_directories(folder, error);
    if (error) {
      notice = "Not saved: " + folder.string() + ": " + error.message() + ". " + defaults().file + " names it.";
      return {};
    }
  }
  if (error || !std::filesystem::exists(folder, error)) {
    notice = "Not saved: the folder that Snug was started in is no longer there. Start Snug in another one.";
    return {};
  }
  std::filesystem::path path = folder / (stem + extension);
  for (int n = 2; std::filesystem::exists(path, error); ++n)
    path = folder / (stem + "-" + std::to_string(n) + extension);
  return path.string();
}

void Shell::save_cover(std::string_view format) {
  const app::Cover& cover = *app_.cover();
  const bool picture = format == "png";
  const std::string text =
      format == "svg" ? app::cover_svg(app_, address()) : cover.file(picture ? cover.formats().front() : format);
  if (text.empty()) {
    notice = "Not saved: nothing has been measured yet.";
    return;
  }
  const std::string path = new_file(app_.cover()->file_name(), "." + std::string(format));
  if (path.empty()) return;
  if (picture) return static_cast<void>(picture_wanted = path);  // drawn after this frame
  const auto written = write_file(path, text);
  if (tell(written)) say("Saved as " + path + ".");
}

void Shell::save_stage(std::string_view format) {
  picture_wanted =
      new_file(session().lesson().id + '-' + std::to_string(session().player().step()), '.' + std::string(format));
}

void Shell::record() {
  auto place = lesson::place_now(session(), mesh_named);
  if (!tell(place)) return;
  place->camera = app_.hand_view();
  if (recorded_.empty()) recorded_ = new_file("demo", ".toml");
  if (recorded_.empty()) return;
  const auto before = std::filesystem::exists(recorded_)
                          ? read_file(recorded_)
                          : "version = 1\ntitle = \"My demo\"\nlecture = \"My lecture\"\n";
  if (!tell(before)) return;
  const std::string text =
      *before + '\n' + lesson::state_text(*place, session().lesson().title, session().player().trace_hash());
  const std::size_t states = lesson::read_demo(text, recorded_).demo.states.size();
  if (tell(write_file(recorded_, text)))
    say("Saved in " + recorded_ + ", with " +
        (states == 1 ? std::string("this state.") : std::to_string(states) + " states."));
}

void Shell::show_code() { hall.taken = code_words(session(), app_.hand_view()); }

}  // namespace snug::desktop
