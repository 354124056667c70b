#include "lesson/demo.hpp"

#include <algorithm>
#include <charconv>

#include "lesson/demo_reveal.hpp"
#include "lesson/names.hpp"
#include "lesson/read_lesson.hpp"
#include "lesson/toml_file.hpp"
#include "number/fnv.hpp"

namespace snug::lesson {
namespace {

constexpr int kMostDemoSteps = 1'000'000;
constexpr std::size_t kHashDigits = 16;

// ---- reading ---------------------------------------------------------------------------------------------------

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

/// Reads the keys of a place, texts as an address has them.
void read_place_keys(TomlTable& table, Place& place) {
  for (const PlaceKey& key : kPlaceKeys) {
    if (key.in_file == "step" && !table.is("step", "end")) {
      const auto step = static_cast<int>(table.integer_or("step", 0, kMostDemoSteps, 0));
      if (table.has("step") || !table.has("question")) place.step = step;
    } else if (key.in_file == "seed") {
      if (table.has("seed")) place.seed = static_cast<std::uint64_t>(table.integer("seed", 0, std::int64_t{1} << 53));
      table.allow("seed");
    } else if (const std::string text = table.text_or(key.in_file, ""); !text.empty()) {
      if (const std::string wrong = read_text(place, key.part, text); !wrong.empty()) table.wrong(key.in_file, wrong);
    }
  }
}

/// A file breaks its lines where it likes.
std::string in_one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool is_space = c == ' ' || c == '\n' || c == '\r' || c == '\t';
    if (!is_space) line += c;
    else if (!line.empty() && line.back() != ' ') line += ' ';
  }
  while (!line.empty() && line.back() == ' ') line.pop_back();
  return line;
}

DemoState read_state(const toml::table& toml, Complaints& complaints) {
  TomlTable table(toml, "[[state]]", complaints);
  DemoState state;
  state.place = table.place();
  state.in_braces = toml.is_inline();
  for (const auto& [key, node] : toml) state.places.emplace_back(std::string(key.str()), file_place(node));
  state.lesson = table.text("lesson");
  read_place_keys(table, state);
  read_shown(table, state);
  state.slide = table.text("slide");
  state.notes = in_one_line(table.text("notes"));
  read_hash(table, state);
  table.refuse_others();
  return state;
}

/// A TOML string with this text.
std::string toml_text(std::string_view text) {
  std::string safe = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') safe += '\\';
    if (c == '\n') safe += "\\n";
    else if (static_cast<unsigned char>(c) >= 0x20) safe += c;
  }
  return safe + '"';
}

/// Where the line of a place begins in a text.
std::size_t begin_of_line(std::string_view text, int line) {
  std::size_t at = 0;
  for (; line > 1; --line) at = text.find('\n', at) + 1;
  return at;
}

/// Where the digits of a hash begin, of which only the line is known in bytes: after its key, whatever quotes they
/// stand in.
std::size_t begin_of_digits(std::string_view text, int line) {
  const std::size_t equals = text.find('=', begin_of_line(text, line));
  return text.find_first_not_of("= \t\r\n\"'", equals);
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

std::string state_text(const Place& place, std::string_view title, std::uint64_t hash) {
  std::string text = "[[state]]\nhash = " + toml_text(hex_of(hash)) + "\nslide = " + toml_text(title) + '\n';
  for (const PlaceKey& key : kPlaceKeys) {
    const std::string value = text_of(place, key.part);
    if (value.empty()) continue;
    const bool is_number = key.is_number && value.find_first_not_of("0123456789") == std::string::npos;
    text += std::string(key.in_file) + " = " + (is_number ? value : toml_text(value)) + '\n';
  }
  return text + "shows = [\"caption\", \"numbers\", \"code\"]\nnotes = \"What you say.\"\n";
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
  const int step = session.player().step();
  for (std::size_t left = 3 * session.conversation().questions().size() + 3; left > 0; --left) {
    if (session.conversation().asked() != nullptr) session.conversation().give({}, false);
    else if (session.conversation().deciding() != nullptr) session.conversation().decide();
    else if (session.conversation().outcome() != nullptr) session.conversation().acknowledge();
    else if (session.player().step() < session.player().steps()) session.go(session.player().steps());
    else break;
  }
  // Those of other algorithms as well: until then the numbers keep from the class what they ask for.
  std::vector<Outcome> outcomes = session.log().outcomes();
  for (Outcome& outcome : outcomes) outcome.passed = false;
  for (const Question& question : session.lesson().questions)
    if (std::none_of(outcomes.begin(), outcomes.end(), [&](const Outcome& one) { return one.question == question.id; }))
      outcomes.push_back({.question = question.id, .skipped = true});
  session.take_up(std::move(outcomes));
  session.conversation().close_summary();
  session.jump(step);
}

void reveal_answer(Session& session) {
  if (session.conversation().asked() == nullptr) return;
  const std::string question = session.conversation().asked()->question->id;
  session.conversation().give({}, false);
  session.conversation().decide();
  pass_questions(session);
  session.conversation().review(question);
}

tl::expected<std::string, FileError> with_hashes(std::string_view toml, const Demo& demo,
                                                 const std::vector<std::uint64_t>& hashes) {
  for (const DemoState& state : demo.states)
    if (state.in_braces)
      return tl::unexpected(
          FileError{state.place, "a state in braces has no line for its hash: write it as [[state]]"});
  std::string text(toml);
  for (std::size_t i = demo.states.size(); i-- > 0;) {  // from the end, so that the places before stay true
    const DemoState& state = demo.states[i];
    const std::string digits = hex_of(hashes[i]);
    if (state.hash) {
      const std::size_t begin = begin_of_digits(text, state.place_of("hash").line);
      if (begin != std::string::npos) text.replace(begin, kHashDigits, digits);
    } else {
      const std::size_t begin = begin_of_line(text, state.place.line + 1);
      const bool has_cr = begin >= 2 && text[begin - 2] == '\r';
      text.insert(begin, "hash = \"" + digits + (has_cr ? "\"\r\n" : "\"\n"));
    }
  }
  // Nothing is written over a file unless it reads as it should.
  const DemoDraft after = read_demo(text, demo.id);
  const bool is_demo = after.mistakes.empty() && after.demo.states.size() == demo.states.size();
  for (std::size_t i = 0; i < demo.states.size(); ++i)
    if (!is_demo || after.demo.states[i].hash != hashes[i])
      return tl::unexpected(
          FileError{demo.states[i].place_of("hash"),
                    "the hash cannot be written here: write it as hash = \"" + hex_of(hashes[i]) + '"'});
  return text;
}

}  // namespace snug::lesson
