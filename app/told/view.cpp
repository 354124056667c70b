#include "app/told/view.hpp"

#include <utility>

namespace snug::app::told {

std::string view_text(App& app) { return Changes().tell(app); }

std::string Changes::tell(App& app) {
  std::string changed = "{";
  std::size_t number = 0;
  see_parts(app, [&](const auto& part) {
    std::string now;
    write_fields(now, part);
    if (number == last_.size()) last_.emplace_back();
    std::string& last = last_[number++];
    if (now == last) return;
    if (changed.size() > 1) changed += ',';
    changed += now;
    last = std::move(now);
  });
  return changed + '}';
}

}  // namespace snug::app::told
