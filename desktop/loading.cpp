#include "desktop/loading.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <thread>

#include "app/widgets.hpp"
#include "desktop/cli/files.hpp"
#include "desktop/column.hpp"
#include "desktop/header.hpp"
#include "lesson/say.hpp"

namespace snug::desktop {
namespace {

std::uintmax_t bytes_of(const std::string& path) {
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  return error ? 0 : bytes;
}

/// The least number of bytes that are read in a second, in the slowest format, text.
constexpr double kUsualRate = 20e6;

}  // namespace

Loading::Loading(std::string path) : path_(std::move(path)), bytes_(bytes_of(path_)) {
  // A cancelled reading runs to its end in its thread, and touches nothing of the window.
  std::promise<tl::expected<io::PointFile, InputError>> promise;
  result_ = promise.get_future();
  std::thread([own = path_, promise = std::move(promise)]() mutable {
    promise.set_value(read_point_file(own));
  }).detach();
}

std::string Loading::says() const {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
  const double left = std::ceil(static_cast<double>(bytes_) / kUsualRate - seconds);
  const auto whole = [](double value) { return std::to_string(static_cast<std::int64_t>(value)); };
  return "Reading " + std::filesystem::path(path_).filename().string() + ", " +
         whole(std::round(static_cast<double>(bytes_) / 1e6)) + " MB: " + whole(seconds) + " s so far" +
         (left >= 1 ? ", about " + whole(left) + " s left." : ".");
}

void Shell::begin_loading(const std::string& path) { loading_ = std::make_unique<Loading>(path); }

void Shell::poll_loading() {
  if (loading_ == nullptr || !loading_->done()) return;
  measured_anew = true;
  const std::string path = loading_->path();
  const auto read = loading_->take();
  loading_.reset();
  if (!tell(read)) return;
  use_points(*read, path);
  if (notice.empty()) remember(path);
}

void draw_loading(Shell& shell, const app::Rect& stage) {
  const Loading* const loading = shell.loading();
  if (loading == nullptr) return;
  const app::Look& look = shell.app().look();
  const float width = std::min(stage.width - 32, look.px(520)), pad = 16, height = look.px(34) + 2 * pad;
  const app::Rect card{stage.x + (stage.width - width) / 2, stage.y + 56, width, height};
  const app::Pane pane("##loading", card, app::Pane::Kind::kOver);
  ImDrawList* const list = pane.list();
  list->AddRectFilled({card.x, card.y}, {card.x + width, card.y + height}, look->panel, 8);
  list->AddRect({card.x, card.y}, {card.x + width, card.y + height}, look->current, 8, 0, 1.5f);
  const float button = look.px(88);
  app::text(list, look, app::Face::kRegular, 14, {card.x + pad, app::middle_of(card.y + height / 2, look.px(14))},
            look->ink, app::shortened(look, app::Face::kRegular, 14, loading->says(), width - button - 3 * pad));
  if (app::button(list, look,
                  {.id = "cancel loading",
                   .rect = {card.x + width - pad - button, card.y + pad, button, look.px(34)},
                   .words = "Cancel",
                   .kind = app::ButtonKind::kOutlined}))
    shell.cancel_loading();
}

}  // namespace snug::desktop
