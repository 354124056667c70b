#include "desktop/cli/package_contents.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include "desktop/cli/files.hpp"
#include "desktop/cli/words.hpp"
#include "desktop/cli/write_js.hpp"

namespace snug::desktop {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFirstPage = "index.html", kCourse = "course.json", kStyle = "style.css";
// Servers of courses refuse files whose endings they do not know: there these have one more (web/page/boot.js).
constexpr std::string_view kToBin[] = {".wasm", ".ply", ".otf", ".ttf"}, kToText[] = {".toml"};

/// What a package is about: what counts in it, and what else it has.
struct About {
  std::string kind, id, title;
  std::string opens;                            // the address of what is opened; empty for the list of what is there
  std::vector<std::string> lessons, exercises;  // which count
  std::set<std::string> all_lessons;            // with those that teach the exercises
  Json sets = Json::array();

  /// A name in a manifest has no colon.
  [[nodiscard]] std::string name() const { return id.empty() ? kind : kind + "." + replaced(id, ":", "."); }
  [[nodiscard]] bool counts(const std::string& exercise) const {
    return std::find(exercises.begin(), exercises.end(), exercise) != exercises.end();
  }
};

const Json* find_id(const Json& list, const std::string& id) {
  for (const Json& one : list)
    if (one.at("id") == id) return &one;
  return nullptr;
}

const Json* find_lesson_entry(const Json& course, const std::string& id) {
  for (const Json& chapter : course.at("chapters"))
    if (const Json* lesson = find_id(chapter.at("lessons"), id)) return lesson;
  return nullptr;
}

void add_exercise_to(About& about, const Json& exercise) {
  const std::string id = exercise.at("id");
  if (about.counts(id)) return;
  about.exercises.push_back(id);
  about.all_lessons.insert(exercise.at("lesson").get<std::string>());
}

void add_set_to(About& about, const Json& set) {
  about.sets.push_back(set);
  for (const Json& exercise : set.at("exercises")) add_exercise_to(about, exercise);
}

About about_all(const Json& course) {
  About about{.kind = "course", .title = "Snug: bounding volumes"};
  for (const Json& chapter : course.at("chapters"))
    for (const Json& lesson : chapter.at("lessons")) about.lessons.push_back(lesson.at("id"));
  for (const Json& set : course.at("sets")) add_set_to(about, set);
  about.all_lessons.insert(about.lessons.begin(), about.lessons.end());
  return about;
}

tl::expected<About, InputError> about_of(const std::string& what, const Json& course) {
  if (what == "course") return about_all(course);
  const std::size_t colon = what.find(':');
  const std::string kind = what.substr(0, colon), id = colon == std::string::npos ? "" : what.substr(colon + 1);
  const auto none = [&](const std::string& list) {
    return tl::unexpected(InputError{.what = "there is no " + kind + " \"" + id + "\"; `" + list + "` lists them"});
  };
  About about{.kind = kind, .id = id, .opens = "?" + kind + "=" + id};
  if (kind == "lesson") {
    const Json* lesson = find_lesson_entry(course, id);
    if (lesson == nullptr) return none("snug lesson list");
    about.title = lesson->at("title");
    about.lessons = {id}, about.all_lessons = {id};
    about.opens += "&amp;step=0";  // before its result, unless it was begun
    return about;
  }
  if (kind == "exercise") {
    const Json* exercise = find_id(course.at("exercises"), id);
    if (exercise == nullptr) return none("snug exercise list");
    about.title = exercise->at("title");
    add_set_to(about, {{"id", id}, {"title", about.title}, {"lecture", ""}, {"exercises", Json::array({*exercise})}});
    return about;
  }
  if (kind == "set") {
    const Json* set = find_id(course.at("sets"), id);
    if (set == nullptr) return none("snug exercise list");
    about.title = set->at("title"), about.opens.clear();
    add_set_to(about, *set);
    return about;
  }
  return tl::unexpected(
      InputError{.what = "what is packaged is lesson:ID, exercise:ID, set:ID or course, not \"" + what + '"'});
}

/// Leaves out the exercises in which a function is written, and their set.
void leave_out_written(Json& course) {
  const auto list = [&](const char* key) -> Json::array_t& { return course.at(key).get_ref<Json::array_t&>(); };
  const auto written = [](const Json& one) { return is_written(one.at("id").get<std::string>()); };
  std::erase_if(list("exercises"), written);
  std::erase_if(list("sets"), [](const Json& one) { return one.at("id") == "write"; });
  for (Json& set : list("sets")) std::erase_if(set.at("exercises").get_ref<Json::array_t&>(), written);
}

/// The course with what is in the package alone.
Json course_with(Json course, const About& about, PackageKind kind) {
  if (about.kind != "course") {
    Json chapters = Json::array(), exercises = Json::array();
    for (Json chapter : course.at("chapters")) {
      Json lessons = Json::array();
      for (const Json& lesson : chapter.at("lessons"))
        if (about.all_lessons.count(lesson.at("id")) != 0) lessons.push_back(lesson);
      chapter["lessons"] = lessons;
      if (!lessons.empty()) chapters.push_back(std::move(chapter));
    }
    for (const Json& exercise : course.at("exercises"))
      if (about.counts(exercise.at("id"))) exercises.push_back(exercise);
    course["chapters"] = std::move(chapters), course["exercises"] = std::move(exercises), course["sets"] = about.sets;
    course["playground"] = "", course["demos"] = Json::array();
  }
  course["package"] = {{"name", about.name()},
                       {"kind", about.kind},
                       {"id", about.id},
                       {"title", about.title},
                       {"lessons", about.lessons},
                       {"exercises", about.exercises},
                       {"scorm", kind == PackageKind::kScorm}};
  return course;
}

std::string stem_in(const std::string& path, std::string_view folder) {
  if (!path.starts_with(folder)) return "";
  const std::string stem = fs::path(path).stem().string();
  constexpr std::string_view kDark = "-dark";  // the same picture for dark themes
  return folder == "course/" && stem.ends_with(kDark) ? stem.substr(0, stem.size() - kDark.size()) : stem;
}

bool belongs(const std::string& path, const About& about, PackageKind kind) {
  if (path.starts_with("write") && kind == PackageKind::kOneFile) return false;
  if (path == "preview.js" || path == "lessons/exercises/sets.toml") return false;
  if (path == "inside.js") return kind == PackageKind::kOneFile;
  if (path == "offline.js" || path == "sw.js") return kind == PackageKind::kFolder;
  if (about.kind == "course") return true;
  if (path.starts_with("demos/")) return false;
  if (path == "cases.json" || path.starts_with("lessons/cases/")) return false;
  if (const std::string id = stem_in(path, "lessons/exercises/"); !id.empty()) return about.counts(id);
  if (path.starts_with("write"))  // its scripts, its styles and its folder
    return path.ends_with(".json") ? about.counts(std::string(kWritePrefix) + stem_in(path, "write/"))
                                   : std::any_of(about.exercises.begin(), about.exercises.end(), is_written);
  for (const std::string_view folder : {"lessons/", "course/"})
    if (const std::string id = stem_in(path, folder); !id.empty()) return about.all_lessons.count(id) != 0;
  return true;
}

std::string name_for_servers(const std::string& path) {
  const auto ends = [&](std::string_view ending) { return path.ends_with(ending); };
  if (std::any_of(std::begin(kToBin), std::end(kToBin), ends)) return path + ".bin";
  return std::any_of(std::begin(kToText), std::end(kToText), ends) ? path + ".txt" : path;
}

SiteFiles renamed_for_servers(SiteFiles files) {
  SiteFiles renamed;
  for (const std::string_view naming : {kFirstPage, kStyle}) {  // which call files by their names
    std::string& text = files.at(std::string(naming));
    for (const auto& [path, bytes] : files) text = replaced(std::move(text), path, name_for_servers(path));
  }
  for (auto& [path, bytes] : files) renamed[name_for_servers(path)] = std::move(bytes);
  return renamed;
}

/// Says to the page, before anything of it runs, what it opens and how its files are called.
void head_of(std::string& html, const About& about, PackageKind kind) {
  const std::string names = kind == PackageKind::kScorm ? "plain" : kind == PackageKind::kOneFile ? "inside" : "";
  const std::string after = "<meta charset=\"utf-8\">\n";
  std::string metas;
  if (!about.opens.empty()) metas += "<meta name=\"snug-opens\" content=\"" + about.opens + "\">\n";
  if (!names.empty()) metas += "<meta name=\"snug-names\" content=\"" + names + "\">\n";
  html.insert(html.find(after) + after.size(), metas);
  const std::string last = "<link rel=\"stylesheet\" href=\"course.css\">\n";
  html.insert(html.find(last) + last.size(), "<link rel=\"stylesheet\" href=\"packaged.css\">\n");
}

/// The worker that keeps the page for use without a network lists the files, each with its hash (web/describe_site.py).
void list_in_worker(SiteFiles& files) {
  constexpr std::size_t kDigits = 16;
  const auto worker = files.find("sw.js");
  if (worker == files.end()) return;
  Json list = Json::object();
  for (const auto& [path, bytes] : files)
    if (path != worker->first) list[path] = sha256_hex_of(bytes).substr(0, kDigits);
  std::string& text = worker->second;
  const std::size_t begin = text.find("const files = ");
  text.replace(begin, text.find('\n', begin) - begin, "const files = " + list.dump() + ';');
}

}  // namespace

