#include "app/subjects/scene/graph.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "app/marks.hpp"
#include "lesson/subjects/scene/effect_words.hpp"
#include "lesson/subjects/scene/scene.hpp"
#include "lesson/subjects/scene/scene_figures.hpp"
#include "scene/graph.hpp"

namespace snug::app {
namespace {

using Did = scene::Deed::Kind;

constexpr float kNodeHeight = 18, kNodeRow = 22, kEffectName = 12, kRailPitch = 15, kLeastPitch = 7, kNodePad = 6,
                kNodeMark = 18;
constexpr float kHeadRow = 18, kKeyRow = 22, kKeyWidth = 230;

class Graph {
 public:
  /// width: that it has room in; its lines stand closer if it has to.
  Graph(const Look& look, const lesson::Session& session, float width)
      : look_(look), p_(*look.palette), run_(*lesson::recorded_scene(session, 0)), frame_(session.player().step_of(0)),
        rails_(scene::rails_of(run_.kinds)) {
    for (const scene::EffectTally& tally : run_.tallies) {
      names_.push_back(lesson::effect_words(tally.effect));
      node_ = std::max(node_, measure(look, Face::kSemiBold, kEffectName, names_.back()).x);
    }
    node_ += look.px(kNodeMark + 2 * kNodePad);
    pitch_ = look.px(kRailPitch);
    while (end_of_names() > width && pitch_ > look.px(kLeastPitch)) pitch_ -= 0.5f;
    size_ = {std::max(end_of_names(), std::min(width, look.px(kKeyWidth))),
             look.px(kHeadRow + kNodeRow * static_cast<float>(names_.size()) + kKeyRow)};
  }

  [[nodiscard]] ImVec2 size() const { return size_; }

  void draw(ImDrawList* list, ImVec2 at) {
    list_ = list, at_ = at;
    for (int pass = 0; pass < 2; ++pass)  // those that changed lie over the others
      for (std::size_t i = 0; i < rails_.size(); ++i)
        if (changed(rails_[i]) == (pass == 1)) draw_rail(i);
    for (std::size_t i = 0; i < rails_.size(); ++i) draw_stops(i);
    for (std::size_t i = 0; i < rails_.size(); ++i) draw_name(i);
    for (std::size_t i = 0; i < names_.size(); ++i) draw_node(i);
    draw_key();
  }

 private:
  [[nodiscard]] bool changed(const scene::Rail& rail) const {
    if (frame_ == 0) return false;
    return rail.slot == scene::Slot::kTime || scene::has(run_.changes[frame_ - 1], rail.slot);
  }
  [[nodiscard]] Color color_of(const scene::Rail& rail) const {
    return changed(rail) ? p_.current : with_alpha(p_.muted, 0.55f);
  }
  [[nodiscard]] float width_of(const scene::Rail& rail) const { return changed(rail) ? 2.0f : 1.0f; }
  [[nodiscard]] float offset(std::size_t rail) const { return node_ + pitch_ * (static_cast<float>(rail) + 1); }
  [[nodiscard]] float x_of(std::size_t rail) const { return at_.x + offset(rail); }
  /// The middle of an effect's row; of -1, where the scene's own things begin.
  [[nodiscard]] float y_of(int place) const {
    return at_.y + look_.px(place < 0 ? kHeadRow / 2 : kHeadRow + kNodeRow * (static_cast<float>(place) + 0.5f));
  }
  /// Whether the next rail begins at the same place. The last one that does bears the names of all of them.
  [[nodiscard]] bool names_more(std::size_t rail) const {
    return rail + 1 < rails_.size() && rails_[rail + 1].begin() == rails_[rail].begin();
  }
  [[nodiscard]] std::string name_of(std::size_t rail) const {
    std::string words;
    std::size_t first = rail;
    while (first > 0 && names_more(first - 1)) --first;
    for (std::size_t i = first; i <= rail; ++i)
      words.append(i > first ? ", " : "").append(scene::kSlotNames[static_cast<std::size_t>(rails_[i].slot)]);
    return words;
  }
  /// Where the name of a rail begins: right of every rail that passes its row, so that none strikes through it.
  [[nodiscard]] float name_offset(std::size_t rail) const {
    const int row = rails_[rail].begin();
    std::size_t last = rail;
    for (std::size_t i = rail + 1; i < rails_.size(); ++i)
      if (rails_[i].first() <= row && row <= rails_[i].last()) last = i;
    return offset(last) + 9;
  }
  [[nodiscard]] float end_of_name(std::size_t rail) const {
    return names_more(rail) ? 0 : name_offset(rail) + measure(look_, Face::kRegular, kEffectName, name_of(rail)).x;
  }

  [[nodiscard]] float end_of_names() const {
    float end = 0;
    for (std::size_t i = 0; i < rails_.size(); ++i) end = std::max(end, end_of_name(i));
    return end;
  }

