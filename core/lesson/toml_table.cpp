#include "lesson/toml_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "geometry/sort.hpp"
#include "io/text.hpp"
#include "lesson/names.hpp"

namespace snug::lesson {
namespace {

/// Each once: what is wrong in two situations is found twice.
std::vector<FileError> in_order(std::vector<FileError> errors) {
  const auto place = [](const FileError& one) { return std::tie(one.place.line, one.place.column); };
  sort_stably(errors, [&](const auto& a, const auto& b) { return place(a) < place(b); });
  const auto same = [&](const auto& a, const auto& b) { return place(a) == place(b) && a.what == b.what; };
  errors.erase(std::unique(errors.begin(), errors.end(), same), errors.end());
  return errors;
}

std::string in_quotes(std::string_view key) { return '"' + std::string(key) + '"'; }

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

}  // namespace

FilePlace file_place(const toml::source_region& region) {
  return {std::max(static_cast<int>(region.begin.line), 1), std::max(static_cast<int>(region.begin.column), 1)};
}

void Complaints::add(FilePlace place, std::string what) { mistakes_.push_back({place, std::move(what), file_}); }
bool Complaints::has_at(FilePlace place) const {
  return std::any_of(mistakes_.begin(), mistakes_.end(), [&](const FileError& one) {
    return one.place.line == place.line && one.place.column == place.column;
  });
}
void Complaints::warn(FilePlace place, std::string what) { warnings_.push_back({place, std::move(what), file_}); }
std::vector<FileError> Complaints::mistakes() const { return in_order(mistakes_); }
std::vector<FileError> Complaints::warnings() const { return in_order(warnings_); }

TomlTable::TomlTable(const toml::table& table, std::string name, Complaints& complaints)
    : table_(table), name_(std::move(name)), complaints_(complaints), place_(file_place(table)) {}

const toml::node* TomlTable::find(std::string_view key) {
  asked_.emplace_back(key);
  return table_.get(key);
}

bool TomlTable::is(std::string_view key, std::string_view text) {
  const auto* value = table_[key].as_string();
  if (value == nullptr || value->get() != text) return false;
  asked_.emplace_back(key);
  return true;
}

const toml::node* TomlTable::require(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) lack(key, name_ + " lacks the key " + in_quotes(key));
  return node;
}

FilePlace TomlTable::place_of(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node != nullptr ? file_place(*node) : place_;
}

void TomlTable::lack(std::string_view key, std::string what) {
  if (is_among(missing_, key)) return;
  missing_.emplace_back(key), missing_says_.push_back(std::move(what));
}

void TomlTable::wrong(std::string_view key, const std::string& what) {
  const FilePlace place = place_of(key);
  if (is_among(missing_, key)) return;  // that it is missing says enough
  if (!has(key) || !complaints_.has_at(place)) complaints_.add(place, in_quotes(key) + " " + what);
}

std::string TomlTable::text(std::string_view key) {
  const toml::node* node = require(key);
  if (node == nullptr) return {};
  const auto* value = node->as_string();
  std::string text = value != nullptr ? trimmed(value->get()) : std::string();
  if (text.empty()) wrong(key, value != nullptr ? "is empty" : "must be a text in quotes");
  return text;
}

std::string TomlTable::text_or(std::string_view key, std::string_view otherwise) {
  asked_.emplace_back(key);
  return has(key) ? text(key) : std::string(otherwise);
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t least, std::int64_t most) {
  const toml::node* node = require(key);
  if (node == nullptr) return least;
  const auto* value = node->as_integer();
  if (value == nullptr) return wrong(key, "must be a whole number"), least;
  if (value->get() < least || value->get() > most) {
    wrong(key, "must be from " + std::to_string(least) + " to " + std::to_string(most));
    return least;
  }
  return value->get();
}

std::int64_t TomlTable::integer_or(std::string_view key, std::int64_t least, std::int64_t most,
                                   std::int64_t otherwise) {
  asked_.emplace_back(key);
  return has(key) ? integer(key, least, most) : otherwise;
}

double TomlTable::number(std::string_view key, double most) {
  const toml::node* node = require(key);
  if (node == nullptr) return 1;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  if (!value) return wrong(key, "must be a number"), 1;
  if (!(*value > 0 && *value <= most)) {
    const bool is_whole = most == std::floor(most);  // "1000000000", and not "1e+09"
    wrong(key, "must be above 0 and at most " +
                   (is_whole ? std::to_string(static_cast<std::int64_t>(most)) : io::shortest_text(most)));
    return 1;
  }
  return *value;
}

double TomlTable::any_number(std::string_view key, double otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  const auto value = node->is_number() ? node->value<double>() : std::nullopt;
  return value ? *value : (wrong(key, "must be a number"), otherwise);
}

bool TomlTable::flag_or(std::string_view key, bool otherwise) {
  const toml::node* node = find(key);
  if (node == nullptr) return otherwise;
  const auto* value = node->as_boolean();
  if (value == nullptr) return wrong(key, "must be true or false"), otherwise;
  return value->get();
}

