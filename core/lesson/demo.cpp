#include "lesson/demo.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lesson/demo_reveal.hpp"
#include "lesson/names.hpp"
#include "lesson/packed_rows.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/stand.hpp"
#include "lesson/toml_file.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
namespace {

constexpr int kMostDemoSteps = 1'000'000;
constexpr std::size_t kHashDigits = 16;

// ---- reading ---------------------------------------------------------------------------------------------------

std::vector<std::string_view> parted(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = text.find(at);
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return parts;
}

std::optional<double> number_of(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
  return whole ? std::optional(value) : std::nullopt;
}

/// Rows as an address has them: "1,2;3,4".
Rows read_rows(TomlTable& table, std::string_view key) {
  Rows rows;
  if (!table.has(key)) return table.allow(key), rows;
  for (const std::string& text = table.text(key); const std::string_view row : parted(text, ';')) {
    std::vector<double>& numbers = rows.emplace_back();
    for (const std::string_view one : parted(row, ',')) {
      const auto number = number_of(one);
      if (!number) return table.wrong(key, "must be rows of numbers, as an address has them: \"1,2;3,4\""), Rows();
      numbers.push_back(*number);
    }
  }
  return rows;
}

int read_step(TomlTable& table) {
  if (table.is("step", "end")) return Standpoint::kLastStep;
  return static_cast<int>(table.integer_or("step", 0, kMostDemoSteps, 0));
}

/// The parts and what else a press may reveal, each once.
void read_shown(TomlTable& table, DemoState& state) {
  const std::vector<std::string_view> parts(kDemoParts.begin(), kDemoParts.end());
  std::vector<std::string_view> reveals = parts;
  reveals.insert(reveals.end(), {kRevealSteps, kRevealAnswer});
  state.shows = {"caption"};
  if (table.has("shows")) state.shows = read_names(table, "shows", 0, parts);
  table.allow("shows");
  state.reveal = read_names(table, "reveal", 0, reveals);
  for (const std::string& one : state.reveal)
    if (is_among(state.shows, one)) table.wrong("reveal", "names " + one + ", which is shown from the start");
}

void read_hash(TomlTable& table, DemoState& state) {
  const std::string text = table.text_or("hash", "");
  std::uint64_t hash = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hash, 16);
  if (text.size() == kHashDigits && error == std::errc{} && end == text.data() + text.size()) state.hash = hash;
  else if (!text.empty()) table.wrong("hash", "must be 16 hexadecimal digits, as `snug demo check --write` writes it");
}

DemoState read_state(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[state]]", complaints);
  DemoState state;
  state.place = table.place();
  for (const auto& [key, node] : toml) state.places.emplace_back(std::string(key.str()), file_place(node));
  state.lesson = table.text("lesson");
  state.situation = table.text_or("situation", "");
  state.algorithm = table.text_or("algorithm", "");
  if (table.has("compare")) {
    state.beside = table.text("compare");
    if (*state.beside == "none") state.beside = "";
  }
  table.allow("compare");
  state.scalar = table.text_or("scalar", "");
  check_name(table, "scalar", state.scalar, std::array<std::string_view, 2>{"float", "double"});
  if (table.has("seed")) state.seed = static_cast<std::uint64_t>(table.integer("seed", 0, std::int64_t{1} << 53));
  table.allow("seed");
  state.from = table.text_or("from", "");
  if (const Rows places = read_rows(table, "sliders"); places.size() == 1) state.sliders = places.front();
  else if (!places.empty()) table.wrong("sliders", "must be a number for each slider: \"0.5,2\"");
  if (const Rows camera = read_rows(table, "camera"); !camera.empty()) {
    state.camera = camera.front();
    if (camera.size() > 1 || (state.camera.size() != 3 && state.camera.size() != 6))
      table.wrong("camera", "must be \"height,x,y\" in the plane, and \"yaw,pitch,height,x,y,z\" in space");
  }
  state.rows = read_rows(table, "rows");
  if (const std::string packed = table.text_or("packed", ""); !packed.empty()) {
    if (auto rows = unpacked_rows(packed)) state.rows = *std::move(rows);
    else table.wrong("packed", "is not as an address has it");
  }
  state.moved = read_rows(table, "moved");
  state.step = read_step(table);
  read_shown(table, state);
  state.slide = table.text("slide");
  state.notes = table.text("notes");
  read_hash(table, state);
  table.refuse_others();
  return state;
}

// ---- showing ---------------------------------------------------------------------------------------------------

InputError told(std::string what) { return {.what = std::move(what)}; }

