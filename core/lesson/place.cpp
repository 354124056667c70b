#include "lesson/place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/text.hpp"
#include "lesson/packed_rows.hpp"

namespace snug::lesson {
namespace {

using Part = PlaceKey::Part;

constexpr std::size_t kMostPacked = 6000;  // numbers: what is packed has 66,000 letters then, more than Firefox shows
constexpr std::int64_t kMostWhole = std::int64_t{1} << 53;
constexpr std::string_view kEnd = "end", kNone = "none";

// ---- writing ---------------------------------------------------------------------------------------------------

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

/// Escapes a text as encodeURIComponent does, but keeps the characters that an address's rows are made of.
std::string address_text(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string safe;
  for (const char c : text) {
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (plain || std::string_view("-_.!~*'(),;:").find(c) != std::string_view::npos) safe += c;
    else safe += {'%', kDigits[static_cast<unsigned char>(c) >> 4], kDigits[c & 15]};
  }
  return safe;
}

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

int digit_of(char c) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  const std::size_t at = kDigits.find(c >= 'A' && c <= 'F' ? static_cast<char>(c - 'A' + 'a') : c);
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

std::string unescaped(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool escaped =
        text[i] == '%' && i + 2 < text.size() && digit_of(text[i + 1]) >= 0 && digit_of(text[i + 2]) >= 0;
    if (!escaped) {
      plain += text[i] == '+' ? ' ' : text[i];
      continue;
    }
    plain += static_cast<char>(16 * digit_of(text[i + 1]) + digit_of(text[i + 2]));
    i += 2;
  }
  return plain;
}

/// None if it holds anything but rows of numbers: "1,2;3,4".
std::optional<Rows> rows_in(std::string_view text) {
  Rows rows;
  for (const std::string_view row : parted(text, ';')) {
    std::vector<double>& numbers = rows.emplace_back();
    for (const std::string_view word : parted(row, ',')) {
      const auto number = io::parse_number(word);
      if (!number || !std::isfinite(*number)) return std::nullopt;
      numbers.push_back(*number);
    }
  }
  return rows;
}

std::string read_rows(Rows& rows, const std::string& text) {
  auto read = rows_in(text);
  if (!read) return "must be rows of numbers: \"1,2;3,4\"";
  rows = *std::move(read);
  return {};
}

std::string read_row(std::vector<double>& row, const std::string& text) {
  Rows rows;
  if (!read_rows(rows, text).empty() || rows.size() != 1) return "must be numbers: \"0.5,2\"";
  row = std::move(rows.front());
  return {};
}

std::string read_packed(Rows& rows, const std::string& text) {
  auto read = unpacked_rows(text);
  if (!read) return "is not as an address has it";
  rows = *std::move(read);
  return {};
}

std::string read_camera(std::vector<double>& camera, const std::string& text) {
  std::vector<double> read;
  if (!read_row(read, text).empty() || (read.size() != 3 && read.size() != 6))
    return "must be \"height,x,y\" in the plane, and \"yaw,pitch,height,x,y,z\" in space";
  camera = std::move(read);
  return {};
}

template <class Whole>
std::string read_whole(std::optional<Whole>& number, const std::string& text, std::int64_t most) {
  const auto read = io::parse_integer(text);
  if (!read || *read < 0 || *read >= most || text.find_first_not_of("0123456789") != std::string::npos)
    return "must be a whole number";
  number = static_cast<Whole>(*read);
  return {};
}

std::string read_step(std::optional<int>& step, const std::string& text) {
  if (text != kEnd) return read_whole(step, text, std::numeric_limits<int>::max());
  step = Place::kLastStep;
  return {};
}

}  // namespace

std::optional<SourceWords> source_in(std::string_view from) {
  constexpr std::int64_t kMostNumber = 99'999;
  const std::vector<std::string_view> parts = parted(from, ':');
  const auto number = parts.size() == 2 ? io::parse_integer(parts[1]) : std::nullopt;
  const bool is_name = parts.front().find_first_not_of("abcdefghijklmnopqrstuvwxyz") == std::string_view::npos;
  if (!is_name || parts.front().empty() || parts.size() > 2) return std::nullopt;
  if (parts.size() == 2 && (!number || *number < 1 || *number > kMostNumber)) return std::nullopt;
  return SourceWords{parts.front(), number ? std::optional(static_cast<int>(*number)) : std::nullopt};
}

bool Place::is_bare() const {
  return std::all_of(kPlaceKeys.begin() + 1, kPlaceKeys.end(),
                     [&](const PlaceKey& key) { return text_of(*this, key.part).empty(); });
}