  void draw_rail(std::size_t i) {
    const scene::Rail& rail = rails_[i];
    int top = rail.begin(), bottom = rail.begin();
    for (const std::vector<int>* stops : {&rail.writers, &rail.readers})
      if (!stops->empty()) bottom = std::max(bottom, stops->back()), top = std::min(top, stops->front());
    const float x = x_of(i);
    if (bottom > top) line(list_, {x, y_of(top)}, {x, y_of(bottom)}, Stroke::kSolid, color_of(rail), width_of(rail));
    if (rail.first() < top)
      line(list_, {x, y_of(rail.first())}, {x, y_of(top)}, Stroke::kDashed, color_of(rail), width_of(rail));
    if (rail.last() > bottom)
      line(list_, {x, y_of(bottom)}, {x, y_of(rail.last())}, Stroke::kDashed, color_of(rail), width_of(rail));
    const auto join = [&](int place, Stroke stroke) {
      line(list_, {at_.x + node_, y_of(place)}, {x, y_of(place)}, stroke, color_of(rail), width_of(rail));
    };
    for (const int place : rail.readers) join(place, Stroke::kSolid);
    for (const int place : rail.writers) join(place, Stroke::kSolid);
    for (const int place : rail.late) join(place, Stroke::kDashed);
  }

  /// A disc where the slot is written, a ring where it is read.
  void draw_stops(std::size_t i) {
    const scene::Rail& rail = rails_[i];
    const Color color = changed(rail) ? p_.current : p_.muted;
    const auto read = [&](int place) {
      disc(list_, {x_of(i), y_of(place)}, 4, p_.panel);
      ring(list_, {x_of(i), y_of(place)}, 3.5f, color, 1.5f);
    };
    for (const int place : rail.readers) read(place);
    for (const int place : rail.late) read(place);
    for (const int place : rail.writers) {
      const bool revises = std::find(rail.readers.begin(), rail.readers.end(), place) != rail.readers.end();
      disc(list_, {x_of(i), y_of(place)}, revises ? 2.0f : 4.0f, color);
    }
  }

  void draw_name(std::size_t i) {
    if (names_more(i)) return;
    const ImVec2 at{at_.x + name_offset(i), middle_of(y_of(rails_[i].begin()), look_.px(kEffectName))};
    text(list_, look_, Face::kRegular, kEffectName, at, changed(rails_[i]) ? p_.current_text : p_.muted, name_of(i));
  }

  void draw_node(std::size_t i) {
    const scene::Deed deed = lesson::deed_of(run_, frame_, i);
    const bool runs = deed.kind == Did::kRan;
    const float middle = y_of(static_cast<int>(i)), half = look_.px(kNodeHeight) / 2;
    const ImVec2 low{at_.x, middle - half}, high{at_.x + node_, middle + half};
    list_->AddRectFilled(low, high, p_.panel, 6);
    if (runs) {
      list_->AddRectFilled(low, high, with_alpha(p_.current, 0.14f), 6);
      list_->AddRect(low, high, p_.current, 6, 0, 1.5f);
    } else {
      const std::vector<ImVec2> outline{low, {high.x, low.y}, high, {low.x, high.y}};
      path(list_, outline, true, deed.kind == Did::kNone ? Stroke::kSolid : Stroke::kDotted, p_.muted, 1);
    }
    draw_mark(deed.kind, {at_.x + look_.px(kNodePad) + 4, middle});
    text(list_, look_, runs ? Face::kSemiBold : Face::kRegular, kEffectName,
         {at_.x + look_.px(kNodeMark + kNodePad), middle_of(middle, look_.px(kEffectName))}, runs ? p_.ink : p_.muted,
         names_[i]);
  }

  void draw_mark(Did did, ImVec2 at) {
    switch (did) {
      case Did::kRan: return tick(list_, at, 4, p_.current, 2);
      case Did::kSkipped: return line(list_, {at.x - 4, at.y}, {at.x + 4, at.y}, Stroke::kSolid, p_.muted, 2);
      case Did::kOff: return cross(list_, at, 4, p_.wrong, 2);
      case Did::kNone: return;
    }
  }

  void draw_key() {
    const float middle = at_.y + size_.y - look_.px(kKeyRow) / 2 + 3;
    float x = at_.x + 4;
    const auto word = [&](const char* words) {
      text(list_, look_, Face::kRegular, kEffectName - 1, {x + 8, middle_of(middle, look_.px(kEffectName - 1))},
           p_.muted, words);
      x += 8 + measure(look_, Face::kRegular, kEffectName - 1, words).x + look_.px(14);
    };
    disc(list_, {x, middle}, 4, p_.muted);
    word("writes");
    ring(list_, {x, middle}, 3.5f, p_.muted, 1.5f);
    word("reads");
    line(list_, {x - 4, middle}, {x + 6, middle}, Stroke::kDashed, p_.muted, 1.5f);
    x += 4;
    word("last frame");
  }

  const Look& look_;
  const Palette& p_;
  const lesson::SceneRecording& run_;
  int frame_;
  std::vector<scene::Rail> rails_;
  std::vector<std::string> names_;
  float node_ = 0, pitch_ = 0;  // how wide a node is, and how far the lines are apart
  ImVec2 size_, at_;
  ImDrawList* list_ = nullptr;
};

bool has_graph(const lesson::Session& session) {
  const lesson::SceneRecording* run = lesson::recorded_scene(session, 0);
  return run != nullptr && lesson::set_of(session).graph && !run->tallies.empty();
}

}  // namespace

ImVec2 graph_size(const Look& look, const lesson::Session& session, float width) {
  return has_graph(session) ? Graph(look, session, width).size() : ImVec2(0, 0);
}

void draw_graph(ImDrawList* list, const Look& look, const lesson::Session& session, ImVec2 at, float width) {
  if (has_graph(session)) Graph(look, session, width).draw(list, at);
}

}  // namespace snug::app
