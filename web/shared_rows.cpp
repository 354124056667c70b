#include "web/shared_rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lesson/demo_now.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/situations.hpp"
#include "web/values.hpp"

namespace snug::web {
namespace {

using emscripten::val;

using lesson::kMostPlainRows;
constexpr std::size_t kMostPacked = 6000;  // numbers: what is packed has 66,000 letters then, more than Firefox shows
constexpr std::size_t kMostKnown = 16;

std::vector<std::size_t> differences(const lesson::Rows& a, const lesson::Rows& b) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) places.push_back(i);
  return places;
}

val row_object(const std::vector<double>& row) { return array_of(row, number); }

std::string sentence(const lesson::Done& done) { return done ? "" : done.error().message(); }

}  // namespace

void SharedRows::remember(const lesson::Session& session) {
  const auto how = lesson::source_words(session);
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
  const bool few = rows.size() <= kMostPlainRows;
  if (nearest != nullptr && fewest.size() <= kMostPlainRows && (!few || 2 * fewest.size() < rows.size())) {
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
  } else if (std::size_t numbers = 0; std::all_of(rows.begin(), rows.end(), [&](const std::vector<double>& row) {
               return (numbers += row.size()) <= kMostPacked;
             })) {
    set_slide();
    object.set("packed", lesson::packed_rows(rows));
  }
  return object;
}

std::string take_rows(lesson::Session& session, const val& rows) {
  lesson::Rows all;
  for (int i = 0; i < rows["length"].as<int>(); ++i) all.push_back(emscripten::vecFromJSArray<double>(rows[i]));
  return sentence(session.set_rows(all));
}

std::string take_packed(lesson::Session& session, const std::string& packed) {
  const auto rows = lesson::unpacked_rows(packed);
  return rows ? sentence(session.set_rows(*rows)) : "the packed numbers of the address are damaged";
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
