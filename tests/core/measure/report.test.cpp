// Tables written and read back to the same bits; damaged ones refused with their line.
#include "measure/report.hpp"

#include <doctest/doctest.h>

#include <array>
#include <limits>

using namespace snug;

namespace {

cost::Provenance provenance() {
  return {.version = "1.2.3",
          .build = "GNU 12.2.0, Release",
          .platform = "native",
          .processor = "A \"fast\" one, #2",
          .points = "cube:100",
          .scalar = "double",
          .dim = 3,
          .seed = 42,
          .clock_resolution_ns = 1.0 / 3};
}

std::vector<cost::CostRow> two_rows() {
  cost::CostRow full{.volume = "obb",
                     .algorithm = "pca",
                     .points = 100,
                     .of = 400,
                     .whole_ns = 1e9 / 7,
                     .time = {0.1, 0.2, 1.0 / 3, 9, 64, true},
                     .operations = {1, 2, 3, 4, 5, 6, std::int64_t{1} << 60, 8},
                     .steps = 12,
                     .size = 1e-300,
                     .measure = 0x1.fffffffffffffp+1000,
                     .tightness = 1.25,
                     .over_hull = 2,
                     .bytes = 120,
                     .overlap_pairs = 64,
                     .overlapping = 32,
                     .update = "transform",
                     .updated = {7, 7, std::nullopt, 1, 2, false},
                     .contains = true,
                     .optimal = false,
                     .on_front = true};
  return {full, {.volume = "hull", .algorithm = "quickhull", .points = 1, .of = 1}};
}

std::string csv() {
  return cost::csv_of(provenance(), std::span<const cost::CostRow>(std::array{two_rows()[0], two_rows()[1]}));
}

/// What is wrong with a text, with its line.
std::string complaint(const std::string& text) {
  const auto table = cost::read_csv<cost::CostRow>(text, "costs.csv");
  return table ? "" : table.error().message();
}

std::string with_replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  REQUIRE(at != std::string::npos);
  return text.replace(at, what.size(), by);
}

}  // namespace

TEST_CASE("what is written as CSV is read back to the same bits") {
  const auto table = cost::read_csv<cost::CostRow>(csv(), "costs.csv");
  REQUIRE(table);
  CHECK(table->provenance.processor == provenance().processor);
  CHECK(table->provenance.seed == 42);
  CHECK(table->provenance.clock_resolution_ns == 1.0 / 3);
  REQUIRE(table->rows.size() == 2);
  const cost::CostRow &read = table->rows[0], written = two_rows()[0];
  CHECK(read.whole_ns == written.whole_ns);
  CHECK(read.time.median == 0.1);
  CHECK(read.time.spread == 1.0 / 3);
  CHECK(read.time.trusted);
  CHECK(read.operations == written.operations);
  CHECK(read.size == written.size);
  CHECK(read.measure == written.measure);
  CHECK(read.optimal == std::optional(false));
  CHECK(read.update == std::optional<std::string>("transform"));
  CHECK(read.updated.median == 7);
  CHECK_FALSE(read.updated.spread);
  CHECK(read.overlap.repeats == 0);
  CHECK_FALSE(table->rows[1].update);
  CHECK_FALSE(table->rows[1].tightness);
  CHECK_FALSE(table->rows[1].optimal);
  CHECK(cost::csv_of(table->provenance, std::span<const cost::CostRow>(table->rows)) == csv());
}

TEST_CASE("the other tables are read back as well") {
  const std::vector<cost::GrowthRow> growth{
      {.volume = "sphere", .algorithm = "ritter", .points = 10, .exponent = 1.02, .theory = "O(n)", .stopped = "a, b"}};
  const auto grown =
      cost::read_csv<cost::GrowthRow>(cost::csv_of(provenance(), std::span<const cost::GrowthRow>(growth)), "");
  REQUIRE(grown);
  CHECK(grown->rows[0].stopped == "a, b");
  CHECK(grown->rows[0].exponent == std::optional(1.02));
  const std::vector<cost::TurnRow> turn{
      {.volume = "aabb", .strategy = "loose", .points = 8, .degrees = 5, .slack = 0.5}};
  CHECK(cost::read_csv<cost::TurnRow>(cost::csv_of(provenance(), std::span<const cost::TurnRow>(turn)), "")
            ->rows[0]
            .slack == 0.5);
  const std::vector<cost::ClaimRow> claims{{.claim = "x", .says = "\"quoted\", and more"}};
  CHECK(cost::read_csv<cost::ClaimRow>(cost::csv_of(provenance(), std::span<const cost::ClaimRow>(claims)), "")
            ->rows[0]
            .says == "\"quoted\", and more");
}

TEST_CASE("columns may stand in another order, and more of them") {
  std::string text = csv();
  text = with_replaced(text, "volume,algorithm,", "new,algorithm,volume,");
  text = with_replaced(text, "\nobb,pca,", "\n7,pca,obb,");
  text = with_replaced(text, "\nhull,quickhull,", "\n8,quickhull,hull,");
  const auto table = cost::read_csv<cost::CostRow>(text, "");
  REQUIRE(table);
  CHECK(table->rows[0].volume == "obb");
}

