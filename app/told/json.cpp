#include "app/told/json.hpp"

#include <cmath>

#include "io/text.hpp"

namespace snug::app::told {
namespace {

constexpr double kWholeBelow = 1e15;  // such a whole number is written as one, which takes a tenth of the time

void separate(std::string& json) {
  if (!json.empty() && std::string_view("{[:,").find(json.back()) == std::string_view::npos) json += ',';
}

void add_quoted(std::string& json, std::string_view text) {
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') json += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) {
      json += c;
    } else {
      json += "\\u00";
      json += "01"[c >> 4];
      json += "0123456789abcdef"[c & 15];
    }
  }
  json += '"';
}

}  // namespace

void write_word(std::string& json, std::string_view word) {
  separate(json);
  json += word;
}

void write_text(std::string& json, std::string_view text) {
  separate(json);
  add_quoted(json, text);
}

void write_whole(std::string& json, std::int64_t number) { write_word(json, std::to_string(number)); }
void write_whole(std::string& json, std::uint64_t number) { write_word(json, std::to_string(number)); }

void write_number(std::string& json, double number) {
  if (!std::isfinite(number)) return write_word(json, "null");
  const bool whole = std::abs(number) < kWholeBelow && std::trunc(number) == number;
  if (whole && !(number == 0 && std::signbit(number))) return write_whole(json, static_cast<std::int64_t>(number));
  write_word(json, io::shortest_text(number));
}

void write_begin(std::string& json, char bracket) {
  separate(json);
  json += bracket;
}

void write_name(std::string& json, std::string_view name) {
  separate(json);
  add_quoted(json, name);
  json += ':';
}

void write_fields(std::string& json, std::span<const std::string_view> fields, const void* const* values,
                  const WriteAny* writes) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t before = json.size();
    write_name(json, camel_case(fields[i]));
    const std::size_t named = json.size();
    writes[i](json, values[i]);
    if (json.size() == named) json.resize(before);
  }
}

void write_list(std::string& json, const void* first, std::size_t count, std::size_t stride, WriteAny write) {
  write_begin(json, '[');
  for (std::size_t i = 0; i < count; ++i) write(json, static_cast<const char*>(first) + i * stride);
  json += ']';
}

std::string camel_case(std::string_view field) {
  std::string name;
  for (std::size_t i = 0; i < field.size(); ++i)
    if (field[i] != '_') name += i > 0 && field[i - 1] == '_' ? static_cast<char>(field[i] - 'a' + 'A') : field[i];
  return name;
}

}  // namespace snug::app::told
