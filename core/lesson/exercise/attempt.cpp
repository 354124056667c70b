#include "lesson/exercise/attempt.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "io/text.hpp"

namespace snug::lesson {
namespace {

constexpr std::size_t kMostRows = 10'000;

std::string built_text(const Rows& rows) {
  std::string text;
  for (const std::vector<double>& row : rows) {
    text += text.empty() ? 'b' : ';';
    for (std::size_t i = 0; i < row.size(); ++i) text += (i > 0 ? "," : "") + io::shortest_text(row[i]);
  }
  return text;
}

std::string list_text(const std::vector<int>& list) {
  std::string text;
  for (const int entry : list) text += (text.empty() ? "" : ".") + std::to_string(entry);
  return text;
}

std::string text_of(const Answer& answer) {
  return std::visit(ByKind{
                        [](const Skipped&) { return std::string("s"); },
                        [](const OneHandle& one) { return 'p' + std::to_string(one.handle); },
                        [](const SeveralHandles& several) { return 'l' + list_text(several.handles); },
                        [](const OneChoice& one) { return 'c' + std::to_string(one.choice); },
                        [](const SeveralChoices& several) { return 'c' + std::to_string(choice_bits(several)); },
                        [](const ChoicesInOrder& all) { return 'o' + list_text(all.choices); },
                        [](const TypedNumber& typed) { return 'n' + io::shortest_text(typed.number); },
                    },
                    answer);
}

std::optional<int> whole_of(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 0) return std::nullopt;
  return value;
}

/// Cuts off what stands before a separator, or all.
std::string_view take_until(std::string_view& rest, char separator) {
  const std::size_t at = rest.find(separator);
  const std::string_view part = rest.substr(0, at);
  rest.remove_prefix(at == std::string_view::npos ? rest.size() : at + 1);
  return part;
}

/// None if it is no list of rows of numbers.
std::optional<Rows> rows_of(std::string_view text) {
  Rows rows;
  while (!text.empty()) {
    std::string_view row = take_until(text, ';');
    rows.emplace_back();
    while (!row.empty()) {
      const auto number = io::parse_number(take_until(row, ','));
      if (!number || !std::isfinite(*number) || rows.size() > kMostRows || rows.back().size() > kMostRows)
        return std::nullopt;
      rows.back().push_back(*number);
    }
  }
  return rows;
}

std::optional<Answer> answer_of(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const char kind = text.front();
  text.remove_prefix(1);
  if (kind == 's') return text.empty() ? std::optional(Answer()) : std::nullopt;
  if (kind == 'p' || kind == 'c') {
    const auto value = whole_of(text);
    if (!value) return std::nullopt;
    return kind == 'p' ? Answer(OneHandle{*value}) : OneChoice{*value};
  }
  if (kind == 'n') {
    const auto number = io::parse_number(text);
    return number && std::isfinite(*number) ? std::optional<Answer>(TypedNumber{*number}) : std::nullopt;
  }
  if (kind != 'l' && kind != 'o') return std::nullopt;
  std::vector<int> list;
  while (!text.empty()) {
    const auto entry = whole_of(take_until(text, '.'));
    if (!entry) return std::nullopt;
    list.push_back(*entry);
  }
  return kind == 'l' ? Answer(SeveralHandles{std::move(list)}) : ChoicesInOrder{std::move(list)};
}

}  // namespace

int Attempt::hints() const {
  int all = 0;
  for (const Made& one : made) all += one.hints;
  return all;
}

double Attempt::seconds() const {
  double last = 0;
  for (const Made& one : made) last = std::max(last, one.seconds);
  return last;
}

std::string text_of(const Made& made) {
  std::string text(static_cast<std::size_t>(made.hints), '?');
  text += built_text(made.built);
  for (std::size_t i = 0; i < made.tries.size(); ++i) text += (i > 0 ? ">" : "") + text_of(made.tries[i]);
  std::array<char, 32> seconds{};
  std::snprintf(seconds.data(), seconds.size(), "@%.1f", made.seconds);
  return text += seconds.data();
}

tl::expected<Made, InputError> made_of(std::string_view text) {
  const auto wrong = tl::unexpected(InputError{.what = "is no decision: \"" + std::string(text) + '"'});
  Made made;
  std::string_view rest = text;
  for (; rest.starts_with('?'); rest.remove_prefix(1)) ++made.hints;
  std::string_view tries = take_until(rest, '@');
  const auto seconds = io::parse_number(rest);
  if (made.hints > kMostHints || !seconds || !(*seconds >= 0) || !std::isfinite(*seconds)) return wrong;
  made.seconds = *seconds;
  if (tries.starts_with('b')) {
    auto rows = rows_of(tries.substr(1));
    if (!rows || rows->empty()) return wrong;
    made.built = *std::move(rows);
    return made;
  }
  while (!tries.empty()) {
    const auto answer = answer_of(take_until(tries, '>'));
    if (!answer || made.tries.size() == 2) return wrong;
    made.tries.push_back(*answer);
  }
  if (made.tries.empty() && made.hints == 0) return wrong;
  return made;
}

}  // namespace snug::lesson
