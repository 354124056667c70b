#include "lesson/on_cloud.hpp"

namespace snug::lesson {
namespace {

const SubjectRow& cloud_row() { return *subject_named("cloud"); }

}  // namespace

std::vector<std::string_view> volumes_on_cloud() { return cloud_row().volumes(); }

std::span<const Method> methods_on_cloud(std::string_view volume) {
  std::span<const Method> methods = cloud_row().methods(volume);
  while (!methods.empty() && methods.back().by_hand) methods = methods.first(methods.size() - 1);
  return methods;
}

std::vector<std::string_view> no_facts() { return {}; }

void read_on_cloud(TomlTable& table, Lesson& lesson, Complaints& complaints) {
  cloud_row().read(table, lesson, complaints);
}

tl::expected<std::unique_ptr<Subject>, InputError> open_cloud_of(const Lesson& lesson,
                                                                 std::optional<io::PointFile> mesh, Clock clock) {
  return cloud_row().open(lesson, std::move(mesh), clock);
}

std::vector<const Method*> methods_of(const Lesson& lesson) {
  std::vector<const Method*> methods;
  for (const std::string& name : lesson.algorithms) methods.push_back(find_method(lesson, name));
  return methods;
}

}  // namespace snug::lesson