bool operator==(const Place& a, const Place& b) {
  return std::all_of(kPlaceKeys.begin(), kPlaceKeys.end(),
                     [&](const PlaceKey& key) { return text_of(a, key.part) == text_of(b, key.part); });
}

std::string text_of(const Place& place, PlaceKey::Part part) {
  const bool plain = place.rows.size() <= kMostPlainRows;
  switch (part) {
    case Part::kLesson: return place.lesson;
    case Part::kStep:
      return !place.step ? "" : *place.step == Place::kLastStep ? kEnd.data() : std::to_string(*place.step);
    case Part::kSeed: return place.seed ? std::to_string(*place.seed) : "";
    case Part::kSituation: return place.situation;
    case Part::kAlgorithm: return place.algorithm;
    case Part::kBeside: return !place.beside ? "" : place.beside->empty() ? kNone.data() : *place.beside;
    case Part::kScalar: return place.scalar;
    case Part::kFrom: return place.from;
    case Part::kSliders: return row_words(place.sliders);
    case Part::kMoved: return rows_words(place.moved);
    case Part::kRows: return plain ? rows_words(place.rows) : "";
    case Part::kPacked: return plain ? "" : packed_rows(place.rows);
    case Part::kCamera: return row_words(place.camera);
    case Part::kFile: return place.file;
    case Part::kDraft: return place.draft;
    case Part::kQuestion: return place.question;
    case Part::kAnswered: return place.answered ? "1" : "";
  }
  return {};
}

std::string read_text(Place& place, PlaceKey::Part part, const std::string& text) {
  std::string* words = nullptr;
  switch (part) {
    case Part::kStep: return read_step(place.step, text);
    case Part::kSeed: return read_whole(place.seed, text, kMostWhole);
    case Part::kSliders: return read_row(place.sliders, text);
    case Part::kMoved: return read_rows(place.moved, text);
    case Part::kRows: return read_rows(place.rows, text);
    case Part::kCamera: return read_camera(place.camera, text);
    case Part::kPacked: return read_packed(place.rows, text);
    case Part::kBeside: place.beside = text == kNone ? "" : text; return {};
    case Part::kAnswered: place.answered = text == "1"; return {};
    case Part::kScalar:
      if (text != "float" && text != "double") return "must be float or double";
      words = &place.scalar;
      break;
    case Part::kFrom:
      if (!source_in(text)) return "must be a name, or a name and a whole number: \"clusters:200\"";
      words = &place.from;
      break;
    case Part::kLesson: words = &place.lesson; break;
    case Part::kSituation: words = &place.situation; break;
    case Part::kAlgorithm: words = &place.algorithm; break;
    case Part::kFile: words = &place.file; break;
    case Part::kDraft: words = &place.draft; break;
    case Part::kQuestion: words = &place.question; break;
  }
  *words = text;
  return {};
}

bool fits_address(const Place& place) {
  std::size_t numbers = 0;
  for (const std::vector<double>& row : place.rows) numbers += row.size();
  return place.rows.size() <= kMostPlainRows || numbers <= kMostPacked;
}

std::string address_of(const Place& place) {
  std::string address, packed;
  for (const PlaceKey& key : kPlaceKeys) {
    if (key.part == Part::kPacked && !fits_address(place)) continue;
    const std::string text = text_of(place, key.part);
    if (text.empty()) continue;
    const std::string part = std::string(key.in_address) + '=' + address_text(text);
    if (key.part == Part::kPacked) packed = '#' + part;
    else address += (address.empty() ? '?' : '&') + part;
  }
  return address + packed;
}

PlaceRead read_place(std::string_view address) {
  PlaceRead read;
  if (address.starts_with('?')) address.remove_prefix(1);
  while (!address.empty()) {
    const std::size_t end = std::min(address.find_first_of("&#"), address.size());
    const std::string_view part = address.substr(0, end);
    address.remove_prefix(std::min(end + 1, address.size()));
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string name = unescaped(part.substr(0, equals));
    const std::string text = unescaped(part.substr(std::min(equals + 1, part.size())));
    const std::string_view known =
        name == "points" || name == "boxes" ? "rows" : std::string_view(name);  // links of old
    for (const PlaceKey& key : kPlaceKeys) {
      if (key.in_address != known || text.empty()) continue;
      const std::string wrong = read_text(read.place, key.part, text);
      if (!wrong.empty())
        read.problems.push_back("The address has " + name + ' ' + io::quoted(text) + ", which " + wrong + '.');
    }
  }
  return read;
}

}  // namespace snug::lesson
