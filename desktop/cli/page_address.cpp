#include "desktop/cli/page_address.hpp"

#include "desktop/cli/defaults.hpp"
#include "desktop/cli/lesson_files.hpp"
#include "lesson/place.hpp"
#include "lesson/qr.hpp"

namespace snug::desktop {

std::string page_address(const lesson::Session& session, std::vector<double> camera) {
  auto place = lesson::place_now(session, mesh_named);
  if (!place) return "";
  place->camera = std::move(camera);
  return defaults().page + lesson::address_of(*place);
}

CodeWords code_words(const lesson::Session& session, std::vector<double> camera) {
  CodeWords words{.letters = lesson::fingerprint(session.player().trace_hash())};
  if (defaults().page.empty()) {
    words.says = "There is no code: a line page = \"https://...\" in snug.toml says where the class finds Snug's page.";
    return words;
  }
  auto place = lesson::place_now(session, mesh_named);
  if (!place) return words.says = place.error().message(), words;
  place->camera = std::move(camera);
  const auto address = [&](bool same) {
    return defaults().page + lesson::address_of(*place) + (same ? "&mark=" + words.letters : "");
  };
  words.address = address(true);
  if (place->rows.size() <= lesson::kMostPlainRows && lesson::qr_code(words.address)) {
    words.says = address(false);
    return words;
  }
  place->rows.clear(), place->moved.clear();
  words.address = words.says = address(false);
  words.says += " It opens this lesson without what was edited here, which is too much for a code.";
  return words;
}

}  // namespace snug::desktop