TEST_CASE("what was not timed is null, and empty fields") {
  const std::vector<cost::CostRow> all{two_rows()[1]};
  const std::string json = cost::json_of(provenance(), std::span<const cost::CostRow>(all));
  CHECK(json.find("\"overlapping\":0,\"overlap_ns\":null,\"scene_overlap_ns\":null,\"update\":null,\"update_ns\":null,"
                  "\"certificate\":{") != std::string::npos);
  const std::string text = cost::csv_of(provenance(), std::span<const cost::CostRow>(all));
  CHECK(text.find(",0,0,,,,,,,,,,,,,,,,,,,,false,false,") != std::string::npos);
  CHECK(cost::read_csv<cost::CostRow>(text, "")->rows[0].updated.repeats == 0);
  // Programs before this one wrote noughts there.
  CHECK(cost::read_csv<cost::CostRow>(
      with_replaced(text, ",0,0,,,,,,,,,,,,,,,,,,,,false", ",0,0,0,0,0,0,0,false,,,,,,,,0,0,0,0,0,false,false"), ""));
  // A median of so many repeats has to be there.
  CHECK_FALSE(cost::read_csv<cost::CostRow>(with_replaced(text, ",0,0,,,,,,,", ",0,0,,,,9,1,true,"), ""));
}

TEST_CASE("damaged CSV is refused with its line") {
  CHECK(complaint("") == "costs.csv:1: the first line of such a table is \"# snug table: costs\"");
  CHECK(complaint(with_replaced(csv(), "table: costs", "table: growth")).starts_with("costs.csv:1: "));
  CHECK(complaint(with_replaced(csv(), "# seed: 42\n", "")) == "costs.csv:10: there is no \"seed\"");
  CHECK(complaint(with_replaced(csv(), "seed: 42", "seed: many")) ==
        "costs.csv:11: \"many\" is not a value of \"seed\"");
  CHECK(complaint(with_replaced(csv(), "# seed: 42", "# seed 42")) == "costs.csv:9: is not a line of a provenance");
  CHECK(complaint(with_replaced(csv(), "time_ns.median", "time_ns.middle")) ==
        "costs.csv:11: there is no \"time_ns.median\"");
  CHECK(complaint(with_replaced(csv(), "\nobb,pca,100", "\nobb,pca,a hundred")) ==
        "costs.csv:12: \"a hundred\" is not a value of \"points\"");
  CHECK(complaint(with_replaced(csv(), "\nobb,pca,100", "\nobb,pca,1e2")).starts_with("costs.csv:12: "));
  CHECK(complaint(with_replaced(csv(), "\nobb,pca", "\nobb,\"pca")) == "costs.csv:12: a quotation mark is not closed");
  CHECK(complaint(with_replaced(csv(), "\nhull,", "\nhull,too,many,")).starts_with("costs.csv:13: there are "));
  CHECK(complaint(csv().substr(0, csv().size() / 2)).find("costs.csv:1") == 0);
}

TEST_CASE("JSON has levels, numbers that are numbers, and null for what there is none of") {
  const std::vector<cost::CostRow> all = two_rows();
  const std::string json = cost::json_of(provenance(), std::span<const cost::CostRow>(all));
  CHECK(json.starts_with("{\"table\":\"costs\",\"provenance\":{\"version\":\"1.2.3\","));
  CHECK(json.find("\"processor\":\"A \\\"fast\\\" one, #2\"") != std::string::npos);
  CHECK(json.find("\"whole_ns\":142857142.85714287,\"time_ns\":{\"median\":0.1,\"min\":0.2,") != std::string::npos);
  CHECK(json.find("\"trusted\":true},\"operations\":{\"points_touched\":1,") != std::string::npos);
  CHECK(json.find("\"orientation_tests\":1152921504606846976,\"exact_decisions\":8},\"steps\":12") !=
        std::string::npos);
  CHECK(json.find("\"certificate\":{\"contains\":true,\"on_boundary\":false,\"optimal\":false},\"on_front\":true}") !=
        std::string::npos);
  CHECK(json.find("\"tightness\":null") != std::string::npos);
  CHECK(json.ends_with("]}\n"));
  cost::CostRow strange{.volume = "a\tb", .size = std::numeric_limits<double>::infinity()};
  const std::string text = cost::json_of(provenance(), std::span<const cost::CostRow>(&strange, 1));
  CHECK(text.find("\"volume\":\"a\\u0009b\"") != std::string::npos);
  CHECK(text.find("\"size\":null") != std::string::npos);
  strange.volume = "obb";
  const auto back =
      cost::read_csv<cost::CostRow>(cost::csv_of(provenance(), std::span<const cost::CostRow>(&strange, 1)), "");
  REQUIRE(back);
  CHECK(back->rows[0].size == strange.size);
}
