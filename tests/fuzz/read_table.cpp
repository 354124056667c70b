// libFuzzer: any bytes as a table of results, as `snug cost` writes them and `--against`, charts and the page read
// them. It is refused with a sentence, or read; and what was read is written as CSV that is read again as the same.
#include <span>
#include <string>
#include <string_view>

#include "desktop/cli/cost_file.hpp"
#include "fuzz/bytes.hpp"

namespace {

using namespace snug;
using fuzz::require;

template <class Row>
void check(std::string_view text) {
  const auto table = desktop::read_table<Row>(text, "table");
  if (!table) {
    require(!table.error().what.empty() && table.error().file == "table");
    return;
  }
  const std::string csv = cost::csv_of(table->provenance, std::span<const Row>(table->rows));
  const auto again = cost::read_csv<Row>(csv, "again.csv");
  require(again && again->rows.size() == table->rows.size());
  require(cost::csv_of(again->provenance, std::span<const Row>(again->rows)) == csv);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  check<cost::CostRow>(text);
  check<cost::GrowthRow>(text);
  check<cost::TurnRow>(text);
  check<cost::TrialRow>(text);
  return 0;
}
