#include "lesson/demo_now.hpp"

#include <map>

#include "geometry/generate.hpp"
#include "io/text.hpp"
#include "lesson/names.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/point_subject.hpp"
#include "lesson/situations.hpp"
#include "lesson/stand.hpp"
#include "lesson/subjects.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
namespace {

std::string row_words(const std::vector<double>& row) {
  std::string text;
  for (const double number : row) text += (text.empty() ? "" : ",") + io::shortest_text(number);
  return text;
}

std::string rows_words(const Rows& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) text += (text.empty() ? "" : ";") + row_words(row);
  return text;
}

/// Each key of the state that has a value, by its name in a file.
std::map<std::string_view, std::string> values_of(const DemoState& state) {
  const bool plain = state.rows.size() <= kMostPlainRows;
  std::map<std::string_view, std::string> values{{"lesson", state.lesson},
                                                 {"situation", state.situation},
                                                 {"algorithm", state.algorithm},
                                                 {"scalar", state.scalar},
                                                 {"from", state.from},
                                                 {"sliders", row_words(state.sliders)},
                                                 {"camera", row_words(state.camera)},
                                                 {"moved", rows_words(state.moved)},
                                                 {"rows", plain ? rows_words(state.rows) : ""},
                                                 {"packed", plain ? "" : packed_rows(state.rows)},
                                                 {"step", std::to_string(state.step)}};
  if (state.beside) values["compare"] = state.beside->empty() ? "none" : *state.beside;
  if (state.seed) values["seed"] = std::to_string(*state.seed);
  return values;
}

/// Escapes a text as encodeURIComponent does, but keeps the characters that an address's rows are made of.
std::string address_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (plain || std::string_view("-_.!~*'(),;:+").find(c) != std::string_view::npos)
      safe += c == '+' ? std::string("%2B") : std::string(1, c);
    else safe += {'%', "0123456789ABCDEF"[static_cast<unsigned char>(c) >> 4], "0123456789ABCDEF"[c & 15]};
  }
  return safe;
}

/// A TOML string with this text.
std::string toml_text(std::string_view text) {
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) safe += c;
  }
  return safe + '"';
}

/// What has to be said of the rows, from those that the rest of the state leads to.
void tell_rows(DemoState& state, const Rows& from, const Rows& to) {
  if (from == to) return;
  if (from.size() == to.size())
    for (std::size_t i = 0; i < to.size(); ++i) {
      if (from[i] == to[i]) continue;
      std::vector<double>& row = state.moved.emplace_back(to[i]);
      row.insert(row.begin(), static_cast<double>(i));
    }
  if (!state.moved.empty() && state.moved.size() <= kMostPlainRows &&
      (to.size() > kMostPlainRows || 2 * state.moved.size() < to.size()))
    return;
  state.moved.clear(), state.rows = to;
}

}  // namespace

std::optional<std::string> source_words(const Session& session) {
  const Points& own = points_in(session.lesson(), session.situation());
  const std::string& source = session.source();
  if (source == "own" || (!own.mesh.empty() && source == own.mesh)) return "";
  const Index count = count_of(session.subject());
  if (source == own.generate && count == own.count) return "";
  if (source == "task" && session.task() > 0) return source + ":" + std::to_string(session.task() + 1);
  if (source == "task" || is_among(mesh_names(), source)) return source;
  if (is_among(generator_kinds(), source)) return source + ":" + std::to_string(count);
  return std::nullopt;
}

tl::expected<DemoState, InputError> state_now(const Session& session, const MeshOf& mesh) {
  const Lesson& lesson = session.lesson();
  DemoState state{.lesson = lesson.id, .seed = session.seed(), .from = source_words(session).value_or("")};
  const auto name = [&](int slot) {
    return session.method(slot) != nullptr ? name_in(lesson, *session.method(slot)) : std::string();
  };
  if (!lesson.situations.empty() && session.situation() != kOwnSituation) state.situation = session.situation();
  if (!lesson.algorithms.empty() && name(0) != lesson.algorithms.front()) state.algorithm = name(0);
  if (name(1) != lesson.compare) state.beside = name(1);
  if (session.subject().in_float() != session.own().in_float())
    state.scalar = session.subject().in_float() ? "float" : "double";
  if (session.has_slid()) state.sliders = session.slider_values();
  state.step = session.step();

  // A session that is led there shows what is still missing.
  std::optional<io::PointFile> file;
  if (!lesson.points.mesh.empty()) {
    auto read = mesh(lesson.points.mesh);
    if (!read) return tl::unexpected(read.error());
    file = *std::move(read);
  }
  auto led = Session::open(lesson, std::move(file));
  if (!led) return tl::unexpected(led.error());
  DemoState stage = state;
  stage.algorithm.clear(), stage.beside.reset(), stage.step = 0;
  if (!take_state(stage, *led, mesh)) state.from.clear();
  tell_rows(state, led->subject().rows(), session.subject().rows());
  return state;
}

std::string address_of(const DemoState& state) {
  const auto values = values_of(state);
  std::string address, packed;
  for (const PlaceKey& key : kPlaceKeys) {
    const auto value = values.find(key.in_file);
    if (value == values.end() || value->second.empty()) continue;
    const std::string part = std::string(key.in_address) + '=' + address_text(value->second);
    if (key.in_file == "packed") packed = '#' + part;
    else address += (address.empty() ? '?' : '&') + part;
  }
  return address + packed;
}

std::string state_text(const DemoState& state, std::string_view title, std::uint64_t hash) {
  const auto values = values_of(state);
  std::string text = "[[state]]\nhash = " + toml_text(hex_of(hash)) + "\nslide = " + toml_text(title) + '\n';
  for (const PlaceKey& key : kPlaceKeys)
    if (const auto value = values.find(key.in_file); value != values.end() && !value->second.empty())
      text += std::string(key.in_file) + " = " + (key.is_number ? value->second : toml_text(value->second)) + '\n';
  return text + "shows = [\"caption\", \"numbers\", \"code\"]\nnotes = \"What you say.\"\n";
}

}  // namespace snug::lesson
