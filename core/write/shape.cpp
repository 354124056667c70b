#include "write/shape.hpp"

#include <algorithm>
#include <cmath>

#include "io/text.hpp"

namespace snug::write {
namespace {

/// A number as a word. A finite one is the shortest text that reads back.
std::string number_word(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  return io::shortest_text(value);
}

/// A list of any length within the numbers.
struct List {
  std::size_t length_at = 0;          // where its length stands
  std::vector<std::size_t> elements;  // where each begins, and where the last ends
};

/// Walks through numbers as a shape says.
class Walk {
 public:
  Walk(std::string_view shape, const Numbers& numbers) : rest_(shape), numbers_(numbers) {}

  void run() { type(); }
  [[nodiscard]] bool fits() const { return sound_ && at_ == numbers_.size(); }
  [[nodiscard]] const std::string& json() const { return json_; }
  [[nodiscard]] const std::vector<List>& lists() const { return lists_; }

 private:
  [[nodiscard]] char next() const { return rest_.empty() ? '\0' : rest_.front(); }
  void skip() { rest_.remove_prefix(1); }
  double take() {
    if (at_ < numbers_.size()) return numbers_[at_++];
    sound_ = false;
    return 0;
  }
  std::string_view word() {
    const std::string_view found = rest_.substr(0, rest_.find_first_of(":|,}"));
    rest_.remove_prefix(found.size());
    return found;
  }

  void type() {
    if (next() == '{') return object();
    if (next() == '*') return list();
    if (next() >= '0' && next() <= '9') return fixed();
    const std::string_view name = word();
    if (next() == '|') return choice(name);
    if (name == "b") json_ += take() != 0 ? "true" : "false";
    else json_ += number_word(take());
  }

  void object() {
    json_ += '{';
    while (next() != '}') {
      skip();  // the brace or the comma
      if (json_.back() != '{') json_ += ',';
      json_ += '"' + std::string(word()) + "\":";
      skip();  // the colon
      type();
    }
    skip();
    json_ += '}';
  }

  /// The same type so many times.
  template <class Between>
  void repeat(int count, Between&& between) {
    const std::string_view element = rest_;
    json_ += '[';
    for (int i = 0; i < count; ++i) {
      if (i > 0) json_ += ',';
      rest_ = element;
      between();
      type();
    }
    if (count == 0) {  // what is not there is passed over
      const std::string before = json_;
      const Numbers none;
      Walk passed(element, none);
      passed.type();
      rest_ = passed.rest_;
    }
    json_ += ']';
  }

  void fixed() {
    const int count = next() - '0';
    skip();
    repeat(count, [] {});
  }

  void list() {
    skip();
    List own{.length_at = at_, .elements = {}};
    const double length = take();
    const auto left = static_cast<double>(numbers_.size() - at_);
    sound_ = sound_ && length >= 0 && length == std::floor(length) && length <= left;
    repeat(sound_ ? static_cast<int>(length) : 0, [&] { own.elements.push_back(at_); });
    own.elements.push_back(at_);
    lists_.push_back(std::move(own));
  }

  void choice(std::string_view first) {
    std::vector<std::string_view> words{first};
    while (next() == '|') {
      skip();
      words.push_back(word());
    }
    const double chosen = take();
    const bool known = chosen >= 0 && chosen < static_cast<double>(words.size());
    sound_ = sound_ && known;
    json_ += '"' + std::string(known ? words[static_cast<std::size_t>(chosen)] : "") + '"';
  }

  std::string_view rest_;
  const Numbers& numbers_;
  std::size_t at_ = 0;
  bool sound_ = true;
  std::string json_;
  std::vector<List> lists_;
};

}  // namespace

std::string json_of(std::string_view shape, const Numbers& numbers) {
  Walk walk(shape, numbers);
  walk.run();
  return walk.json();
}

bool fits(std::string_view shape, const Numbers& numbers) {
  Walk walk(shape, numbers);
  walk.run();
  return walk.fits();
}

std::vector<Numbers> simpler(std::string_view shape, const Numbers& numbers) {
  Walk walk(shape, numbers);
  walk.run();
  std::vector<Numbers> found;
  std::vector<bool> is_length(numbers.size());
  for (const List& list : walk.lists()) {
    is_length[list.length_at] = true;
    for (std::size_t i = 0; i + 1 < list.elements.size(); ++i) {
      Numbers fewer = numbers;
      fewer[list.length_at] -= 1;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(list.elements[i]),
                  fewer.begin() + static_cast<std::ptrdiff_t>(list.elements[i + 1]));
      found.push_back(std::move(fewer));
    }
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (is_length[i]) continue;
    const double value = numbers[i];
    for (const double other : {0.0, std::copysign(1.0, value), std::round(value), std::round(value / 2)}) {
      if (other == value && std::signbit(other) == std::signbit(value)) continue;
      if (std::abs(other) > 2 * std::abs(value)) continue;                    // what is tiny stays so
      if (std::abs(value) > 0x1p30 && std::abs(other - value) > 1) continue;  // and what is far away
      found.push_back(numbers);
      found.back()[i] = other;
    }
  }
  return found;
}

}  // namespace snug::write
