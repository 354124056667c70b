#include "lesson/playable.hpp"

#include "lesson/subjects.hpp"

namespace snug::lesson {

std::vector<std::string> playable(const Session& session) {
  std::vector<std::string> names;
  for (const std::string& name : session.lesson().algorithms)
    if (const Method* known = find_method(session.lesson(), name); known && session.stage().subject().suits(*known))
      names.push_back(name);
  return names;
}

}  // namespace snug::lesson
