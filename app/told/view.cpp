#include "app/told/view.hpp"

#include <utility>

namespace snug::app::told {

std::string view_text(App& app) { return Changes().tell(app); }

std::string Changes::tell(App& app) {
  std::string changed = "{";
  std::size_t number = 0;
  const App::SessionRevision before = std::exchange(revision_, app.session_revision());
  see_parts(app, [&](From from, const auto& part) {
    if (number == last_.size()) last_.emplace_back();
    std::string& last = last_[number++];
    if (from == From::kSession && before == revision_) return;
    std::string now;
    write_fields(now, part());
    if (now == last) return;
    if (changed.size() > 1) changed += ',';
    changed += now;
    last = std::move(now);
  });
  return changed + '}';
}

}  // namespace snug::app::told
