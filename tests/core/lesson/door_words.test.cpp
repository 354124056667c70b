#include "lesson/door_words.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/lesson/lesson_files.hpp"
#include "lesson/say.hpp"

using namespace snug;
using namespace snug::lesson;

namespace {

/// All HTML and JavaScript of the page.
std::string page() {
  std::string all;
  for (const auto& entry : std::filesystem::directory_iterator(test::lessons_folder() + "../web/page")) {
    const auto kind = entry.path().extension();
    if (kind != ".html" && kind != ".js") continue;
    std::ifstream file(entry.path(), std::ios::binary);
    all.append(std::istreambuf_iterator<char>(file), {}).append("\n");
  }
  return all;
}

/// Whether the words stand in it as a whole: as an element's text, an attribute or a string.
bool says(const std::string& page, std::string_view words) {
  for (std::size_t at = page.find(words); at != std::string::npos; at = page.find(words, at + 1)) {
    const char before = at == 0 ? '\0' : page[at - 1], after = page[std::min(at + words.size(), page.size() - 1)];
    if ((before == '>' || before == '"' || before == '`') && (after == '<' || after == '"' || after == ':'))
      return true;
  }
  return false;
}

}  // namespace

TEST_CASE("around a lesson, the page says what the window says") {
  const std::string all = page();
  REQUIRE(all.size() > 50'000);
  for (const std::string_view words : {kCourseTitle,
                                       kCourseSays,
                                       kGalleryTitle,
                                       kGallerySays,
                                       kCasesWord,
                                       kShowAllWord,
                                       kSearchWord,
                                       kStartWord,
                                       kNotBegunWord,
                                       kSettingsWord,
                                       kThemeWord,
                                       kTextSizeWord,
                                       kPresentWord,
                                       kScalarWord,
                                       kNextLessonWord,
                                       kContinueWord,
                                       kKeptFoot,
                                       kAlgorithmWord,
                                       kCompareWord,
                                       kNoneWord,
                                       std::string_view(kLeaveKeyed),
                                       std::string_view(kPreviousKeyed),
                                       std::string_view(kNextKeyed),
                                       std::string_view(kTextKeyed)})
    CHECK_MESSAGE(says(all, words), words);
  for (const std::string_view theme : kThemeWords) CHECK_MESSAGE(says(all, theme), theme);
}
