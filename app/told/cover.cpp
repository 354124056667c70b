#include "app/told/cover.hpp"

#include "app/cover_picture.hpp"

namespace snug::app::told {

Covers cover_of(App& app) {
  const app::Cover* const own = app.cover();
  if (own == nullptr) return {};
  const lesson::Session& session = *app.session();
  Cover told{.choices = own->choices(session),
             .work = own->work_buttons(session),
             .button = own->button(),
             .shown = own->shown(),
             .running = own->running(),
             .progress = own->progress(),
             .decided = own->decided(session),
             .says = own->status(session),
             .table = own->table(session)};
  for (const std::string_view format : formats_of(*own)) told.formats.emplace_back(format);
  told.any = !told.table.rows.empty();
  return {std::move(told)};
}

}  // namespace snug::app::told
