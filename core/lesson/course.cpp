#include "lesson/course.hpp"

#include <algorithm>
#include <map>

#include "lesson/lesson.hpp"
#include "lesson/toml_file.hpp"

namespace snug::lesson {
namespace {

constexpr std::int64_t kCourseVersion = 1;

/// The lessons read so far, and where each was named.
struct Seen {
  std::span<const std::string> ids;
  std::map<std::string, int, std::less<>> lines;  // by id
};

/// The line of an item of "lessons", which texts() has checked.
int line_of_item(const toml::table& chapter, std::size_t i) {
  return static_cast<int>(chapter["lessons"].as_array()->get(i)->source().begin.line);
}

Chapter read_chapter(const toml::table& toml, Seen& seen, Complaints& complaints) {
  TomlTable table(toml, "[[chapter]]", complaints);
  Chapter chapter;
  chapter.title = table.text("title");
  chapter.lessons = table.texts("lessons", 1);
  table.refuse_others();
  if (complaints.first()) return chapter;
  for (std::size_t i = 0; i < chapter.lessons.size(); ++i) {
    const std::string& id = chapter.lessons[i];
    const int line = line_of_item(toml, i);
    if (std::find(seen.ids.begin(), seen.ids.end(), id) == seen.ids.end())
      complaints.add(line, "there is no lesson \"" + id + "\": its file would be " + id + ".toml beside this one");
    if (const auto [at, added] = seen.lines.emplace(id, line); !added)
      complaints.add(line,
                     "the lesson \"" + id + "\" is listed twice: in line " + std::to_string(at->second) + " as well");
  }
  return chapter;
}

Idea read_idea(const toml::table& toml, const std::vector<Idea>& before, Complaints& complaints) {
  TomlTable table(toml, "[[idea]]", complaints);
  Idea idea{table.text("id"), table.text("slide")};
  const auto same = [&](const Idea& other) { return other.id == idea.id; };
  if (std::any_of(before.begin(), before.end(), same)) table.wrong("id", "is that of an idea above: " + idea.id);
  table.refuse_others();
  return idea;
}

}  // namespace

std::vector<std::string> slides_of(const Course& course, std::span<const std::string> covers) {
  std::vector<std::string> slides;
  for (const Idea& idea : course.ideas)
    if (std::find(covers.begin(), covers.end(), idea.id) != covers.end() &&
        std::find(slides.begin(), slides.end(), idea.slide) == slides.end())
      slides.push_back(idea.slide);
  return slides;
}

tl::expected<Course, InputError> read_course(std::string_view text, std::string_view name,
                                             std::span<const std::string> ids) {
  Complaints complaints(name);
  const auto toml = parse_file(text, "a course", complaints);
  if (!toml) return tl::unexpected(complaints.first()->error());
  TomlTable table(*toml, "the course", complaints);
  if (table.integer("version", 1, 1'000'000) != kCourseVersion)
    table.wrong("version", "is not one that this program reads: it reads 1");
  Course course;
  course.playground = table.text_or("playground", "");
  if (!course.playground.empty() && std::find(ids.begin(), ids.end(), course.playground) == ids.end())
    table.wrong("playground", "is not a lesson: " + course.playground);
  Seen seen{ids, {}};
  int last = 1;
  for (const toml::table* chapter : table.tables("chapter")) {
    last = static_cast<int>(chapter->source().begin.line);
    course.chapters.push_back(read_chapter(*chapter, seen, complaints));
  }
  for (const toml::table* idea : table.tables("idea"))
    course.ideas.push_back(read_idea(*idea, course.ideas, complaints));
  if (course.chapters.empty()) complaints.add(1, "the course has no [[chapter]]");
  table.refuse_others();
  for (const std::string& id : ids)
    if (seen.lines.find(id) == seen.lines.end())
      complaints.add(last, "the lesson \"" + id + "\" is in no chapter: add it to the \"lessons\" of one");
  if (complaints.first()) return tl::unexpected(complaints.first()->error());
  return course;
}

}  // namespace snug::lesson
