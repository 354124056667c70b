// What only a lecture needs, as a small program of its own: the class's votes and the code of a state, from the core.
// Only a vote and a code load it (page/lecture.js).
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <charconv>
#include <map>
#include <string>

#include "lesson/qr.hpp"
#include "lesson/vote.hpp"

namespace snug::web {
namespace {

using emscripten::val;

/// The votes, by the state of the demo in which they were taken.
std::map<int, lesson::Vote>& votes() {
  static std::map<int, lesson::Vote> all;
  return all;
}

std::vector<std::string> texts(const val& list) { return emscripten::vecFromJSArray<std::string>(list); }

/// Takes a key for the vote on a state's question, which begins with it. Returns whether it was one.
bool vote_key(int state, const std::string& key, const val& choices, const val& places) {
  if (const auto vote = votes().find(state); vote != votes().end()) return vote->second.take_key(key);
  lesson::Vote fresh(texts(choices), texts(places));
  return fresh.take_key(key) && votes().emplace(state, std::move(fresh)).second;
}

/// {hidden, told, rows: [{name, words, text, percents: [first, second]}]}, a vote that was not taken as -1; null
/// without one.
val vote_of(int state) {
  const auto found = votes().find(state);
  if (found == votes().end()) return val::null();
  const lesson::Vote& vote = found->second;
  val object = val::object(), rows = val::array();
  for (const lesson::VoteRow& row : vote.rows()) {
    val one = val::object(), percents = val::array();
    for (int round = 0; round < 2; ++round)
      percents.call<void>("push", vote.counted(round) ? vote.percent(row, round) : -1);
    one.set("name", row.name);
    one.set("words", row.words);
    one.set("text", vote.row_text(row));
    one.set("percents", percents);
    rows.call<void>("push", one);
  }
  object.set("hidden", vote.hidden_text());
  object.set("told", vote.told_text());
  object.set("rows", rows);
  return object;
}

/// {size, quiet, dark: "0110…"} row by row; null if the text is too long.
val qr_code(const std::string& text) {
  const auto code = lesson::qr_code(text);
  if (!code) return val::null();
  std::string dark;
  for (const bool one : code->dark) dark += one ? '1' : '0';
  val object = val::object();
  object.set("size", code->size);
  object.set("quiet", lesson::kQuietZone);
  object.set("dark", dark);
  return object;
}

/// trace: sixteen hexadecimal digits.
std::string fingerprint(const std::string& trace) {
  std::uint64_t hash = 0;
  std::from_chars(trace.data(), trace.data() + trace.size(), hash, 16);
  return lesson::fingerprint(hash);
}

}  // namespace

EMSCRIPTEN_BINDINGS(lecture) {
  using emscripten::function;
  function("vote_key", &vote_key);
  function("vote_of", &vote_of);
  function("qr_code", &qr_code);
  function("fingerprint", &fingerprint);
}

}  // namespace snug::web
