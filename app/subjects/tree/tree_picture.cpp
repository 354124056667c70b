// The tree below or beside its boxes, growing as they are gathered into nodes; and what a query keeps on its stack.
#include <algorithm>
#include <cmath>
#include <functional>

#include "app/marks.hpp"
#include "app/subjects/tree/draw.hpp"
#include "lesson/figures.hpp"

namespace snug::app {
namespace {

using lesson::Branch;
using lesson::Forest;

constexpr float kTreeRow = 46, kInnerRadius = 6, kLeafRadius = 10, kNodeWords = 13, kPanelHead = 24;
constexpr float kLeafShare = 0.46f;   // of a leaf's slot, half its mark at most
constexpr float kLetterShare = 1.6f;  // of that half, the size of its letter at most

/// Where each branch is in the picture: a slot for each box, a row for each level.
struct TreeLayout {
  struct Place {
    float slot = 0, slots = 1;  // its first slot, and how many
    int row = 0;
  };
  std::vector<Place> places;  // by branch
  float slots = 0;
  int rows = 1;

  TreeLayout(const Forest& forest, lesson::Growth::Way way) : forest_(forest) {
    places.resize(forest_.branches.size());
    for (const Index root : forest_.roots) put(root, 0);
    if (way != lesson::Growth::Way::kUp) return;
    for (const Index i : forest_.there()) at(i).row = rows - 1 - height_of(i);  // the leaves in one row
  }
  Place& at(Index i) { return places[i]; }

 private:
  int height_of(Index i) const {
    const Branch& branch = forest_.at(i);
    return branch.divides() ? 1 + std::max(height_of(branch.children[0]), height_of(branch.children[1])) : 0;
  }
  void put(Index i, int row) {
    const Branch& branch = forest_.at(i);
    rows = std::max(rows, row + 1);
    at(i) = {slots, static_cast<float>(branch.boxes.size()), row};
    if (!branch.divides()) slots += static_cast<float>(branch.boxes.size());
    else
      for (const Index child : branch.children) put(child, row + 1);
  }
  const Forest& forest_;
};

class TreePicture {
 public:
  TreePicture(Brush& brush, const TreeShown& shown, const Rect& room, TreeSide side)
      : brush_(brush), look_(brush.look), shown_(shown), side_(side), forest_(forest_on(shown, side)),
        list_(brush.list), layout_(forest_, shown.run->way()), room_(room),
        row_(layout_.rows > 1 ? std::min(look_.px(kTreeRow), room.height / static_cast<float>(layout_.rows - 1)) : 0),
        leaf_(std::min(look_.px(kLeafRadius), kLeafShare * room.width / std::max(layout_.slots, 1.0f))) {}

  void draw() {
    for (const Index i : forest_.there()) edges(i);
    for (const Index i : forest_.there()) node(i);
    brush_.canvas.obstacles.taken.push_back(
        {room_.x, room_.y - look_.px(kLeafRadius), room_.width, room_.height + 2 * look_.px(kLeafRadius)});
  }

 private:
  ImVec2 place_of(Index i) {
    const TreeLayout::Place& place = layout_.at(i);
    const float slot = room_.width / std::max(layout_.slots, 1.0f);
    return {room_.x + (place.slot + place.slots / 2) * slot, room_.y + row_ * static_cast<float>(place.row)};
  }

  void edges(Index i) {
    const Branch& branch = forest_.at(i);
    if (!branch.divides()) return;
    for (const Index child : branch.children) {
      const TreeInk ink = ink_of(*look_.palette, shown_, child, side_);
      const bool dotted = ink.pale || side_ == TreeSide::kCopy;
      line(list_, place_of(i), place_of(child), dotted ? Stroke::kDotted : Stroke::kSolid,
           with_alpha(ink.line, ink.pale ? 0.5f : 0.8f), 1.5f);
    }
  }

  void node(Index i) {
    const Branch& branch = forest_.at(i);
    const Palette& p = *look_.palette;
    const bool now = i == branch_on(shown_, side_);
    const bool alone = branch.boxes.size() == 1;
    TreeInk ink = ink_of(p, shown_, i, side_);
    if (alone && branch.boxes.front() == shown_.incoming) ink = {p.examined, p.examined_text};
    if (!alone && !branch.divides()) return group(i, ink, now);
    const ImVec2 at = place_of(i);
    const float radius = alone ? leaf_ : look_.px(kInnerRadius) * (now ? 1.4f : 1);
    disc(list_, at, radius + (now ? 2.5f : 1), p.panel);
    if (!alone) disc(list_, at, radius, ink.pale ? with_alpha(ink.line, 0.5f) : ink.line);
    else {
      list_->AddRectFilled({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius},
                           with_alpha(ink.line, now || ink.fill > 0 ? 0.22f : 0.08f), 4);
      list_->AddRect({at.x - radius, at.y - radius}, {at.x + radius, at.y + radius}, ink.line, 4, 0, now ? 2.0f : 1.0f);
      const float words = std::min(kNodeWords, kLetterShare * radius / look_.px(1));
      text_middle(list_, look_, Face::kSemiBold, words, {at.x, middle_of(at.y, look_.px(words))}, ink.words,
                  side_ == TreeSide::kOwn ? lesson::box_name(branch.boxes.front())
                                          : lesson::small(lesson::box_name(branch.boxes.front())));
    }
    if (now) ring(list_, at, radius + 4, ink.line, 2);
    if (ink.crossed)
      cross(list_, alone ? ImVec2{at.x + radius, at.y - radius} : at, alone ? 3.5f : 4, alone ? ink.line : p.panel, 2);
  }

