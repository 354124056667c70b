#include <algorithm>

#include "geometry/generate.hpp"
#include "lesson/names.hpp"
#include "lesson/place.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/situations.hpp"
#include "lesson/subjects.hpp"
#include "lesson/text_change.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostKnown = 16;

std::vector<std::size_t> differences(const Rows& a, const Rows& b) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) places.push_back(i);
  return places;
}

/// All but the points and what fills them.
Place place_in_run(const Session& session) {
  const Lesson& lesson = session.lesson();
  Place place{.lesson = lesson.id, .seed = session.stage().subject().origin().seed};
  const auto name = [&](int slot) {
    return session.player().method(slot) != nullptr ? name_in(lesson, *session.player().method(slot)) : std::string();
  };
  if (!lesson.situations.empty() && session.stage().situation() != kOwnSituation)
    place.situation = session.stage().situation();
  if (!lesson.algorithms.empty() && name(0) != lesson.algorithms.front()) place.algorithm = name(0);
  if (name(1) != lesson.compare) place.beside = name(1);
  if (session.stage().subject().in_float() != session.stage().own().in_float())
    place.scalar = session.stage().subject().in_float() ? "float" : "double";
  if (session.stage().has_slid()) place.sliders = session.stage().slider_values();
  if (!session.player().previewing())
    place.step = session.player().step();  // a preview is not a step that anyone chose
  if (const auto file = session.stage().subject().file())
    place.file = change_of(file->own, file->runs), place.draft = change_of(file->runs, file->typed);
  return place;
}

}  // namespace

std::optional<std::string> source_words(const Session& session) {
  const Points& own = points_in(session.lesson(), session.stage().situation());
  const std::string& source = session.stage().subject().origin().source;
  if (source == "own" || (!own.mesh.empty() && source == own.mesh)) return "";
  const Index count = count_of(session.stage().subject());
  if (source == own.generate && count == own.count) return "";
  if (source == "task" && session.stage().task() > 0) return source + ":" + std::to_string(session.stage().task() + 1);
  if (source == "task" || is_among(mesh_names(), source)) return source;
  if (is_among(generator_kinds(), source)) return source + ":" + std::to_string(count);
  return std::nullopt;
}

void NamedStages::remember(const Session& session) {
  const auto from = source_words(session);
  if (!from) return;
  if (known_.size() == kMostKnown) known_.erase(known_.begin() + 1);  // the first is the lesson as it opened
  known_.push_back({*from, session.stage().subject().origin().seed, session.stage().snapshot()});
}

/// The rows that a known stage has with the sliders where they stand now; none if it is another situation's.
Rows NamedStages::rows_from(const Known& known, const Session& session) {
  const Snapshot& stage = known.stage;
  if (known.seed != session.stage().subject().origin().seed ||
      stage.subject->origin().situation != session.stage().situation())
    return {};
  if (stage.slid.values == session.stage().slider_values()) return stage.subject->rows();
  const auto slid = slid_to(session.lesson(), stage, session.stage().slider_values());
  return slid ? slid->subject->rows() : Rows();
}

Place NamedStages::place_of(const Session& session) const {
  Place place = place_in_run(session);
  if (known_.empty()) {
    place.from = source_words(session).value_or("");
    if (session.stage().edited()) place.rows = session.stage().subject().rows();
    return place;
  }
  const Rows rows = session.stage().subject().rows();
  const Known* nearest = nullptr;
  std::vector<std::size_t> fewest;
  for (const Known& known : known_) {
    const Rows known_rows = rows_from(known, session);
    if (known_rows.size() != rows.size()) continue;
    std::vector<std::size_t> places = differences(known_rows, rows);
    if (nearest != nullptr && places.size() >= fewest.size()) continue;
    nearest = &known;
    fewest = std::move(places);
  }
  const bool few = rows.size() <= kMostPlainRows;
  if (nearest == nullptr || fewest.size() > kMostPlainRows ||
      (few && !fewest.empty() && 2 * fewest.size() >= rows.size())) {
    place.rows = rows;
    return place;
  }
  place.from = nearest->from;
  for (const std::size_t i : fewest) {
    std::vector<double>& row = place.moved.emplace_back(rows[i]);
    row.insert(row.begin(), static_cast<double>(i));
  }
  return place;
}

tl::expected<Place, InputError> place_now(const Session& session, const MeshOf& mesh) {
  const Lesson& lesson = session.lesson();
  std::optional<io::PointFile> file;
  if (!lesson.points.mesh.empty()) {
    auto read = mesh(lesson.points.mesh);
    if (!read) return tl::unexpected(read.error());
    file = *std::move(read);
  }
  auto led = Session::open(lesson, std::move(file));
  if (!led) return tl::unexpected(led.error());
  Place stage = place_in_run(session);
  stage.from = source_words(session).value_or("");
  stage.algorithm.clear(), stage.beside.reset(), stage.step.reset(), stage.file.clear(), stage.draft.clear();
  NamedStages named;
  if (go_to(stage, *led, mesh)) named.remember(*led);
  return named.place_of(session);
}

}  // namespace snug::lesson
