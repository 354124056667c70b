#include "lesson/read_view.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/names.hpp"
#include "lesson/speaking.hpp"

namespace snug::lesson {
namespace {

constexpr double kMostZoom = 1000, kMostSize = 1e6, kSteepest = 85;
constexpr std::size_t kLongestName = 12;
constexpr std::string_view kNoNames = "none";

bool is_text(const toml::table& toml, std::string_view key) {
  const toml::node* node = toml.get(key);
  return node != nullptr && node->is_string();
}

StagePlace read_place(TomlTable& table, const toml::table& toml, std::string_view key) {
  StagePlace place;
  if (is_text(toml, key)) {
    place.handle = table.text(key);
    return place;
  }
  const std::vector<double> numbers = table.numbers(key);
  place.numbers = numbers.size();
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); });
  if (table.has(key) && (numbers.size() < 2 || numbers.size() > 3 || !finite))
    table.wrong(key, "must be a handle's name, \"gap\" or coordinates: [x, y]");
  for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 3); ++i) place.at[static_cast<int>(i)] = numbers[i];
  return place;
}

std::optional<Inset> read_inset(TomlTable& view, Complaints& complaints) {
  const toml::table* toml = view.table("inset");
  if (toml == nullptr) return std::nullopt;
  TomlTable table(*toml, "\"inset\"", complaints);
  Inset inset{read_place(table, *toml, "at"), 0};
  if (table.has("size") || !inset.at.is_gap()) inset.size = table.number("size", kMostSize);
  table.refuse_others();
  return inset;
}

std::array<double, 2> read_camera(TomlTable& table) {
  const std::vector<double> angles = table.numbers("camera");
  if (angles.size() != 2 || !(std::abs(angles[0]) <= 360) || !(std::abs(angles[1]) <= kSteepest)) {
    table.wrong("camera", "must be two angles in degrees, [yaw, pitch]: from -360 to 360, and from -85 to 85");
    return {};
  }
  return {angles[0], angles[1]};
}

/// What is wrong with the name of point i; empty for nothing.
std::string fault_of(const std::vector<std::string>& names, std::size_t i) {
  constexpr std::string_view kTaken = "()[]{}/:*$\"\\";  // links and formulas of the prose are written with these
  const std::string& name = names[i];
  const auto here = names.begin() + static_cast<std::ptrdiff_t>(i);
  const auto same = [&](const std::string& other) { return plain_name(other) == plain_name(name); };
  if (plain_name(name).empty()) return "has an empty name";
  if (name.size() > kLongestName) return "has a name longer than 12 letters: " + name;
  if (name.find_first_of(kTaken) != std::string::npos) return "has a sign that no name may have: " + name;
  if (name == StagePlace::kGap || name == "support") return "has a name that means something else: " + name;
  if (std::any_of(names.begin(), here, same)) return "has a name twice: " + name;
  return {};
}

void read_names_of_points(TomlTable& table, const toml::table& toml, StageView& view) {
  if (is_text(toml, "names")) {
    if (table.text("names") != kNoNames) table.wrong("names", "must be a list of names, or \"none\"");
    view.named = false;
    return;
  }
  view.names = table.texts("names", 1);
  for (std::size_t i = 0; i < view.names.size(); ++i)
    if (const std::string fault = fault_of(view.names, i); !fault.empty()) table.wrong("names", fault);
}

}  // namespace

StageView read_view(TomlTable& lesson, Complaints& complaints) {
  StageView view;
  const toml::table* toml = lesson.table("view");
  if (toml == nullptr) return view;
  TomlTable table(*toml, "[view]", complaints);
  if (table.has("camera")) view.camera = read_camera(table);
  if (table.has("zoom")) view.zoom = table.number("zoom", kMostZoom);
  if (table.has("look_at")) view.look_at = read_place(table, *toml, "look_at");
  if (table.has("names")) read_names_of_points(table, *toml, view);
  view.outline = table.flag_or("outline", false);
  if (table.has("decimals")) view.decimals = static_cast<int>(table.integer("decimals", 0, 9));
  if (table.has("point_size")) view.point_size = table.number("point_size", 5);
  view.inset = read_inset(table, complaints);
  for (const std::string_view key : {"camera", "zoom", "look_at", "names", "decimals", "point_size"}) table.allow(key);
  table.refuse_others();
  return view;
}

}  // namespace snug::lesson