  /// The names of boxes, or how many they are, if that fits.
  std::string words_of(const std::vector<Index>& boxes, float room) const {
    std::string names, close;
    for (const Index box : boxes) {
      names += (names.empty() ? "" : " ") + lesson::box_name(box);
      close += lesson::box_name(box);
    }
    for (const std::string& words : {names, close, std::to_string(boxes.size())})
      if (measure(look_, Face::kSemiBold, kNodeWords, words).x + 4 <= room) return words;
    return {};
  }

  /// A node that is still to be divided: its boxes' names.
  void group(Index i, const TreeInk& ink, bool now) {
    const TreeLayout::Place& place = layout_.at(i);
    const float slot = room_.width / layout_.slots, half = slot * place.slots / 2 - 2, high = look_.px(kLeafRadius);
    const ImVec2 at = place_of(i);
    list_->AddRectFilled({at.x - half, at.y - high}, {at.x + half, at.y + high}, look_->panel, 4);
    list_->AddRectFilled({at.x - half, at.y - high}, {at.x + half, at.y + high}, with_alpha(ink.line, 0.1f), 4);
    list_->AddRect({at.x - half, at.y - high}, {at.x + half, at.y + high}, ink.line, 4, 0, now ? 2.0f : 1.0f);
    text_middle(list_, look_, Face::kSemiBold, kNodeWords, {at.x, middle_of(at.y, look_.px(kNodeWords))}, ink.words,
                words_of(forest_.at(i).boxes, 2 * half));
  }

  Brush& brush_;
  const Look& look_;
  const TreeShown& shown_;
  TreeSide side_;
  const Forest& forest_;
  ImDrawList* list_;
  TreeLayout layout_;
  Rect room_;
  float row_, leaf_;
};

/// The nodes that wait, the next one first.
std::string waiting_words(const TreeShown& shown) {
  std::string words;
  std::vector<Index> waiting = shown.query()->waiting;
  if (shown.asks_next) std::sort(waiting.begin(), waiting.end(), std::greater{});
  for (auto node = waiting.rbegin(); node != waiting.rend(); ++node)
    words += (words.empty() ? "" : ", ") + shown.run->name_of(shown.forest(), *node);
  return words.empty() ? "empty" : words;
}

/// The pairs of nodes that wait, the next one first: "BDE fg, A fg".
std::string waiting_pairs(const TreeShown& shown) {
  const Forest& copy = shown.run->pairing()->copy;
  const auto name = [&](const Forest& forest, Index node) {
    const std::string own = shown.run->name_of(forest, node);
    return own == "the root" ? std::string("root") : own;
  };
  std::string words;
  const auto& waiting = shown.pairs()->waiting;
  for (auto pair = waiting.rbegin(); pair != waiting.rend(); ++pair)
    words +=
        (words.empty() ? "" : ", ") + name(shown.forest(), (*pair)[0]) + "–" + lesson::small(name(copy, (*pair)[1]));
  return words.empty() ? "empty" : words;
}

}  // namespace

void draw_tree_picture(Brush& brush, const TreeShown& shown, TreePlace place) {
  const lesson::Box2 box = tree_room(brush.session, place);
  const ImVec2 low = brush.at({box.min[0], box.max[1], 0}), high = brush.at({box.max[0], box.min[1], 0});
  const Rect room{low.x, low.y, high.x - low.x, high.y - low.y};
  if (shown.run->pairing() == nullptr) return TreePicture(brush, shown, room, TreeSide::kOwn).draw();
  const float half = room.width / 2;
  TreePicture(brush, shown, {room.x, room.y, half, room.height}, TreeSide::kOwn).draw();
  TreePicture(brush, shown, {room.x + half, room.y, half, room.height}, TreeSide::kCopy).draw();
}

float draw_tree_panel(const Look& look, const TreeShown& shown, ImVec2 at, float width) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  float y = at.y;
  const auto heading = [&](std::string_view words) {
    text(list, look, Face::kSemiBold, 13, {at.x, y + look.px(5)}, look->muted, words);
    y += look.px(kPanelHead);
  };
  if (shown.query() != nullptr) {
    heading(shown.asks_next ? "On the stack" : "Stack, the next node first");
    y += paragraph(list, look, Face::kMono, 13, 20, {at.x, y}, width, look->ink, waiting_words(shown));
  } else if (shown.pairs() != nullptr) {
    heading("Stack, the next pair first");
    y += paragraph(list, look, Face::kMono, 13, 20, {at.x, y}, width, look->ink, waiting_pairs(shown));
  } else if (shown.priced != nullptr) {
    heading("Expected tests at each split");
    y += draw_cost_curve(look, *shown.priced, {at.x, y}, width);
  }
  return y - at.y;
}

}  // namespace snug::app
