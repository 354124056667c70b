#include "lesson/subjects/criteria/load.hpp"

#include <array>
#include <cmath>

namespace snug::lesson {
namespace {

constexpr double kMostCount = 1e9;  // of any count

double read_count(TomlTable& table, std::string_view key, double otherwise) {
  const double count = table.any_number(key, otherwise);
  if (!(count >= 0 && count <= kMostCount)) table.wrong(key, "must be a number from 0 to 1,000,000,000");
  return count;
}

}  // namespace

const Load& load_of(const Lesson& lesson) { return static_cast<const LoadTables&>(*lesson.tables).load; }

std::shared_ptr<const LoadTables> read_load(TomlTable& table, Complaints& complaints) {
  auto tables = std::make_shared<LoadTables>();
  Load& load = tables->load;
  const toml::table* own = table.table("load");
  if (own == nullptr) return table.lack("load", table.name() + " lacks [load]"), tables;
  TomlTable numbers(*own, "[load]", complaints);
  load.bodies = read_count(numbers, "bodies", load.bodies);
  load.frames = read_count(numbers, "frames", load.frames);
  load.updates = read_count(numbers, "updates", load.updates);
  load.pairs = read_count(numbers, "pairs", load.pairs);
  load.hit_rate = numbers.any_number("hit_rate", 100 * load.hit_rate) / 100;
  if (!(load.hit_rate >= 0 && load.hit_rate <= 1))
    numbers.wrong("hit_rate", "must be a number from 0 to 100, per cent");
  load.deforms = numbers.flag_or("deforms", load.deforms);
  numbers.refuse_others();
  return tables;
}

std::vector<double> row_of(const Load& load) { return {load.frames, load.pairs, load.hit_rate, load.updates}; }

tl::expected<Load, InputError> with_row(const Load& load, const std::vector<double>& row) {
  const auto refused = [](const char* what) { return tl::unexpected(InputError{.what = what}); };
  if (row.size() != kLoadRow) return refused("a load must have four numbers: frames, pairs, hit rate and updates");
  for (const double number : row)
    if (!(number >= 0 && number <= kMostCount)) return refused("a load's numbers must be from 0 to 1,000,000,000");
  if (row[2] > 1) return refused("a hit rate must be at most 1");
  Load next = load;
  next.frames = row[0], next.pairs = row[1], next.hit_rate = row[2], next.updates = row[3];
  return next;
}

}  // namespace snug::lesson