tl::expected<SiteFiles, InputError> read_site(const std::string& folder) {
  SiteFiles files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string name = fs::relative(entry->path(), folder).generic_string();
    if (!entry->is_regular_file() || name.find("/.") != std::string::npos || name.starts_with(".")) continue;
    auto bytes = read_file(entry->path().string());
    if (!bytes) return tl::unexpected(std::move(bytes.error()));
    files[name] = *std::move(bytes);
  }
  for (const std::string_view needed : {kFirstPage, kCourse, kStyle, std::string_view("snug.wasm")})
    if (files.count(std::string(needed)) == 0)
      return tl::unexpected(InputError{.what = "is not the page's folder: it has no " + std::string(needed) +
                                               "; `./run package` builds the page",
                                       .file = folder});
  return files;
}

tl::expected<PackageContents, InputError> package_of(const std::string& what, SiteFiles site, PackageKind kind) {
  Json course = Json::parse(site.at(std::string(kCourse)), nullptr, false);
  if (course.is_discarded() || !course.contains("exercises"))
    return tl::unexpected(InputError{.what = "is not the page's own", .file = std::string(kCourse)});
  auto about = about_of(what, course);
  if (!about) return tl::unexpected(about.error());
  const std::size_t all = about->exercises.size();
  if (kind == PackageKind::kOneFile) {
    if (what == "set:write" || what.starts_with("exercise:" + std::string(kWritePrefix)))
      return tl::unexpected(InputError{.what = "code that students write runs in a worker, which a page in one file "
                                               "cannot start: take -o or --static"});
    leave_out_written(course);
    about = about_of(what, course);
  }
  PackageContents contents{about->name(), about->title, {}, all - about->exercises.size()};
  for (auto& [path, bytes] : site)
    if (belongs(path, *about, kind)) contents.files[path] = std::move(bytes);
  contents.files[std::string(kCourse)] = course_with(course, *about, kind).dump() + '\n';
  if (kind == PackageKind::kScorm) contents.files["reached.txt"] = about->name() + '\n';  // asked for by packaged.js
  if (kind == PackageKind::kScorm) contents.files = renamed_for_servers(std::move(contents.files));
  head_of(contents.files.at(std::string(kFirstPage)), *about, kind);
  list_in_worker(contents.files);
  return contents;
}

}  // namespace snug::desktop
