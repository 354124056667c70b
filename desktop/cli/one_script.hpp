// The page's modules as one script, for a page that is one file.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "desktop/cli/packing.hpp"
#include "geometry/input_error.hpp"

namespace snug::desktop {

/// The module of that path with all that it imports, those that it loads later included. It reads what the page's
/// modules are written like: imports by name, each on one line, and exports where something is declared. Errors: a
/// module that is written otherwise, that is not there, or that imports itself by way of others.
[[nodiscard]] tl::expected<std::string, InputError> one_script(const SiteFiles& files, const std::string& path);

}  // namespace snug::desktop
