// What a package has of the page's folder: a lesson, an exercise, a set of exercises, or all of the course.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "desktop/cli/json.hpp"
#include "desktop/cli/packing.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// Where a package goes, which decides what it has beside its lessons.
enum class PackageKind { kScorm, kFolder, kOneFile };

struct PackageContents {
  std::string id;     // "set.collision", for a manifest
  std::string title;  // as people read it
  SiteFiles files;
  std::size_t left_out = 0;  // exercises that one file cannot have
};

/// The files below a folder, without hidden ones. Errors: those of reading; it is not the page's folder.
[[nodiscard]] tl::expected<SiteFiles, InputError> read_site(const std::string& folder);

/// what: "lesson:ID", "exercise:ID", "set:ID" or "course". site: the page's own files. Its index.html then opens what
/// the package is about, whose lessons and exercises alone are in it, with the lesson that teaches each exercise; and
/// its course.json says under "package" what counts there. Errors: there is no such thing.
[[nodiscard]] tl::expected<PackageContents, InputError> package_of(const std::string& what, SiteFiles site,
                                                                   PackageKind kind);

/// The package as one HTML file, whose policy allows its own scripts by their hashes and nothing else. Errors: a file
/// of the page that cannot be put into it.
[[nodiscard]] tl::expected<std::string, InputError> one_page_of(const PackageContents& contents);

}  // namespace snug::desktop
