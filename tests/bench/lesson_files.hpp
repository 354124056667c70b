// The lessons' files, for benchmarks.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace snug::bench {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// wanted: their ids; all, if there are none.
inline std::vector<std::filesystem::path> lesson_paths(const std::vector<std::string>& wanted) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(SNUG_LESSONS_DIR)) {
    const std::string id = entry.path().stem().string();
    const bool is_wanted = wanted.empty() || std::find(wanted.begin(), wanted.end(), id) != wanted.end();
    if (entry.path().extension() == ".toml" && id != "course" && is_wanted) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

}  // namespace snug::bench
