#include "app/focus.hpp"

#include <algorithm>
#include <functional>

namespace snug::app {
namespace {

constexpr int kFramesDue = 5;  // until ImGui has answered a press, or given a text field the keys
constexpr float kOff = 3, kCorner = 10;

}  // namespace

Focus::Part::Part(std::string_view name, Layer layer) {
  Focus* const focus = current();
  if (focus == nullptr) return;
  name_before_ = std::exchange(focus->drawing_part_, name);
  layer_before_ = std::exchange(focus->drawing_layer_, layer);
}

Focus::Part::~Part() {
  Focus* const focus = current();
  if (focus == nullptr) return;
  focus->drawing_part_ = name_before_;
  focus->drawing_layer_ = layer_before_;
}

void Focus::begin_frame(Color color) {
  color_ = color;
  due_ = std::max(0, due_ - 1);
  const bool(&clicked)[5] = ImGui::GetIO().MouseClicked;
  if (std::any_of(std::begin(clicked), std::end(clicked), std::identity{})) leave();
}

void Focus::end_frame() {
  drawn_.swap(drawing_);
  drawing_.clear();
  pressed_ = 0;
  arrives_ = again_ = scrolled_ && !again_;  // what was out of view arrives once more, where it can be seen
  scrolled_ = false;
  const auto now = std::find_if(drawn_.begin(), drawn_.end(), [&](const Drawn& one) { return one.id == at_; });
  const auto popup =
      std::find_if(drawn_.begin(), drawn_.end(), [](const Drawn& one) { return one.layer == Layer::kPopup; });
  if (at_ == 0) return;
  if (popup != drawn_.end() && layer_ != Layer::kPopup) return opener_ = at_, stand(first_of(popup->part));
  if (now != drawn_.end()) return;
  // What it was on is gone: a popup closed, or a card says something else.
  if (layer_ == Layer::kPopup) return go_to(opener_);
  stand(layer_ == Layer::kCard ? first_of(part_) : nullptr);
}

Focus::Here Focus::offer(const Control& control) {
  drawing_.push_back({control.id, std::string(control.name), std::string(drawing_part_), drawing_layer_,
                      control.enabled, control.first});
  Here here;
  here.focused = control.id == at_;
  if (!here.focused) return here;
  name_ = control.name;  // a button's words may change under it
  here.arrived = arrives_;
  here.pressed = control.enabled && pressed_ == control.id;
  draw_ring(control.low, control.high);
  const float top = ImGui::GetWindowPos().y, bottom = top + ImGui::GetWindowHeight();
  if (arrives_ && (control.low.y < top || control.high.y > bottom)) {
    ImGui::SetScrollFromPosY((control.low.y + control.high.y) / 2 - top);
    scrolled_ = true;
  }
  return here;
}

void Focus::draw_ring(ImVec2 low, ImVec2 high) const {
  ImGui::GetWindowDrawList()->AddRect({low.x - kOff, low.y - kOff}, {high.x + kOff, high.y + kOff}, color_, kCorner, 0,
                                      2);
}

/// What Tab can come to: of a popup that is open that alone, and a card before the panels.
std::vector<const Focus::Drawn*> Focus::reachable() const {
  Layer top = Layer::kPanel;
  for (const Drawn& one : drawn_) top = std::max(top, one.layer);
  std::vector<const Drawn*> all;
  for (const Layer layer : {Layer::kCard, Layer::kPanel, Layer::kPopup})
    for (const Drawn& one : drawn_)
      if (one.layer == layer && one.enabled && (top == Layer::kPopup) == (layer == Layer::kPopup)) all.push_back(&one);
  return all;
}

const Focus::Drawn* Focus::first_of(std::string_view part) const {
  const Drawn* found = nullptr;
  for (const Drawn& one : drawn_)
    if (one.part == part && one.enabled && (found == nullptr || (one.first && !found->first))) found = &one;
  return found;
}

void Focus::stand(const Drawn* control) {
  due_ = kFramesDue;
  arrives_ = control != nullptr, again_ = scrolled_ = false;
  if (control == nullptr) {
    at_ = 0, layer_ = Layer::kPanel;
    name_.clear(), part_.clear();
    return;
  }
  at_ = control->id, layer_ = control->layer;
  name_ = control->name, part_ = control->part;
}

void Focus::move(int by) {
  const auto all = reachable();
  if (all.empty()) return;
  const bool menu = all.front()->layer == Layer::kPopup;                  // which would close
  if (!menu && ImGui::IsAnyItemActive()) ImGui::SetWindowFocus(nullptr);  // the text field gives the keys back
  const auto n = static_cast<std::ptrdiff_t>(all.size());
  const auto at = std::find_if(all.begin(), all.end(), [&](const Drawn* one) { return one->id == at_; }) - all.begin();
  if (at == n && by > 0 && all.front()->layer == Layer::kCard) return stand(first_of(all.front()->part));
  stand(all[at == n ? (by > 0 ? 0 : n - 1) : (at + by + n) % n]);
}

bool Focus::move_within(int by) {
  const auto all = reachable();
  const auto n = static_cast<std::ptrdiff_t>(all.size());
  const auto at = std::find_if(all.begin(), all.end(), [&](const Drawn* one) { return one->id == at_; }) - all.begin();
  const std::ptrdiff_t to = at + by;
  if (at == n || to < 0 || to >= n || all[to]->part != part_) return false;
  stand(all[to]);
  return true;
}

void Focus::go_to(ImGuiID id) {
  const auto found = std::find_if(drawn_.begin(), drawn_.end(), [&](const Drawn& one) { return one.id == id; });
  stand(found != drawn_.end() ? &*found : nullptr);
}

bool Focus::press() {
  if (at_ == 0) return false;
  pressed_ = at_;
  due_ = kFramesDue;
  return true;
}

bool Focus::leave() {
  if (at_ == 0) return false;
  stand(nullptr);
  return true;
}

}  // namespace snug::app
