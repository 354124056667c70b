#include "web/shared_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/generate.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/situations.hpp"
#include "web/values.hpp"

namespace snug::web {
namespace {

using emscripten::val;

constexpr std::size_t kMostInAddress = 64;  // in full precision: about 4000 characters, which every browser accepts
constexpr std::size_t kMostKnown = 16;

std::vector<std::size_t> differences(const lesson::Rows& a, const lesson::Rows& b) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) places.push_back(i);
  return places;
}

bool is_one_of(const auto& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// How an address names the state, apart from the seed; none if it cannot.
std::optional<std::string> words_for(const lesson::Session& session) {
  const lesson::Points& own = lesson::points_in(session.lesson(), session.situation());
  const std::string& source = session.source();
  if (source == "own" || (!own.mesh.empty() && source == own.mesh)) return "";
  const Index count = lesson::count_of(session.subject());
  if (source == own.generate && count == own.count) return "";
  if (source == "task" && session.task() > 0) return source + ":" + std::to_string(session.task() + 1);
  if (source == "task" || is_one_of(lesson::mesh_names(), source)) return source;
  if (is_one_of(generator_kinds(), source)) return source + ":" + std::to_string(count);
  return std::nullopt;
}

val row_object(const std::vector<double>& row) { return array_of(row, number); }

std::string sentence(const lesson::Done& done) { return done ? "" : done.error().message(); }

}  // namespace

void SharedRows::remember(const lesson::Session& session) {
  const auto how = words_for(session);
  if (!how) return;
  if (known_.size() == kMostKnown) known_.erase(known_.begin() + 1);  // the first is the lesson as it opened
  known_.push_back({*how, session.seed(), session.snapshot()});
}

/// The rows that a known state has with the sliders where they stand now; none if it is another situation's.
lesson::Rows SharedRows::rows_from(const Known& known, const lesson::Session& session) {
  const lesson::Snapshot& state = known.state;
  if (known.seed != session.seed() || state.subject->origin().situation != session.situation()) return {};
  if (state.slid.values == session.slider_values()) return state.subject->rows();
  const auto slid = lesson::slid_to(session.lesson(), state, session.slider_values());
  return slid ? slid->subject->rows() : lesson::Rows();
}

val SharedRows::describe(const lesson::Session& session) const {
  val object = val::object();
  const lesson::Rows rows = session.subject().rows();
  const Known* nearest = nullptr;
  std::vector<std::size_t> fewest;
  for (const Known& known : known_) {
    const lesson::Rows known_rows = rows_from(known, session);
    if (known_rows.size() != rows.size()) continue;
    auto places = differences(known_rows, rows);
    if (nearest != nullptr && places.size() >= fewest.size()) continue;
    nearest = &known;
    fewest = std::move(places);
  }
  const auto set_slide = [&] {
    if (session.has_slid()) object.set("slide", array_of(session.slider_values(), number));
  };
  const bool few = rows.size() <= kMostInAddress;
  if (nearest != nullptr && fewest.size() <= kMostInAddress && (!few || 2 * fewest.size() < rows.size())) {
    set_slide();
    object.set("how", nearest->how);
    object.set("moved", array_of(fewest, [&](std::size_t i) {
                 std::vector<double> row = rows[i];
                 row.insert(row.begin(), static_cast<double>(i));
                 return row_object(row);
               }));
  } else if (few) {
    set_slide();
    object.set("rows", array_of(rows, row_object));
  }
  return object;
}

std::string take_rows(lesson::Session& session, const val& rows) {
  lesson::Rows all;
  for (int i = 0; i < rows["length"].as<int>(); ++i) all.push_back(emscripten::vecFromJSArray<double>(rows[i]));
  return sentence(session.set_rows(all));
}

std::string take_changes(lesson::Session& session, const val& moved) {
  lesson::Rows all = session.subject().rows();
  for (int i = 0; i < moved["length"].as<int>(); ++i) {
    std::vector<double> row = emscripten::vecFromJSArray<double>(moved[i]);
    const double place = row.front();
    if (!(place >= 0 && place < static_cast<double>(all.size())) || place != std::floor(place))
      return "there is no such point";
    row.erase(row.begin());
    all[static_cast<std::size_t>(place)] = std::move(row);
  }
  return sentence(session.set_rows(all));
}

}  // namespace snug::web
