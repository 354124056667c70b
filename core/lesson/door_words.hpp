// What both doors say around a lesson. The window takes these words from here; the page has them in its HTML, which
// must stand before the program is loaded, and a test compares the two.
#pragma once

#include <array>
#include <string_view>

namespace snug::lesson {

inline constexpr std::string_view
    kCourseTitle = "Bounding volumes, by hand and eye",
    kCourseSays = "Drag points, turn boxes, and watch each algorithm answer at once: how a volume is fitted, how tight "
                  "it is, what it costs, and where the arithmetic breaks.",
    kGalleryTitle = "Gallery of hard cases",
    kGallerySays = "Small inputs on which real programs failed, with links to the reports. Each opens on the stage. "
                   "A naive method, if there is one, runs beside a careful one.",
    kCasesWord = "Hard cases", kShowAllWord = "Show all lessons", kSearchWord = "Search the lessons",
    kStartWord = "Start here", kNotBegunWord = "Not begun";

// Each with its key.
inline constexpr const char *kLeaveKeyed = "Leave presentation (Esc)", *kPreviousKeyed = "Previous lesson (P)",
                            *kNextKeyed = "Next lesson (N)", *kTextKeyed = "The lesson’s text (T)";

inline constexpr std::string_view kSettingsWord = "Settings", kThemeWord = "Theme", kTextSizeWord = "Text size",
                                  kPresentWord = "Present", kScalarWord = "Computed in";

/// The names of the themes, in the order of app::Theme.
inline constexpr std::array<std::string_view, 4> kThemeWords{"Light", "Dark", "High contrast", "Projector"};

}  // namespace snug::lesson
