// Runs a fuzz target without libFuzzer, for compilers that lack it: plain SECONDS FAILED FOLDER...: every kept input of
// the folders, then changes of them at random for so many seconds, the same ones each time. What fails is written to
// the file FAILED. (It does not watch which way the code goes; the preset fuzz does.)
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "geometry/random.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);
extern "C" [[gnu::weak]] void __sanitizer_set_death_callback(void (*callback)());

namespace {

using Input = std::vector<unsigned char>;
namespace fs = std::filesystem;

constexpr std::size_t kMostBytes = 4096;

Input running;
const char* failed = nullptr;

void keep_running() {
  std::ofstream(failed, std::ios::binary)
      .write(reinterpret_cast<const char*>(running.data()), static_cast<std::streamsize>(running.size()));
  std::fprintf(stderr, "the input that failed is in %s\n", failed);
}

void aborted(int) {
  keep_running();
  std::_Exit(1);
}

void run(const Input& input) {
  running = input;
  LLVMFuzzerTestOneInput(running.data(), running.size());
}

std::vector<Input> kept_inputs(int folders, char** names) {
  std::vector<Input> kept;
  for (int i = 0; i < folders; ++i)
    for (const auto& file : fs::recursive_directory_iterator(names[i]))
      if (file.is_regular_file()) {
        std::ifstream in(file.path(), std::ios::binary);
        kept.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
      }
  return kept;
}

/// An input with a few bytes changed, left out, doubled or taken from another.
Input changed(Input input, const std::vector<Input>& kept, snug::Random& random) {
  const auto below = [&](std::size_t n) { return random.below(static_cast<std::uint32_t>(n)); };
  for (std::uint32_t changes = 1 + below(6); changes > 0; --changes) {
    const std::size_t at = below(input.size() + 1);
    const auto place = input.begin() + static_cast<std::ptrdiff_t>(at);
    const auto byte = static_cast<unsigned char>(below(256));
    switch (below(5)) {
      case 0: input.insert(place, byte); break;
      case 1: {
        const Input& other = kept[below(kept.size())];
        const std::size_t from = below(other.size() + 1),
                          length = below(std::min<std::size_t>(32, other.size() - from) + 1);
        const auto first = other.begin() + static_cast<std::ptrdiff_t>(from);
        input.insert(place, first, first + static_cast<std::ptrdiff_t>(length));
        break;
      }
      case 2:
        input.erase(place, place + static_cast<std::ptrdiff_t>(below(std::min<std::size_t>(8, input.size() - at) + 1)));
        break;
      default:
        if (at < input.size())
          input[at] = below(2) == 0 ? byte : static_cast<unsigned char>(input[at] ^ 1u << below(8));
    }
  }
  if (input.size() > kMostBytes) input.resize(kMostBytes);
  return input;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::chrono::duration<double> most(std::atof(argv[1]));
  failed = argv[2];
  std::signal(SIGABRT, aborted);
  if (__sanitizer_set_death_callback != nullptr) __sanitizer_set_death_callback(keep_running);
  std::vector<Input> kept = kept_inputs(argc - 3, argv + 3);
  const std::size_t files = kept.size();
  for (const Input& input : kept) run(input);
  snug::Random random(1);
  for (int i = 0; i < 8; ++i) {  // for targets that make numbers of any bytes
    kept.emplace_back(64);
    for (auto& byte : kept.back()) byte = static_cast<unsigned char>(random.below(256));
  }
  const auto start = std::chrono::steady_clock::now();
  long runs = 0;
  for (; std::chrono::steady_clock::now() - start < most; ++runs)
    run(changed(kept[random.below(static_cast<std::uint32_t>(kept.size()))], kept, random));
  std::fprintf(stderr, "%zu kept inputs and %ld changed ones\n", files, runs);
  return 0;
}