std::vector<std::string> TomlTable::texts(std::string_view key, std::size_t least) {
  std::vector<std::string> all;
  const toml::node* node = least > 0 ? require(key) : find(key);
  if (node == nullptr) return all;
  const toml::array* array = node->as_array();
  if (array == nullptr) return wrong(key, "must be a list of texts"), all;
  for (const toml::node& item : *array) {
    const auto* value = item.as_string();
    if (value == nullptr) {
      complaints_.add(file_place(item), in_quotes(key) + " must be a list of texts");
      return all;
    }
    all.push_back(value->get());
  }
  if (all.size() < least) wrong(key, "needs at least " + std::to_string(least) + (least == 1 ? " text" : " texts"));
  return all;
}

std::vector<double> TomlTable::numbers(std::string_view key) {
  std::vector<double> all;
  const toml::node* node = require(key);
  if (node == nullptr) return all;
  const auto add = [&](const toml::node& one) {
    const auto value = one.is_number() ? one.value<double>() : std::nullopt;
    if (value) all.push_back(*value);
    return value.has_value();
  };
  const toml::array* list = node->as_array();
  if (list != nullptr ? !std::all_of(list->begin(), list->end(), add) : !add(*node))
    wrong(key, "must be a number or numbers");
  return all;
}

std::vector<Vector<double, 3>> TomlTable::points(std::string_view key, int dim) {
  std::vector<Vector<double, 3>> all;
  const toml::node* node = require(key);
  if (node == nullptr) return all;
  const toml::array* array = node->as_array();
  if (array == nullptr || array->empty()) return wrong(key, "must be a list of points"), all;
  for (const toml::node& item : *array) {
    const toml::array* numbers = item.as_array();
    Vector<double, 3> point = Vector<double, 3>::Zero();
    bool good = numbers != nullptr && numbers->size() == static_cast<std::size_t>(dim);
    for (int i = 0; good && i < dim; ++i) {
      const toml::node* number = numbers->get(i);
      point[i] = number->is_number() ? number->value_or(std::nan("")) : std::nan("");  // none: beyond double's integers
      good = std::isfinite(point[i]);
    }
    if (!good) {
      const char* form = dim == 3   ? "3 finite numbers: [x, y, z]"
                         : dim == 2 ? "2 finite numbers: [x, y]"
                                    : "one finite number: [x]";
      complaints_.add(file_place(item), "each of " + in_quotes(key) + " must be a point of " + form);
      return all;
    }
    all.push_back(point);
  }
  return all;
}

const toml::table* TomlTable::table(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) return nullptr;
  if (!node->is_table()) wrong(key, "must be a table: [" + std::string(key) + "]");
  return node->as_table();
}

std::vector<const toml::table*> TomlTable::tables(std::string_view key) {
  std::vector<const toml::table*> all;
  const toml::node* node = find(key);
  if (node == nullptr) return all;
  const toml::array* array = node->as_array();
  if (array == nullptr) return wrong(key, "must be tables: [[" + std::string(key) + "]]"), all;
  for (const toml::node& item : *array) {
    if (!item.is_table()) return wrong(key, "must be tables: [[" + std::string(key) + "]]"), all;
    all.push_back(item.as_table());
  }
  return all;
}

std::string TomlTable::next_missing() {
  const auto next =
      std::find_if(missing_says_.begin(), missing_says_.end(), [](const std::string& says) { return !says.empty(); });
  if (next == missing_says_.end()) return {};
  const std::string says = std::exchange(*next, {});
  return "; " + (says.starts_with(name_ + " ") ? "it" + says.substr(name_.size()) : says);
}

bool TomlTable::refuse_others() {
  bool usable = missing_.empty();
  std::vector<const toml::key*> unknown;  // and like none that there is
  for (const auto& [key, node] : table_) {
    if (is_among(asked_, key.str())) continue;
    // A key that is missing is the likeliest to be meant, and then is not told as missing too.
    std::string meant(nearest(missing_, key.str()));
    if (meant.empty()) meant = nearest(asked_, key.str());
    if (meant.empty()) unknown.push_back(&key);
    else
      complaints_.add(file_place(key.source()),
                      name_ + " has no key " + in_quotes(key.str()) + ": did you mean " + in_quotes(meant) + "?");
    usable = usable && (meant.empty() || has(meant));
    for (std::size_t i = missing_.size(); i-- > 0;)
      if (missing_[i] == meant) missing_says_[i].clear();
  }
  const auto line_of = [](const toml::key* key) { return key->source().begin.line; };
  sort_stably(unknown, [&](const toml::key* a, const toml::key* b) { return line_of(a) < line_of(b); });
  for (const toml::key* key : unknown)
    complaints_.add(file_place(key->source()), name_ + " has no key " + in_quotes(key->str()) + next_missing());
  for (std::string& what : missing_says_)
    if (!what.empty()) complaints_.add(place_, std::move(what));
  missing_.clear(), missing_says_.clear();
  return usable;
}

}  // namespace snug::lesson
