// libFuzzer: any bytes as a result file. It is read, or refused; an attempt that was read is written in a form that is
// read again as the same.
#include "desktop/cli/result_file.hpp"
#include "fuzz/bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace snug;
  const auto file = desktop::read_result({reinterpret_cast<const char*>(data), size});
  if (!file) return 0;
  for (const auto& claimed : file->attempts) {
    if (!claimed) continue;
    const lesson::Attempt& attempt = claimed->attempt;
    const auto again = desktop::attempt_of(desktop::json_of(attempt, 0, 0));
    fuzz::require(again && again->attempt.seed == attempt.seed && again->attempt.hash == attempt.hash);
    fuzz::require(again->attempt.made.size() == attempt.made.size() && again->attempt.hints() == attempt.hints());
  }
  return 0;
}
