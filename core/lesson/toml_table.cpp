#include "lesson/toml_table.hpp"

#include <algorithm>
#include <cmath>

namespace snug::lesson {
namespace {

int line_of_node(const toml::node& node) { return static_cast<int>(node.source().begin.line); }

std::string quoted(std::string_view key) { return '"' + std::string(key) + '"'; }

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

}  // namespace

void Complaints::add(int line, std::string what) {
  if (!first_) first_ = InputError{std::move(what), file_, InputError::Unit::kLine, std::max(line, 1)};
}

TomlTable::TomlTable(const toml::table& table, std::string name, Complaints& complaints)
    : table_(table), name_(std::move(name)), complaints_(complaints), line_(std::max(line_of_node(table), 1)) {}

const toml::node* TomlTable::find(std::string_view key) {
  asked_.emplace_back(key);
  return table_.get(key);
}

const toml::node* TomlTable::require(std::string_view key) {
  const toml::node* node = find(key);
  if (node == nullptr) complaints_.add(line_, name_ + " lacks the key " + quoted(key));
  return node;
}

int TomlTable::line_of(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return node != nullptr ? line_of_node(*node) : line_;
}

void TomlTable::wrong(std::string_view key, const std::string& what) {
  complaints_.add(line_of(key), quoted(key) + " " + what);
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
    wrong(key, "must be above 0 and at most " + std::to_string(static_cast<int>(most)));
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
      complaints_.add(line_of_node(item), quoted(key) + " must be a list of texts");
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
      const toml::node* number = numbers->get(static_cast<std::size_t>(i));
      point[i] = number->is_number() ? number->value_or(std::nan("")) : std::nan("");  // none: beyond double's integers
      good = std::isfinite(point[i]);
    }
    if (!good) {
      const char* form = dim == 3   ? "3 finite numbers: [x, y, z]"
                         : dim == 2 ? "2 finite numbers: [x, y]"
                                    : "one finite number: [x]";
      complaints_.add(line_of_node(item), "each of " + quoted(key) + " must be a point of " + form);
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

void TomlTable::refuse_others() {
  for (const auto& [key, node] : table_)
    if (std::find(asked_.begin(), asked_.end(), key.str()) == asked_.end())
      complaints_.add(static_cast<int>(key.source().begin.line), name_ + " has no key " + quoted(key.str()));
}

}  // namespace snug::lesson
