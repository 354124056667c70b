#include "web/shared_points.hpp"

#include <algorithm>
#include <optional>

#include "geometry/generate.hpp"
#include "web/boxes.hpp"
#include "web/view.hpp"

namespace snug::web {
namespace {

using emscripten::val;

constexpr std::size_t kMostInAddress = 64;  // in full precision: about 4000 characters, which every browser accepts
constexpr std::size_t kMostKnown = 16;

std::vector<Vector<double, 3>> points_of(const lesson::Session& session) {
  std::vector<Vector<double, 3>> points;
  points.reserve(session.size());
  for (Index i = 0; i < session.size(); ++i) points.push_back(session.point(i));
  return points;
}

std::vector<Index> differences(const std::vector<Vector<double, 3>>& a, const std::vector<Vector<double, 3>>& b) {
  std::vector<Index> moved;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) moved.push_back(static_cast<Index>(i));
  return moved;
}

bool is_one_of(const auto& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// How an address names the points, apart from the seed; none if it cannot.
std::optional<std::string> words_for(const lesson::Session& session) {
  const lesson::Points& own = session.lesson().points;
  const std::string& source = session.source();
  if (source == "own" || (!own.mesh.empty() && source == own.mesh)) return "";
  if (source == own.generate && session.size() == own.count) return "";
  if (source == "task" || is_one_of(lesson::mesh_names(), source)) return source;
  if (is_one_of(generator_kinds(), source)) return source + ":" + std::to_string(session.size());
  return std::nullopt;
}

val row(const lesson::Session& session, Index i, bool with_index) {
  val numbers = val::array();
  if (with_index) numbers.call<int>("push", i);
  for (int axis = 0; axis < session.dim(); ++axis) numbers.call<int>("push", session.point(i)[axis]);
  return numbers;
}

}  // namespace

void SharedPoints::remember(const lesson::Session& session) {
  const auto how = words_for(session);
  if (!how) return;
  if (known_.size() == kMostKnown) known_.erase(known_.begin() + 1);  // the first is the lesson as it opened
  known_.push_back({*how, session.seed(), session.dim(), points_of(session)});
}

val SharedPoints::describe(const lesson::Session& session) const {
  val object = val::object();
  if (session.subject().boxes() != nullptr) {
    if (session.edited()) object.set("boxes", box_rows(session));
    return object;
  }
  if (session.subject().points() == nullptr) return object;  // nothing for an address
  const auto points = points_of(session);
  const Known* nearest = nullptr;
  std::vector<Index> fewest;
  for (const Known& known : known_) {
    if (known.seed != session.seed() || known.dim != session.dim() || known.points.size() != points.size()) continue;
    auto moved = differences(known.points, points);
    if (nearest != nullptr && moved.size() >= fewest.size()) continue;
    nearest = &known;
    fewest = std::move(moved);
  }
  const bool few = points.size() <= kMostInAddress;
  if (nearest != nullptr && fewest.size() <= kMostInAddress && (!few || 2 * fewest.size() < points.size())) {
    object.set("how", nearest->how);
    val moved = val::array();
    for (const Index i : fewest) moved.call<void>("push", row(session, i, true));
    object.set("moved", moved);
  } else if (few) {
    val all = val::array();
    for (Index i = 0; i < session.size(); ++i) all.call<void>("push", row(session, i, false));
    object.set("points", all);
  }
  return object;
}

}  // namespace snug::web