/// The points or the task that an address names: "task", "task:2", "clusters:200", "bunny".
Done take_points(const DemoState& state, Session& session, const MeshOf& mesh) {
  const std::vector<std::string_view> parts = parted(state.from, ':');
  const std::string name(parts.front());
  const auto count = parts.size() > 1 ? number_of(parts[1]) : std::nullopt;
  if (parts.size() > 2 ||
      (parts.size() == 2 && (!count || *count < 1 || *count > 99'999 || *count != std::floor(*count))))
    return tl::unexpected(told("must be a name, or a name and a whole number: \"clusters:200\""));
  if (name == "task") {
    const std::size_t task = count ? static_cast<std::size_t>(*count) : 1, tasks = session.lesson().tasks.size();
    if (task > tasks) return tl::unexpected(told("this lesson has no task " + std::to_string(task)));
    session.start_task(task - 1);
    return {};
  }
  if (count)
    return session.set_generator(name, static_cast<int>(*count), session.dim(),
                                 state.seed.value_or(session.lesson().seed));
  if (!is_among(session.lesson().meshes, name))
    return tl::unexpected(told("this lesson has no points \"" + name + '"'));
  return mesh(name).and_then([&](const io::PointFile& file) { return session.load(file, name); });
}

Done take_moved(const DemoState& state, Session& session) {
  Rows all = session.subject().rows();
  for (std::vector<double> row : state.moved) {
    const double place = row.front();
    if (!(place >= 0 && place < static_cast<double>(all.size())) || place != std::floor(place))
      return tl::unexpected(told("there is no such point"));
    row.erase(row.begin());
    all[static_cast<std::size_t>(place)] = std::move(row);
  }
  return session.set_rows(all);
}

/// Where the line of a place begins in a text.
std::size_t begin_of_line(std::string_view text, int line) {
  std::size_t at = 0;
  for (; line > 1; --line) at = text.find('\n', at) + 1;
  return at;
}

}  // namespace

FilePlace DemoState::place_of(std::string_view key) const {
  for (const auto& [name, at] : places)
    if (name == key) return at;
  return place;
}

DemoDraft read_demo(std::string_view text, std::string_view name) {
  Complaints complaints(name);
  DemoDraft draft;
  draft.demo.id = id_of(name);
  if (const auto toml = parse_file(text, "a demo", complaints)) {
    TomlTable table(*toml, "the demo", complaints);
    if (table.integer("version", 1, 1) != 1) table.wrong("version", "must be 1");
    draft.demo.title = table.text("title");
    draft.demo.lecture = table.text("lecture");
    for (const toml::table* one : table.tables("state")) draft.demo.states.push_back(read_state(*one, complaints));
    if (!table.has("state")) table.lack("state", "the demo lacks a [[state]]");
    table.refuse_others();
  }
  draft.mistakes = complaints.mistakes();
  return draft;
}

tl::expected<void, DemoFault> take_state(const DemoState& state, Session& session, const MeshOf& mesh) {
  std::optional<DemoFault> fault;
  const AtOnce at_once(session);  // each part is taken on what the last one left
  const auto take = [&](bool asked, std::string_view key, const auto& deed) {
    if (fault || !asked) return;
    if (const Done done = deed(); !done) fault = DemoFault{std::string(key), done.error()};
  };
  take(!state.situation.empty(), "situation", [&] { return session.show_situation(state.situation); });
  if (!fault && state.seed && *state.seed != session.lesson().seed) session.scatter(*state.seed);
  take(!state.from.empty(), "from", [&] { return take_points(state, session, mesh); });
  take(!state.scalar.empty(), "scalar", [&] { return session.set_float(state.scalar == "float"); });
  take(!state.sliders.empty(), "sliders", [&] { return session.set_sliders(state.sliders); });
  take(!state.rows.empty(), "rows", [&] { return session.set_rows(state.rows); });
  take(!state.moved.empty(), "moved", [&] { return take_moved(state, session); });
  take(!state.algorithm.empty(), "algorithm", [&] { return stand_at(session, {.algorithm = state.algorithm}); });
  take(state.beside.has_value(), "compare", [&] { return session.choose(1, *state.beside); });
  take(true, "step", [&] { return stand_at(session, {.step = state.step}); });
  if (fault) return tl::unexpected(*std::move(fault));
  return {};
}

std::string_view revealed_text(std::string_view reveal) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kTexts{{{"caption", "the sentence"},
                                                                                 {"prose", "the lesson’s text"},
                                                                                 {"numbers", "the numbers"},
                                                                                 {"code", "the code"},
                                                                                 {kRevealSteps, "the steps, played"},
                                                                                 {kRevealAnswer, "the answer"}}};
  for (const auto& [name, text] : kTexts)
    if (name == reveal) return text;
  return reveal;
}

void pass_questions(Session& session) {
  const int step = session.step();
  for (std::size_t left = 3 * session.questions().size() + 3; left > 0; --left) {
    if (session.asked() != nullptr) session.skip();
    else if (session.deciding() != nullptr) session.decide();
    else if (session.outcome() != nullptr) session.acknowledge();
    else if (session.step() < session.steps()) session.go(session.steps());
    else break;
  }
  // Those of other algorithms as well: until then the numbers keep from the class what they ask for.
  std::vector<Outcome> outcomes = session.outcomes();
  for (Outcome& outcome : outcomes) outcome.passed = false;
  for (const Question& question : session.lesson().questions)
    if (std::none_of(outcomes.begin(), outcomes.end(), [&](const Outcome& one) { return one.question == question.id; }))
      outcomes.push_back({.question = question.id, .skipped = true});
  session.take_up_answers(std::move(outcomes));
  session.close_summary();
  session.jump(step);
}

void reveal_answer(Session& session) {
  if (session.asked() == nullptr) return;
  const std::string question = session.asked()->question->id;
  session.skip();
  session.decide();
  pass_questions(session);
  session.review(question);
}

std::string with_hashes(std::string_view toml, const Demo& demo, const std::vector<std::uint64_t>& hashes) {
  std::string text(toml);
  for (std::size_t i = demo.states.size(); i-- > 0;) {  // from the end, so that the places before stay true
    const DemoState& state = demo.states[i];
    const std::string line = "hash = \"" + hex_of(hashes[i]) + '"';
    if (state.hash) {
      const std::size_t begin = begin_of_line(text, state.place_of("hash").line);
      text.replace(begin, text.find('\n', begin) - begin, line);
    } else {
      text.insert(begin_of_line(text, state.place.line + 1), line + '\n');
    }
  }
  return text;
}

}  // namespace snug::lesson
