#include "lesson/subjects/scene/declared_effects.hpp"

#include <algorithm>
#include <utility>

#include "geometry/sort.hpp"
#include "lesson/names.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/subjects/scene/effect_words.hpp"
#include "lesson/subjects/scene/scene_text.hpp"
#include "scene/schedule.hpp"

namespace snug::lesson {
namespace {

/// An effect that the lesson has, and whether the scene calls for it.
struct Offered {
  const scene::EffectCall* call;
  bool called;
};

/// All of the lesson's effects, in the order of its file.
std::vector<Offered> offered_by(const SceneSet& set) {
  std::vector<Offered> all;
  for (const scene::EffectCall& call : set.effects) all.push_back({&call, true});
  for (const scene::EffectCall& call : set.spare) all.push_back({&call, false});
  sort_stably(all, [](const Offered& a, const Offered& b) { return a.call->line < b.call->line; });
  return all;
}

std::shared_ptr<const SceneSet> set_with(const SceneSet& set, const std::vector<Offered>& offered) {
  auto next = std::make_shared<SceneSet>(set);
  next->effects.clear(), next->spare.clear();
  for (const auto& [call, called] : offered) (called ? next->effects : next->spare).push_back(*call);
  std::vector<bool> flags;
  for (const Offered& one : offered) flags.push_back(one.called);
  if (!next->text.empty()) next->text = with_calls(set.text, flags);
  return next;
}

/// What a called effect of a scene that cannot run lacks: "needs pairs, which no effect writes"; empty for nothing.
std::string lack_words(const SceneSet& set, std::string_view effect) {
  const scene::EffectKind* kind = scene::find_effect(scene::catalogue(), effect);
  const scene::SlotSet missing = kind != nullptr ? scene::missing_for(*kind, set.effects, scene::catalogue()) : 0;
  return missing == 0 ? "" : "needs " + slot_words(missing) + ", which no effect writes";
}

}  // namespace

std::vector<double> called_row(const SceneSet& set) {
  std::vector<double> row;
  for (const Offered& one : offered_by(set)) row.push_back(one.called ? 1 : 0);
  row.resize(std::max<std::size_t>(row.size(), 4), 0);
  return row;
}

std::shared_ptr<const SceneSet> with_called(const SceneSet& set, const std::vector<double>& row) {
  std::vector<Offered> offered = offered_by(set);
  for (std::size_t i = 0; i < offered.size(); ++i) offered[i].called = i < row.size() && row[i] != 0;
  return set_with(set, offered);
}

std::shared_ptr<const SceneSet> with_all_called(const SceneSet& set) {
  return with_called(set, std::vector<double>(set.effects.size() + set.spare.size(), 1));
}

std::shared_ptr<const SceneSet> with_call(const SceneSet& set, std::string_view name, bool called) {
  std::vector<Offered> offered = offered_by(set);
  const auto found =
      std::find_if(offered.begin(), offered.end(), [&](const Offered& one) { return name_of(*one.call) == name; });
  if (!set.graph || found == offered.end()) return nullptr;
  found->called = called;
  return set_with(set, offered);
}

std::vector<Switch> with_optional(std::vector<Switch> running, const SceneSet& set) {
  for (const auto& [call, called] : offered_by(set)) {
    const std::string name = name_of(*call);
    const auto found =
        std::find_if(running.begin(), running.end(), [&](const Switch& one) { return one.name == name; });
    if (found != running.end()) found->optional = true;
    else
      running.push_back({.name = name,
                         .called = called,
                         .optional = true,
                         .says = called ? lack_words(set, call->name) : "not called for"});
  }
  return running;
}

std::vector<Figure> picture_figures(const SceneSet& set, const Pictured& pictured) {
  if (!set.graph) return {};
  std::vector<Figure> figures;
  const auto add = [&](const char* title, const char* key, int value, const std::string& unit) {
    const std::string counted = value != 1 ? unit : unit == "bodies" ? "body" : unit.substr(0, unit.size() - 1);
    figures.push_back({title, key, std::to_string(value) + " " + counted, static_cast<double>(value), unit});
  };
  add("Effects", "effects", pictured.effects, "effects");
  add("Shadows", "shadows", pictured.shadows, "shadows");
  add("Trails", "trails", pictured.trails, "trails");
  add("Projection rays", "rays", pictured.rays, "rays");
  figures.push_back(
      {"Bodies outside the view", "culled", std::to_string(pictured.culled), static_cast<double>(pictured.culled), ""});
  return figures;
}

Rows read_scene_model(TomlTable& task, const Lesson& lesson, Complaints& complaints) {
  Rows rows = read_point_model(task, lesson, complaints);
  if (!task.has("effects") || lesson.tables == nullptr) return rows;
  const auto& set = static_cast<const SceneSet&>(*lesson.tables);
  if (!set.graph) task.wrong("effects", "is for scenes with graph = true");
  const std::vector<std::string> wanted = task.texts("effects", 1);
  std::vector<std::string> known;
  std::vector<double> row;
  for (const Offered& one : offered_by(set)) {
    known.push_back(name_of(*one.call));
    row.push_back(is_among(wanted, known.back()) ? 1 : 0);
  }
  for (const std::string& name : wanted)
    if (!is_among(known, name)) task.wrong("effects", none_of_text(name, known));
  row.resize(std::max<std::size_t>(row.size(), 4), 0);
  rows.push_back(std::move(row));
  return rows;
}

}  // namespace snug::lesson
