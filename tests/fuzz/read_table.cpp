// libFuzzer: any bytes as a table of results, as `snug cost` writes them and `--against`, charts and the page read
// them. It is refused with a sentence, or read; and what was read is written as CSV that is read again as the same.
#include <sys/mman.h>
#include <unistd.h>

#include <span>
#include <string>

#include "desktop/cli/cost_file.hpp"
#include "fuzz/bytes.hpp"

namespace {

using namespace snug;
using fuzz::require;

template <class Row>
void check(const std::string& path) {
  const auto table = desktop::read_table<Row>(path);
  if (!table) {
    require(!table.error().what.empty() && table.error().file == path);
    return;
  }
  const std::string csv = cost::csv_of(table->provenance, std::span<const Row>(table->rows));
  const auto again = cost::read_csv<Row>(csv, "again.csv");
  require(again && again->rows.size() == table->rows.size());
  require(cost::csv_of(again->provenance, std::span<const Row>(again->rows)) == csv);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const int file = memfd_create("table", 0);
  require(file >= 0 && write(file, data, size) == static_cast<ssize_t>(size));
  const std::string path = "/proc/self/fd/" + std::to_string(file);
  check<cost::CostRow>(path);
  check<cost::GrowthRow>(path);
  check<cost::TurnRow>(path);
  check<cost::TrialRow>(path);
  close(file);
  return 0;
}
